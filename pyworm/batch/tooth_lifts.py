"""Lifts of a drive's teeth, which move its loads, by first transient solves of their life or steady films.

A first transient solve is a tenth of the work of films within error bars. It is kept as a run keeps its own
(`transient_solutions`): where the loads that follow from its lifts are those that it was solved under, the
run goes on from it.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from pyworm.batch.task import Task
from pyworm.batch.transient_solutions import LifePart, left_for, solve_parts, tasks_by_part
from pyworm.io.present import present
from pyworm.kernel.core import KernelError
from pyworm.solver.transient.lifts import Lift, moving_lift, steady_lift
from pyworm.solver.transient.transient import present_in_life


def moving_lifts_of(
    tasks: Sequence[Task], directory: Path, executor: Executor | None
) -> dict[float, Lift]:
    """Phase -> lift of the contacts of one life in motion, without those of which no film is found.

    The transient solves are kept in a directory.
    """
    parts = [LifePart(tasks[0], part, 0) for part in tasks_by_part(tasks)]
    solve_parts(parts, directory, executor)
    lifts = {}
    for task in tasks:
        left = left_for(task, directory, 0)
        if left is None or isinstance(left, str):
            continue
        seconds = present_in_life(task.scene).seconds
        with suppress(KernelError):  # its scene meets the same dry contact, and tells it
            lift = moving_lift(tasks[0].time_grid, seconds, left.rigid_film, left.records)
            lifts[_phase(task)] = lift
    return lifts


@dataclass(frozen=True)
class SteadyLifts:
    """Lifts of contacts of one life, all point contacts, by steady films in the window of their motion."""

    tasks: tuple[Task, ...]
    """The contacts."""

    def __call__(self) -> dict[float, Lift]:
        """Phase -> lift; without those of which no film is found."""
        time_grid = self.tasks[0].time_grid
        found = {
            _phase(task): steady_lift(time_grid, present_in_life(task.scene).seconds)
            for task in self.tasks
        }
        return {phase: lift for phase, lift in found.items() if lift is not None}


def steady_lifts_of(tasks: Sequence[Task], executor: Executor | None) -> dict[float, Lift]:
    """Phase -> lift of the contacts of one life by steady films, without those of which none is found."""
    parts = [SteadyLifts(part) for part in tasks_by_part(tasks)]
    calls: list[Callable[[], dict[float, Lift]]] = [*parts]
    if executor is not None:
        calls = [future.result for future in [executor.submit(part) for part in parts]]
    found: dict[float, Lift] = {}
    for call in calls:
        with suppress(Exception):  # the scenes of that part meet the same, and tell it
            found |= call()
    return found


def _phase(task: Task) -> float:
    return present(task.place.phase, "phase")
