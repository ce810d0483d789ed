"""The film at one time of a transient solve, and what follows from some of them for another time."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.io.present import present
from pyworm.solver.level import InitialGuess, Level
from pyworm.solver.transient.differences import weights

MIN_PRESSURE_RATIO = 0.5
"""Least pressure of a first guess, over the last one. Where a smaller window cuts off the oil that flanks
press out, pressures extrapolated to nothing rupture the film, and Newton's iteration wets it again node by
node."""

EXTRAPOLATED_PRESSURE = 0.02
"""Pressure, over the largest, above which temperatures are extrapolated: those of far nodes settle slowly,
and extrapolated they run away."""


@dataclass(frozen=True)
class TimeLevel:
    """The film at one time, and what its surfaces remember."""

    seconds: float
    """The time [s]."""
    content: Array
    """Oil at the nodes: film thickness times relative density, as far as the gap is filled [m]."""
    state: InitialGuess
    """Pressure, rigid film and temperatures."""
    rise: Array | None = None
    """What both surfaces are warmer by than in steady conduction (`heat_memory`), body along the last axis
    [K]; None where that is not known."""
    limited: bool = False
    """Whether its rate of change is limited anywhere under pressure (`backward_term`)."""

    def finer(self, window: Any = np.s_[...]) -> "TimeLevel":
        """Interpolated to nodes of half the spacing within a window."""
        rise = None if self.rise is None else kernel.prolong_levels(self.rise[window])
        content = kernel.prolong(self.content[window])
        return replace(self, content=content, state=self.state.finer(window), rise=rise)


def time_level_of(level: Level, seconds: float) -> TimeLevel:
    """What later films need of the one at a time."""
    term = level.transient_term
    rise = None if term is None else term.remembered(level.grid)
    return TimeLevel(seconds, content_of(level), level.state(), rise, is_limited(level))


def is_limited(level: Level) -> bool:
    """Whether the rate of change of a film is limited anywhere under pressure."""
    term = level.transient_term
    return term is not None and bool(np.any(term.limited & (level.film.pressure > 0)))


def content_of(level: Level) -> Array:
    """Oil at the nodes of a level [m]: film thickness times relative density, as far as the gap is filled."""
    film, density, _ = level.film.fields()
    return level.film.fraction() * density * film


def extrapolated(before: Sequence[TimeLevel], seconds: float, warmed: bool) -> InitialGuess:
    """A film extrapolated from those at earlier times, the latest first; only where that bears pressure.

    Pressures fall to no less than `MIN_PRESSURE_RATIO` of the latest. Temperatures are extrapolated if
    `warmed`, else the latest.
    """
    latest = before[0].state
    coefficients, _ = weights([time_level.seconds for time_level in before], seconds)

    def onward(name: str) -> Array:
        parts = zip(coefficients, before, strict=True)
        return np.asarray(
            sum(weight * getattr(time_level.state, name) for weight, time_level in parts)
        )

    oil = present(latest.oil, "pressure of the oil")
    pressure, oil = (
        np.where(last > 0, np.maximum(onward(name), MIN_PRESSURE_RATIO * last), 0.0)
        for name, last in (("pressure", latest.pressure), ("oil", oil))
    )
    rise = _rise_onward(before, seconds) if warmed else latest.rise
    return InitialGuess(pressure, float(onward("rigid_film")), rise, oil)


def _rise_onward(before: Sequence[TimeLevel], seconds: float) -> Array | None:
    """Temperatures by the last two films in the contact (`EXTRAPOLATED_PRESSURE`); elsewhere the latest."""
    latest = before[0].state
    if latest.rise is None or len(before) < 2 or before[1].state.rise is None:
        return latest.rise
    (now, then), _ = weights([film.seconds for film in before[:2]], seconds)
    onward = now * latest.rise + then * before[1].state.rise
    pressed = latest.pressure > EXTRAPOLATED_PRESSURE * latest.pressure.max()
    return np.where(pressed[..., np.newaxis], onward, latest.rise)
