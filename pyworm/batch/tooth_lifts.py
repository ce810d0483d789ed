"""Lifts of a drive's teeth, which move its loads, by coarse transient solves of their life.

They have twice the spacing and the time step of a run's first transient solve, at 0.3 to 0.6 of its cost in
`cases/zi_drive.toml` and `cases/worm_drawing.toml`. By their grids and by pressure beyond their windows lifts
are 0.15 to 0.30 smaller than full ones there, and friction 0.15 larger; steady films of one contact tell how
much (`SteadyRatios`). Loads then differ from those by full lifts by 1.8 and 0.5 %
(`benchmarks/accuracy/coarse_lifts.py`).
"""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import dataclass

from pyworm.batch.task import Task
from pyworm.batch.transient_solutions import tasks_by_part
from pyworm.io.present import present
from pyworm.kernel.core import KernelError
from pyworm.solver.transient.lifts import Lift, moving_lift, steady_lift
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.transient import part_at, present_in_life

LARGEST_RATIO = 2.0
"""Largest ratio of a value by steady films of usual and of coarse grids that is used."""


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
                lifts[present(phases[seconds], "phase")] = lift
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


@dataclass(frozen=True)
class SteadyRatios:
    """What steady films of a contact have over those on the coarse grid of its life."""

    task: Task
    """The contact, in motion."""
    steady: Task
    """A task of its steady film."""

    def __call__(self) -> tuple[float, float]:
        """Ratios of the lifts and of the friction coefficients (`_ratio`).

        KernelError or NoFilmError where one of the films is not found.
        """
        figures = self.steady.solved().solutions[0].figures
        seconds = present_in_life(self.task.scene).seconds
        coarse = steady_lift(self.task.time_grid.coarser(), seconds)
        friction = figures.friction_coefficient
        return (
            _ratio(present(figures.lift, "lift"), coarse.distance),
            _ratio(friction.value if friction else 0.0, coarse.friction),
        )


def steady_ratios(task: Task, steady: Task, executor: Executor | None) -> tuple[float, float]:
    """The ratios of a contact in motion (`SteadyRatios`); 1 where they are not known."""
    ratios = SteadyRatios(task, steady)
    try:
        return ratios() if executor is None else executor.submit(ratios).result()
    except Exception:  # its scene may meet the same, and tells it
        return 1.0, 1.0


def _ratio(full: float, coarse: float) -> float:
    """Their ratio; 1 where they are not known, or where a factor of two between them tells of other films."""
    return full / coarse if coarse / LARGEST_RATIO < full < LARGEST_RATIO * coarse else 1.0
