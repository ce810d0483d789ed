"""Iteration of friction, lifts and loss with the loads and temperatures that they determine.

The loads of a drive's teeth follow from its torque, from friction and from how far films lift the teeth off
each other, the temperatures of its oil and bodies from the loss between the teeth; all of these follow from
films under these loads and temperatures. Where roughness carries load and is not simulated, a standard's
loss takes the place of a smaller simulated one. The first pass takes usual values, and no lift. Where those
found would change loads or temperatures too much, films are solved again. What takes several passes is cheap:
temperatures are found with every `PHASE_STRIDE`-th phase and steady films, lifts by coarse transient solves
(`tooth_lifts`), or without transient solutions by steady films of `ESTIMATE_ACCURACY` in one window. All that
is solved last is solved in full.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from operator import methodcaller
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.batch.case_run import RESULT_NAME, run
from pyworm.batch.task import Task
from pyworm.batch.tooth_lifts import lifts_of, steady_ratios
from pyworm.batch.transient_solutions import is_transient
from pyworm.case.case import Case, case_again
from pyworm.drives.tooth_loss import FEWEST_PHASES
from pyworm.io.present import present
from pyworm.io.progress import Progress
from pyworm.planning.effects.selection import effect_names
from pyworm.ratings.heating import HeatingLoss, heating_loss, mesh_heating_loss, tooth_loss_of
from pyworm.ratings.mesh_loss import mesh_loss
from pyworm.ratings.standard_loss import standard_loss
from pyworm.result.mesh_cycle import DriveCycle, drive_cycle
from pyworm.result.result import Result, case_in
from pyworm.solver.transient.lifts import Lift, mean_friction

PASSES = 3
"""Most passes with all phases: friction moves loads by a few per cent, which hardly move friction."""

WARM_PASSES = 8
"""Most passes with some of the phases, until temperatures are found."""

PHASE_STRIDE = 4
"""Every which phase is solved while temperatures are sought."""

ESTIMATE_ACCURACY = 0.1
"""Accuracy of steady films by which lifts are sought: it leaves 1 % in a lift, and so 0.1 % in a load."""

ESTIMATE_GRID = 250_000
"""Nodes beyond which no grid is refined for them: lifts settle long before the minimum film thickness."""

MAX_ESTIMATES = 2
"""Maximum number of passes at that accuracy."""

MAX_TRANSIENT_SOLVES = 3
"""Maximum number of coarse transient solves of a life for its lifts."""

REMAINING_CHANGE = 0.25
"""Change of loads left to the next pass, as a share of the change by this one."""

LOAD_SHARE = 0.5
"""Change of the loads that asks for another pass, as a share of the accuracy: pressures follow them with a
power of a third, films with less, and the loss of the cycle hardly, since the torque is given."""

WARMTH = 0.5
"""Change of the sump's temperature that does [K]."""

FIRST_FALL = -0.5
"""How the loss found goes with the loss assumed, before two passes tell: warmer oil loses less."""


def run_balanced(
    case: Case,
    tasks: Sequence[Task],
    directory: Path,
    executor: Executor | None = None,
    progress: Progress | None = None,
    print_message: Callable[[str], None] = lambda message: None,
    all_digits: bool = False,
) -> tuple[Result, Sequence[Task]]:
    """Solve a case, iterating friction, lifts and loss where these are not given.

    Arguments and errors as of `batch.case_run.run`; also returns the tasks as they were solved in the end.
    """
    how: dict[str, Any] = {
        "directory": directory,
        "executor": executor,
        "progress": progress,
        "print_message": print_message,
        "all_digits": all_digits,
    }
    open_ = case.left_open
    if not open_:
        return run(case, tasks, **how), tasks
    earlier = _earlier(case, directory)
    search = _Search(open_, tasks[0].accuracy, print_message)
    if earlier:
        case = case.with_found(earlier)
    else:
        if "cooling" in open_:
            some = [steady(task) for task in every(PHASE_STRIDE, tasks)]
            case, _, _ = search.iterate(case, some, how, WARM_PASSES)
        if "lifts" in open_.get("operation", ()):
            case = search.lifted(case, tasks, how)
    case, result, tasks = search.iterate(case, tasks, how, PASSES)
    return result, tasks


