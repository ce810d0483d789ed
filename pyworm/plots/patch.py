"""Picture of a rough patch that moved through a contact: film and pressure, also along the entrainment."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.formulas.arrays import Array
from pyworm.io.quantities import QUANTITIES
from pyworm.plots.layout import MEGA, MICRO, new_figure
from pyworm.solver.patch.patch_record import RoughPatch

MOST_FILM = 3.0
"""End of the axis of films over the mean smooth one."""


def draw_patch(name: str, patch: RoughPatch) -> Figure:
    """Film thickness and pressure at the end, and both along the entrainment beside the smooth film."""
    nodes = " x ".join(map(str, patch.grid.shape))
    figure = new_figure(13.6, 8.2, f"Rough surfaces moving through {name}  ·  {nodes} nodes")
    (film_map, pressure_map), (film, pressure) = figure.subplots(2, 2)
    most = MOST_FILM * patch.smooth.film_mean * MICRO
    film_label, pressure_label = (QUANTITIES[name].axis() for name in ("film", "pressure"))
    _draw_map(figure, film_map, patch, patch.last.film * MICRO, film_label, most)
    _draw_map(figure, pressure_map, patch, patch.last.pressure * MEGA, pressure_label, None)
    x, middle = patch.grid.x * MICRO, patch.grid.ny // 2
    film.plot(x, patch.last.film[:, middle] * MICRO, lw=0.9, label="rough")
    film.plot(x, patch.smooth_film[:, middle] * MICRO, "--", lw=1, label="smooth")
    film.set_ylim(0, most)
    film.set_ylabel(film_label)
    pressure.plot(x, patch.last.pressure[:, middle] * MEGA, lw=0.9, label="rough")
    pressure.plot(x, patch.smooth_pressure[:, middle] * MEGA, "--", lw=1, label="smooth")
    pressure.set_ylabel(pressure_label)
    for axes in (film, pressure):
        axes.set_xlabel("x along the entrainment / µm")
        axes.set_xlim(x[0], x[-1])
        axes.grid(True, color="0.9")
        axes.legend(frameon=False, fontsize="small")
    return figure


def _draw_map(
    figure: Figure, axes: Axes, patch: RoughPatch, field: Array, label: str, most: float | None
) -> None:
    west, east, south, north = (side * MICRO for side in patch.grid.box)
    drawn = axes.imshow(
        np.asarray(field).T,
        origin="lower",
        extent=(west, east, south, north),
        cmap="viridis",
        vmin=0.0,
        vmax=most,
    )
    figure.colorbar(drawn, ax=axes, label=label, extend="neither" if most is None else "max")
    axes.set_xlabel("x along the entrainment / µm")
    axes.set_ylabel("y / µm")
