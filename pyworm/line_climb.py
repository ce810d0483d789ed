"""The film of a line contact: up grids of halving spacing until the figures are as accurate as asked."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil

import numpy as np

from pyworm.kernels import NO_DESCENT, KernelError, LineFilm
from pyworm.line_far_field import line_far_field
from pyworm.line_scene import Array, LineScene
from pyworm.line_solution import LineReading, LineSolution, LineStride
from pyworm.solution import Estimate

INLET_FILMS = 12.0
"""Films that Hertz's gap has risen at the inlet end of the grid; what lies beyond is `line_far_field`."""

EXIT_FILMS = 1.0
"""The same at the exit end. A rigid film ruptures where the gap has risen by a quarter of the film."""

FIRST_CELLS = 64
"""Cells of the first grid."""

MOST_STEPS = 40
"""Newton steps on one grid before it is given up."""

FORCING = 1e-3
"""Share of the residual to which each Newton step solves its linear system."""

TOLERANCE = 1e-6
"""Residual and load error at which a grid is settled. Newton's last step falls far below it."""

MOST_UNSETTLED = 2
"""Grids that may stay short of the tolerance: one too coarse for its film is no failure."""

FLOOR_SHARE = 1e-3
"""Film, as a share of the expected one, below which mobility falls no further."""

TRACE = 1e-6
"""Pressure that a film starts with outside its dry contact, over the largest dry pressure.

A rupture line that starts too far out is found in a few steps; from too near it moves by a cell a step."""

ACCURATE = "the figures are as accurate as asked for"
"""The stop reason of a converged solution."""


@dataclass(frozen=True)
class _Rung:
    """A film on one grid."""

    scene: LineScene
    x: Array
    film: LineFilm


def climb_line(
    scene: LineScene,
    accuracy: float = 0.01,
    largest_grid: int = 33_000,
    inlet_films: float = INLET_FILMS,
) -> LineSolution:
    """Solve a line contact for its film.

    Parameters
    ----------
    scene : LineScene
        The contact.
    accuracy : float
        Relative error wanted in central and minimum film.
    largest_grid : int
        Most points of a grid. A step costs some milliseconds at 2000 and grows nearly as their number.
    inlet_films : float
        Films that the gap has risen at the inlet end of the grid.

    Returns
    -------
    LineSolution
        Marked not converged, with the reason, where the figures are not to be trusted.

    Raises
    ------
    ValueError
        If there is no entrainment, load or viscosity.
    KernelError
        If the scene makes no sense to the kernel (values that are not finite).
    """
    if not abs(scene.speed) > 0:
        raise ValueError(
            "the surfaces entrain no oil (mean velocity 0 m/s): give them a mean velocity"
        )
    if not (scene.load > 0 and scene.oil.viscosity.eta0 > 0):
        raise ValueError(
            f"a load of {scene.load:g} N/m on an oil of {scene.oil.viscosity.eta0:g} Pa s forms no film: "
            "both must be positive"
        )
    rung = _first_rung(scene, inlet_films)
    strides = _settle(rung)
    # what lies before the inlet follows from a film, and the film from it: the first grid is solved twice
    rung = _rung(scene, rung.x, rung.film.pressure, rung)
    readings: list[LineReading] = []
    unsettled = 0
    while True:
        strides += _settle(rung)
        readings.append(_read(rung))
        unsettled += rung.film.balance.worst > TOLERANCE
        stop_reason = _stop_reason(rung, readings, unsettled, accuracy, largest_grid)
        if stop_reason is not None:
            return _solution(rung, stop_reason, readings, strides)
        rung = _rung(scene, _prolonged_nodes(rung.x), _prolonged(rung.film.pressure), rung)


def relative_error(values: Sequence[float], order: float) -> float:
    """Relative error of the last of a figure's values on grids of halving spacing.

    The last change, divided by what the observed fall of the changes promises: at second order three
    quarters of the error are gone at each grid. Until a third grid shows the order, or where the changes do
    not fall by half, the whole last change is the error.

    Parameters
    ----------
    values : sequence of float
        The figure, from the coarsest grid to the finest.
    order : float
        The highest order to believe in.
    """
    if len(values) < 2:
        return np.inf
    last = abs(values[-1] - values[-2])
    fall = abs(values[-2] - values[-3]) / last if len(values) > 2 and last > 0 else 1.0
    return last / abs(values[-1]) / max(min(fall, 2**order) - 1, 1.0)


def _first_rung(scene: LineScene, inlet_films: float) -> _Rung:
    """The coarsest grid, entered from the dry contact lifted by the expected film."""
    x = _first_nodes(scene, inlet_films)
    dry = scene.dry.pressure(x)
    probe = _line_film(scene, x, scene.load)
    probe.start(dry, 0.0)
    deflected, _, _ = probe.fields()
    rigid_film = scene.film - float(deflected[np.argmin(abs(x))])
    probe.start(np.where(scene.gap(x)[1], dry + TRACE * dry.max(), 0.0), rigid_film)
    return _rung(scene, x, probe.pressure, _Rung(scene, x, probe))


def _first_nodes(scene: LineScene, inlet_films: float) -> Array:
    """Nodes [m] of the first grid, one of them at the contact point."""
    inlet = scene.distance_of(inlet_films * scene.film)
    outlet = scene.distance_of(EXIT_FILMS * scene.film)
    dx = (inlet + outlet) / FIRST_CELLS
    nodes = dx * np.arange(-ceil(inlet / dx), ceil(outlet / dx) + 1)
    return nodes if scene.speed > 0 else -nodes[::-1]


