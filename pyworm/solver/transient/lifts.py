"""How much farther transient films hold bodies apart than dry ones, from a transient solve of a life.

The lift is the rigid film plus the approach of the dry contact on the same grid. Pressure far in front of a
contact, beyond the window of a life, pushes bodies apart by a tenth of the lift.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from pyworm.planning.line_grid import LineGrid
from pyworm.scene.line import LineScene
from pyworm.scene.scales import scales
from pyworm.solver.point.level import dry_contact
from pyworm.solver.transient.next_film import contact_at, steady_level
from pyworm.solver.transient.time_grid import TimeGrid
from pyworm.solver.transient.time_records import TimeRecord
from pyworm.solver.transient.time_steps import Step


@dataclass(frozen=True)
class Lift:
    """How far a film holds bodies apart, and what it loses."""

    distance: float
    """The lift [m]."""
    friction: float = 0.0
    """Friction coefficient [-]; 0 where the flow law of the oil is not known."""
    loss: float = 0.0
    """Work of the friction [W], likewise."""


def mean_friction(lifts: Iterable[Lift]) -> float | None:
    """Friction coefficient by which some films together lose what they do; None where it is not known."""
    rubbing = [lift for lift in lifts if lift.friction > 0]
    slid = sum(lift.loss / lift.friction for lift in rubbing)
    return sum(lift.loss for lift in rubbing) / slid if slid > 0 else None


def moving_lift(
    time_grid: TimeGrid, seconds: float, rigid_film: float, records: Sequence[TimeRecord]
) -> Lift:
    """Lift by the transient film of a life of point contacts at a time [s].

    Args:
        time_grid: Time grid of the life.
        seconds: The time [s].
        rigid_film: Rigid film of a transient solve there [m].
        records: What that found, of which the nearest gives friction and loss.
    """
    figures = min(records, key=lambda record: abs(record.seconds - seconds)).figures
    return Lift(rigid_film + _approach(time_grid, seconds), *_friction(figures))


def _friction(figures: Mapping[str, float]) -> tuple[float, float]:
    """Friction coefficient and loss [W] among the figures of a film."""
    return figures.get("friction_coefficient", 0.0), figures.get("power_loss", 0.0)


def steady_lift(time_grid: TimeGrid, seconds: float) -> Lift:
    """Lift by the steady film of a point contact at a time [s], in the window of its life.

    NoFilmError if there is none.
    """
    level, _ = steady_level(time_grid, Step(seconds, 0))
    distance = level.film.rigid_film + _approach(time_grid, seconds)
    return Lift(distance, *_friction(level.read().figures))


def _approach(time_grid: TimeGrid, seconds: float) -> float:
    """Approach of the dry bodies at a time, on the first moving grid [m]."""
    contact, grid = contact_at(time_grid, seconds), time_grid.grid(seconds, 0)
    if isinstance(contact, LineScene) or isinstance(grid, LineGrid):
        raise TypeError("the separation is that of a point contact")
    x, y = grid.mesh()
    gap, covered = contact.gap(x, y)
    guess = scales(contact).hertz.pressure(x, y)
    return dry_contact(contact, grid, gap, covered, guess).approach
