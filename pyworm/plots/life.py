"""Figures of a contact over its life, with error bars, and the contacts solved on finer grids."""

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyworm.io.quantities import QUANTITIES
from pyworm.plots.error_bars import BODY_COLOURS, TEMPERATURES, estimates_of
from pyworm.plots.layout import KILO, LOAD_UNITS, MILLI, add_grids, broken, joined, placed_panels
from pyworm.result.headline import of_all
from pyworm.result.life import ContactLife
from pyworm.result.result import Result

Array = np.ndarray

MILLI_SECOND = 1e-3

PANEL = 1.9
"""Height of a panel [inch]."""

THICKEST = 4.0
"""Thickest film shown, over the median one at the contact point, which at a tooth's ends is beside the
pressure."""

ROOM = 1.3
"""Upper end of a scale that begins at zero, over its largest value: room for the legend."""


def draw_life(result: Result, life: ContactLife) -> Figure:
    """Load, films, pressure, friction and temperatures over a contact's life."""
    drawn = [
        draw for name, draw in PANELS.items() if name in ("load", "entrainment", *life.figures)
    ]
    size = 9, PANEL * len(drawn) + 1.2
    words = "one mesh engagement" if life.phases is not None else "load and speed history"
    what = joined(result.case_name, f"{life.place} {words}".strip(), of_all(life.solutions).note)
    room = (0.95, 0.25, 0.5, 0.12)
    figure, panels = placed_panels(size, what, room, len(drawn), space=0.08, sharex=True)
    abscissa, label = life.seconds / MILLI_SECOND, "time / ms"
    if life.phases is not None:
        abscissa, label = life.phases, f"mesh phase (cycle duration {life.span * MILLI:.3g} ms)"
    for panel, draw in zip(panels, drawn, strict=True):
        draw(panel, result, life, abscissa)
    add_grids(panels)
    panels[-1].set_xlabel(label)
    return figure


def _draw_load(axes: Axes, result: Result, life: ContactLife, abscissa: Array) -> None:
    large = life.load.max() >= 1 / KILO
    axes.plot(abscissa, _broken(life, life.load * (KILO if large else 1)), color="tab:brown")
    axes.set_ylim(0, 1.1 * axes.get_ylim()[1])
    unit = LOAD_UNITS[life.kind]
    axes.set_ylabel(f"load / {'k' if large else ''}{unit}")


def _draw_speed(axes: Axes, result: Result, life: ContactLife, abscissa: Array) -> None:
    axes.plot(abscissa, _broken(life, life.entrainment), color="0.3")
    low, high = min(0.0, life.entrainment.min()), max(0.0, life.entrainment.max())
    axes.set_ylim(low * 1.1, high * 1.1)
    axes.set_ylabel(broken(QUANTITIES["entrainment"].axis()))


def _draw_films(axes: Axes, result: Result, life: ContactLife, abscissa: Array) -> None:
    _draw(axes, life, abscissa, "film_central", "tab:blue")
    _draw(axes, life, abscissa, "film_min", "tab:green")
    film = QUANTITIES["film"]
    thick = THICKEST * film.number(float(np.nanmedian(life.figures["film_central"])))
    axes.set_ylim(0, min(ROOM * axes.get_ylim()[1], thick))
    axes.set_ylabel(film.axis())
    # films are thick where a life begins and ends
    axes.legend(frameon=False, ncols=2, loc="upper center")


def _draw_pressure(axes: Axes, result: Result, life: ContactLife, abscissa: Array) -> None:
    _draw(axes, life, abscissa, "pressure_max", "tab:red")
    axes.set_ylim(0)
    axes.set_ylabel(broken(QUANTITIES["pressure_max"].axis()))


def _draw_friction(axes: Axes, result: Result, life: ContactLife, abscissa: Array) -> None:
    _draw(axes, life, abscissa, "friction_coefficient", "tab:purple", "of oil and asperities")
    axes.set_ylim(0, ROOM * axes.get_ylim()[1])
    axes.set_ylabel(broken(QUANTITIES["friction_coefficient"].axis()))
    if "friction_boundary" in life.figures:
        _draw(axes, life, abscissa, "friction_boundary", "tab:olive", "of asperities")
        axes.legend(frameon=False, ncols=2, loc="upper left")


def _draw_temperatures(axes: Axes, result: Result, life: ContactLife, abscissa: Array) -> None:
    labels = *result.body_names, "film"
    for name, label, colour in zip(TEMPERATURES, labels, BODY_COLOURS, strict=True):
        _draw(axes, life, abscissa, name, colour, label)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.3 * (high - low))
    axes.set_ylabel(broken(QUANTITIES["temperature_max"].axis()))
    axes.legend(frameon=False, ncols=3, loc="upper left")


PANELS: dict[str, Callable[[Axes, Result, ContactLife, Array], None]] = {
    "load": _draw_load,
    "entrainment": _draw_speed,
    "film_min": _draw_films,
    "pressure_max": _draw_pressure,
    "friction_coefficient": _draw_friction,
    "temperature_max_film": _draw_temperatures,
}
"""Figure that a panel needs -> what draws the panel."""


def _draw(
    axes: Axes, life: ContactLife, abscissa: Array, name: str, colour: str, label: str = ""
) -> None:
    """A figure over the life with a band of its error bars, and that of the contacts solved finer."""
    quantity = QUANTITIES[name]
    values, errors = quantity.number(life.figures[name]), life.errors[name] * quantity.scale
    words = label or quantity.words()
    axes.plot(abscissa, _broken(life, values), color=colour, label=words, linewidth=1.4)
    low, high = (_broken(life, values + sign * errors) for sign in (-1, 1))
    axes.fill_between(abscissa, low, high, color=colour, alpha=0.25)
    good = [solution for solution in life.solutions if solution.converged]
    end = life.seconds[-1] / MILLI_SECOND
    places = [end if solution.phase is None else solution.phase for solution in good]
    estimates, finer, sizes = estimates_of(good, name)
    bars = sizes * [estimate.error for estimate in estimates]
    axes.errorbar(places, finer, bars, fmt="o", color=colour, markersize=4, capsize=3)


def _broken(life: ContactLife, values: Array) -> Array:
    """A curve with gaps where part of the life was not solved."""
    values = np.array(values, float)
    values[life.gaps] = np.nan
    return values
