"""Numerical errors of figures: discretisation, window and algebra."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from pyworm.planning.target import FIGURES, FILMS


@dataclass(frozen=True)
class Peak:
    """Resolution, on a grid, of the peaks of a field whose largest value is a figure."""

    bound: float
    """Upper bound of the largest value between nodes, in the field's unit."""
    nodes: float
    """Full width at half maximum, in nodes, of the narrowest peak that may be the largest."""


@dataclass(frozen=True)
class Reading:
    """Figures of a film on one grid."""

    film_min: float
    """Minimum film, between nodes [m]."""
    film_central: float
    """Film at the contact point [m]."""
    pressure_max: float
    """Largest pressure, between nodes [Pa]."""
    film_min_at: tuple[float, ...]
    """Place of the minimum film, along each direction of the grid [m]."""
    peaks: dict[str, Peak]
    """Resolution of the figures that are largest values of fields, by name."""
    further: dict[str, float] = field(default_factory=dict)
    """Figures of a sheared film (`SHEAR_FIGURES`) and of a heated one (`HEAT_FIGURES`), temperatures above
    the colder body's bulk temperature [K]."""
    left: dict[str, float] = field(default_factory=dict)
    """Relative error that finer grids about its place leave in a figure (`point.local_grids`)."""

    @property
    def figures(self) -> dict[str, float]:
        """All figures by name."""
        return {name: getattr(self, name) for name in FIGURES} | self.further


@dataclass(frozen=True)
class Left:
    """Error that grids leave in a figure, over its changes from grid to grid."""

    figure: float
    """On two grids: error over the figure's change, or over the films' if that is larger."""
    films: float
    """On two grids: error over the larger change of both films."""
    limit: float = 1.0
    """On more grids: error over the last change of its limit, where it is extrapolated."""
    least: float = 0.05
    """On more grids: least error over the figure's last change; two limits may be equal by chance."""

    def of_changes(self, figure: float, films: float) -> float:
        """Relative error by relative changes, of either sign, between the only two grids."""
        return max(self.figure * abs(figure), self.films * abs(films))


@dataclass(frozen=True)
class Convergence:
    """Orders of convergence and window errors of the figures of a kind of contact."""

    orders: Mapping[str, float]
    """Highest credible order of convergence of each figure with the spacing."""
    left: Mapping[str, Left]
    """Error that grids leave in each figure that is extrapolated."""
    window: Mapping[str, tuple[float, float]]
    """Least and largest change of figures to an endless window over that by doubling its reach."""
    kept: Mapping[str, Left] = field(default_factory=dict)
    """Error that two grids leave in figures that are not extrapolated, by default `UNKNOWN`."""
    falls: tuple[float, float] = (4.0, 4.0)
    """Credible ratios of successive errors of extrapolated figures: 2 at first order, 4 at second."""


def change(before: Reading, after: Reading) -> dict[str, float]:
    """Absolute relative change of each figure from one reading to another."""
    return {name: abs(relative) for name, relative in changes(before, after).items()}


def changes(before: Reading, after: Reading) -> dict[str, float]:
    """Change of each figure from one reading to another, relative to the latter."""
    last = before.figures
    return {name: _ratio(value - last[name], abs(value)) for name, value in after.figures.items()}


def largest_of_films(changed: Mapping[str, float]) -> float:
    """The larger change of both films."""
    return max(abs(changed[name]) for name in FILMS)


def _ratio(change: float, size: float) -> float:
    """Ratio of a change to a size that may be zero, such as that of friction without sliding."""
    if change == 0:
        return 0.0
    return change / size if size > 0 else float(np.copysign(np.inf, change))


STEEPEST_FALL = 8.0
"""Ratio of successive changes beyond which the last is small by chance: twice that of the second order."""

SAFETY = 1.25
"""Safety factor of the error by Richardson extrapolation, as recommended for three grids (Roache, Annu. Rev.
Fluid Mech. 29, 1997, 123-160)."""


UNKNOWN = Left(SAFETY, SAFETY)
"""Error that two grids leave in a figure of unknown order of convergence."""


