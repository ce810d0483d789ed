"""How far Newton's iteration goes in the films of a transient solve."""

from dataclasses import dataclass

from pyworm.solver.level import Level
from pyworm.solver.newton import MOST_STEPS, iterate
from pyworm.solver.transient.time_grid import TimeGrid
from pyworm.solver.transient.time_steps import Step

TOLERANCE = 0.06
"""Residual of the films over the square of the time step in passages of oil through the contact: half the
step halves what Newton's iteration leaves in a rate of change, which a film sums up along the flow.

In transits of the time grid, of which a passage is up to 13 where a life lasts two passages (drive 0 of seed
99020 of `tests/hard`), friction by two solves differs by 56 % at phase 0.7, so by 20 %, at a sixth more
time."""

TOLERANCE_RATIO_WITHOUT_APPROACH = 0.1
"""Tolerance of other courses over that where surfaces come together.

A film with a given rate of change sums up along the flow what that is off by, and the residual is a share of
the flow far out, where gaps are tens of films high. Under a load that rises fourfold and falls back within a
transit (M = 1000) such films were off by 5 % with the whole tolerance, by 0.5 % with a tenth, at a fifth more
time. Where surfaces come together films are thick for long, and tell no difference beyond their bars: up to
phase 0.3 the first solve of `cases/zi_drive.toml` moves by 6 %."""

TEMPERATURE_CHANGE = 1e-2
"""Last change of their temperatures over the largest rise. The heat of the instants is steady and keeps no
errors; in a rate of change they are divided by a time step, but the oil follows within microseconds."""

FORCING, HEATED_TOLERANCE_RATIO, JUDGED_PRESSURE = 1e-2, 2.0, 0.1
"""Residual, over the present one, to which Newton steps of heated films solve the linear system where
surfaces come together, tolerance of these films over that of others, and pressure, over the largest, where
their temperatures are judged.

A sweep of heat costs more than all else in a step, and a step so exact takes the place of two
(`benchmarks/accuracy/motion_iteration.py`, seven phases of `cases/zi_drive.toml`): with a tenth, the whole
tolerance and temperatures that are not extrapolated the iteration leaves up to 1.5 % in the minimum film by
the second solve in 416 Newton steps, so 0.8 % in 269. The first has the tolerance of the second, and 0.13 %
(1.3 %). Nodes that enter the contact have no temperature to go on from, and would ask for a second step at
every time."""


@dataclass(frozen=True)
class Settling:
    """How far Newton's iteration goes in a film."""

    tolerance: float
    """Residual."""
    exact: bool = False
    """Whether its steps are exact, and temperatures judged above `JUDGED_PRESSURE`."""

    @property
    def forcing(self) -> float | None:
        """That of its steps, as of `newton.newton_step`."""
        return FORCING if self.exact else None

    def iterated(self, level: Level, most: int = MOST_STEPS) -> int:
        """Make further Newton steps of a film, at most so many; their number."""
        return len(iterate(level, self.tolerance, TEMPERATURE_CHANGE, most, self.forcing))


def settling_of(time_grid: TimeGrid, step: Step) -> Settling:
    """How far it goes in the film of a step of a transient solve."""
    tolerance = TOLERANCE * _passages(time_grid, step.seconds, step.refinement) ** 2
    if time_grid.approach is None:
        return Settling(TOLERANCE_RATIO_WITHOUT_APPROACH * tolerance)
    if not time_grid.plan.model.heated:
        return Settling(tolerance)
    tolerance = TOLERANCE * _passages(time_grid, step.seconds, max(step.refinement, 1)) ** 2
    return Settling(HEATED_TOLERANCE_RATIO * tolerance, exact=True)


def _passages(time_grid: TimeGrid, seconds: float, refinement: int) -> float:
    """Passages of oil through the contact in a time step at a time [s]."""
    return time_grid.step(refinement) * time_grid.passages_of_transit(seconds)
