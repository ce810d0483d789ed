"""Many scenes, each solved by itself.

None starts from another: any order and any number of processes gives the same solutions to the last bit.
Transient solutions are found first, since many scenes share them.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor, Future, as_completed

from pyworm.batch.solved_scenes import Store
from pyworm.batch.task import Task
from pyworm.batch.transient_solutions import drop_rates, rates_for, solve_lives
from pyworm.batch.workers import WorkerDiedError, WorkerPool
from pyworm.io.progress import Progress, marks_tenth
from pyworm.io.reason import reason_of
from pyworm.io.terminal import print_message
from pyworm.kernel.core import KernelError


def solve_all(
    tasks: Sequence[Task],
    store: Store,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> dict[str, str]:
    """Solve tasks, each once (`Store.missing`), and store each solution as soon as it is found.

    Every process of the executor must reach the store's directory; without an executor this process solves.
    Returns the reason of each task without a solution, by its key.
    """
    tell = progress or (lambda message, share: None)
    solve_lives(tasks, store.directory, executor, tell)
    reasons = {}
    if executor is None:
        for position, task in enumerate(tasks):
            share = _share(tell, position, len(tasks))
            reasons[task.key] = solve_and_keep(task, store, share)
    else:
        tell(f"0 of {len(tasks)} contacts", 0.0)
        count, watched = len(tasks), isinstance(executor, WorkerPool)
        futures = {
            executor.submit(solve_for, task.key, task, store, _line(number, count, watched)): task
            for number, task in enumerate(tasks, 1)
        }
        for done, future in enumerate(as_completed(futures), 1):
            reasons[futures[future].key] = _reason(future, futures[future], store)
            tell(f"{done} of {len(tasks)} contacts", done / len(tasks))
    return {task.key: why for task in tasks if (why := reasons[task.key]) is not None}


def solve_and_keep(task: Task, store: Store, progress: Progress | None = None) -> str | None:
    """Solve one task, unless another run has meanwhile; returns why there is no solution, or None.

    Whatever goes wrong is the reason, since it must not cost the other tasks.
    """
    reason = None
    try:
        if not store.holds(task):
            store.keep(task, task.solved(progress, rates_for(task, store.directory)))
    except KernelError as error:
        reason = str(error)
    except Exception as error:
        reason = reason_of(error)
    drop_rates(task, store.directory)
    return reason


def solve_for(key: str, task: Task, store: Store, line: str | None = None) -> str | None:
    """Solve a task in another process, where it must have the same key, and end with a line for its log."""
    if task.key != key:
        return "its worker has another build of pyworm, or of what it builds on"
    reason = solve_and_keep(task, store)
    if line is not None:
        print_message(f"{line}, {'solved' if reason is None else reason}")
    return reason


def _line(number: int, count: int, watched: bool) -> str | None:
    """Line of a worker's log for a scene: the first, each tenth and the last, where nobody watches."""
    return None if watched or not marks_tenth(number, count) else f"scene {number} of {count}"


def _reason(future: Future, task: Task, store: Store) -> str | None:
    """Reason why a task has no solution, if it failed."""
    error = future.exception()
    if error is not None:  # of the process, not of the solve
        return str(error) if isinstance(error, WorkerDiedError) else reason_of(error)
    reason: str | None = future.result()
    if reason is None and not store.file(task).exists():
        return "its worker has another directory"
    return reason


def _share(tell: Callable[[str, float], None], position: int, count: int) -> Progress:
    """Progress of one of several solves as a fraction of all."""
    return lambda message, fraction: tell(message, (position + fraction) / count)
