"""Levels across a hot film, added until a film with more of them has the same figures.

The table of errors by which a plan chooses levels (`planning.model.LEVEL_ERRORS`) is that of films whose
viscosity hardly changes across them. Where a film is much warmer than its walls shear gathers in the hot
layer, which few levels miss: a film of 7 um that is 115 K warmer has 1.1 % less friction with 7 levels than
with 21, 0.4 % with 9 and 0.14 % with 11.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from pyworm.planning.plan import Plan
from pyworm.scene.contact import Contact
from pyworm.solver.contact import ContactSolver
from pyworm.solver.error_estimate import change
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import Level
from pyworm.solver.newton import ALGEBRA_FRACTION, Settled, settle
from pyworm.solver.stop_reason import film_is_sound
from pyworm.solver.transient.transient import Transient

WARM = 0.25
"""Decay of ln eta from the walls to the hottest oil from which levels are judged by a film with more of them:
of 16 thermal lines (`tests/hard/draws.py`, seed 7) those below have errors of at most 0.1 %."""

MORE, MOST = 2, 13
"""Levels added at a time, and the most there are."""

SHARE = 0.2
"""Error by the levels, as a share of the accuracy, at which there are enough."""

LEAST = 0.2
"""Least error of a figure, as a share of the largest change of any: one may stand still by chance."""


UNJUDGED = 0.02
"""Error of hot films of which none with more levels is found, above the largest seen, 1.2 % with 7."""


@dataclass(frozen=True)
class EnoughLevels:
    """A film with enough levels across it.

    Attributes
    ----------
    plan : Plan
        The plan with that number of levels.
    solver : ContactSolver
        Its solver.
    level : Level
        The film.
    settled : Settled
        Its figures.
    errors : dict
        Relative error of each figure by the levels [-].
    """

    plan: Plan
    solver: ContactSolver
    level: Level
    settled: Settled
    errors: dict[str, float]


def is_hot(scene: Contact, figures: Mapping[str, float]) -> bool:
    """Whether a heated film is so much warmer than its walls that few levels across it may not do."""
    first, second, film = (
        figures[f"temperature_max_{place}"] for place in ("body_1", "body_2", "film")
    )
    return scene.oil.beta * (film - (first + second) / 2) > WARM


def enough_levels(
    plan: Plan, level: Level, settled: Settled, transient: Transient | None
) -> EnoughLevels | None:
    """Add levels until figures change by little; None where no film with more of them is found.

    The last change is taken as the error: figures approach their limit irregularly.
    """
    found, scene = None, level.scene
    while plan.model.levels < MOST:
        plan = replace(plan, model=replace(plan.model, levels=plan.model.levels + MORE))
        rate = None if transient is None else transient.rate
        solver = SOLVERS[type(scene)](scene, plan, rate)
        level = solver.with_rate(level)
        before, wanted = settled.reading, ALGEBRA_FRACTION * plan.accuracy * SHARE
        settled = settle(level, plan.tolerance, plan.aim, wanted)
        if not film_is_sound(level, settled, plan):
            return found
        changed = change(before, settled.reading)
        worst = plan.aim.worst(changed, settled.reading.figures)
        errors = {name: max(of, LEAST * worst) for name, of in changed.items()}
        found = EnoughLevels(plan, solver, level, settled, errors)
        if worst <= SHARE * plan.accuracy:
            return found
    return found
