"""Extrapolation of figures over grids: limit, observed order, uncertainty."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, log2

MIN_ORDER, MAX_ORDER = 1.0, 2.0
"""Bounds of the order in an extrapolation; the schemes are of second order."""

MIN_RELATIVE_ERROR = 0.1
"""Least error of an extrapolation, as a fraction of its step."""


@dataclass(frozen=True)
class Limit:
    """A figure on an infinitely fine grid."""

    value: float
    """Extrapolated value, in its unit."""
    error: float
    """Uncertainty of the value, in the same unit."""
    order: float | None
    """Observed order on the last three grids; None where the changes do not fall from grid to grid."""


def observed_order(values: Sequence[float]) -> float | None:
    """Observed order from the last three values on grids of halving spacing; None where they diverge."""
    if len(values) < 3:
        return None
    before, last = values[-2] - values[-3], values[-1] - values[-2]
    return log2(before / last) if last != 0 and before / last > 1 else None


def limit(values: Sequence[float]) -> Limit:
    """Richardson's extrapolation of values on grids of halving spacing.

    The step beyond the finest grid is d/(2^p - 1), d the last change and p the observed order, limited to
    `MIN_ORDER` and `MAX_ORDER`. Its error is half the error of the same step one grid earlier, at least a
    tenth of the step; half the step on three grids, the whole step where no order is observed.
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
    return Limit(
        value, max(MIN_RELATIVE_ERROR * abs(step), min(abs(step), abs(value - earlier) / 2)), order
    )


def _beyond(values: Sequence[float]) -> tuple[float, float]:
    """The extrapolated value, and the step to it from the last."""
    order = observed_order(values)
    believed = MAX_ORDER if order is None else min(max(order, MIN_ORDER), MAX_ORDER)
    step = (values[-1] - values[-2]) / (2**believed - 1)
    return values[-1] + step, step
