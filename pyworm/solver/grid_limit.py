"""Figures in the limit of infinitely fine grids, and their discretisation errors."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyworm.solver.error_estimate import (
    Convergence,
    Reading,
    changes,
    grid_errors,
    largest_of_films,
)

SECOND_ORDER_FALLS = (2.0, 8.0)
"""Falls of a figure's change from grid to grid at which its convergence is believed to be of second order, a
fall by 4: of 118 central films 116 fell by 3 to 5; minimum films fall by up to 8 while their place
settles. Where changes fell by 2 to 3 the limit was off by 0.02 to 0.17 of the last one in all of 13 pairs,
the figure on the last grid by 0.16 to 0.45."""


REGULAR_SHARE = 0.75
"""Least regular fall over the least credible one, where that is below 2: of first order 1.5."""


@dataclass(frozen=True)
class GridLimit:
    """A figure in the limit of infinitely fine grids."""

    value: float
    """The extrapolated figure, or that of the last grid where its changes promise no limit."""
    error: float
    """Its relative discretisation error."""


def second_order_limit(coarse: float, fine: float) -> float:
    """Limit of a figure from two grids of halving spacing, whose errors are as 4 to 1."""
    return fine + (fine - coarse) / 3


def mixed_order_limit(values: Sequence[float], falls: tuple[float, float]) -> float:
    """Limit of a figure on grids of halving spacing, the finest last, with errors A s + B s^2 of the spacing.

    With the last change d and the ratio f of the one before to it, of which `falls` are the bounds and, on
    two grids, the mean, the limit is d (5 - f)/3 beyond the last value: d at first order (f = 2), d/3 at
    second (f = 4).
    """
    change = values[-1] - values[-2]
    fall = sum(falls) / 2
    if len(values) > 2 and change != 0:
        fall = float(np.clip((values[-2] - values[-3]) / change, *falls))
    return values[-1] + change * (5 - fall) / 3


def grid_limits(readings: Sequence[Reading], convergence: Convergence) -> dict[str, GridLimit]:
    """Each figure in the limit of grids of halving spacing, by Richardson's extrapolation.

    The limit is the last value plus a third of the last change (second order; Roache, Annu. Rev. Fluid Mech.
    29, 1997, 123-160), more where errors may fall by less than 4 (`Convergence.falls`). On two grids its
    error is a share of its change, or of the films' (`Convergence.left`), and by how much the limit depends
    on the order; on more it is a share of the change of the limit itself since the grid before, if the
    changes fall regularly. Figures that are not extrapolated keep their value, with the errors of
    `grid_errors`.
    """
    plain = grid_errors(readings, convergence.orders, convergence.kept)
    last = readings[-1].figures
    limits = {name: GridLimit(last[name], plain[name]) for name in last}
    if len(readings) > 1:
        for name in convergence.left:
            if name in last:
                limits[name] = _limit(name, readings, convergence, limits[name])
    return limits


def _limit(
    name: str, readings: Sequence[Reading], convergence: Convergence, plain: GridLimit
) -> GridLimit:
    """The limit of one figure; `plain` where its changes do not fall regularly."""
    left, falls = convergence.left[name], convergence.falls
    values = [reading.figures[name] for reading in readings[-4:]]
    limit, change = mixed_order_limit(values, falls), values[-1] - values[-2]
    if len(values) == 2:
        moved = changes(*readings[-2:])
        unknown_order = (falls[1] - falls[0]) / 6 * abs(moved[name])
        return GridLimit(
            limit, unknown_order + left.of_changes(moved[name], largest_of_films(moved))
        )
    before = values[-2] - values[-3]
    least, most = min(SECOND_ORDER_FALLS[0], REGULAR_SHARE * falls[0]), SECOND_ORDER_FALLS[1]
    if not least * abs(change) <= before * np.sign(change) <= most * abs(change):
        return plain
    earlier = mixed_order_limit(values[:-1], falls)
    error = max(left.limit * abs(limit - earlier), left.least * abs(change))
    return GridLimit(limit, error / abs(limit) if limit else plain.error)
