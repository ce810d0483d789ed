"""Store of solved scenes: one file for each, written as soon as it is solved, named by the task's key."""

import json
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from pyworm.batch.task import Task, key_of
from pyworm.io.atomic import remove_abandoned, whole_file
from pyworm.io.bounded_number import read_json
from pyworm.result.result import Result, open_result
from pyworm.result.rounded_fields import is_rounded, rounded
from pyworm.solver.solution import Solution


@dataclass(frozen=True)
class Store:
    """A directory of solved scenes; several processes may fill one together.

    Files appear whole or not at all; a damaged one counts as not there.
    """

    directory: Path
    """Where the files are; made with the first."""
    fields: bool
    """Whether solutions are kept in full, `KEY.nc`, a result of one scene; else only their scalars are,
    `KEY.json`, with all that decided them."""
    sole: bool = False
    """Whether one scene is solved, which goes into a result at once, without a file of its own."""
    all_digits: bool = False
    """Whether fields keep all their digits; else they are rounded to the accuracy they have."""
    _solved_here: dict[str, Result] = field(default_factory=dict, compare=False, repr=False)

    def file(self, task: Task) -> Path:
        """File of a solved task."""
        return self.directory / f"{task.key}.{'nc' if self.fields else 'json'}"

    def keep(self, task: Task, result: Result) -> None:
        """Store the solution of a task; OSError if that is not possible."""
        file = self.file(task)
        if self.fields:
            if not self.all_digits:
                result = replace(result, solutions=tuple(map(rounded, result.solutions)))
            self._solved_here[task.key] = result
            if not self.sole:
                result.save(file)
            return
        (solution,) = result.solutions
        content = {"task": task.identity, "summary": solution.summary()}
        with whole_file(file) as partial:
            partial.write_text(json.dumps(content, default=lambda item: item.item()))

    def secure(self, tasks: Iterable[Task]) -> None:
        """Write those solved here whose result cannot be written, as far as their files can be."""
        for task in tasks:
            if task.key in self._solved_here and not self.file(task).exists():
                with suppress(OSError):
                    self._solved_here[task.key].save(self.file(task))

    def holds(self, task: Task) -> bool:
        """Whether a task was solved and its file can be read."""
        try:
            self.summary(task)
        except OSError:
            return False
        return True

    def missing(self, tasks: Iterable[Task]) -> list[Task]:
        """The tasks still to be solved, each once, as of `solved`."""
        wanted = {task.key: task for task in tasks}
        found = self.solved(wanted.values())
        return [task for key, task in wanted.items() if key not in found]

    def solved(self, tasks: Iterable[Task]) -> dict[str, dict[str, Any]]:
        """Key and `summary` of the tasks that are solved; partial files of killed processes are removed."""
        remove_abandoned(self.directory)
        found = {}
        for task in tasks:
            with suppress(OSError):
                found[task.key] = self.summary(task)
        return found

    def result(self, task: Task) -> Result:
        """A complete solution, solved here or stored; OSError if its file is missing or damaged."""
        here = self._solved_here.get(task.key)
        return self._stored(task) if here is None else here

    def _stored(self, task: Task) -> Result:
        file = self.file(task)
        try:
            result = open_result(file)
        except ValueError as error:
            raise OSError(f"{error}; the same command solves it again") from error
        if result.provenance.get("keys") != [task.key] or len(result.solutions) != 1:
            raise OSError(f"{file} holds another contact; the same command solves it again")
        if not self.serves(result.solutions[0]):
            raise OSError(f"{file} has rounded fields; the same command solves it again")
        return result

    def serves(self, solution: Solution) -> bool:
        """Whether a solution of an earlier run has the digits wanted."""
        return not (self.all_digits and is_rounded(solution))

    def summary(self, task: Task) -> dict[str, Any]:
        """The scalars of a stored solution, as `Solution.summary`; OSError if its file is missing or bad."""
        if self.fields:
            return self._stored(task).solutions[0].summary()
        file = self.file(task)
        try:
            content = read_json(file.read_bytes())
            summary = dict(content["summary"])
            sound = key_of(content["task"]) == task.key
        except (ValueError, LookupError, TypeError, RecursionError):
            sound = False
        if not sound:
            raise OSError(f"{file} is damaged; the same command solves it again")
        return summary

    def drop(self, tasks: Iterable[Task]) -> None:
        """Remove the stored solutions of some tasks."""
        for task in tasks:
            self.file(task).unlink(missing_ok=True)
        with suppress(OSError):  # not empty, or never made
            self.directory.rmdir()
