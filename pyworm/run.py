"""From the tasks of one case to its result; what an earlier run solved is not solved again."""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import replace
from pathlib import Path

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
    solutions = tuple(
        replace(earlier.get(task.key) or store.solution(task), name=task.scene.name)
        for task in solved
    )
    failed = {task.scene.name: reasons[task.key] for task in tasks if task.key in reasons}
    result = Result(
        case.name,
        case.resolved,
        solutions,
        None if case.drive is None else case.drive.cycle_data(),
        provenance(solved) | {"failed": failed},
    )
    directory.mkdir(parents=True, exist_ok=True)
    result.save(directory / RESULT_NAME)
    store.drop(tasks)
    return result


def _solved_before(path: Path) -> dict[str, Solution]:
    """Solutions of an earlier result, if there is one, by key."""
    try:
        result = open_result(path)
    except (FileNotFoundError, ValueError):
        return {}
    return dict(zip(result.provenance.get("keys", ()), result.solutions, strict=False))
