"""The rate of change of a film's oil in the limit of small spacing and time steps (Richardson 1911).

Transient solves halve both. Where their films converge with an order, so do their rates of change, and what
the last one is off is a share of what it differs from the one before: a third at second order, all of it at
first, where edges or kinks of the load pass. The order is seen in films by three solves: where flanks come
together on an edge (drive 3 of seed 99005 of `tests/hard`, phase 0.1) 0.214, 0.244 and 0.259 um.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.target import AccuracyTarget
from pyworm.solver.error_estimate import Reading, changes
from pyworm.solver.transient.tied_rate import TiedRate
from pyworm.solver.transient.time_integration import RateOfChange

SECOND_ORDER, FIRST_ORDER = 1 / 3, 1.0
"""Share of the last change that is left, at either order."""

MAX_FALL = 0.75
"""Ratio of successive changes from which on films do not converge with an order that is seen."""


def share_left(readings: Sequence[Reading], target: AccuracyTarget) -> float:
    """Share of the last change of rates that is left, by figures of films with each of them; 0 if unknown.

    Their order is seen in the sum of the changes of all figures that are asked for; there is none to be seen
    where they have another sign than those before.
    """
    if len(readings) < 3:
        return 0.0
    earlier, later = (
        np.array([changes(*pair)[name] for name in target.figures])
        for pair in (readings[-3:-1], readings[-2:])
    )
    before, last = np.abs(earlier).sum(), np.abs(later).sum()
    if not last < MAX_FALL * before or earlier @ later < 0:
        return 0.0
    return float(np.clip(last / (before - last), SECOND_ORDER, FIRST_ORDER))


@dataclass(frozen=True)
class ExtrapolatedRate:
    """d(rho h)/dt and remembered heat of two transient solves, extrapolated; a `level.TransientTerm`."""

    coarse: RateOfChange | TiedRate
    """That of the solve before."""
    fine: RateOfChange | TiedRate
    """That of the last one."""
    share: float
    """Share of their difference that is left (`share_left`)."""

    @property
    def limited(self) -> bool:
        """Whether the rates are limited anywhere in the contact: never, where they are extrapolated."""
        return False

    def on(self, grid: Grid | LineGrid) -> tuple[float, Array]:
        """Implicit [1/s] and explicit part [m/s] at nodes of a grid."""
        (implicit, fine), (_, coarse) = self.fine.on(grid), self.coarse.on(grid)
        return implicit, fine + self.share * (fine - coarse)

    def remembered(self, grid: Grid | LineGrid) -> Array | None:
        """What both surfaces are warmer by at nodes of a grid [K]."""
        fine, coarse = self.fine.remembered(grid), self.coarse.remembered(grid)
        if fine is None or coarse is None:
            return fine
        return fine + self.share * (fine - coarse)

    def stored(self, grid: Grid | LineGrid) -> kernel.HeatStorage | None:
        """Rates of change of the oil's temperature and pressure at nodes of a grid, of the last solve."""
        return self.fine.stored(grid)