def _line_film(scene: LineScene, x: Array, load: float) -> LineFilm:
    gap, covered = scene.gap(x)
    return LineFilm(
        gap,
        covered,
        np.full_like(x, scene.speed),
        np.zeros_like(x),
        x[1] - x[0],
        scene.reduced_modulus,
        load,
        scene.oil,
        FLOOR_SHARE * scene.film,
    )


def _rung(scene: LineScene, x: Array, pressure: Array, before: _Rung) -> _Rung:
    """A grid entered from a pressure on it; oil comes to its inlet as the rung before lets it."""
    film, _, _ = before.film.fields()
    beyond = line_far_field(scene, before.x, before.film.pressure, film)
    dx = x[1] - x[0]
    # of the strip about the inlet node, half lies beyond the grid but counts with its pressure
    contact = _line_film(scene, x, scene.load - beyond.load + beyond.pressure * dx / 2)
    started = np.where(scene.gap(x)[1], pressure, 0.0)
    started[[0, -1]] = (beyond.pressure, 0.0) if scene.speed > 0 else (0.0, beyond.pressure)
    contact.start(started, before.film.rigid_film)
    return _Rung(scene, x, contact)


def _settle(rung: _Rung) -> list[LineStride]:
    """Newton steps until residual and load error are small, or no step helps any more."""
    strides = []
    while rung.film.balance.worst > TOLERANCE and len(strides) < MOST_STEPS:
        try:
            step = rung.film.step(FORCING)
        except KernelError as error:
            if error.status != NO_DESCENT:
                raise
            break
        balance = step.balance
        strides.append(LineStride(rung.x.size, balance.residual, balance.load_error, step.krylov))
    return strides


def _prolonged_nodes(x: Array) -> Array:
    """Nodes of half the spacing, the contact point still among them to the last bit."""
    first = round(x[0] / (x[1] - x[0]))
    return (x[1] - x[0]) / 2 * np.arange(2 * first, 2 * (first + x.size) - 1)


def _prolonged(pressure: Array) -> Array:
    """Pressure on the grid of half the spacing, by cubic interpolation and never below zero."""
    p = pressure
    fine = np.empty(2 * p.size - 1)
    fine[::2] = p
    fine[3:-3:2] = (9 * (p[1:-2] + p[2:-1]) - p[:-3] - p[3:]) / 16
    for side, (a, b, c, d) in ((1, p[:4]), (-2, p[:-5:-1])):
        fine[side] = (5 * a + 15 * b - 5 * c + d) / 16
    return np.maximum(fine, 0.0)


def _read(rung: _Rung) -> LineReading:
    film, _, _ = rung.film.fields()
    film_min, at = _vertex(rung.x, film)
    return LineReading(
        rung.x.size,
        float(film[np.argmin(abs(rung.x))]),
        film_min,
        at,
        -_vertex(rung.x, -rung.film.pressure)[0],
    )


def _vertex(x: Array, values: Array) -> tuple[float, float]:
    """Smallest value and its place, by a parabola through the smallest nodal one and its neighbours."""
    i = int(np.argmin(values))
    if not 0 < i < x.size - 1:
        return float(values[i]), float(x[i])
    slope, bend = (values[i + 1] - values[i - 1]) / 2, values[i + 1] - 2 * values[i] + values[i - 1]
    if not bend > 0:
        return float(values[i]), float(x[i])
    return float(values[i] - slope**2 / (2 * bend)), float(x[i] - slope / bend * (x[1] - x[0]))


_ORDERS = {"film_central": 2.0, "film_min": 1.25, "pressure_max": 1.0}
"""Order at which a figure is believed to converge.

That of the scheme is 2. The smallest film lies behind the pressure spike, and as long as the grid does not
resolve that, its observed order is 1.2 to 1.8. The largest pressure may be the tip of the spike itself."""

_JUDGED = ("film_central", "film_min")
"""Figures that the accuracy is asked of. Not the largest pressure: a grid may miss a narrow spike."""


def _error(readings: Sequence[LineReading], name: str) -> float:
    return relative_error([getattr(reading, name) for reading in readings], _ORDERS[name])


def _stop_reason(
    rung: _Rung,
    readings: Sequence[LineReading],
    unsettled: int,
    accuracy: float,
    largest_grid: int,
) -> str | None:
    """Why the climb ends here, or None if it goes on."""
    error = max(_error(readings, name) for name in _JUDGED)
    settled = rung.film.balance.worst <= TOLERANCE
    resolved = readings[-1].film_min > 0
    if settled and resolved and error <= accuracy:
        return ACCURATE
    last = 2 * rung.x.size - 1 > largest_grid
    if not settled and (last or unsettled >= MOST_UNSETTLED):
        return f"the residual stayed at {rung.film.balance.worst:.1e}, {TOLERANCE:.1e} is wanted"
    if not last:
        return None
    if not resolved:
        return "the largest grid allowed does not resolve the film"
    return f"the largest grid allowed leaves an error of {error:.1%}"


def _solution(
    rung: _Rung,
    stop_reason: str,
    readings: Sequence[LineReading],
    strides: Sequence[LineStride],
) -> LineSolution:
    film, density, _ = rung.film.fields()
    estimates = {
        name: Estimate(getattr(readings[-1], name), _error(readings, name)) for name in _ORDERS
    }
    return LineSolution(
        converged=stop_reason == ACCURATE,
        stop_reason=stop_reason,
        **estimates,
        film_min_at=readings[-1].film_min_at,
        residual=rung.film.balance.residual,
        load_error=rung.film.balance.load_error,
        x=rung.x,
        gap=rung.scene.gap(rung.x)[0],
        pressure=rung.film.pressure,
        film=film,
        density=density,
        readings=tuple(readings),
        strides=tuple(strides),
    )
