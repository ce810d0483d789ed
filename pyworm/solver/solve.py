"""Solve a scene by its plan, on finer grids until the figures are as accurate as asked."""

from collections.abc import Mapping
from math import inf
from typing import Any

from pyworm.io.given import Names, WithUnit
from pyworm.io.progress import Progress
from pyworm.io.quantity_text import percent
from pyworm.kernel.core import KernelError
from pyworm.planning.effects.squeeze import SQUEEZE
from pyworm.planning.effects.starvation import STARVATION
from pyworm.planning.plan import Plan, isothermal, reviewed, steady, with_accuracy
from pyworm.planning.plan import plan as make_plan
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.ending import Ending
from pyworm.solver.grid_sequence import GridSequence
from pyworm.solver.solution import Solution
from pyworm.solver.stop_reason import MAX_USED_ERROR
from pyworm.solver.timing import Stopwatch
from pyworm.solver.transient.transient import Rates, finer, rates_at_present

COARSER_ACCURACIES = 0.05, 0.2
"""Accuracies of coarser requests, of which the next one is tried where a finer one ends with more error."""


def solve(
    scene: Scene | LineScene,
    plan: Plan | None = None,
    progress: Progress | None = None,
    rates: Rates | None = None,
    *,
    accuracy: WithUnit | None = None,
    effects: Names | None = None,
    quantities: Names | None = None,
) -> Solution:
    """Solve a scene for its film, `solve(scene, accuracy="2 %")` or `solve(scene, plan)`.

    Args:
        scene: The contact.
        plan: Its plan, by `pyworm.plan`; by default it is made of the last three arguments.
        progress: Called with what is being done and the fraction of the work that is done, 0 to 1.
        rates: Rates of change of its film where it changes as oil passes; by default they are found first.
        accuracy, effects, quantities: As of `pyworm.plan`, with its defaults; not together with a plan.

    Returns:
        Marked not converged, with the reason, where the figures are not to be trusted; that of a coarser
        request where it leaves less error. Unless effects were given those are added that the solved figures
        require, and a steady film stands for one in motion that is not found.

    Raises:
        ValueError: No contact, the plan of another one, a plan together with its arguments, or as of
            `pyworm.plan`.
        KernelError: Values of the scene are not finite, or memory does not suffice for the first grids
            (`memory.NoMemoryError`); a lack of memory for finer grids ends the sequence instead.
    """
    plan = _plan(scene, plan, {"accuracy": accuracy, "effects": effects, "quantities": quantities})
    report = _rising(progress)
    stopwatch, warm_start = Stopwatch(), None
    while True:
        plan, rates = _rates_of_change(scene, plan, rates, report)
        sequence = GridSequence(plan.simplified(scene), plan, rates, report, stopwatch)
        warm_start = sequence.begin(warm_start)
        rates, again = _finer_rates(scene, plan, rates, sequence, report)
        if again:
            continue
        # the first grid tells what closed forms missed, before finer ones cost their time
        updated = _updated(scene, plan, sequence.figures() if plan.may_grow else None)
        if updated.on <= plan.on:
            solution = sequence.finish()
            rates, again = _finer_rates(scene, plan, rates, sequence, report)
            if again:
                continue
            if solution.ending is Ending.CIRCULATING and plan.asked is None:
                report(f"{scene.name}: without heat, {solution.stop_reason}", 0.0)
                plan, warm_start = isothermal(scene, plan, solution.stop_reason), None
                continue
            figures = solution.figures.values() if solution.converged else None
            updated = _updated(scene, plan, figures)
            if updated.on <= plan.on:
                solution = solution.changed(effects=updated.effects, solved=(scene, plan))
                return _no_worse(scene, plan, solution, rates, report)
        missed = updated.on - plan.on
        warm_start = None if STARVATION.name in missed else warm_start  # of another window
        report(f"{scene.name}: calls for {', '.join(sorted(missed))} too", 0.0)
        plan = updated


