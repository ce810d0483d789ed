"""Films in motion of many phases: one transient solve of each part of a life serves all of them.

Each solve is a call of its own, in any process, and leaves a file for each task that it serves; the tasks
then solve their films with these rates of change. Both are the same to the last bit as where a task finds its
own: a transient solve does not depend on which of its times are wanted.
"""

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor, as_completed
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from zipfile import BadZipFile

import numpy as np

from pyworm.batch.task import Task
from pyworm.io.atomic import whole_file
from pyworm.io.reason import reason_of
from pyworm.planning.expected_work import REFINEMENTS
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.solver.transient.course import course_of
from pyworm.solver.transient.march import LostError, RateOfChange, march
from pyworm.solver.transient.transient import Rates, part_at, recent

FEWEST = 2
"""Number of tasks of one life from which they share its transient solve."""


@dataclass(frozen=True)
class LifePart:
    """One transient solve through a part of a life.

    Attributes
    ----------
    tasks : tuple of Task
        The tasks whose films it holds.
    refinement : int
        Halvings of the spacing and of the time step.
    """

    tasks: tuple[Task, ...]
    refinement: int

    def solve_into(self, directory: Path) -> str | None:
        """Write the rates of change of its tasks; returns why there are none, or None."""
        try:
            self._solve_into(directory)
        except Exception as error:  # its tasks will find the same reason, each for itself
            return reason_of(error)
        return None

    def _solve_into(self, directory: Path) -> None:
        first = self.tasks[0]
        course = course_of(first.scene.past.life, first.plan)
        wanted = {task.key: task.scene.past.seconds for task in self.tasks}
        part = part_at(course, first.scene.past.seconds)
        try:
            rates = march(course, self.refinement, part.begin, sorted(wanted.values())).rates
        except LostError as lost:
            for key in wanted:
                _write(_file(directory, key, self.refinement), flaw=str(lost))
            return
        for key, at in wanted.items():
            rate = rates[at]
            grid = list(vars(rate.grid).values())
            _write(_file(directory, key, self.refinement), grid=grid, rate=rate.rate)


def solve_lives(
    tasks: Sequence[Task],
    directory: Path,
    executor: Executor | None,
    tell: Callable[[str, float], None],
) -> None:
    """Solve the lives that several tasks share, where films in motion are simulated, into a directory."""
    parts = [
        LifePart(part, refinement)
        for refinement in reversed(range(REFINEMENTS))
        for life in _lives(tasks, directory)
        for part in _parts(life)
    ]
    if not parts:
        return
    directory.mkdir(parents=True, exist_ok=True)
    message = "films in motion, from the first touch to the last"
    tell(message, 0.0)
    if executor is None:
        for part in parts:
            part.solve_into(directory)
        return
    for _ in as_completed([executor.submit(part.solve_into, directory) for part in parts]):
        tell(message, 0.0)


def rates_for(task: Task, directory: Path) -> Rates | None:
    """Rates of change of a task's film that were left for it; None where there are not all."""
    found = []
    for refinement in range(REFINEMENTS):
        try:
            with (
                _file(directory, task.key, refinement).open("rb") as file,
                np.load(file) as data,
            ):
                if "flaw" in data:
                    return Rates((), str(data["flaw"]))
                numbers = data["grid"].tolist()
                found.append(RateOfChange(_grid(numbers), data["rate"]))
        except (OSError, ValueError, LookupError, EOFError, BadZipFile):
            return None
    return Rates(tuple(found))


def drop_rates(tasks: Iterable[Task], directory: Path) -> None:
    """Remove what was left for some tasks."""
    for task in tasks:
        for refinement in range(REFINEMENTS):
            with suppress(OSError):
                _file(directory, task.key, refinement).unlink(missing_ok=True)


def _parts(life: Sequence[Task]) -> list[tuple[Task, ...]]:
    """Tasks of a life by the part that holds their film."""
    course = course_of(life[0].scene.past.life, life[0].plan)
    found = defaultdict(list)
    for task in life:
        found[part_at(course, task.scene.past.seconds)].append(task)
    return [tuple(part) for part in found.values()]


def _lives(tasks: Sequence[Task], directory: Path) -> list[tuple[Task, ...]]:
    """Tasks whose films are in motion, by their life; without those that nobody shares one with."""
    lives = defaultdict(list)
    for task in tasks:
        if _shares_its_life(task) and rates_for(task, directory) is None:
            lives[id(task.case), replace(task.place, phase=None)].append(task)
    return [tuple(life) for life in lives.values() if len(life) >= FEWEST]


def _shares_its_life(task: Task) -> bool:
    """Whether a task's film is in motion, and its life is solved as a whole."""
    try:
        return "squeeze" in task.plan.on and recent(task.scene) is task.scene.past
    except ValueError:  # the reason that the task will give
        return False


def _file(directory: Path, key: str, refinement: int) -> Path:
    return directory / f"{key}.rate-{refinement}.npz"


def _write(file: Path, **content: object) -> None:
    with whole_file(file) as partial, partial.open("wb") as stream:
        np.savez(stream, **content)


def _grid(numbers: Sequence[float]) -> Grid | LineGrid:
    """A grid from the values of its attributes."""
    kind = Grid if len(numbers) == len(Grid.__dataclass_fields__) else LineGrid
    whole = [of.type in ("int", int) for of in kind.__dataclass_fields__.values()]
    return kind(*(int(of) if is_whole else of for of, is_whole in zip(numbers, whole, strict=True)))
