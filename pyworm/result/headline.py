"""Sentences before the results of solved contacts: minimum film thickness, and neglected effects at worst."""

from collections.abc import Iterable, Sequence

from pyworm.io.quantities import QUANTITIES
from pyworm.planning.no_friction import no_friction
from pyworm.solver.neglected_effects import NeglectedEffects, worst
from pyworm.solver.solution import Solution


def of_all(solutions: Iterable[Solution]) -> NeglectedEffects:
    """The worst of solved contacts; of those that converged if there are any."""
    solutions = list(solutions)
    good = [solution for solution in solutions if solution.converged] or solutions
    return worst([solution.neglected_effects for solution in good])


def headline(solutions: Sequence[Solution]) -> str:
    """Minimum film thickness of solved contacts, its error bar and the effects left out; empty without."""
    words = of_all(solutions).words
    films = [solution.figures.film_min for solution in solutions if solution.converged]
    if not words or not films:
        return words
    film = min(films, key=lambda film: film.value)
    numerical = f"± {film.error * 100:.2g} % (numerical)"
    model = "" if film.model is None else f" ± {film.model * 100:.2g} % (model)"
    thickness = QUANTITIES["film_min"]
    return f"{thickness.title()} {thickness.text(film.value)} {numerical}{model}; {words}"


def less_accurate(solutions: Sequence[Solution]) -> str:
    """The contacts whose figures are used with wider error bars than asked for; empty without any."""
    wide = [solution for solution in solutions if solution.converged and not solution.accurate]
    if not wide:
        return ""
    return "Less accurate than requested: " + ", ".join(solution.name for solution in wide) + "."


def without_friction(solutions: Sequence[Solution]) -> str:
    """Why contacts have no friction though their oil's data would allow it; empty where they have."""
    lacking = [solution for solution in solutions if solution.figures.friction_coefficient is None]
    reason = next(filter(None, (no_friction(solution.effects) for solution in lacking)), "")
    return f"Friction is not given: {reason}." if reason else ""


def opening(
    solutions: Sequence[Solution],
    rough_teeth: str,
    beyond_limits: Sequence[str] = (),
    summarised: bool = False,
) -> list[str]:
    """Sentences shown before any result of solved contacts.

    `rough_teeth` is about their friction by a standard, for where roughness carries load; `beyond_limits`
    about bodies that are hotter than their material bears. The headline is left out if a table has it,
    `summarised`.
    """
    at_worst = of_all(solutions)
    lines = [
        *beyond_limits,
        at_worst.sentence,
        "" if summarised else headline(solutions),
        less_accurate(solutions),
        without_friction(solutions),
        rough_teeth if at_worst.as_if_smooth else "",
    ]
    return [line for line in lines if line]