def _no_worse(
    scene: Scene | LineScene, plan: Plan, solution: Solution, rates: Rates | None, report: Progress
) -> Solution:
    """The solution, or that of a coarser request which leaves less error, accurate if no more than asked.

    A finer request has a wider window and a lower tolerance, on grids of the same size: by either its error
    may be larger in the end, or its film be lost. A transient film keeps its rates of change.
    """
    error = _error(solution, plan)
    coarser = next((accuracy for accuracy in COARSER_ACCURACIES if accuracy > plan.accuracy), None)
    if solution.accurate or coarser is None or error <= coarser:
        return solution
    usual = with_accuracy(scene, plan, plan.accuracy)
    chosen = (usual.grids, usual.tolerance) != (plan.grids, plan.tolerance)
    if chosen or plan.refusal is not None:
        return solution
    report(f"{scene.name}: again at {percent(coarser)}", 0.0)
    try:
        again = solve(scene, with_accuracy(scene, plan, coarser), report, rates)
    except KernelError:
        return solution
    left = _error(again, plan)
    if not left < error:
        return solution
    if left <= plan.accuracy:
        return again.changed(accuracy=plan.accuracy)
    stop = Ending.COARSER_REQUEST.stop(
        error=percent(left), accuracy=percent(plan.accuracy), reason=solution.stop_reason
    )
    return again.changed(accuracy=plan.accuracy, ending=stop.ending, stop_reason=stop.reason)


def _error(solution: Solution, plan: Plan) -> float:
    """Largest error of the figures asked for; infinite without a film.

    Temperatures that are not known, as at a sharp edge, are so by a coarser request as well: films decide.
    """
    if not solution.converged:
        return inf
    found = {name: getattr(solution.figures, name) for name in plan.target.figures}
    errors = {name: estimate.error for name, estimate in found.items()}
    rises = {name: estimate.value - estimate.datum for name, estimate in found.items()}
    worst = plan.target.worst(errors, rises)
    return (
        worst
        if worst <= MAX_USED_ERROR
        else plan.target.without(*HEAT_FIGURES).worst(errors, rises)
    )


def _plan(scene: Scene | LineScene, plan: Plan | None, how: Mapping[str, Any]) -> Plan:
    """The plan of a scene, made if there is none; ValueError for any other, or what is no scene or plan."""
    if not isinstance(scene, Scene | LineScene):
        of_case = "; a case gives it by case.scene()" if hasattr(scene, "scene") else ""
        raise ValueError(
            f"scene is a {type(scene).__name__}: must be a Scene or a LineScene{of_case}"
        )
    given = {name: value for name, value in how.items() if value is not None}
    if plan is None:
        return make_plan(scene, **given)
    if not isinstance(plan, Plan):
        accuracy = plan if isinstance(plan, float | str) else 0.02
        raise ValueError(
            f"plan = {plan!r:.40}: must be a Plan; give an accuracy by its name, accuracy={accuracy!r:.20}"
        )
    if given:
        raise ValueError(f"{', '.join(given)}: the plan has its own; give either plan or these")
    plan.require_of(scene)
    return plan


def _rates_of_change(
    scene: Scene | LineScene, plan: Plan, rates: Rates | None, report: Progress
) -> tuple[Plan, Rates | None]:
    """The rates of change of a transient film, found if they are not given; or a plan of a steady film."""
    if SQUEEZE.name not in plan.on:
        return plan, None
    if rates is None:
        report(f"{scene.name}: its history", 0.0)
        rates = rates_at_present(scene, plan)
    if rates.flaw is not None and plan.asked is None:
        return steady(plan, f"not found: {rates.flaw}"), None
    return plan, rates


def _finer_rates(
    scene: Scene | LineScene,
    plan: Plan,
    rates: Rates | None,
    sequence: GridSequence,
    report: Progress,
) -> tuple[Rates | None, bool]:
    """The rates of change, and whether they have one more transient solve, which a sequence wants."""
    if rates is None or rates.finest or not sequence.wants_finer_rates:
        return rates, False
    report(f"{scene.name}: its history, on a finer grid", 0.0)
    rates = finer(scene, plan, rates)
    return rates, not rates.finest


def _updated(scene: Scene | LineScene, plan: Plan, figures: Mapping[str, float] | None) -> Plan:
    """The plan judged again by solved figures, where there are some."""
    return plan if figures is None else reviewed(scene, plan, figures)


def _rising(progress: Progress | None) -> Progress:
    """Progress that never decreases, even where a solve starts again with more effects."""
    reached = 0.0

    def report(message: str, fraction: float) -> None:
        nonlocal reached
        reached = max(reached, fraction)
        if progress is not None:
            progress(message, reached)

    return report
