"""Lifts of a drive's teeth by films in motion, with the loads that they move.

Steady films give lifts first. What motion changes in them is told by the first transient solve of each part
of the life, a tenth of the work of films within error bars; under the loads that follow it is told again
until they stay. Each call goes to any process.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import dataclass

from pyworm.batch.films_in_motion import tasks_by_part
from pyworm.batch.task import Task
from pyworm.io.present import present
from pyworm.solver.transient.lifts import moving_lifts, steady_lift
from pyworm.solver.transient.transient import part_at, present_in_life


@dataclass(frozen=True)
class PartLifts:
    """Lifts at phases of one part of a life."""

    tasks: tuple[Task, ...]
    """Its contacts, all with point contacts in motion."""
    moving: bool
    """Whether by films in motion; else by steady ones in the same window."""

    def __call__(self) -> dict[float, float]:
        """Phase -> lift [m]; without those of which no film is found."""
        course = self.tasks[0].course
        phases = {
            present_in_life(task.scene).seconds: present(task.place.phase, "phase")
            for task in self.tasks
        }
        if self.moving:
            begin = part_at(course, min(phases)).begin
            found = moving_lifts(course, begin, sorted(phases))
        else:
            steady = {at: steady_lift(course, at) for at in phases}
            found = {at: lift for at, lift in steady.items() if lift is not None}
        return {phases[at]: lift for at, lift in found.items()}


def lifts_of(tasks: Sequence[Task], moving: bool, executor: Executor | None) -> dict[float, float]:
    """Phase -> lift [m] of the contacts of one life, without those of which no film is found."""
    parts = [PartLifts(part, moving) for part in tasks_by_part(tasks)]
    calls: list[Callable[[], dict[float, float]]] = [*parts]
    if executor is not None:
        calls = [future.result for future in [executor.submit(part) for part in parts]]
    found: dict[float, float] = {}
    for call in calls:
        with suppress(Exception):  # the scenes of that part meet the same, and tell it
            found |= call()
    return found
