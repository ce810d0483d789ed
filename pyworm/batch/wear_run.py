"""Wear of a worm drive over its life: contacts solved anew as the wheel's flank wears; the worm beside it."""

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from math import pi
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.batch.drive_iteration import run_balanced
from pyworm.batch.task import Task, key_of
from pyworm.batch.wear_integration import UnsolvedError, Worn, first_step, integrate_wear
from pyworm.case.case import Case
from pyworm.drives.duty import WormDuty
from pyworm.formulas.wear_law import (
    RUN_IN,
    WEAR_COEFFICIENT,
    WHEEL_HARDNESS,
    WORM_HARDNESS,
    harder_ratio,
    truncated_roughness,
)
from pyworm.io.bounded_number import read_json
from pyworm.io.kept_arrays import DamagedError, keep, kept
from pyworm.io.present import present
from pyworm.result.flank_wear import FlankGrid, asperity_pass, flank_grid, smoothed
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex

Array = np.ndarray

STATE = "wear.npz"
"""File with all that an integration needs to go on."""

EFFECTS = ("auto", "roughness", "-squeeze")
"""Effects that wear asks for: roughness simulated, each phase steady."""

PATTERN = 0.05
"""Work of asperities over the largest above which a place belongs to the contact pattern."""

HOUR = 3600.0


@dataclass(frozen=True)
class WearPlan:
    """How a wheel's wear is simulated."""

    hours: float
    """Time to simulate [h]."""
    coefficient: float = WEAR_COEFFICIENT
    """k of Archard's law [m2/N]."""
    calibrated_to: float | None = None
    """Mean depth worn off the run-in pattern in an hour [m/h], by which k is found; None where it is
    given."""
    tolerance: float = 0.25e-6
    """Largest error of the depth in a step [m], where nothing is worn off yet."""
    relative: float = 0.02
    """By how much that error may be larger, over the largest depth worn off [-]."""
    run_in: float = RUN_IN
    """Roughness of the wheel after running in, over that as cut [-]."""
    worm_ratio: float = harder_ratio(WORM_HARDNESS, WHEEL_HARDNESS)
    """k of the worm over that of the wheel, and the worm's worn volume over the wheel's [-]."""


@dataclass(frozen=True)
class WearFigures:
    """Figures of a wheel at a time of its life."""

    hours: float
    """Time [h]."""
    depth_max_m: float
    """Largest depth [m]."""
    depth_mean_m: float
    """Depth in the pattern, weighted with the work done there [m]."""
    step_error_m: float
    """Error of the depth by the step that ended here [m]."""
    volume_m3: float
    """Volume worn off a tooth [m3]."""
    mass_kg: float
    """Mass worn off the wheel [kg]."""
    backlash_m: float
    """Growth of the play under load, by which the wheel stays behind, at its reference circle [m]."""
    pattern_m2: float
    """Area of the contact pattern, as seen along the axis of the teeth [m2]."""
    asperity_share: float
    """Mean fraction of the load that asperities carry [-]."""
    friction: float
    """Mean friction of the teeth [-]."""
    film_min_m: float
    """Least film of the solved phases [m]."""
    worm_roughness_m: float
    """Rq of the worm [m]."""
    wheel_roughness_m: float
    """Rq of the wheel [m]."""
    worm_depth_max_m: float
    """Largest depth worn off the worm's threads [m]."""
    worm_volume_m3: float
    """Volume worn off a thread [m3]."""
    worm_mass_kg: float
    """Mass worn off the worm [kg]."""


@dataclass(frozen=True)
class _Solved:
    """Contacts of worn flanks: rates, and figures that do not depend on what is worn off yet."""

    rate: Array
    worm_rate: Array
    volume_rate: float
    roughness: tuple[float, float]
    turn: float
    result: Result | None

    @property
    def rates(self) -> Array:
        """Rates of wear of the wheel's cells, then of the worm's [m/h]."""
        return np.concatenate([self.rate.ravel(), self.worm_rate.ravel()])


def worm_duty(case: Case) -> WormDuty:
    """The worm gear of a case as the standards see it; ValueError of another drive, or none."""
    duty = None if case.drive is None else case.drive.duty()
    if not isinstance(duty, WormDuty):
        raise ValueError(f"{case.name}: wear is simulated of worm drives only")
    return duty


