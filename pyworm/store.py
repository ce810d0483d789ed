"""Solved scenes, each kept in a file of its own as soon as it is solved, under the key of its task."""

import json
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pyworm.output import PARTIAL, whole_file
from pyworm.result import Result, open_result
from pyworm.task import Task


@dataclass(frozen=True)
class Store:
    """A directory of solved scenes; several processes may fill one together.

    Files appear whole or not at all; an empty one, as a power cut may leave, counts as not there.

    Attributes
    ----------
    directory : Path
        Where the files are; made with the first.
    fields : bool
        Whether solutions are kept in full, `KEY.nc`, a result of one scene; else only their scalars are,
        `KEY.json`, with all that decided them.
    """

    directory: Path
    fields: bool

    def file(self, task: Task) -> Path:
        """Where a solved task is kept."""
        return self.directory / f"{task.key}.{'nc' if self.fields else 'json'}"

    def keep(self, task: Task, result: Result) -> None:
        """Write down what a task came to; OSError if that is not possible."""
        self.directory.mkdir(parents=True, exist_ok=True)
        file = self.file(task)
        if self.fields:
            result.save(file)
            return
        (solution,) = result.solutions
        content = {"task": task.identity, "summary": solution.summary()}
        with whole_file(file) as partial:
            partial.write_text(json.dumps(content, default=lambda item: item.item()))

    def missing(self, tasks: Iterable[Task]) -> list[Task]:
        """The tasks that are still to be solved, each once."""
        there = {path.name for path in self.directory.glob("*") if path.stat().st_size}
        return list(
            {task.key: task for task in tasks if self.file(task).name not in there}.values()
        )

    def result(self, task: Task) -> Result:
        """A solution kept in full, as the result that it came in; OSError if its file was damaged."""
        try:
            return open_result(self.file(task))
        except ValueError as error:
            raise OSError(f"{error}; without it the scene is solved again") from error

    def summary(self, task: Task) -> dict[str, Any]:
        """The scalars of a solution, as of `Solution.summary`; OSError if its file was damaged."""
        if self.fields:
            return self.result(task).solutions[0].summary()
        file = self.file(task)
        try:
            return json.loads(file.read_text())["summary"]
        except (ValueError, LookupError, TypeError) as error:
            raise OSError(f"{file} is damaged; without it the scene is solved again") from error

    def drop(self, tasks: Iterable[Task]) -> None:
        """Forget what these tasks came to, halves that killed processes left behind included."""
        names = {self.file(task).name for task in tasks}
        for path in self.directory.glob("*"):
            partial = PARTIAL.fullmatch(path.name)
            if (partial[1] if partial else path.name) in names:
                path.unlink(missing_ok=True)
        with suppress(OSError):  # not empty, or never made
            self.directory.rmdir()
