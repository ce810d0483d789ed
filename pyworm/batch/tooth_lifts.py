"""Lifts of a drive's teeth, which move its loads, by coarse transient solves of their life.

They have twice the spacing and the time step of a run's first transient solve, at a quarter to a half of its
cost. What they lack by their grids and by pressure beyond their windows is added at all phases alike
(`FULL_LIFT`).
"""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import dataclass, replace

from pyworm.batch.task import Task
from pyworm.batch.transient_solutions import tasks_by_part
from pyworm.io.present import present
from pyworm.kernel.core import KernelError
from pyworm.solver.transient.lifts import Lift, moving_lift
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.transient import part_at, present_in_life

FULL_LIFT = 1.25
"""Lift of a film within error bars over that of a coarse solve.

It is 1.16 to 1.40 in `cases/zi_drive.toml` and `cases/worm_drawing.toml`, 1.00 to 1.25 in drives 2 of seeds
99014 and 99015 of `tests/hard`, whose asperities carry most of the load. Loads by lifts of coarse solves
differ from those by full ones by 5.0, 0.4, 0.7 and 1.8 %, by 1.1, 0.5, 0.6 and 2.3 % with it.
"""


@dataclass(frozen=True)
class PartLifts:
    """Lifts of contacts of one part of a life, all point contacts."""

    tasks: tuple[Task, ...]
    """The contacts."""

    def __call__(self) -> dict[float, Lift]:
        """Phase -> lift, without those of which no film is found.

        NoFilmError if there is none of any.
        """
        time_grid = self.tasks[0].time_grid.coarser()
        phases = {present_in_life(task.scene).seconds: task.place.phase for task in self.tasks}
        begin = part_at(time_grid, min(phases)).begin
        found = integrate_in_time(time_grid, 0, begin, [*phases])
        lifts = {}
        for seconds, rigid_film in found.rigid_films.items():
            with suppress(KernelError):  # its scene meets the same dry contact, and tells it
                lift = moving_lift(time_grid, seconds, rigid_film, found.records)
                phase = present(phases[seconds], "phase")
                lifts[phase] = replace(lift, distance=FULL_LIFT * lift.distance)
        return lifts


def lifts_of(tasks: Sequence[Task], executor: Executor | None) -> dict[float, Lift]:
    """Phase -> lift of the contacts of one life in motion, without those of which no film is found."""
    parts = [PartLifts(part) for part in tasks_by_part(tasks)]
    calls: list[Callable[[], dict[float, Lift]]] = [*parts]
    if executor is not None:
        calls = [future.result for future in [executor.submit(part) for part in parts]]
    found: dict[float, Lift] = {}
    for call in calls:
        with suppress(Exception):  # the scenes of that part meet the same, and tell it
            found |= call()
    return found
