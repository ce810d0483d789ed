"""Sensitivities of the results of a run to the numbers of its case, as `pyworm run --sensitivities` shows."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from pyworm.batch.case_figures import FigureChanges
from pyworm.batch.case_run import RESULT_NAME
from pyworm.batch.drive_iteration import steady
from pyworm.batch.key_sensitivities import BY_ADJOINT, BY_CLOSED_FORMS, Solved, key_sensitivities
from pyworm.batch.operating_points import OperatingPoint
from pyworm.batch.task import Task
from pyworm.batch.uncertain_run import MODERATE_ACCURACY
from pyworm.case.case import Case
from pyworm.io.progress import Progress
from pyworm.kernel.core import KernelError
from pyworm.planning.closed_form_figures import ClosedFormChanges
from pyworm.ratings.heating import heating_of
from pyworm.ratings.standard_loss import standard_loss
from pyworm.result.key_sensitivities import IN_PROVENANCE, KeySensitivities
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex
from pyworm.solver.adjoint import NoAdjointError, adjoint_of
from pyworm.solver.solution import Solution


def sensitivities_of_run(
    result: Result,
    tasks: Sequence[Task],
    progress: Progress | None = None,
    print_message: Callable[[str], None] = lambda message: None,
) -> KeySensitivities:
    """Derivatives of the results of a run with respect to all numbers of its case.

    Args:
        result: The result; contacts that did not converge do not count.
        tasks: Its contacts as they were solved.
        progress: What is called with the progress.
        print_message: Reports contacts without an adjoint, whose changes are those of closed forms.
    """
    known = {task.place: task for task in tasks}
    solutions = result.sound.solutions
    wanted = [known[ContactIndex.of(solution)] for solution in solutions]
    changes, by_adjoint = [], True
    for count, (task, solution) in enumerate(zip(wanted, solutions, strict=True)):
        if progress is not None:
            progress(f"adjoint of {task.scene.name}", count / len(wanted))
        try:
            changes.append(_adjoint(task, solution))
        except (NoAdjointError, KernelError) as error:
            print_message(f"{task.case.name}: changes by closed forms: {error}")
            changes.append(ClosedFormChanges(task.scene))
            by_adjoint = False
    point = OperatingPoint(wanted[0].case, tuple(task.place for task in wanted))
    summaries = tuple(solution.summary() for solution in solutions)
    solved = Solved(point, summaries, tuple(changes), _heated_by(point.case, result))
    return key_sensitivities(
        solved, BY_ADJOINT if by_adjoint else BY_CLOSED_FORMS, progress=progress
    )


def _heated_by(case: Case, result: Result) -> str:
    """Source of the loss that warms the teeth; simulation where nothing does."""
    heating = heating_of(case, drive_cycle(result), standard_loss(case))
    return "simulation" if heating is None else heating.found.by


def with_sensitivities(result: Result, found: KeySensitivities, directory: Path) -> Result:
    """A result with its sensitivities, in its file in a directory too."""
    whole = replace(result, provenance=result.provenance | {IN_PROVENANCE: found.summary()})
    whole.save(directory / RESULT_NAME)
    return whole


def _adjoint(task: Task, solution: Solution) -> FigureChanges:
    """The adjoint of a solved contact at a moderate accuracy: its changes need no finer grid."""
    moderate = replace(
        steady(task), accuracy=max(task.accuracy, MODERATE_ACCURACY), wider_window=False
    )
    return adjoint_of(moderate.scene, moderate.plan, solution)
