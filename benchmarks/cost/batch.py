"""Throughput of a batch: the shipped sweep of 40 scenes on one and on two processes, each one thread.

Run from the repository's root, with nothing else on the machine:

    python benchmarks/cost/batch.py         # one process against two
    python benchmarks/cost/batch.py cost    # processor time of a scene by accuracy

Both runs have worker processes, whose start is counted; tasks are checked before. Bits are compared too. The
processor time of the workers tells, on a busy machine as well, what the second one costs.
"""

import sys
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from tempfile import TemporaryDirectory
from time import perf_counter, process_time

from pyworm.batch.solve_tasks import solve_all
from pyworm.batch.solved_scenes import Store
from pyworm.batch.sweep import load_sweep
from pyworm.batch.task import Task
from pyworm.batch.workers import WorkerPool
from pyworm.case.case import load
from pyworm.scene.index import ContactIndex

SWEEP = Path("cases/sweeps/film_of_speed_and_load.toml")
TIMED = ("seconds", "convolutions")


CASES = (
    ("line contact, isothermal", Path("cases/line_m20_l10.toml"), "isothermal"),
    ("line contact, thermal", Path("cases/line_thermal.toml"), "all"),
    ("point contact, isothermal", Path("cases/traction_steel.toml"), "isothermal"),
    ("point contact, thermal", Path("cases/traction_steel.toml"), "all"),
    ("worm teeth, isothermal", Path("cases/zi_sharif_2001.toml"), "isothermal"),
    ("worm teeth, thermal", Path("cases/zi_sharif_2001.toml"), ("all", "-squeeze")),
)
ACCURACIES = (0.05, 0.02, 0.01)


def throughput() -> None:
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


def cost() -> None:
    """Seconds of processor a scene, on average over up to three places of a case, planning included."""
    Task(
        load(CASES[0][1]), ContactIndex(), 0.05
    ).solved()  # what is loaded at the first solve is not a scene's
    print(f"{'':26}" + "".join(f"{accuracy:>10.0%}" for accuracy in ACCURACIES))
    for name, path, effects in CASES:
        cells = []
        for accuracy in ACCURACIES:
            case = load(path)
            places = case.places()
            chosen = {places[len(places) // 4], places[len(places) // 2], places[-1]}
            started = process_time()
            for place in chosen:
                Task(case, place, accuracy, effects).solved()
            cells.append((process_time() - started) / len(chosen))
        print(f"{name:26}" + "".join(f"{seconds:10.2f}" for seconds in cells), flush=True)


def processor_time() -> float:
    """Of the processes that have ended [s]."""
    used = getrusage(RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


if __name__ == "__main__":
    cost() if sys.argv[1:] == ["cost"] else throughput()
