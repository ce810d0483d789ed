"""Figures in the limit of infinitely fine grids, and their discretisation errors."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyworm.solver.error_estimate import (
    Convergence,
    Left,
    Reading,
    changes,
    grid_errors,
    largest_of_films,
)

REGULAR = (2.0, 8.0)
"""Falls of a figure's change from grid to grid at which its convergence is believed to be of second order, a
fall by 4: of 118 central films 116 fell by 3 to 5; minimum films fall by up to 8 while their place
settles. Where changes fell by 2 to 3 the limit was off by 0.02 to 0.17 of the last one in all of 13 pairs,
the figure on the last grid by 0.16 to 0.45."""


@dataclass(frozen=True)
class GridLimit:
    """A figure in the limit of infinitely fine grids.

    Attributes
    ----------
    value : float
        The extrapolated figure, or that of the last grid where its changes promise no limit.
    error : float
        Its relative discretisation error.
    """

    value: float
    error: float


def second_order_limit(coarse: float, fine: float) -> float:
    """Limit of a figure from two grids of halving spacing, whose errors are as 4 to 1."""
    return fine + (fine - coarse) / 3


def grid_limits(readings: Sequence[Reading], convergence: Convergence) -> dict[str, GridLimit]:
    """Each figure in the limit of grids of halving spacing, by Richardson's extrapolation.

    Parameters
    ----------
    readings : sequence of Reading
        Figures on the grids, the finest last.
    convergence : Convergence
        Orders of convergence, and which figures are extrapolated.

    Notes
    -----
    The limit is the last value plus a third of the last change (second order; Roache, Annu. Rev. Fluid Mech.
    29, 1997, 123-160). On two grids its error is a share of its change, or of the films'
    (`Convergence.left`); on more it is a share of the change of the limit itself since the grid before, if
    the changes fall regularly. Figures that are not extrapolated keep their value, with the errors of
    `grid_errors`.
    """
    plain = grid_errors(readings, convergence.orders, convergence.kept)
    last = readings[-1].figures
    limits = {name: GridLimit(last[name], plain[name]) for name in last}
    if len(readings) > 1:
        for name, left in convergence.left.items():
            if name in last:
                limits[name] = _limit(name, left, readings, limits[name])
    return limits


def _limit(name: str, left: Left, readings: Sequence[Reading], plain: GridLimit) -> GridLimit:
    """The limit of one figure; `plain` where its changes do not fall regularly."""
    values = [reading.figures[name] for reading in readings[-3:]]
    change = values[-1] - values[-2]
    limit = second_order_limit(*values[-2:])
    if len(values) == 2:
        moved = changes(*readings[-2:])
        return GridLimit(limit, left.of_changes(moved[name], largest_of_films(moved)))
    before = values[1] - values[0]
    if not REGULAR[0] * abs(change) <= before * np.sign(change) <= REGULAR[1] * abs(change):
        return plain
    earlier = second_order_limit(*values[:2])
    error = max(left.limit * abs(limit - earlier), left.least * abs(change))
    return GridLimit(limit, error / abs(limit) if limit else plain.error)
