"""Time integration of wear: steps by their own error, each kept before the next begins.

A step predicts the worn depth with the rate at its beginning, has the rate there found anew, and corrects
the depth with the mean of both (Heun's rule with one new rate a step). Half the difference of both is the
step's error.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

Array = np.ndarray

MAX_STEP_GROWTH = 2.0
"""Most by which a step is longer than the one before."""

SAFETY = 0.8
"""Step over the one that would just meet the tolerance."""

MIN_STEP = 1e-3
"""Shortest step, over the time to integrate, that is still halved."""


class UnsolvedError(ValueError):
    """Contacts of a worn flank that could not be solved."""


@dataclass(frozen=True)
class Worn:
    """A flank at a time."""

    hours: float
    """Time [h]."""
    depth: Array
    """Worn off [m]."""
    rate: Array
    """Wear then [m/h]."""
    step: float
    """Step to try next [h]."""


Rates = Callable[[Array], Array]
"""Worn depth [m] -> rate of wear [m/h]; solves the contacts of the flank so worn, UnsolvedError without."""


def first_step(rate: Array, tolerance: float) -> float:
    """Step that wears off twice the tolerance at most [h]."""
    fastest = float(rate.max())
    return np.inf if fastest <= 0 else 2 * tolerance / fastest


def integrate_wear(
    start: Worn,
    until: float,
    rates: Rates,
    tolerance: float,
    keep: Callable[[Worn, float], None] = lambda worn, error: None,
    deepest: float = np.inf,
    relative: float = 0.0,
) -> Worn:
    """Integrate the wear of a flank to a time [h].

    `keep` is called with the end of each step and its error [m] before the next begins; from such an end an
    integration continues as if it had not been stopped. The error of a step may be `tolerance` [m] plus
    `relative` times the largest depth. The integration ends before a step that would go deeper than `deepest`
    [m]. UnsolvedError for what `rates` raises in the shortest step, and for rates that are not finite; longer
    steps are shortened.
    """
    _finite(start.rate)
    worn = start
    shortest = MIN_STEP * (until - start.hours)
    while worn.hours < until * (1 - 1e-12):
        step = min(worn.step, until - worn.hours)
        if float((worn.depth + worn.rate * step).max()) > deepest:
            break
        try:
            rate = _finite(rates(worn.depth + worn.rate * step))
        except UnsolvedError:
            if step <= 2 * shortest:
                raise
            worn = Worn(worn.hours, worn.depth, worn.rate, step / 4)
            continue
        error = float(np.abs(rate - worn.rate).max() * step / 2)
        allowed = tolerance + relative * float(worn.depth.max())
        wanted = step * SAFETY * np.sqrt(allowed / max(error, 1e-3 * allowed))
        if error > allowed and step > shortest:
            worn = Worn(worn.hours, worn.depth, worn.rate, max(wanted, step / 5))
            continue
        depth = worn.depth + (worn.rate + rate) / 2 * step
        worn = Worn(worn.hours + step, depth, rate, min(wanted, MAX_STEP_GROWTH * step))
        keep(worn, error)
    return worn


def _finite(rate: Array) -> Array:
    """A rate of wear known everywhere; UnsolvedError otherwise, as no comparison with its error is true."""
    if not np.isfinite(rate).all():
        unknown_cells = rate.size - int(np.isfinite(rate).sum())
        raise UnsolvedError(
            f"the rate of wear is not known in {unknown_cells} of {rate.size} cells"
        )
    return rate
