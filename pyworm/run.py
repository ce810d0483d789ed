"""From the tasks of one case to its result; what an earlier run solved is not solved again."""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import replace
from pathlib import Path
from typing import Any

from pyworm.batch import solve_all
from pyworm.case import Case
from pyworm.result import Result, open_result
from pyworm.solution import Solution
from pyworm.solver import Progress
from pyworm.store import Store
from pyworm.task import Task, provenance

RESULT_NAME = "result.nc"
SCENES = "scenes"
"""Directory, beside the result, of scenes kept while others are not solved yet."""


class NothingSolvedError(RuntimeError):
    """No scene of a run has a solution; the message is the last one's reason."""


def run(
    case: Case,
    tasks: Sequence[Task],
    directory: Path,
    executor: Executor | None = None,
    progress: Progress | None = None,
    say: Callable[[str], None] = lambda message: None,
) -> Result:
    """Solve a case and write its result.

    Parameters
    ----------
    case : Case
        The case.
    tasks : sequence of Task
        Scenes of this case.
    directory : Path
        Where the result is written as `RESULT_NAME`; what it, or a run that was stopped, left there is used.
    executor : Executor, optional
        Whose processes solve; by default this one does.
    progress : callable, optional
        Told what is being done and which share of all is done, 0 to 1.
    say : callable, optional
        Told once if scenes were solved before.

    Returns
    -------
    Result
        Solutions in the order of the tasks. Scenes without one are missing and named, with the reason, under
        `failed` in its provenance.

    Raises
    ------
    NothingSolvedError
        No scene has a solution.
    OSError
        The result cannot be written.
    """
    store = Store(directory.absolute() / SCENES, fields=True)
    earlier = _solved_before(directory / RESULT_NAME)
    missing = [task for task in store.missing(tasks) if task.key not in earlier]
    before = sum(task not in missing for task in tasks)
    if before:
        say(f"{before} of {len(tasks)} scenes were solved before, in {directory}")
    reasons = solve_all(missing, store, executor, progress)
    solved = [task for task in tasks if task.key not in reasons]
    if not solved:
        raise NothingSolvedError(reasons[tasks[-1].key])
    kept = dict(earlier)
    for task in solved:
        if task.key not in earlier:
            kept |= _of_each(store.result(task))
    solutions = tuple(replace(kept[task.key][0], name=task.scene.name) for task in solved)
    plans = {task.key: kept[task.key][1] for task in solved}
    failed = {task.scene.name: reasons[task.key] for task in tasks if task.key in reasons}
    result = Result(
        case.name,
        case.resolved,
        solutions,
        None if case.drive is None else case.drive.cycle_data(),
        provenance(plans) | {"failed": failed},
    )
    directory.mkdir(parents=True, exist_ok=True)
    result.save(directory / RESULT_NAME)
    store.drop(tasks)
    return result


def _solved_before(path: Path) -> dict[str, tuple[Solution, dict[str, Any]]]:
    """Solutions of an earlier result, if there is one, with their plans, by key."""
    try:
        return _of_each(open_result(path))
    except (FileNotFoundError, ValueError):
        return {}


def _of_each(result: Result) -> dict[str, tuple[Solution, dict[str, Any]]]:
    """Solutions of a result with their plans, by key."""
    said = result.provenance
    plans = zip(result.solutions, said.get("plans", ()), strict=False)
    return dict(zip(said.get("keys", ()), plans, strict=False))
