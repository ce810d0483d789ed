"""From a sweep file to the tasks of all its scenes, each checked before the first is solved."""

from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any

from pyworm.batch.solved_scenes import Store
from pyworm.batch.task import Task
from pyworm.case.case import Case, case_of, case_without_contacts, checked
from pyworm.case.dotted_keys import with_values
from pyworm.case.fitted_values import with_fitted
from pyworm.case.sweep import SweepTable, Value
from pyworm.io.input_error import CaseError, toml
from pyworm.io.toml import read_toml


@dataclass(frozen=True)
class Sweep:
    """Scenes that differ in some values of one case."""

    name: str
    """File name without its ending."""
    title: str
    """What it is."""
    written: dict[str, Any]
    """The file."""
    axes: list[list[str]]
    """The keys that vary, those that go together in one list."""
    values: tuple[Mapping[str, Value], ...]
    """Values of each scene that vary, as written, by key."""
    tasks: tuple[Task, ...]
    """Its scenes: the values of the last table of `vary` change fastest but for the places of each case."""


def load_sweep(
    path: str | Path,
    share: tuple[int, int] = (1, 1),
    executor: Executor | None = None,
    progress: Callable[[str, float], None] | None = None,
    store: Store | None = None,
) -> Sweep:
    """Read a sweep file and check every scene of it in full, those solved before by their keys alone.

    `share` (i, n) takes the i-th of n shares of its cases; the processes of `executor` check, by default this
    one. CaseError with whatever is wrong first: one sentence that names the sweep and, of a scene, the
    values.
    """
    path = Path(path)
    data = read_toml(path)
    try:
        tables = checked(SweepTable, data)
        base = path.parent / tables.case
        # One that cannot be read says its own name.
        whole = with_fitted(read_toml(base), base.parent).content
        content = with_values(whole, tables.fixed)
        first, count = share
        combinations = list(_combinations(tables))[first - 1 :: count]
        make = partial(_tasks, content, path.stem, base.parent, tables.effects, store)
        pairs = []
        tasks_of_all = (executor.map if executor else map)(make, combinations)
        for number, (values, tasks) in enumerate(zip(combinations, tasks_of_all, strict=True), 1):
            pairs += [(values, task) for task in tasks]
            if progress is not None:
                progress(
                    f"{number} of {len(combinations)} cases checked", number / len(combinations)
                )
    except CaseError as error:
        raise CaseError(f"{path}: {error}") from error
    if not pairs:
        raise CaseError(f"{path}: has no share {first}/{count}, there are fewer cases")
    every_values, every_task = zip(*pairs, strict=True)
    axes = [list(table) for table in tables.vary]
    return Sweep(path.stem, tables.title, data, axes, every_values, every_task)


def label(values: Mapping[str, Value]) -> str:
    """Label of a scene of a sweep: its varied values."""
    return ", ".join(f"{key} = {toml(value)}" for key, value in values.items())


def _combinations(tables: SweepTable) -> Iterator[dict[str, Value]]:
    """The values of every scene, by key."""
    axes = [
        [dict(zip(axis, together, strict=True)) for together in zip(*axis.values(), strict=True)]
        for axis in tables.axes()
    ]
    for parts in product(*axes):
        yield {key: value for part in parts for key, value in part.items()}


def _tasks(
    content: dict[str, Any],
    name: str,
    directory: Path,
    effects: tuple[str, ...] | None,
    store: Store | None,
    values: dict[str, Value],
) -> list[Task]:
    """The scenes of one case of a sweep, checked and planned unless they are solved; without the plans."""
    data, named = with_values(content, values), f"{name}: {label(values)}"
    try:
        if store is not None:
            tasks = _of_case(case_without_contacts(data, named, directory), effects)
            if all(map(store.holds, tasks)):
                return tasks
        case = case_of(data, named, directory)
        tasks = _of_case(case, effects)
        for task in tasks:
            _ = task.plan
    except ValueError as error:
        raise CaseError(f"with {label(values)}: {error}") from error
    bare = replace(case)
    return [replace(task, case=bare) for task in tasks]


def _of_case(case: Case, effects: tuple[str, ...] | None) -> list[Task]:
    return [
        Task(case, place, case.accuracy, effects or case.effects, case.quantities)
        for place in case.places()
    ]