class WearRun:
    """Time integration of a case's wear; it continues where an earlier one in the same directory was stopped.

    Args:
        case: A worm drive whose bodies have a roughness. Friction and lifts that it leaves open are those of
            the flank one step before.
        tasks: Its contacts.
        plan: How to wear them.
        directory: Where everything is kept.
        print_message: Told what is being done.
        how: Executor and progress, as `run_balanced` takes them.
    """

    def __init__(
        self,
        case: Case,
        tasks: Sequence[Task],
        plan: WearPlan,
        directory: Path,
        print_message: Callable[[str], None] = lambda message: None,
        **how: Any,
    ) -> None:
        self.case, self.plan, self.directory = case, plan, directory
        self.print_message, self.how = print_message, how
        self.tasks = [replace(task, effects=EFFECTS, wider_window=False) for task in tasks]
        self.duty = worm_duty(case)
        worm, wheel = self.duty.roughness
        self.cut = present(worm, "bodies.worm.roughness"), present(wheel, "bodies.wheel.roughness")
        self.steps: list[WearFigures] = []
        self.depths: list[Array] = []
        self.volume, self.turn = 0.0, 0.0
        self.coefficient = plan.coefficient
        self.loads: dict[str, Any] = {}
        self._grids: tuple[FlankGrid, FlankGrid] | None = None
        self._state: _Solved | None = None
        identity = {
            "case": case.physics,
            "form": "whole mesh",
            "coefficient": plan.calibrated_to or plan.coefficient,
            "tolerance": (plan.tolerance, plan.relative),
            "run_in": plan.run_in,
            "worm_ratio": plan.worm_ratio,
            "accuracy": self.tasks[0].accuracy,
            "places": [task.place.given for task in self.tasks],
        }
        self.key = key_of(identity)

    @property
    def grid(self) -> FlankGrid:
        """Cells of the wheel's flank, known from the first solve on."""
        return present(self._grids, "the cells of the flanks")[0]

    @property
    def thread(self) -> FlankGrid:
        """Cells of the worm's flank, likewise."""
        return present(self._grids, "the cells of the flanks")[1]

    @property
    def _last(self) -> _Solved:
        """Contacts of the flanks as they are."""
        return present(self._state, "contacts of the flanks")

    def run(self) -> tuple[WearFigures, ...]:
        """Integrate to the plan's hours, or to what the standard allows; figures at the end of each step."""
        worn = self._restored() or self._begun()
        allowed = self.duty.gear.wear_limit
        plan = self.plan
        integrate_wear(
            worn, plan.hours, self._rates, plan.tolerance, self._keep, allowed, plan.relative
        )
        return tuple(self.steps)

    @property
    def hours_allowed(self) -> float:
        """Hours after which the deepest place is as deep as the standard allows, at the last rate [h]."""
        left, rate = self.duty.gear.wear_limit - self.depths[-1], self._last.rate
        with np.errstate(divide="ignore"):
            return self.steps[-1].hours + float(np.min(np.where(rate > 0, left / rate, np.inf)))

    def _begun(self) -> Worn:
        """The flanks as they were cut, with the rates of their wear."""
        solved = self._solved(None, self.cut)
        if self.plan.calibrated_to is not None:
            solved = self._calibrated(solved)
        self._state, self.turn = solved, solved.turn
        step = min(first_step(solved.rates, self.plan.tolerance), self.plan.hours)
        worn = Worn(0.0, np.zeros(len(solved.rates)), solved.rates, step)
        self._written(worn, 0.0)
        return worn

    def _calibrated(self, solved: _Solved) -> _Solved:
        """Flanks as they were cut, worn at the k by which run-in ones wear as it is calibrated to."""
        worm, wheel = self.cut
        part = self.plan.run_in
        run_in = self._solved(np.zeros(self.grid.shape), (part * worm, part * wheel))
        found = _mean(run_in.rate, run_in.rate)
        scale = present(self.plan.calibrated_to, "calibrated_to") / found
        self.coefficient *= scale
        self.print_message(f"k = {self.coefficient:.3g} m2/N, calibrated")
        rates = {
            name: scale * getattr(solved, name) for name in ("rate", "volume_rate", "worm_rate")
        }
        return replace(solved, **rates)

    def _split(self, depth: Array) -> tuple[Array, Array]:
        """Depths off the wheel and off the worm, each over its cells."""
        wheel, worm = np.split(depth, [self.grid.shape[0] * self.grid.shape[1]])
        return wheel.reshape(self.grid.shape), worm.reshape(self.thread.shape)

    def _rates(self, depth: Array) -> Array:
        """Rates of wear of flanks worn so far [m/h]."""
        wheel, worm = self._split(depth)
        removed = _mean(worm, self._last.worm_rate), _mean(wheel, self._last.rate)
        rough_worm, rough_wheel = (
            truncated_roughness(cut, off, self.plan.run_in)
            for cut, off in zip(self.cut, removed, strict=True)
        )
        self._next = self._solved(wheel, (rough_worm, rough_wheel))
        return self._next.rates

    def _keep(self, worn: Worn, error: float) -> None:
        """Store a step's end, before the next begins."""
        before = self.steps[-1].hours
        rates = self._last.volume_rate + self._next.volume_rate
        self.volume += rates / 2 * (worn.hours - before)
        self._state = self._next
        self._written(worn, error)

    def _solved(self, depth: Array | None, roughness: tuple[float, float]) -> _Solved:
        """Contacts of flanks so worn; load sharing, friction and films are those of now."""
        case = self.case
        if depth is not None:
            grid = self.grid
            found = case.tables.worn(grid.face, grid.radius, smoothed(depth), roughness)
            case = case.with_found(found | {"operation": self.loads})
        tasks = [replace(task, case=case) for task in self.tasks]
        result, _ = run_balanced(
            case, tasks, self.directory / "contacts", print_message=self.print_message, **self.how
        )
        try:
            if self._grids is None:
                self._grids = flank_grid(result), flank_grid(result, "worm")
            speed = present(
                present(case.drive, "drive").phases_per_second, "speed of the mesh cycle"
            )
            on_wheel = asperity_pass(result, self.grid, speed)
            on_worm = asperity_pass(result, self.thread, speed, "worm")
        except ValueError as error:
            why = "; ".join(
                f"{ContactIndex.of(solution)}: {solution.stop_reason}"
                for solution in result.unsound
            )
            raise UnsolvedError(f"{error} ({why})" if why else str(error)) from None
        self.loads = self._loads(result)
        # a tooth meets a thread once in a turn of the wheel, a thread a tooth once in a turn of the worm
        worm_turns = self.duty.worm_speed / (2 * pi) * HOUR
        of_worm = self.coefficient * self.plan.worm_ratio * worm_turns
        of_wheel = self.coefficient * worm_turns / self.duty.gear.ratio
        turn = float(present(result.mesh_cycle, "a mesh cycle")["wheel_turn"].mean())
        rates = of_wheel * on_wheel.work, of_worm * on_worm.work, of_wheel * on_wheel.volume
        return _Solved(*rates, roughness, turn, result)

    def _loads(self, result: Result) -> dict[str, Any]:
        """Friction in the balance of torques and lifts of the films, for the next flank."""
        cycle = present(drive_cycle(result), "a mesh cycle")
        loss, open_ = present(cycle.loss, "its loss"), self.case.left_open.get("operation", ())
        found = {"friction": float(f"{loss.friction:.2g}"), "lifts": cycle.lifts or None}
        return {key: found[key] for key in open_}

    def _figures(self, worn: Worn, error: float) -> WearFigures:
        last, result = self._last, present(self._last.result, "solved contacts")
        solutions = result.sound.solutions
        loss = present(present(drive_cycle(result), "a mesh cycle").loss, "its loss")
        borne = [solution.figures.asperity_load_fraction for solution in solutions]
        wheel_depth, worm_depth = self._split(worn.depth)
        densities = [
            body.density or usual
            for body, usual in zip(
                present(self.case.drive, "drive").bodies, (7850.0, 8800.0), strict=True
            )
        ]
        # the same force and path on both: volumes are as their k, over all threads and all teeth
        worm = self.plan.worm_ratio * self.volume * self.duty.gear.ratio
        return WearFigures(
            hours=worn.hours,
            depth_max_m=float(wheel_depth.max()),
            depth_mean_m=_mean(wheel_depth, last.rate),
            step_error_m=error,
            volume_m3=self.volume,
            mass_kg=self.volume * self.duty.gear.teeth * densities[1],
            backlash_m=(last.turn - self.turn) * self.duty.gear.module * self.duty.gear.teeth / 2,
            pattern_m2=float((last.rate > PATTERN * last.rate.max()).sum() * self.grid.cell),
            asperity_share=float(np.mean([share.value for share in borne if share is not None])),
            friction=loss.friction,
            film_min_m=min(solution.figures.film_min.value for solution in solutions),
            worm_roughness_m=last.roughness[0],
            wheel_roughness_m=last.roughness[1],
            worm_depth_max_m=float(worm_depth.max()),
            worm_volume_m3=worm,
            worm_mass_kg=worm * self.duty.gear.starts * densities[0],
        )

    def _written(self, worn: Worn, error: float) -> None:
        """Everything that an integration needs to go on, in one file that is whole or not there."""
        self.steps.append(self._figures(worn, error))
        wheel_depth, self.worm_depth = self._split(worn.depth)
        self.depths.append(wheel_depth)
        self.print_message(_told(self.steps[-1]))
        keep(
            self.directory / STATE,
            key=self.key,
            steps=json.dumps([asdict(step) for step in self.steps]),
            face=self.grid.face,
            radius=self.grid.radius,
            depths=np.array(self.depths),
            axial=self.thread.face,
            from_worm_axis=self.thread.radius,
            worm_depth=self.worm_depth,
            rate=self._last.rate,
            worm_rate=self._last.worm_rate,
            volume_rate=self._last.volume_rate,
            turns=(self.turn, self._last.turn),
            coefficient=self.coefficient,
            loads=json.dumps(self.loads),
            next_step=worn.step,
        )

    def _restored(self) -> Worn | None:
        """Where an earlier integration of the same plan was stopped; None without one."""
        path = self.directory / STATE
        try:
            key, state = kept(path, lambda held: (str(held["key"]), held))
            if key != self.key:
                self.print_message(f"{path}: of another case or plan, not used")
                return None
            found = kept(path, _state_of)
        except FileNotFoundError:
            return None
        except DamagedError as error:
            self.print_message(f"{error}, not used")
            return None
        if not all(np.isfinite(state[name]).all() for name in ("depths", "rate", "worm_rate")):
            self.print_message(f"{path}: has a flank that is not known everywhere, not used")
            return None
        vars(self).update(found)
        last = self.steps[-1]
        self.print_message(f"goes on at {last.hours:.4g} h")
        depth = np.concatenate([self.depths[-1].ravel(), self.worm_depth.ravel()])
        return Worn(last.hours, depth, self._last.rates, float(state["next_step"]))


