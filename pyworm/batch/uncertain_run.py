"""Uncertainty of the results of a run by its inputs: each is moved to both sides, all else is held."""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import replace
from pathlib import Path
from typing import Any

from pyworm.batch.case_run import RESULT_NAME
from pyworm.batch.operating_points import OperatingPoint, Solving, read_results
from pyworm.batch.task import Task
from pyworm.case.case import Case, case_without_contacts
from pyworm.io.input_error import CaseError
from pyworm.io.progress import Progress
from pyworm.result.input_uncertainty import (
    BOUND,
    IN_PROVENANCE,
    InputUncertainty,
    UncertainResult,
    by_inputs,
)
from pyworm.result.result import Result

MODERATE_ACCURACY = 0.05
"""Accuracy of solves with moved inputs, where none lower is requested: errors of two nearly cancel in their
difference."""


def require_uncertain(case: Case) -> None:
    """CaseError for a case whose inputs are all exact."""
    if not case.uncertain.values:
        raise CaseError(
            f'{case.name}: no input is written with its uncertainty, such as "0.4 um +- 0.1 um"'
        )


def with_input_uncertainty(
    result: Result,
    tasks: Sequence[Task],
    directory: Path,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Result:
    """A result with the uncertainty by inputs, in its file too.

    Args:
        tasks: Its contacts as they were solved.
        directory: Where its file is, and where contacts with moved inputs are kept.

    Raises:
        NotSolvedError: A contact with a moved input has no solution.
    """
    solving = Solving(
        directory, max(tasks[0].accuracy, MODERATE_ACCURACY), tasks[0].effects, executor, progress
    )
    found = uncertainty_of(result, tasks, moved_points(tasks), solving)
    kept = result.provenance | {IN_PROVENANCE: found.summary()}
    whole = replace(result, provenance=kept)
    whole.save(directory / RESULT_NAME)
    return whole


def moved_points(tasks: Sequence[Task]) -> list[OperatingPoint]:
    """The contacts of a run with each input one standard uncertainty below and above, input by input.

    CaseError of a value that there cannot be.
    """
    case, places = tasks[0].case, tuple(task.place for task in tasks)
    found = {
        table: {key: getattr(getattr(case.tables, table), key) for key in keys}
        for table, keys in _left_open(case).items()
    }
    return [
        OperatingPoint(_moved(case, key, step).with_found(found), places, tasks[0].quantities)
        for key in case.uncertain.values
        for step in (-1.0, 1.0)
    ]


def _left_open(case: Case) -> dict[str, tuple[str, ...]]:
    """What a run finds by iteration, whether the case as solved holds it or not."""
    written = case_without_contacts(case.content, case.name, case.directory)
    return written.left_open


def _moved(case: Case, key: str, step: float) -> Case:
    try:
        content = case.uncertain.moved(case.content, key, step)
        return case_without_contacts(content, case.name, case.directory)
    except CaseError as error:
        raise CaseError(f"{key} moved by its standard uncertainty: {error}") from None


def uncertainty_of(
    result: Result, tasks: Sequence[Task], points: Sequence[OperatingPoint], solving: Solving
) -> InputUncertainty:
    """The uncertainty of a result; NotSolvedError of a contact with a moved input without a solution."""
    case = tasks[0].case
    sides = solving.results(points)
    summaries: list[dict[str, Any]] = [solution.summary() for solution in result.sound.solutions]
    here = OperatingPoint(case, tuple(task.place for task in tasks))
    found = []
    for name, computed in read_results(here, summaries).items():
        pairs = zip(sides[::2], sides[1::2], strict=True)
        if any(name not in side for side in sides):
            continue
        changes = tuple((more[name].value - less[name].value) / 2 for less, more in pairs)
        found.append(
            UncertainResult(
                name,
                computed.value,
                changes,
                by_inputs(case.uncertain, changes),
                computed.model / BOUND,
                computed.error / BOUND,
            )
        )
    inputs = case.uncertain.values
    texts = tuple(
        f"{each.moved()} ± {each.standard:.3g} {each.unit}".rstrip() for each in inputs.values()
    )
    return InputUncertainty(tuple(inputs), texts, tuple(found))