def grid_errors(
    readings: Sequence[Reading],
    orders: Mapping[str, float],
    two_grids: Mapping[str, Left] | None = None,
) -> dict[str, float]:
    """Relative error of each figure on the last of grids of halving spacing.

    On two grids the order of convergence is not seen: what they leave of figures is `UNKNOWN`, where
    `two_grids` does not say better.
    """
    if len(readings) == 1:
        return dict.fromkeys(readings[0].figures, np.inf)
    last = changes(readings[-2], readings[-1])
    if len(readings) == 2:
        films, known = largest_of_films(last), two_grids or {}
        return {
            name: known.get(name, UNKNOWN).of_changes(figure, films)
            for name, figure in last.items()
        }
    before = changes(readings[-3], readings[-2])
    return {name: _grid_error(before[name], last[name], 2 ** orders[name]) for name in last}


def _grid_error(before: float, last: float, steepest: float) -> float:
    """Discretisation error of a figure from its last two changes, whose ratio is limited to `steepest`.

    The last change, `SAFETY` times, or a quarter of the one before if that is larger (a figure may stand
    still by chance). Where changes fall regularly it is divided by what their fall promises: at second order
    three quarters of the error are gone at each grid. Changes that differ in sign or fall too steeply promise
    nothing, and are taken as they are.
    """
    if before * last < 0 or abs(before) > STEEPEST_FALL * abs(last):
        return max(abs(last), abs(before) / 4)
    fall = before / last if last != 0 else steepest
    return float(max(SAFETY * abs(last), abs(before) / 4) / (np.clip(fall, 2.0, steepest) - 1))


LEAST_PEAK = 4.0
"""Width in nodes below which a grid does not resolve a peak of pressure (`docs/theory/film.md`)."""


def unresolved(reading: Reading) -> str | None:
    """Reason why the error of the largest pressure is unbounded on a grid; None where the peak is resolved.

    The changes between grids do not show it: as long as a spike is lower than the middle of the contact, the
    largest pressure stands still while the spike grows.
    """
    nodes = reading.peaks["pressure_max"].nodes
    return None if nodes >= LEAST_PEAK else f"unresolved pressure spike, {nodes:.1f} nodes wide"


SPIKE = 8.0
"""Width in nodes up to which the peak of the film's temperature is the tip of a spike: where the pressure
spikes, compression heats oil that flow has no time to cool, and the rise grows with the spike from grid to
grid (by a quarter at 2.6 nodes, by a twentieth at 5.7)."""


def hot_spike(reading: Reading) -> str | None:
    """Reason why the film's largest temperature is that of a spike; None for a broad peak or without heat."""
    peak = reading.peaks.get("temperature_max_film")
    if peak is None or peak.nodes >= SPIKE:
        return None
    return f"tip of a temperature spike, {peak.nodes:.1f} nodes wide"


def peak_errors(reading: Reading) -> dict[str, float]:
    """Relative error of the largest values of fields by the resolution of their peaks."""
    errors = {}
    for name, peak in reading.peaks.items():
        value = reading.figures[name]
        errors[name] = SAFETY * _ratio(max(peak.bound - value, 0.0), value)
    if unresolved(reading) is not None:
        errors["pressure_max"] = np.inf
    return errors


FIRST_CHANGE = 0.5
"""Relative change by a Newton step above which it belongs to no geometric series, as when heating starts."""

LEAST_FALL = 0.2
"""Least credible ratio of successive changes by Newton steps: changes of opposite sign may nearly cancel."""


MOST_FALL = 0.8
"""Largest credible ratio of successive changes by Newton steps; heat converges by 0.8 a step at worst."""


def algebra_errors(before: Mapping[str, float], last: Mapping[str, float]) -> dict[str, float]:
    """Relative error of each figure that is left after the last two Newton steps changed it so much.

    What later steps of a geometric series would still add, at most four times the last change, which is also
    taken where changes rise; the last change itself where they have only begun. A last change below the least
    credible fall is taken as that: a minimum film that moved by 6.4 % and then by 0.006 % moved by 0.77 %
    with the next step. The fall of the residual is no measure here: it shows the roughest errors, and a step
    may divide it by ten while the central film, a smooth figure, is still on its way.
    """
    errors = {}
    for name in last:
        series = 0 < before[name] < FIRST_CHANGE
        credible = max(last[name], LEAST_FALL * before[name]) if series else last[name]
        seen = min(credible / before[name], MOST_FALL) if series else 0.5
        errors[name] = credible * seen / (1 - seen)
    return errors
