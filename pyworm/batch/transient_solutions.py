"""Transient solutions at many phases: one solve of each part of a life serves all of them.

Each solve is a call of its own, in any process, and leaves a file for each task that it serves; the tasks
then solve their films with these rates of change. Both are the same to the last bit as where a task finds its
own, but for point contacts of the later part of a life, which begin later alone (`MAX_ALONE_TRANSITS`): a
transient solve does not depend on which of its times are wanted.
"""

from collections import defaultdict
from collections.abc import Callable, Sequence
from concurrent.futures import Executor, as_completed
from contextlib import suppress
from dataclasses import dataclass, fields, replace
from math import inf
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.batch.task import Task
from pyworm.io.kept_arrays import DamagedError, keep, kept
from pyworm.io.reason import reason_of
from pyworm.planning.effects.selection import effect_names
from pyworm.planning.expected_work import solves_of_life
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.solver.transient.next_film import NoFilmError
from pyworm.solver.transient.time_integration import RateOfChange, integrate_in_time
from pyworm.solver.transient.time_records import TimeRecord, as_arrays, from_arrays, until
from pyworm.solver.transient.transient import Rates, part_at, present_in_life, recent

MIN_SHARED_TASKS = 2
"""Number of tasks of one life from which they share its transient solve."""


RATES = "rate", "rise", "warming", "pressing", "limited"
"""Fields of a rate of change; those that are None are not kept."""


@dataclass(frozen=True)
class TaskFilm:
    """What a transient solve has left for a task: its film's rate of change, and the way there."""

    rate: RateOfChange
    """Rate of change of its film."""
    rigid_film: float
    """Rigid film [m]."""
    records: tuple[TimeRecord, ...]
    """What the solve found up to then, of the last task of a part up to the end of that."""
    since: float
    """Time of the scene before [s]."""
    begin: float
    """Where the solve begins [transits]."""


@dataclass(frozen=True)
class LifePart:
    """One transient solve through a part of a life."""

    task: Task
    """A task of its life: all parts take its course, which costs as much as a scene's plan."""
    tasks: tuple[Task, ...]
    """The tasks whose films it holds."""
    refinement: int
    """Halvings of the spacing and of the time step."""

    def solve_into(self, directory: Path) -> str | None:
        """Write the rates of change of its tasks; returns why there are none, or None."""
        try:
            self._solve_into(directory)
        except Exception as error:  # its tasks will find the same reason, each for itself
            return reason_of(error)
        return None

    def _solve_into(self, directory: Path) -> None:
        if self.refinement > 0 and self._diverged(directory):
            return
        time_grid = self.task.time_grid
        wanted = {task.key: present_in_life(task.scene).seconds for task in self.tasks}
        part = part_at(time_grid, present_in_life(self.tasks[0].scene).seconds)
        times, last = sorted(wanted.values()), time_grid.time_at(part.last)
        try:
            found = integrate_in_time(time_grid, self.refinement, part.begin, times, last)
            rates, flaw, records = found.rates, found.failure, found.records
        except NoFilmError as error:
            rates, flaw, records = {}, str(error), ()
        # each task keeps the stretch of the life since the one before it, and together they keep all of it
        first = time_grid.time_at(part.first) if part.first > 0 else -inf
        since = dict(zip(times, (first, *times[:-1]), strict=True))
        ends = {time: time for time in times} | {times[-1]: last}
        for key, seconds in wanted.items():
            file = directory / _file(key, self.refinement)
            if seconds not in rates:
                keep(file, flaw=flaw)
            else:
                grid = list(vars(rates[seconds].grid).values())
                arrays = as_arrays(until(records, ends[seconds]))
                figures = {name: getattr(rates[seconds], name) for name in RATES}
                known = {name: rate for name, rate in figures.items() if rate is not None}
                beside = {
                    "since": since[seconds],
                    "begin": part.begin,
                    "rigid_film": found.rigid_films[seconds],
                }
                keep(file, grid=grid, **beside, **known, **arrays)

    def _diverged(self, directory: Path) -> bool:
        """Whether the solve of twice the spacing has ended already and found no film of any task."""
        return all(
            isinstance(left_for(task, directory, self.refinement - 1), str) for task in self.tasks
        )

    def is_solved(self, directory: Path) -> bool:
        """Whether all that it finds is in a directory."""
        return None not in (left_for(task, directory, self.refinement) for task in self.tasks)


def solve_lives(
    tasks: Sequence[Task],
    directory: Path,
    executor: Executor | None,
    tell: Callable[[str, float], None],
) -> None:
    """Solve the lives that several tasks share, where transient solutions are simulated, into a directory."""
    parts = [
        LifePart(life[0], part, refinement)
        for life in _lives(tasks, directory)
        for part in tasks_by_part(life)
        for refinement in range(solves_of_life(life[0].accuracy))
    ]
    # where those of few nodes find nothing, finer ones need not begin
    parts.sort(key=lambda part: part.refinement)
    solve_parts(parts, directory, executor, tell)


