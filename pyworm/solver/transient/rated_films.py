"""Films of the present on one grid with the rate of change of each transient solve, and what error is left.

On the first grid of the figures they follow one from the other. Where the entrainment has turned round, or
has started from rest, the film of that time is a dip as narrow as the cells of that grid, which makes much
of what the solves differ by: on finer ones, down to the spacing of the last solve, they are those of the
figures. For `past:4` of `tests/hard`, with the usual number of time steps, the minimum film thickness by the
last two of four solves is 3.25 and 2.84 um on 73 x 65 nodes, 4.88 and 4.84 um on 289 x 257
(`benchmarks/accuracy/turned_steps.py --solves 4`).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import prod

from pyworm.planning import error_budget
from pyworm.planning.plan import Plan
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.any_contact import AnyContact
from pyworm.solver.error_estimate import Reading
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import Level, TransientTerm
from pyworm.solver.memory import shortage
from pyworm.solver.newton import converge
from pyworm.solver.transient.extrapolated_rate import ExtrapolatedRate, share_left
from pyworm.solver.transient.rate_errors import rate_errors
from pyworm.solver.transient.tied_rate import TiedRate
from pyworm.solver.transient.time_integration import RateOfChange

SolvedRate = RateOfChange | TiedRate
"""A rate of change by a transient solve."""


@dataclass(frozen=True)
class RatedFilms:
    """Films on one grid: steady, with each rate of change, and with the last, which may be extrapolated."""

    scene: AnyContact
    """The contact."""
    plan: Plan
    """Its plan."""
    found: tuple[SolvedRate, ...]
    """Rates of change of each transient solve, the finest last."""
    slow: bool
    """Whether films settle slowly (`transient._settles_slowly`)."""
    level: Level
    """The film with the last rate."""
    rate: TransientTerm
    """The last rate."""
    readings: tuple[Reading, ...]
    """Figures of the steady film and with the rate of each solve."""
    figures: dict[str, float]
    """Figures with the last rate."""
    errors: dict[str, float]
    """Relative error of the figures by grids and time steps of the transient solves."""
    imbalance: float
    """Largest residual or load error of these films."""

    @property
    def film_error(self) -> float:
        """Largest of these errors, of films and friction."""
        return self.plan.target.without(*HEAT_FIGURES).worst(self.errors, self.figures)

    @property
    def heat_error(self) -> float:
        """Largest of them, of temperatures as well."""
        return self.plan.target.worst(self.errors, self.figures)

    @property
    def within(self) -> bool:
        """Whether it is within the share of the accuracy that is its."""
        return self.heat_error <= error_budget.TIME * self.plan.accuracy

    def finer(self) -> "RatedFilms | None":
        """Those on the grid of half the spacing.

        None where it is finer than that of the last solve, larger than the plan or memory allows, or where a
        film is not found.
        """
        finer = self.level.grid.finer()
        short = shortage(finer, self.plan.model, stores=True) is not None
        if self.level.diverged() or finer.nodes > self.plan.largest_grid or short:
            return None
        if prod(finer.spacing) < prod(self.found[-1].grid.spacing):
            return None
        level, _ = SOLVERS[type(self.scene)](self.scene, self.plan, self.rate).refined(self.level)
        films = rated_films(self.scene, self.plan, self.found, self.slow, level)
        return films if films.imbalance <= self.plan.tolerance else None

    def with_rate(self, rate: TransientTerm) -> Level:
        """The film on this grid with the last rate, which may be extrapolated otherwise."""
        level, _ = _film_with(self.scene, self.plan, self.level, rate)
        return level


def rated_films(
    scene: AnyContact, plan: Plan, found: Sequence[SolvedRate], slow: bool, level: Level
) -> RatedFilms:
    """The films of a steady or transient film's grid with each of some rates of change."""
    readings: list[Reading] = []
    imbalances: list[float] = []
    for rate in (None, *found):
        level, reading = _film_with(scene, plan, level, rate)
        readings.append(reading)
        imbalances.append(level.film.balance.worst)
    last: TransientTerm = found[-1]
    extrapolated, share = None, 0.0 if slow else share_left(readings[1:], plan.target)
    if share > 0:
        last = ExtrapolatedRate(found[-2], found[-1], share)
        level, extrapolated = _film_with(scene, plan, level, last)
    errors = rate_errors(readings, extrapolated, share, plan.work.kind, slow, plan.target)
    figures = (extrapolated or readings[-1]).figures
    read = tuple(readings), figures, errors, max(*imbalances, level.film.balance.worst)
    return RatedFilms(scene, plan, tuple(found), slow, level, last, *read)


def _film_with(
    scene: AnyContact, plan: Plan, level: Level, rate: TransientTerm | None
) -> tuple[Level, Reading]:
    """A film with a rate of change, on the grid and from the film of another, and its figures.

    Between rough surfaces one that is not found from there, as the steady film may be far from it, begins
    with the dry contact.
    """
    if rate is None and level.transient_term is None:
        return level, _reading_of(plan, level)
    solver = SOLVERS[type(scene)](scene, plan, rate)
    moving = solver.with_rate(level)
    reading = _reading_of(plan, moving)
    if moving.diverged() and (dry := solver.from_dry(level)) is not None:
        moving, reading = dry, _reading_of(plan, dry)
    return moving, reading


def _reading_of(plan: Plan, level: Level) -> Reading:
    """The figures of a film after Newton's iteration: after two steps at least.

    A rate that changes little leaves less than the tolerance, but not nothing.
    """
    return converge(
        level, plan.tolerance, plan.target, error_budget.ALGEBRA * plan.accuracy
    ).reading
