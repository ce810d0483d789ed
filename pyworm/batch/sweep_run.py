"""Solve a sweep and make its table; scenes solved by an earlier run are reused."""

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import asdict
from pathlib import Path

from pyworm.batch.case_run import SCENES
from pyworm.batch.provenance import where_and_when
from pyworm.batch.solve_tasks import solve_all
from pyworm.batch.solved_scenes import Store
from pyworm.batch.sweep import Sweep
from pyworm.batch.task import Task
from pyworm.io.progress import Progress
from pyworm.result.sweep_result import SweepResult, sweep_table


def run_sweep(
    sweep: Sweep,
    directory: Path,
    fields: bool = False,
    executor: Executor | None = None,
    progress: Progress | None = None,
    say: Callable[[str], None] = lambda message: None,
) -> SweepResult:
    """Solve a sweep.

    Parameters
    ----------
    sweep : Sweep
        What to solve.
    directory : Path
        Under it solved scenes are kept, and looked for.
    fields : bool
        Whether they are kept in full, or their scalars only.
    executor, progress, say
        As of `pyworm.batch.case_run.run`.

    Returns
    -------
    SweepResult
        A row a scene, those without a solution included.
    """
    reasons, found = solve_share(sweep.tasks, directory, fields, executor, progress, say)
    store = _store(directory, fields)

    def row(task: Task) -> dict:
        if task.key in reasons:
            return _unsolved(task, reasons[task.key])
        # each file is read once more only if it was solved just now
        return found.get(task.key) or store.summary(task)

    rows = [row(task) for task in sweep.tasks]
    return SweepResult(
        sweep.name,
        sweep.title,
        sweep.axes,
        sweep_table(sweep.values, rows, [task.key for task in sweep.tasks]),
        where_and_when() | {"sweep": sweep.written},
    )


def solve_share(
    tasks: tuple[Task, ...],
    directory: Path,
    fields: bool = False,
    executor: Executor | None = None,
    progress: Progress | None = None,
    say: Callable[[str], None] = lambda message: None,
) -> tuple[dict[str, str], dict[str, dict]]:
    """Solve some scenes of a sweep and store them; arguments as of `run_sweep`.

    Returns
    -------
    tuple of dict and dict
        Key and reason of each scene without solution; key and summary of each that was solved before.
    """
    store = _store(directory, fields)
    found = store.solved(tasks)
    if found:
        before = sum(task.key in found for task in tasks)
        say(f"{before} of {len(tasks)} scenes were solved before, in {directory}")
    missing = list({task.key: task for task in tasks if task.key not in found}.values())
    return solve_all(missing, store, executor, progress), found


def _store(directory: Path, fields: bool) -> Store:
    return Store(directory.absolute() / SCENES, fields)


def _unsolved(task: Task, reason: str) -> dict:
    return {**asdict(task.place), "converged": False, "stop_reason": reason}
