"""Expected processor time of a run: of all that is solved, and of the search for what a case leaves open.

It goes by what `drive_iteration` usually does.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from pyworm.batch.drive_iteration import (
    ESTIMATE_ACCURACY,
    MAX_ESTIMATES,
    PHASE_STRIDE,
    estimate_of,
    every,
    steady,
)
from pyworm.batch.task import Task
from pyworm.batch.transient_solutions import is_transient
from pyworm.case.case import Case
from pyworm.solver.cost.expected_time import Expectation, expectations, together

TEMPERATURE_PASSES = 2
"""Usual number of passes until temperatures are found: that of `cases/zi_cooled.toml`."""

USUAL_PASSES = 2
"""Usual number of passes until loads are found by steady films of the accuracy asked for, where it is no
higher than the one of the search."""

COARSE_SOLVES = 0.8
"""Work of the search for lifts in motion, in first transient solves of the life: one or two coarse ones and
steady films of one contact; 1.5 and 1.0 in the cases of `tooth_lifts`, half where lives take longer."""

MOVING_PASSES = 1.1
"""Usual number of passes with all phases whose lifts coarse solves found before: one, of ten runs of drives 1
to 3 of seed 99017 of `tests/hard` and of these cases at 5 and 10 %, and some drives need two."""

OVERHEAD_SECONDS = 3.5
"""Processor time of a run besides its solves: start, results file and pictures [s]. Whole runs of steel gear
pairs at 10 %, five contacts each, whose solves take tenths of a second, took 3.2 to 11.7 s, half of 38 up to
4.0 (`docs/evidence/data/hard_drives.csv`)."""


@dataclass(frozen=True)
class ExpectedRun:
    """Expected cost of a run."""

    case: Case
    """The case."""
    tasks: tuple[Task, ...]
    """Those of the run."""
    each: tuple[Expectation, ...]
    """Cost of each task by itself."""
    once: float
    """Processor time of all of them solved once, with transient solves that they share [s]."""

    @cached_property
    def search(self) -> float:
        """Processor time of the search for temperatures and lifts before [s]; planning it takes a second."""
        open_, search = self.case.left_open, 0.0
        if "cooling" in open_:
            some = [steady(task) for task in every(PHASE_STRIDE, self.tasks)]
            search += TEMPERATURE_PASSES * _solved(some)[1]
        if "lifts" in open_.get("operation", ()):
            search += _lifts(self.tasks, self.once)
        return search

    @cached_property
    def cycle(self) -> float:
        """Processor time of the mesh cycle's data for the result [s]; none of a single contact."""
        drive = self.case.drive
        if drive is None or len(self.each) == 1:
            return 0.0
        sampling = float(np.mean([expectation.sampling for expectation in self.each]))
        return drive.cycle_seconds + drive.cycle_points * sampling

    @property
    def seconds(self) -> float:
        """Processor time of the run, but for that search [s]."""
        return self.once + self.cycle + OVERHEAD_SECONDS


def expected_run(case: Case, tasks: Sequence[Task]) -> ExpectedRun:
    """The expected cost of a run of some tasks of a case that were not solved before."""
    return ExpectedRun(case, tuple(tasks), *_solved(tasks))


def _solved(tasks: Sequence[Task]) -> tuple[tuple[Expectation, ...], float]:
    """Expected cost of each of some tasks, and processor time of all together [s]."""
    lives = [replace(task.place, phase=None) for task in tasks]
    each = tuple(expectations([(task.scene, task.plan) for task in tasks], lives))
    return each, together(each, lives)


def _lifts(tasks: Sequence[Task], once: float) -> float:
    """Processor time of the search for lifts, from some of the tasks and that of all solved once [s]."""
    accuracy = tasks[0].accuracy
    some = [estimate_of(task) for task in every(PHASE_STRIDE, tasks)]
    all_of_them = len(tasks) / len(some)
    moving = [task for task in some if is_transient(task)]
    if not moving and accuracy < ESTIMATE_ACCURACY:
        return MAX_ESTIMATES * all_of_them * _solved(some)[1]
    if not moving:
        return (USUAL_PASSES - 1) * once
    each, seconds = _solved(moving)
    life = seconds - sum(expectation.seconds - expectation.past for expectation in each)
    return COARSE_SOLVES * life + (MOVING_PASSES - 1) * once
