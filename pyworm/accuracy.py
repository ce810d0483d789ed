"""How far a figure may be from the truth: by its grid, by its window, by its unfinished algebra."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np


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
    further : dict
        Figures of a sheared film (`SHEAR_FIGURES`) and of a heated one (`HEAT_FIGURES`), temperatures above
        the inlet's [K].
    """

    film_min: float
    film_central: float
    pressure_max: float
    film_min_at: tuple[float, ...]
    further: dict[str, float] = field(default_factory=dict)

    @property
    def figures(self) -> dict[str, float]:
        """All figures by name."""
        return {name: getattr(self, name) for name in FIGURES} | self.further


FILMS = ("film_min", "film_central")

FIGURES = (*FILMS, "pressure_max")

SHEAR_FIGURES = ("friction_coefficient", "power_loss", "shear_rate_max")

HEAT_FIGURES = ("temperature_max_body_1", "temperature_max_body_2", "temperature_max_film")


@dataclass(frozen=True)
class Aim:
    """The figures whose error bars an accuracy is asked of.

    The largest pressure is never among them: under light loads it is the tip of a spike at the exit, which no
    practicable grid resolves.

    Attributes
    ----------
    figures : tuple of str
        Their names.
    warmth : float
        Temperature difference to which errors of temperatures are relative where the rise is smaller [K].
    """

    figures: tuple[str, ...]
    warmth: float = 0.0

    def worst(self, errors: Mapping[str, float], figures: Mapping[str, float]) -> float:
        """The largest of relative errors of figures, temperatures among these as rises [K]."""
        return max(errors[name] * self._weight(name, figures[name]) for name in self.figures)

    def _weight(self, name: str, value: float) -> float:
        if name not in HEAT_FIGURES or value >= self.warmth:
            return 1.0
        return max(value, 0.0) / self.warmth


@dataclass(frozen=True)
class Convergence:
    """How the figures of a kind of contact come near the truth.

    Attributes
    ----------
    orders : mapping
        The highest order to believe in by which each figure converges with the spacing.
    window_limit : float
        Error of a window over what doubling its reach (in gap) changes.
    wider_share : float
        Share of a window's error that is left when its reach is doubled.
    """

    orders: Mapping[str, float]
    window_limit: float
    wider_share: float


def change(before: Reading, after: Reading) -> dict[str, float]:
    """Relative change of each figure from one reading to another."""
    last = before.figures
    return {
        name: _share(abs(value - last[name]), abs(value)) for name, value in after.figures.items()
    }


def _share(change: float, of: float) -> float:
    """A change over a figure, which may be nought, as friction without sliding."""
    if change == 0:
        return 0.0
    return change / of if of > 0 else np.inf


def grid_errors(readings: Sequence[Reading], orders: Mapping[str, float]) -> dict[str, float]:
    """Relative error of each figure on the last of grids of halving spacing.

    The last change, or a quarter of the one before if that is larger (a figure may stand still by chance),
    divided by what the observed fall of the changes promises: at second order three quarters of the error are
    gone at each grid. On two grids no fall is seen; then the larger change of both films is the error of all.
    """
    if len(readings) == 1:
        return dict.fromkeys(readings[0].figures, np.inf)
    last = change(readings[-2], readings[-1])
    if len(readings) == 2:
        films = max(last[name] for name in FILMS)
        return {name: max(films, of) for name, of in last.items()}
    before = change(readings[-3], readings[-2])
    errors = {}
    for name in last:
        steepest = 2 ** orders[name]
        fall = np.clip(before[name] / last[name], 2.0, steepest) if last[name] > 0 else steepest
        errors[name] = float(max(last[name], before[name] / 4) / (fall - 1))
    return errors


def domain_errors(this: Reading, wider: Reading, limit: float) -> dict[str, float]:
    """Relative error of each figure by the end of its window, from a window of twice the reach.

    `limit` is that error over the change seen (`Convergence.window_limit`).
    """
    return {name: limit * of for name, of in change(wider, this).items()}


LEAST_FALL = 0.2
"""Ratio of a Newton step's change to that of the step before below which it is not believed: changes of
either sign may nearly cancel."""


def algebra_errors(before: Mapping[str, float], last: Mapping[str, float]) -> dict[str, float]:
    """Relative error of each figure that is left after the last two Newton steps changed it so much.

    What later steps of a geometric series would still add; the whole last change where the changes do not
    fall by half. The fall of the residual says nothing here: it shows the roughest errors, and a step may
    divide it by ten while the central film, a smooth figure, is still on its way.
    """
    errors = {}
    for name in last:
        fall = max(last[name] / before[name], LEAST_FALL) if before[name] > 0 else 1.0
        errors[name] = last[name] * (fall / (1 - fall) if fall < 0.5 else 1.0)
    return errors