@dataclass
class _Search:
    """Fixed-point iteration of the values that a case leaves open."""

    open: dict[str, tuple[str, ...]]
    accuracy: float
    print_message: Callable[[str], None]

    def lifted(self, case: Case, tasks: Sequence[Task], how: dict[str, Any]) -> Case:
        """The case with lifts, as far as finding them costs less than another pass."""
        given = [replace(task, case=case) for task in tasks]
        moving = [task for task in given if is_transient(task)]
        if moving:
            return self._by_motion(case, moving, how["executor"])
        return self._estimated(case, given, how) if self.accuracy < ESTIMATE_ACCURACY else case

    def _by_motion(self, case: Case, moving: Sequence[Task], executor: Executor | None) -> Case:
        """The case with lifts and friction by coarse transient solves."""
        ratios = None
        for _ in range(MAX_TRANSIENT_SOLVES):
            under = [replace(task, case=case) for task in moving]
            then = lifts_of(under, executor)
            if not then:
                return case
            if ratios is None:
                middle = under[len(under) // 2]
                ratios = steady_ratios(middle, steady(estimate_of(middle)), executor)
            found = self._found_moving(then, *ratios)
            before, case = case, case.with_found({"operation": found})
            if self._is_close(before, case, sorted(then)):
                break
        said = _told_lifts(present(case.tables.operation.lifts, "lifts"))
        self.print_message(f"transient solution: film-induced separation {said}")
        return case

    def _found_moving(
        self, then: dict[float, Lift], of_lift: float, of_friction: float
    ) -> dict[str, Any]:
        """Lifts, and friction where it is sought, by those of coarse transient solves times ratios."""
        lifts = tuple((phase, of_lift * then[phase].distance) for phase in sorted(then))
        friction = mean_friction(then.values())
        if "friction" not in self.open["operation"] or friction is None:
            return {"lifts": lifts}
        return {"lifts": lifts, "friction": float(f"{of_friction * friction:.2g}")}

    def _estimated(self, case: Case, given: Sequence[Task], how: dict[str, Any]) -> Case:
        """The case with values of steady films of lower accuracy."""
        coarse = [estimate_of(task) for task in given]
        for _ in range(MAX_ESTIMATES):
            again = [replace(task, case=case) for task in coarse]
            before, result = case, run(case, again, **how, cycle_of=methodcaller("loaded_cycle"))
            case = self._next(before, result, [])
            if case is before:
                break
            phases = present(drive_cycle(result), "a mesh cycle").phases
            if self._is_close(before, case, phases):
                break
        return case

    def _is_close(self, case: Case, new: Case, phases: Sequence[float]) -> bool:
        """Whether what a change of loads leaves to the next one is within the accuracy."""
        return REMAINING_CHANGE * load_change(case, new, phases) <= LOAD_SHARE * self.accuracy

    def iterate(
        self, case: Case, tasks: Sequence[Task], how: dict[str, Any], passes: int
    ) -> tuple[Case, Result, Sequence[Task]]:
        """The case as last solved, its result and tasks, after at most `passes` passes."""
        losses: list[tuple[float, float]] = []
        while True:
            tasks = [task if task.case is case else replace(task, case=case) for task in tasks]
            result = run(case, tasks, **how)
            passes -= 1
            new = case if passes == 0 else self._next(case, result, losses)
            if new is case:
                return case, result, tasks
            case = new

    def _next(self, case: Case, result: Result, losses: list[tuple[float, float]]) -> Case:
        """The case to solve next; the same case if the iteration converged."""
        cycle = drive_cycle(result)
        if cycle is None or cycle.loss is None:
            return self._warmed(case, result, losses)
        heating = heating_loss(cycle, standard_loss(case))
        found = self._found(case, cycle, heating, losses)
        new = case.with_found(found)
        if self._enough(case, new, cycle, heating):
            return case
        by = f" ({heating.words})" if "cooling" in found else ""
        self.print_message(f"solved again with {' and '.join(_told(found))}{by}")
        return new

    def _warmed(self, case: Case, result: Result, losses: list[tuple[float, float]]) -> Case:
        """The case to solve next of gears without such a cycle, of which temperatures alone are sought."""
        loss = mesh_loss(case.drive, result)
        if "cooling" not in self.open or loss is None:
            return case
        heating = mesh_heating_loss(loss, result, standard_loss(case))
        if _is_warm(case, heating):
            return case
        found = {"cooling": _next_heat(case, heating, losses)}
        self.print_message(f"solved again with {_told(found)[0]} ({heating.words})")
        return case.with_found(found)

    def _found(
        self,
        case: Case,
        cycle: DriveCycle,
        heating: HeatingLoss,
        losses: list[tuple[float, float]],
    ) -> dict[str, dict[str, Any]]:
        """Values for the next pass; a standard's loss, which does not depend on temperature, unchanged."""
        loss = present(cycle.loss, "the loss of the cycle")
        of_loads = {"friction": float(f"{loss.friction:.2g}"), "lifts": cycle.lifts or None}
        found: dict[str, dict[str, Any]] = {
            table: {key: of_loads[key] for key in keys}
            for table, keys in self.open.items()
            if table == "operation"
        }
        if "cooling" in self.open:
            found["cooling"] = _next_heat(case, heating, losses)
        return found

    def _enough(self, case: Case, new: Case, cycle: DriveCycle, heating: HeatingLoss) -> bool:
        """Whether the iteration converged."""
        if "cooling" in self.open and not _is_warm(case, heating):
            return False
        return load_change(case, new, cycle.phases) <= LOAD_SHARE * self.accuracy


def _next_heat(
    case: Case, heating: HeatingLoss, losses: list[tuple[float, float]]
) -> dict[str, float]:
    """The loss between the teeth [W] to assume next, as a key of `[cooling]`."""
    losses.append((tooth_loss_of(case), heating.power))
    power = heating.power if heating.by == "standard" else next_loss(losses)
    return {"tooth_loss": float(f"{power:.3g}")}


def _is_warm(case: Case, heating: HeatingLoss) -> bool:
    """Whether the loss found would change the temperature of the sump by less than `WARMTH`."""
    conductance: float = case.tables.unit_of(present(case.drive, "drive")).conductance
    return abs(heating.power - tooth_loss_of(case)) <= WARMTH * conductance


def estimate_of(task: Task) -> Task:
    """The task as it is solved for lifts."""
    return replace(task, accuracy=ESTIMATE_ACCURACY, wider_window=False, largest_grid=ESTIMATE_GRID)


def steady(task: Task) -> Task:
    """The task without transient solutions, which change the loss by less than temperatures need."""
    first, *others = effect_names(task.effects)
    if first not in ("auto", "all", "isothermal"):
        return task
    kept = [name for name in others if name != "squeeze"]
    return replace(task, effects=(first, *kept, "-squeeze"))


def every(stride: int, tasks: Sequence[Task]) -> Sequence[Task]:
    """Every `stride`-th task and the last; all of them if fewer than a mesh cycle needs would be left."""
    some = [*tasks[:-1:stride], tasks[-1]]
    return some if len(some) >= FEWEST_PHASES else tasks


def next_loss(losses: list[tuple[float, float]]) -> float:
    """The next loss to assume [W]: by the secant of the last two pairs (assumed, found)."""
    fall = FIRST_FALL
    if len(losses) > 1 and losses[-1][0] != losses[-2][0]:
        (before, first), (after, last) = losses[-2:]
        fall = min((last - first) / (after - before), 0.0)
    assumed, found = losses[-1]
    return assumed + (found - assumed) / (1 - fall)


def _told(found: dict[str, dict[str, Any]]) -> list[str]:
    """The values found, as written in a case file."""
    said = []
    for table, values in found.items():
        for key, value in values.items():
            if key != "lifts":
                said.append(f"{table}.{key} = {value:g}")
            elif value is not None:
                said.append(f"{table}.lifts of {_told_lifts(value)}")
    return said


def _told_lifts(given: Sequence[tuple[float, float]]) -> str:
    """Range of lifts in words."""
    lifts = [1e6 * lift for _, lift in given]
    return f"{min(lifts):.2f} to {max(lifts):.2f} µm"


def load_change(case: Case, new: Case, phases: Sequence[float]) -> float:
    """Largest relative change of the loads at some phases between two cases."""
    before, after = (
        np.array([present(variant.drive, "drive").normal_load(phase) for phase in phases])
        for variant in (case, new)
    )
    return float(np.max(np.abs(after / before - 1)))


def _earlier(case: Case, directory: Path) -> dict[str, dict[str, Any]]:
    """The values found by an earlier run of the same case; nothing if there was none."""
    kept = case_in(directory / RESULT_NAME)
    if kept is None or _given(kept, case.left_open) != _given(case.resolved, case.left_open):
        return {}
    tables = case_again(kept).tables
    found = {
        table: {key: getattr(getattr(tables, table), key) for key in keys}
        for table, keys in case.left_open.items()
    }
    return found if all(None not in values.values() for values in found.values()) else {}


def _given(resolved: dict, open_: dict[str, tuple[str, ...]]) -> dict:
    """A case without the values found, and without the phases asked for."""
    left = {
        table: {key: value for key, value in resolved[table].items() if key not in found}
        for table, found in open_.items()
        if resolved.get(table) is not None
    }
    left["operation"] = {**left.get("operation", resolved["operation"]), "phases": None}
    return {**resolved, **left}
