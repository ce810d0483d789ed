"""Names of the sides of a worm wheel's flank, as a shop calls them."""

from matplotlib.axes import Axes


def name_sides(axes: Axes, leaving_right: bool, root: float) -> None:
    """Words at tip, root and both ends of a flank that fills a panel.

    Parameters
    ----------
    axes : Axes
        The panel, places along the face from left to right.
    leaving_right : bool
        Whether the worm's threads leave at the right end.
    root : float
        Height of the word for the root, a fraction of the panel.
    """
    right, left = ("leaving side", "entering side")[:: 1 if leaving_right else -1]
    at = axes.transAxes
    axes.text(0.5, 0.985, "tip", ha="center", va="top", transform=at)
    axes.text(0.5, root, "root", ha="center", va="bottom", transform=at)
    axes.text(0.985, 0.5, right, rotation=90, ha="right", va="center", transform=at)
    axes.text(0.015, 0.5, left, rotation=90, ha="left", va="center", transform=at)
