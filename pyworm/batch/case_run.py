"""Solve the tasks of a case; scenes solved by an earlier run are reused."""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import replace
from operator import methodcaller
from pathlib import Path
from typing import Any

from pyworm.batch.provenance import provenance
from pyworm.batch.solve_tasks import solve_all
from pyworm.batch.solved_scenes import Store
from pyworm.batch.task import Task
from pyworm.case.case import Case
from pyworm.drives.drive import Drive
from pyworm.io.progress import Progress
from pyworm.result.result import Result, open_result
from pyworm.scene.plausibility import overheated
from pyworm.solver.solution import Solution

RESULT_NAME = "result.nc"
SCENES = "scenes"
"""Directory, beside the result, of scenes kept while others are not solved yet."""


CycleOf = Callable[[Drive], Any]
"""A drive -> a dataset of its mesh cycle."""


class NothingSolvedError(RuntimeError):
    """No scene of a run has a solution; the message gives the reasons, each once."""

    def __init__(self, reasons: dict[str, str]):
        super().__init__("; ".join(dict.fromkeys(reasons.values())))
        self.reasons = reasons
        """Name of each scene and its reason."""


def run(
    case: Case,
    tasks: Sequence[Task],
    directory: Path,
    executor: Executor | None = None,
    progress: Progress | None = None,
    print_message: Callable[[str], None] = lambda message: None,
    cycle_of: CycleOf | None = None,
    all_digits: bool = False,
) -> Result:
    """Solve a case and write its result as `RESULT_NAME` into a directory; scenes solved before are reused.

    `executor` has the processes that solve, by default this one. `print_message` reports scenes solved before
    and an earlier result that cannot be used; `cycle_of` makes what is written of the mesh cycle of a drive,
    by default all of it, or what belongs to the contact where there is one alone.
    Fields are rounded to the accuracy they have unless `all_digits` are kept. The solutions have the order of
    the tasks; scenes without one are missing and named, with the reason, under `failed` in the provenance.

    NothingSolvedError if no scene has a solution; OSError if the result cannot be written: what was solved is
    then kept where that is possible.
    """
    store = Store(directory.absolute() / SCENES, fields=True, all_digits=all_digits)
    earlier = _solved_before(directory / RESULT_NAME, store, print_message)
    missing = store.missing(task for task in tasks if task.key not in earlier)
    before = sum(task not in missing for task in tasks)
    if before:
        print_message(f"{before} of {len(tasks)} contacts were solved before, in {directory}")
    if executor is None and len(missing) == 1:
        store = replace(store, sole=True)
    reasons = solve_all(missing, store, executor, progress)
    kept, unread = _collected(tasks, store, earlier, directory / RESULT_NAME)
    reasons = {key: reasons.get(key, why) for key, why in unread.items()}
    result = _result(case, tasks, kept, reasons, cycle_of)
    try:
        result.save(directory / RESULT_NAME)
    except OSError:
        store.secure(missing)
        raise
    store.drop(tasks)
    return result


_Kept = dict[str, tuple[Solution, dict[str, Any]]]
"""Solutions with their plans, by the keys of their tasks."""


def _result(
    case: Case,
    tasks: Sequence[Task],
    kept: _Kept,
    reasons: dict[str, str],
    cycle_of: CycleOf | None,
) -> Result:
    """The result of what is solved of a case, reasons of the rest in it; NothingSolvedError if nothing is."""
    solved = [task for task in tasks if task.key in kept]
    failed = {task.scene.name: reasons[task.key] for task in tasks if task.key in reasons}
    if not solved:
        raise NothingSolvedError(failed)
    cycle_of = cycle_of or methodcaller("cycle_around_contact" if len(tasks) == 1 else "cycle_data")
    solutions = tuple(kept[task.key][0].changed(name=task.scene.name) for task in solved)
    plans = {task.key: kept[task.key][1] for task in solved}
    hot = overheated(solution.summary() for solution in solutions)
    return Result(
        case.name,
        case.resolved,
        solutions,
        None if case.drive is None else cycle_of(case.drive),
        provenance(plans) | {"failed": failed, "warnings": [*case.warnings, *hot]},
    )


def _collected(
    tasks: Sequence[Task], store: Store, earlier: _Kept, file: Path
) -> tuple[_Kept, dict[str, str]]:
    """Solutions of these tasks, and by key why others cannot be read.

    Another run of the same case in the same directory may have taken them from the store into its result.
    """
    kept, unread = dict(earlier), {}
    for task in tasks:
        if task.key not in kept:
            try:
                kept |= _of_each(store.result(task))
            except OSError as error:
                unread[task.key] = str(error)
    if unread:
        kept |= _solved_before(file, store, lambda message: None)
    return kept, {key: why for key, why in unread.items() if key not in kept}


def _solved_before(path: Path, store: Store, print_message: Callable[[str], None]) -> _Kept:
    """Solutions of an earlier result, if there is one, that serve; a message if it cannot be used."""
    try:
        every = _of_each(open_result(path))
        return {key: kept for key, kept in every.items() if store.serves(kept[0])}
    except FileNotFoundError:
        return {}
    except ValueError as error:
        print_message(f"{error}; its contacts are solved again")
        return {}


def _of_each(result: Result) -> _Kept:
    """Solutions of a result with their plans, by key."""
    said = result.provenance
    plans, keys = said.get("plans", ()), said.get("keys", ())
    if not len(plans) == len(keys) == len(result.solutions):
        return {}  # of another program, or made in Python
    return dict(zip(keys, zip(result.solutions, plans, strict=True), strict=True))
