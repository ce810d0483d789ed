"""How far a figure may be from the truth: by its grid, by its window, by its unfinished algebra."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from pyworm.planning.target import FIGURES, FILMS


@dataclass(frozen=True)
class Peak:
    """How well a grid resolves the peaks of a field, of which the largest value is a figure.

    Attributes
    ----------
    bound : float
        Largest value that the grid does not exclude, in the field's unit.
    nodes : float
        Width at half its height, in nodes, of the narrowest peak that may hold the largest value.
    """

    bound: float
    nodes: float


@dataclass(frozen=True)
class Reading:
    """Figures of a film on one grid.

    Attributes
    ----------
    film_min, film_central : float
        Minimum film, between nodes, and film at the contact point [m].
    pressure_max : float
        Largest pressure, between nodes [Pa].
    film_min_at : tuple of float
        Where the minimum film is, along each direction of the grid [m].
    peaks : dict
        How well the grid resolves the figures that are the largest values of fields, by name.
    further : dict
        Figures of a sheared film (`SHEAR_FIGURES`) and of a heated one (`HEAT_FIGURES`), temperatures above
        the inlet's [K].
    """

    film_min: float
    film_central: float
    pressure_max: float
    film_min_at: tuple[float, ...]
    peaks: dict[str, Peak]
    further: dict[str, float] = field(default_factory=dict)

    @property
    def figures(self) -> dict[str, float]:
        """All figures by name."""
        return {name: getattr(self, name) for name in FIGURES} | self.further


@dataclass(frozen=True)
class Convergence:
    """How the figures of a kind of contact come near the truth.

    Attributes
    ----------
    orders : mapping
        The highest order to believe in by which each figure converges with the spacing.
    window_limits : mapping
        Error of each figure by a window over what doubling its reach (in gap) changes.
    wider_ratios : mapping
        Fraction of that error that is left when its reach is doubled.
    """

    orders: Mapping[str, float]
    window_limits: Mapping[str, float]
    wider_ratios: Mapping[str, float]


def change(before: Reading, after: Reading) -> dict[str, float]:
    """Relative change of each figure from one reading to another, without its sign."""
    return {name: abs(of) for name, of in _changes(before, after).items()}


def _changes(before: Reading, after: Reading) -> dict[str, float]:
    """Change of each figure from one reading to another over the size that it has then."""
    last = before.figures
    return {name: _ratio(value - last[name], abs(value)) for name, value in after.figures.items()}


def _ratio(change: float, size: float) -> float:
    """A change over a size, which may be zero, as that of friction without sliding."""
    if change == 0:
        return 0.0
    return change / size if size > 0 else float(np.copysign(np.inf, change))


STEEPEST_FALL = 8.0
"""Fall of the changes beyond which the last is small by chance: twice that of the second order."""

SAFETY = 1.25
"""Error bar over what changes that fall regularly promise: what Roache recommends of three grids (Annu. Rev.
Fluid Mech. 29, 1997, 123-160)."""


def grid_errors(readings: Sequence[Reading], orders: Mapping[str, float]) -> dict[str, float]:
    """Relative error of each figure on the last of grids of halving spacing.

    On two grids no fall of the changes is seen; then the larger change of both films is the error of all, or
    their own change if that is larger, `SAFETY` times.
    """
    if len(readings) == 1:
        return dict.fromkeys(readings[0].figures, np.inf)
    last = _changes(readings[-2], readings[-1])
    if len(readings) == 2:
        films = max(abs(last[name]) for name in FILMS)
        return {name: SAFETY * max(films, abs(of)) for name, of in last.items()}
    before = _changes(readings[-3], readings[-2])
    return {name: _grid_error(before[name], last[name], 2 ** orders[name]) for name in last}


def _grid_error(before: float, last: float, steepest: float) -> float:
    """Error that the last two changes of a figure leave, which fall by so much at most.

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
"""Nodes across a peak of pressure below which the grid does not resolve it (`docs/theory/film.md`)."""


def unresolved(reading: Reading) -> str | None:
    """Why nothing bounds the largest pressure on a grid; None where the grid resolves it.

    The changes between grids do not show it: as long as a spike is lower than the middle of the contact, the
    largest pressure stands still while the spike grows.
    """
    nodes = reading.peaks["pressure_max"].nodes
    return None if nodes >= LEAST_PEAK else f"unresolved pressure spike, {nodes:.1f} nodes wide"


SPIKE = 8.0
"""Nodes across the peak of the film's temperature up to which it is the tip of a spike: where the pressure
spikes, compression heats oil that flow has no time to cool, and the rise grows with the spike from grid to
grid (by a quarter at 2.6 nodes, by a twentieth at 5.7)."""


def hot_spike(reading: Reading) -> str | None:
    """Why the film's largest temperature is that of a spike; None where it is a broad one's, or not known."""
    peak = reading.peaks.get("temperature_max_film")
    if peak is None or peak.nodes >= SPIKE:
        return None
    return f"tip of a temperature spike, {peak.nodes:.1f} nodes wide"


def peak_errors(reading: Reading) -> dict[str, float]:
    """Relative error of the largest values of fields by how narrow their peaks are on the grid."""
    errors = {}
    for name, peak in reading.peaks.items():
        value = reading.figures[name]
        errors[name] = SAFETY * _ratio(max(peak.bound - value, 0.0), value)
    if unresolved(reading) is not None:
        errors["pressure_max"] = np.inf
    return errors


def domain_errors(
    this: Reading, wider: Reading, limits: Mapping[str, float], algebra: Mapping[str, float]
) -> dict[str, float]:
    """Relative error of each figure by the end of its window, from a window of twice the reach.

    Parameters
    ----------
    this, wider : Reading
        Figures in both windows.
    limits : mapping
        Error over the change seen (`Convergence.window_limits`).
    algebra : mapping
        Relative error of each figure in both windows together by their unfinished algebra, which may hide
        a change as large.
    """
    changes = change(wider, this)
    return {name: limits[name] * of + algebra[name] for name, of in changes.items()}


FIRST_CHANGE = 0.5
"""Change by a Newton step from which it belongs to no series yet, as where a film begins to warm."""

LEAST_FALL = 0.2
"""Ratio of a Newton step's change to that of the step before below which it is not believed: changes of
either sign may nearly cancel."""


MOST_FALL = 0.8
"""The same ratio beyond which no series is believed. Heat may settle as slowly as by four fifths a step."""


def algebra_errors(before: Mapping[str, float], last: Mapping[str, float]) -> dict[str, float]:
    """Relative error of each figure that is left after the last two Newton steps changed it so much.

    What later steps of a geometric series would still add, at most four times the last change; that change
    itself where the changes rise or have only begun. The fall of the residual says nothing here: it shows the
    roughest errors, and a step may divide it by ten while the central film, a smooth figure, is still on its
    way.
    """
    errors = {}
    for name in last:
        series = 0 < before[name] < FIRST_CHANGE
        fall = last[name] / before[name] if series else 1.0
        seen = min(max(fall, LEAST_FALL), MOST_FALL)
        errors[name] = last[name] * (seen / (1 - seen) if fall < 1 else 1.0)
    return errors
