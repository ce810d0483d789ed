"""Transient solutions at many phases: one solve of each part of a life serves all of them.

Each solve is a call of its own, in any process, and leaves a file for each task that it serves; the tasks
then solve their films with these rates of change. Both are the same to the last bit as where a task finds its
own, but for point contacts: those of the later part of a life begin later alone (`MAX_ALONE_TRANSITS`), and
stretches of finer solves that overlap are one, which begins with the first (`time_steps.restart_place`).
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
from pyworm.solver.transient.restart import Restart, restart_arrays, restart_from
from pyworm.solver.transient.time_integration import (
    RateOfChange,
    TimeIntegration,
    integrate_in_time,
    integrate_on,
)
from pyworm.solver.transient.time_records import (
    TimeRecord,
    as_arrays,
    completed,
    from_arrays,
    until,
)
from pyworm.solver.transient.time_steps import in_stretches, restart_place
from pyworm.solver.transient.transient import Part, Rates, part_at, present_in_life, recent

MIN_SHARED_TASKS = 2
"""Number of tasks of one life from which they share its transient solve."""


RATES = "rate", "rise", "warming", "pressing", "limited", "content"
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
    memory_end: float
    """Time from which its films no longer depend on those from which it went on [s]."""


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
        left: Sequence[Task] = self.tasks
        while left:
            left = self._solve_some(directory, left)

    def _solve_some(self, directory: Path, tasks: Sequence[Task]) -> list[Task]:
        """Write what one solve leaves for some tasks; returns those that another beginning may lead to."""
        time_grid, begin = self.task.time_grid, self._part.begin
        wanted = [_seconds(task) for task in tasks]
        restarts = [self._restart(task, directory) for task in tasks]
        after = solves_of_life(self.task.accuracy) - 1 - self.refinement
        found, flaw = None, None
        try:
            if restarts[0] is not None:
                found = integrate_on(time_grid, restarts[0], begin, wanted, after)
            else:
                how = begin, wanted, self._until(wanted), after
                found = integrate_in_time(time_grid, self.refinement, *how)
            flaw = found.failure
        except NoFilmError as error:
            flaw = str(error)
        first = time_grid.time_at(begin) if restarts[0] is None else restarts[0].step.seconds
        last = found.records[-1].seconds if found else first
        left = []
        for task, seconds, restart in zip(tasks, wanted, restarts, strict=True):
            if found and seconds in found.rates:
                self._keep(directory, task, seconds, found)
            elif restart is not None and restart.step.seconds > last:
                left.append(task)
            else:
                keep(directory / _file(task.key, self.refinement), flaw=flaw)
        return left

    def _keep(self, directory: Path, task: Task, seconds: float, found: TimeIntegration) -> None:
        """Write what a solve has found for a task whose film it holds at a time [s]."""
        rate = found.rates[seconds]
        figures = {name: getattr(rate, name) for name in RATES}
        known = {name: value for name, value in figures.items() if value is not None}
        since, until_then = self._kept_between(seconds)
        keep(
            directory / _file(task.key, self.refinement),
            grid=list(vars(rate.grid).values()),
            since=since,
            begin=self._part.begin,
            rigid_film=found.rigid_films[seconds],
            memory_end=found.memory_end,
            **known,
            **as_arrays(until(found.records, until_then)),
        )
        if seconds in found.restarts:
            file = directory / _restart_file(task.key, self.refinement)
            keep(file, **restart_arrays(found.restarts[seconds]))

    @property
    def _part(self) -> Part:
        return part_at(self.task.time_grid, _seconds(self.tasks[0]))

    def _until(self, wanted: Sequence[float]) -> float:
        """Time up to which a solve that begins with the part goes [s]: the first to its end."""
        time_grid = self.task.time_grid
        if self.refinement > 0 and in_stretches(time_grid):
            return wanted[-1]
        return time_grid.time_at(self._part.last)

    def _restart(self, task: Task, directory: Path) -> Restart | None:
        """Films of the solve before from which this one goes on for a task, if it has left some."""
        if self.refinement == 0:
            return None
        try:
            return kept(directory / _restart_file(task.key, self.refinement - 1), restart_from)
        except (OSError, DamagedError):
            return None

    def stretches(self, refinement: int) -> list["LifePart"]:
        """Solves of its tasks on finer grids: each a stretch, or several that overlap."""
        if refinement == 0:
            return [self]
        after = solves_of_life(self.task.accuracy) - refinement
        time_grid = self.task.time_grid
        parts: list[list[Task]] = []
        last = inf
        for task in self.tasks:
            place = restart_place(time_grid, _seconds(task), after)
            if parts and (place is None or place <= last):
                parts[-1].append(task)
            else:
                parts.append([task])
            last = time_grid.place(_seconds(task))
        return [LifePart(self.task, tuple(tasks), refinement) for tasks in parts]

    def _kept_between(self, seconds: float) -> tuple[float, float]:
        """Times between which a task of a time keeps what a solve found: together they keep all of it [s]."""
        time_grid, part = self.task.time_grid, self._part
        times = [_seconds(task) for task in self.tasks]
        number = times.index(seconds)
        first = time_grid.time_at(part.first) if part.first > 0 else -inf
        last = time_grid.time_at(part.last)
        return (times[number - 1] if number else first), (seconds if seconds < times[-1] else last)

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
    first = [
        LifePart(life[0], part, 0)
        for life in _lives(tasks, directory)
        for part in tasks_by_part(life)
    ]
    # finer ones go on from films of those before, or need not begin where these find nothing
    most = max((solves_of_life(part.task.accuracy) for part in first), default=0)
    for refinement in range(most):
        parts = [
            stretch
            for part in first
            if refinement < solves_of_life(part.task.accuracy)
            for stretch in part.stretches(refinement)
        ]
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
    since, begin = (found[0].since, found[0].begin) if found else (-inf, 0.0)
    rates = tuple(left.rate for left in found)
    records = completed([(left.records, left.memory_end) for left in found])
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
        float(data["memory_end"]),
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
        found[part_at(time_grid, _seconds(task))].append(task)
    return [tuple(sorted(part, key=_seconds)) for part in found.values()]


def _seconds(task: Task) -> float:
    """Time of a task's film in its life [s]."""
    return present_in_life(task.scene).seconds


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


def _restart_file(key: str, refinement: int) -> str:
    """One of those that `_file` has of any refinement."""
    return _file(key, f"{refinement}.restart")


def _grid(numbers: Sequence[float]) -> Grid | LineGrid:
    """A grid from the values of its attributes."""
    if len(numbers) == len(fields(Grid)):
        west, south, dx, dy, columns, rows = numbers
        return Grid(west, south, dx, dy, int(columns), int(rows))
    dx, first, count = numbers
    return LineGrid(dx, int(first), int(count))