def _state_of(held: dict[str, np.ndarray]) -> dict[str, Any]:
    """Attributes of a run, by their names, from the arrays of its state."""
    steps = [WearFigures(**step) for step in read_json(str(held["steps"]))]
    last, loads = steps[-1], read_json(str(held["loads"]))
    if loads.get("lifts") is not None:
        loads["lifts"] = tuple(map(tuple, loads["lifts"]))
    turn, last_turn = map(float, held["turns"])
    grid = FlankGrid(held["face"], held["radius"])
    thread = FlankGrid(held["axial"], held["from_worm_axis"])
    if (
        held["depths"].shape != (len(steps), *grid.shape)
        or held["worm_depth"].shape != thread.shape
    ):
        raise ValueError("depths of another grid")
    roughness = last.worm_roughness_m, last.wheel_roughness_m
    rates = held["rate"], held["worm_rate"]
    return {
        "_grids": (grid, thread),
        "worm_depth": held["worm_depth"],
        "depths": list(held["depths"]),
        "steps": steps,
        "volume": last.volume_m3,
        "loads": loads,
        "turn": turn,
        "coefficient": float(held["coefficient"]),
        "_state": _Solved(*rates, float(held["volume_rate"]), roughness, last_turn, None),
    }


def _mean(depth: Array, rate: Array) -> float:
    """Depth in the mean over where a flank wears, by how fast [m]."""
    return float((depth * rate).sum() / max(rate.sum(), 1e-300))


def _told(step: WearFigures) -> str:
    """A step's figures in a line."""
    return (
        f"{step.hours:.4g} h: {step.depth_max_m * 1e6:.3g} um worn at most, {step.mass_kg * 1e3:.3g} g, "
        f"asperities {step.asperity_share:.1%}, friction {step.friction:.4f}, "
        f"pattern {step.pattern_m2 * 1e6:.1f} mm2"
    )
