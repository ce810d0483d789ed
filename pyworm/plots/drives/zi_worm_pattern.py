"""The contact pattern of worm and wheel without load, as a fitter sees it with marking compound."""

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.io.on_demand import xarray as xr
from pyworm.plots.layout import MICRO, MILLI, new_figure, result_heading
from pyworm.result.result import Result

LEVELS = 10.0, 20.0, 50.0, 100.0
"""Separations of the lines beyond the marked part [um]."""

MARKED = "#3f6fb5"
"""Colour of the marked part, as of engineer's blue."""


def draw_pattern(result: Result) -> Figure | None:
    """Both flanks with what is marked, and lines of equal separation beyond; None without a pattern."""
    cycle = result.mesh_cycle
    if "marking_separation" not in cycle:
        return None
    thickness = cycle.attrs["marking_thickness"] * MICRO
    what = f"contact pattern without load, compound of {thickness:g} µm"
    figure = new_figure(13, 3.9, result_heading(result, what))
    axes = figure.subplots(1, 2, sharex=True, sharey=True)
    forward = cycle.attrs["driver"] == "worm"
    names = "flank that the worm drives", "other flank, the worm turned the other way"
    for number, (panel, flank) in enumerate(zip(axes, cycle["marked_flank"].values, strict=True)):
        _draw_marks(panel, cycle.sel(marked_flank=flank), thickness)
        _name_sides(panel, leaving_right=forward == (number == 0))
        part = float(cycle["marking_fraction"].sel(marked_flank=flank))
        panel.set_title(f"{names[number]}: {part:.0%} marked", fontsize=9)
    axes[0].set_ylabel("distance from the wheel's axis / mm")
    return figure


def _draw_marks(axes: Axes, flank: "xr.Dataset", thickness: float) -> None:
    """Outline of the flank, what is marked, and lines of equal separation."""
    face, radius = flank["marking_place"].values * MILLI, flank["marking_radius"].values * MILLI
    separation = flank["marking_separation"].values * MICRO
    for edge in (0, -1):
        axes.plot(face[edge], radius[edge], color="0.25", lw=1.5)
        axes.plot(face[:, edge], radius[:, edge], color="0.25", lw=1.5)
    axes.contourf(face, radius, separation, [-1.0, thickness], colors=[MARKED])
    lines = axes.contour(face, radius, separation, LEVELS, colors="0.5", linewidths=0.8)
    axes.clabel(lines, fmt="%g µm", fontsize=7)
    half, low, high = face.max(), radius.min(), radius.max()
    axes.set_xlim(-1.15 * half, 1.15 * half)
    axes.set_ylim(low - 0.3 * (high - low), high + 0.1 * (high - low))
    axes.set_aspect("equal")
    axes.set_xlabel("along the face / mm")


def _name_sides(axes: Axes, leaving_right: bool) -> None:
    """Words at the four sides of a flank, and the way of the worm's threads over it."""
    sides = ["leaving side", "entering side"]
    right, left = sides if leaving_right else reversed(sides)
    axes.text(0.5, 0.985, "tip", ha="center", va="top", transform=axes.transAxes)
    axes.text(0.5, 0.235, "root", ha="center", va="bottom", transform=axes.transAxes)
    axes.text(0.985, 0.5, right, rotation=90, ha="right", va="center", transform=axes.transAxes)
    axes.text(0.015, 0.5, left, rotation=90, ha="left", va="center", transform=axes.transAxes)
    ends = (0.75, 0.25) if not leaving_right else (0.25, 0.75)
    axes.annotate(
        "",
        (ends[1], 0.05),
        (ends[0], 0.05),
        xycoords="axes fraction",
        arrowprops={"arrowstyle": "->", "color": "0.3"},
    )
    axes.text(0.5, 0.07, "threads of the worm", ha="center", fontsize=8, transform=axes.transAxes)
