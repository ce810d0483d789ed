"""Throughput of a batch: the shipped sweep of 40 scenes on one and on two processes, each one thread.

Run from the repository's root, with nothing else on the machine:

    python benchmarks/batch.py

Both runs have worker processes, whose start is counted; tasks are checked before. Bits are compared too. The
processor time of the workers tells, on a busy machine as well, what the second one costs.
"""

from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from tempfile import TemporaryDirectory
from time import perf_counter

from pyworm.batch import solve_all
from pyworm.store import Store
from pyworm.sweep import load_sweep
from pyworm.workers import WorkerPool

SWEEP = Path("cases/sweeps/film_of_speed_and_load.toml")
TIMED = ("seconds", "convolutions")


def main() -> None:
    tasks = load_sweep(SWEEP).tasks
    seconds, summaries = {}, {}
    for processes in (1, 2):
        with TemporaryDirectory() as directory:
            store = Store(Path(directory), fields=False)
            started, worked = perf_counter(), processor_time()
            with WorkerPool(processes) as pool:
                failed = solve_all(tasks, store, pool)
            seconds[processes] = perf_counter() - started
            work = processor_time() - worked
            summaries[processes] = [store.summary(task) | dict.fromkeys(TIMED) for task in tasks]
        solves = f"{len(tasks) - len(failed)} of {len(tasks)} scenes solved"
        print(
            f"{processes} processes: {seconds[processes]:6.1f} s, {work:6.1f} s of processor, {solves}",
            flush=True,
        )
    print(f"throughput: {seconds[1] / seconds[2]:.2f} times that of one process")
    print(f"same bits: {summaries[1] == summaries[2]}")


def processor_time() -> float:
    """Of the processes that have ended [s]."""
    used = getrusage(RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


if __name__ == "__main__":
    main()
