"""Extrapolation of figures over grids: limit, observed order, uncertainty."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, log2

LOWEST, HIGHEST = 1.0, 2.0
"""Orders between which an extrapolation is believed; the schemes are of second order."""

SURE = 0.1
"""Error of an extrapolation, as a fraction of the step that it makes, at least."""


@dataclass(frozen=True)
class Limit:
    """A figure on an infinitely fine grid.

    Attributes
    ----------
    value : float
        Its value, in its unit.
    error : float
        How far that may be off, in the same unit.
    order : float or None
        Order seen on the last three grids; None where the changes do not fall from grid to grid.
    """

    value: float
    error: float
    order: float | None


def observed_order(values: Sequence[float]) -> float | None:
    """Observed order from the last three values on grids of halving spacing; None where they diverge."""
    if len(values) < 3:
        return None
    before, last = values[-2] - values[-3], values[-1] - values[-2]
    return log2(before / last) if last != 0 and before / last > 1 else None


def limit(values: Sequence[float]) -> Limit:
    """Richardson's extrapolation of values on grids of halving spacing.

    The step beyond the finest grid is d/(2^p - 1), d the last change and p the order seen, kept between the
    least and the largest believed. Its error is half of what the same step one grid earlier was off by, a
    tenth of the step at least; half of the step on three grids, all of it where no order is seen.
    """
    if len(values) == 1:
        return Limit(values[0], inf, None)
    order = observed_order(values)
    value, step = _beyond(values)
    if order is None:
        return Limit(value, max(abs(step), abs(values[-1] - values[-2]) / 3), None)
    if len(values) == 3:
        return Limit(value, abs(step) / 2, order)
    earlier, _ = _beyond(values[:-1])
    return Limit(value, max(SURE * abs(step), min(abs(step), abs(value - earlier) / 2)), order)


def _beyond(values: Sequence[float]) -> tuple[float, float]:
    """The extrapolated value and the step to it."""
    order = observed_order(values)
    believed = HIGHEST if order is None else min(max(order, LOWEST), HIGHEST)
    step = (values[-1] - values[-2]) / (2**believed - 1)
    return values[-1] + step, step
