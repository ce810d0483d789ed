"""Pictures of a transient solution: `result.plot.history()`."""

import os
from pathlib import Path

from matplotlib.figure import Figure

from pyworm.plots.layout import write
from pyworm.plots.life import draw_life
from pyworm.plots.life_animation import animate
from pyworm.result.transient_result import TransientResult


class TransientPictures:
    """The pictures of a contact over time."""

    def __init__(self, transient: TransientResult):
        self._transient = transient

    def history(self, path: str | os.PathLike | None = None) -> Figure:
        """Load, film thickness, pressure, friction, temperatures over time; written where a path is given."""
        figure = draw_life(self._transient.result, self._transient.over_time)
        if path is not None:
            write(figure, Path(path))
        return figure

    def animation(self, path: str | os.PathLike) -> Path:
        """Write an animation of pressure and film thickness, as of `TransientResult.animate`."""
        return animate(self._transient.result, self._transient.over_time, Path(path))