def solve_parts(
    parts: Sequence[LifePart],
    directory: Path,
    executor: Executor | None,
    tell: Callable[[str, float], None] = lambda message, share: None,
) -> None:
    """Make the transient solves of some parts that are not in a directory yet."""
    left = [part for part in parts if not part.is_solved(directory)]
    if not left:
        return
    directory.mkdir(parents=True, exist_ok=True)
    message = "transient solution, from the first touch to the last"
    tell(message, 0.0)
    if executor is None:
        for part in left:
            part.solve_into(directory)
        return
    for _ in as_completed([executor.submit(part.solve_into, directory) for part in left]):
        tell(message, 0.0)


def rates_for(task: Task, directory: Path) -> Rates | None:
    """Rates of change of a task's film that were left for it; None where there are not all."""
    found: list[TaskFilm] = []
    for refinement in range(solves_of_life(task.accuracy)):
        left = left_for(task, directory, refinement)
        if left is None:
            return None
        if isinstance(left, str):  # what coarser solves found is better than nothing
            flaw = None if found else left
            return _rates(found, flaw=flaw, finest=True)
        found.append(left)
    return _rates(found)


def _rates(found: Sequence[TaskFilm], flaw: str | None = None, finest: bool = False) -> Rates:
    """Rates of change by what each of some transient solves has left."""
    since, begin = (found[-1].since, found[-1].begin) if found else (-inf, 0.0)
    rates, records = tuple(left.rate for left in found), tuple(left.records for left in found)
    return Rates(rates, records, since, begin, flaw, finest)


def left_for(task: Task, directory: Path, refinement: int) -> TaskFilm | str | None:
    """What a transient solve has left for a task, or why it found no film; None where there is no file."""
    try:
        return kept(directory / _file(task.key, refinement), _left)
    except (OSError, DamagedError):
        return None


def _left(data: dict[str, np.ndarray]) -> TaskFilm | str:
    """What a transient solve has left for a task by the arrays of its file, or why there is none."""
    if "flaw" in data:
        return str(data["flaw"])
    rates: dict[str, Any] = {name: data[name] for name in RATES if name in data}
    rates["limited"] = bool(data["limited"])
    return TaskFilm(
        RateOfChange(_grid(data["grid"].tolist()), **rates),
        float(data["rigid_film"]),
        from_arrays(data),
        float(data["since"]),
        float(data["begin"]),
    )


def drop_rates(task: Task, directory: Path) -> None:
    """Remove what was left for a task."""
    for file in directory.glob(_file(task.key, "*")):
        with suppress(OSError):
            file.unlink()


def tasks_by_part(life: Sequence[Task]) -> list[tuple[Task, ...]]:
    """Tasks of a life by the part that holds their film."""
    try:
        time_grid = life[0].time_grid
    except ValueError:  # the reason that each task will give
        return []
    found = defaultdict(list)
    for task in life:
        found[part_at(time_grid, present_in_life(task.scene).seconds)].append(task)
    return [tuple(part) for part in found.values()]


def _lives(tasks: Sequence[Task], directory: Path) -> list[list[Task]]:
    """Tasks whose films are transient, by their life; without those that nobody shares one with.

    Only what may share a life is planned: a sweep's thousands of cases have one each.
    """
    by_life = defaultdict(list)
    for task in tasks:
        by_life[id(task.case), replace(task.place, phase=None)].append(task)
    lives = (
        [task for task in some if is_transient(task) and rates_for(task, directory) is None]
        for some in by_life.values()
        if len(some) >= MIN_SHARED_TASKS
    )
    return [life for life in lives if len(life) >= MIN_SHARED_TASKS]


def is_transient(task: Task) -> bool:
    """Whether a task's film is transient, and its life is solved as a whole."""
    # a plan costs a tenth of a coarse solve
    if "-squeeze" in effect_names(task.effects):
        return False
    try:
        return "squeeze" in task.plan.on and recent(task.scene) is task.scene.past
    except ValueError:  # the reason that the task will give
        return False


def _file(key: str, refinement: object) -> str:
    return f"{key}.rate-{refinement}.npz"


def _grid(numbers: Sequence[float]) -> Grid | LineGrid:
    """A grid from the values of its attributes."""
    if len(numbers) == len(fields(Grid)):
        west, south, dx, dy, columns, rows = numbers
        return Grid(west, south, dx, dy, int(columns), int(rows))
    dx, first, count = numbers
    return LineGrid(dx, int(first), int(count))
