"""Why a run took far more processor time than was expected of it."""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from math import prod

from pyworm.batch.expected_run import ExpectedRun, expected_run
from pyworm.batch.task import Task
from pyworm.case.case import Case
from pyworm.io.quantity_text import duration
from pyworm.planning.expected_work import solves_of_life
from pyworm.result.result import Result
from pyworm.solver.cost.expected_time import Expectation
from pyworm.solver.solution import Solution

MAX_TIME_RATIO = 2.0
"""Processor time over that expected from which a run says why it took so long."""

MIN_SECONDS = 30.0
"""Processor time of a run up to which nothing is said [s]: start, writing and pictures are not expected."""

MIN_WORK_RATIO = 1.5
"""Nodes of a contact's finest grid, and Newton steps, over those expected from which they are named: grids
are refined fourfold, and numbers expected are means."""

SHARED = (
    "no contact by itself; the rest are transient solves that several share, the search for what the case "
    "leaves open, and flanks"
)
"""Where a run's time went of which no contact took far more than was expected of it."""


@dataclass(frozen=True)
class Overrun:
    """Processor time of a run that took far more than was expected."""

    taken: float
    """Processor time taken [s]."""
    expected: float
    """Processor time expected [s]."""
    reasons: tuple[str, ...]
    """Contacts that took most beyond what was expected of each, and why."""

    @property
    def sentence(self) -> str:
        """What took so long, in one sentence."""
        why = "; ".join(self.reasons) or SHARED
        taken, expected = duration(self.taken), duration(self.expected)
        return f"took {taken} of CPU time where {expected} were expected: {why}"


def processor_seconds() -> float:
    """Processor time of this process and of those of its own that have ended [s]."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def overrun(case: Case, tasks: Sequence[Task], result: Result, taken: float) -> Overrun | None:
    """Why a run took so long, by its processor time [s]; None of one that did not."""
    if taken <= MIN_SECONDS:
        return None
    expected = expected_run(case, tasks)
    least = taken / MAX_TIME_RATIO
    # planning the search takes a second, and only where a run took long does it decide
    if least <= expected.seconds or least <= (whole := expected.seconds + expected.search):
        return None
    return Overrun(taken, whole, tuple(_reasons(tasks, result, expected)))


def _reasons(tasks: Sequence[Task], result: Result, expected: ExpectedRun) -> list[str]:
    """Contacts that took more than twice what was expected of each, the longest first."""
    solved = {solution.name: solution for solution in result.solutions}
    beyond = [
        (solution.cost.processor_seconds - expectation.seconds, task, solution, expectation)
        for task, expectation in zip(tasks, expected.each, strict=True)
        if (solution := solved.get(task.scene.name)) is not None
        and solution.cost.processor_seconds > MAX_TIME_RATIO * expectation.seconds
    ]
    beyond.sort(key=lambda entry: -entry[0])
    return [_reason(task, solution, expectation) for _, task, solution, expectation in beyond]


def _reason(task: Task, solution: Solution, expected: Expectation) -> str:
    """Why one contact took so long."""
    times = f"{duration(solution.cost.processor_seconds)}, {duration(expected.seconds)} expected"
    more = []
    solves, usual = solution.cost.transient_solves, solves_of_life(task.accuracy)
    if solves > usual:
        more.append(f"{solves} transient solves, {usual} expected")
    history = solution.history
    nodes = prod(
        int(history[name].values[-1]) for name in ("points_x", "points_y") if name in history
    )
    if nodes > MIN_WORK_RATIO * task.plan.work.finest:
        more.append(f"a finest grid of {nodes:,} nodes, {task.plan.work.finest:,.0f} expected")
    steps = history.sizes["iteration"]
    if steps > MIN_WORK_RATIO * task.plan.work.steps:
        more.append(f"{steps} Newton steps, {task.plan.work.steps:.0f} expected")
    more = more or ["each Newton step took longer than when this machine was measured"]
    return f"{solution.name} ({times}: {', '.join(more)})"
