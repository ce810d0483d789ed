"""Friction fed back into the forces of a drive.

Its tooth loads follow from its torque and from friction, and friction from the films under these loads.

The first pass takes a usual friction. If that found would change the loads by more than a share of the
accuracy, all is solved again under the loads of the friction found.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import replace
from pathlib import Path

import numpy as np

from pyworm.case import Case
from pyworm.drive_cycle import drive_cycle
from pyworm.drives.zi_load import Transmission
from pyworm.result import Result, case_in
from pyworm.run import RESULT_NAME, run
from pyworm.solver import Progress
from pyworm.task import Task

PASSES = 2
"""Most passes: friction moves loads by a few per cent, and loads move friction far less than they move."""

LOAD_SHARE = 0.25
"""Change of the loads that asks for another pass, as a share of the accuracy."""


def run_balanced(
    case: Case,
    tasks: Sequence[Task],
    directory: Path,
    executor: Executor | None = None,
    progress: Progress | None = None,
    say: Callable[[str], None] = lambda message: None,
) -> tuple[Result, Sequence[Task]]:
    """Solve a case, with the friction that it finds itself if it is to find it.

    Arguments and errors as of `pyworm.run.run`; also returns the tasks as they were solved in the end.
    """
    open_ = case.friction_left_open
    if open_:
        case = _with_earlier_friction(case, directory)
        tasks = [replace(task, case=case) for task in tasks]
    result = run(case, tasks, directory, executor, progress, say)
    for _ in range(PASSES - 1 if open_ else 0):
        cycle = drive_cycle(result)
        if cycle is None or cycle.loss is None:
            break
        found = float(f"{cycle.loss.friction:.2g}")
        change = load_change(case, found)
        if change <= LOAD_SHARE * tasks[0].accuracy:
            break
        say(
            f"friction of the teeth is {found:g}, their loads change by {change:.1%} and all is "
            "solved again"
        )
        case = case.with_friction(found)
        tasks = [replace(task, case=case) for task in tasks]
        result = run(case, tasks, directory, executor, progress, say)
    return result, tasks


def load_change(case: Case, friction: float) -> float:
    """Share by which the loads of a drive's teeth change with another friction in the balance."""
    load: Transmission = case.drive.load
    arms = case.drive.arms(np.array([0.5]))
    before, after = (float(arms.of(load.shaft, of)[0]) for of in (load.friction, friction))
    return abs(before / after - 1)


def _with_earlier_friction(case: Case, directory: Path) -> Case:
    """The case with the friction that an earlier run of it found: it need not be found again."""
    earlier = case_in(directory / RESULT_NAME)
    if earlier is None:
        return case
    friction = earlier["operation"].get("friction")
    if friction is None or _without_choices(earlier) != _without_choices(case.resolved):
        return case
    return case.with_friction(friction)


def _without_choices(resolved: dict) -> dict:
    operation = {
        key: value
        for key, value in resolved["operation"].items()
        if key not in ("friction", "phases")
    }
    return {**resolved, "operation": operation}
