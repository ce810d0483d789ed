"""Solve a sweep and make its table; scenes solved by an earlier run are reused.

Scenes of which films alone are asked for, no more accurately than a formula gives them, are not solved
(`planning.by_formula`), unless fields are wanted, which only solved ones have.
"""

from collections.abc import Callable, Iterable
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
from pyworm.planning.by_formula import films_by_formula
from pyworm.planning.effects.effect import FILM
from pyworm.result.formula_summary import formula_summary
from pyworm.result.sweep_result import SweepResult, sweep_table

BY_FORMULA = "film thickness by formula, with the requested accuracy"

_ACCURATE = {"converged": True, "accurate": True, "stop_reason": BY_FORMULA}
"""Stop reason of a scene that needed no solve."""


def run_sweep(
    sweep: Sweep,
    directory: Path,
    fields: bool = False,
    executor: Executor | None = None,
    progress: Progress | None = None,
    print_message: Callable[[str], None] = lambda message: None,
) -> SweepResult:
    """Solve a sweep; its table has a row for each scene, those without a solution included.

    Solved scenes are kept in the directory, in full with `fields` or else as scalars, and found again there;
    the other arguments are those of `pyworm.batch.case_run.run`.
    """
    reasons, found = solve_share(sweep.tasks, directory, fields, executor, progress, print_message)
    store = _store(directory, fields)

    def row(task: Task) -> dict:
        if task.key in reasons:
            unsolved = {"converged": False, "accurate": False, "stop_reason": reasons[task.key]}
            return asdict(task.place) | unsolved
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
    print_message: Callable[[str], None] = lambda message: None,
) -> tuple[dict[str, str], dict[str, dict]]:
    """Solve some scenes of a sweep and store them; arguments as of `run_sweep`.

    Returns the reason of each scene without a solution, and the summary of each that was solved before or
    needs no solve, by key.
    """
    store = _store(directory, fields)
    found = store.solved(tasks)
    if found:
        before = sum(task.key in found for task in tasks)
        print_message(f"{before} of {len(tasks)} contacts were solved before, in {directory}")
    if not fields:
        given = _by_formula(task for task in tasks if task.key not in found)
        if given:
            print_message(f"{len(given)} of {len(tasks)} contacts need no solve: {BY_FORMULA}")
        found |= given
    missing = list({task.key: task for task in tasks if task.key not in found}.values())
    return solve_all(missing, store, executor, progress), found


def _store(directory: Path, fields: bool) -> Store:
    return Store(directory.absolute() / SCENES, fields)


def _by_formula(tasks: Iterable[Task]) -> dict[str, dict]:
    """Key and summary of each scene whose films a formula gives as accurately as they are asked for."""
    found = {}
    for task in tasks:
        if task.quantities != (FILM,):
            continue
        films = films_by_formula(task.scene, task.plan)
        if films is not None:
            summary = formula_summary(task.scene, task.plan, films)
            found[task.key] = {**summary, **_ACCURATE}
    return found
