"""Levels across a hot film, added until a film with more of them has the same figures.

The table of errors by which a plan chooses levels (`planning.model.LEVEL_ERRORS`) is that of films whose
viscosity hardly changes across them. Where a film is much warmer than its walls shear gathers in the hot
layer, which few levels miss: a film of 7 um that is 115 K warmer has 1.1 % less friction with 7 levels than
with 21, 0.4 % with 9 and 0.14 % with 11.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from pyworm.planning import error_budget
from pyworm.planning.expected_work import Kind
from pyworm.planning.plan import Plan
from pyworm.scene.contact import Contact
from pyworm.solver.contact import ContactSolver
from pyworm.solver.error_estimate import change
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import Level
from pyworm.solver.newton import Iteration
from pyworm.solver.stop_reason import MAX_JUDGED_RESIDUAL, film_is_sound
from pyworm.solver.transient.transient import Transient

MIN_VISCOSITY_DECAY = 0.25
"""Decay of ln eta from the walls to the hottest oil from which levels are judged by a film with more of them:
of 16 thermal lines (`tests/hard/draws.py`, seed 7) those below have errors of at most 0.1 %."""

ADDED_LEVELS = 2
"""Levels added at a time."""

MAX_LEVELS: dict[Kind, int] = {"point": 13, "line": 25}
"""The most there are; those of lines cost little. Friction of a helical pair whose film of 6 um is 22 K
warmer (drive 8 of seed 99010 of `tests/hard`, phase 0.3) is 3.58, 4.12, 3.59, 3.88, 3.81, 3.77, 3.83, 3.80
and 3.80 thousandths with 9 to 25 levels."""

MOST_DIVERGED = 2
"""Numbers of levels in a row whose films do not settle, from which on no more are tried: of its phases 0.1
and 0.7 the film with 9 or 11 levels swings, and those with more settle."""

MIN_ERROR_SHARE = 0.2
"""Least error of a figure, as a share of the largest change of any: one may stand still by chance."""


MAX_FILM_CHANGE = 0.1
"""Change of a film since the grid on which its levels were judged from which on they are judged again: on a
first grid, whose film was 22 % too thin, two levels changed it by 0.09 %, on finer ones by 0.26 %."""

UNJUDGED_LEVEL_ERROR = 0.02
"""Error of hot films of which none with more levels is found, above the largest seen, 1.2 % with 7."""


@dataclass(frozen=True)
class EnoughLevels:
    """A film with enough levels across it."""

    plan: Plan
    """The plan with that number of levels."""
    solver: ContactSolver
    """Its solver."""
    level: Level
    """The film."""
    iteration: Iteration
    """Its figures."""
    errors: dict[str, float]
    """Relative error of each figure by the levels [-]."""


def is_hot(scene: Contact, figures: Mapping[str, float]) -> bool:
    """Whether a heated film is so much warmer than its walls that few levels across it may not do."""
    first, second, film = (
        figures[f"temperature_max_{place}"] for place in ("body_1", "body_2", "film")
    )
    return scene.oil.beta * (film - (first + second) / 2) > MIN_VISCOSITY_DECAY


def enough_levels(
    start: EnoughLevels, transient: Transient | None, again: bool
) -> EnoughLevels | None:
    """Add levels until figures change by little; None where no film with more of them is found.

    The error is the last change, or half of the one before if that is larger: figures approach their limit
    irregularly (a film 35 K above its walls is off by +0.16, -0.11, +0.06, +0.08 % with 7 to 13 levels). If
    levels were added on a coarser grid (`again`) a film that has enough is kept, with what was read before.
    """
    found, last, film, diverged = None, start, start, 0
    before = dict.fromkeys(start.iteration.reading.figures, 0.0)
    while film.plan.model.levels < MAX_LEVELS[start.plan.work.kind]:
        film = _with_more_levels(film, transient)
        changed = change(last.iteration.reading, film.iteration.reading)
        target, figures = last.plan.target, film.iteration.reading.figures
        worst = target.worst(changed, figures)
        errors = {
            name: max(relative, before[name] / 2, MIN_ERROR_SHARE * worst)
            for name, relative in changed.items()
        }
        if not film_is_sound(film.level, film.iteration, film.plan):
            diverged += 1
            found = _as_judged_by(film, replace(last, errors=errors)) or found
            if diverged == MOST_DIVERGED:
                break
            continue
        enough = worst <= error_budget.LEVELS * last.plan.accuracy
        found = replace(start if again and enough and last is start else film, errors=errors)
        if enough:
            break
        last, before, diverged = film, changed, 0
    return found


def _as_judged_by(further: EnoughLevels, last: EnoughLevels) -> EnoughLevels | None:
    """The last film, with the error that one with more levels shows and the algebraic error of that one.

    None where its figures have not settled either. Local slip may keep the residual above the tolerance where
    they have.
    """
    algebra, figures = further.iteration.algebra, further.iteration.reading.figures
    figures_converged = last.plan.target.worst(algebra, figures) <= last.plan.accuracy
    if figures["film_min"] <= 0 or not (
        further.level.film.balance.worst <= MAX_JUDGED_RESIDUAL and figures_converged
    ):
        return None
    return replace(
        last, errors={name: error + algebra[name] for name, error in last.errors.items()}
    )


def _with_more_levels(film: EnoughLevels, transient: Transient | None) -> EnoughLevels:
    """The film with some more levels, whose errors are not known yet."""
    plan, scene = film.plan, film.level.scene
    plan = replace(plan, model=replace(plan.model, levels=plan.model.levels + ADDED_LEVELS))
    rate = None if transient is None else transient.rate
    solver = SOLVERS[type(scene)](scene, plan, rate)
    level = solver.with_rate(film.level)
    wanted = error_budget.ALGEBRA * plan.accuracy * error_budget.LEVELS
    iteration = solver.converged(level, plan, wanted)
    return EnoughLevels(plan, solver, level, iteration, film.errors)
