"""Pictures of one solution: `solution.plot.film()`."""

from collections.abc import Callable
from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.plots.draw import SCENE_PICTURES, has_picture
from pyworm.plots.layout import drawn_into, write
from pyworm.solver.solution import Solution


class Pictures:
    """The pictures of a solution, each a function that returns a matplotlib figure.

    A contact has those that its kind has and of which the simulated effects make something to show:
    `dir(solution.plot)` lists them.
    """

    def __init__(self, solution: Solution):
        self._solution = solution

    def __dir__(self) -> list[str]:
        kind = SCENE_PICTURES[self._solution.kind]
        return [name for name in kind if has_picture(self._solution, name)]

    def __getattr__(self, name: str) -> Callable[..., Figure]:
        if name not in dir(self):
            shown = ", ".join(dir(self))
            raise AttributeError(f"this solution has no picture {name!r}; it has {shown}")
        draw = SCENE_PICTURES[self._solution.kind][name]

        def picture(
            path: str | Path | None = None, *, ax: Axes | None = None, **how: object
        ) -> Figure:
            """The picture, in place of axes where some are given; with a path it is written there too."""
            with drawn_into(ax):
                figure = draw(self._solution.name, self._solution, **how)
            if path is not None:
                write(figure, Path(path))
            return figure

        picture.__doc__ = draw.__doc__
        return picture

    def __repr__(self) -> str:
        return f"<Pictures of {self._solution.name}: {', '.join(dir(self))}>"
