"""Processor time of Newton steps on this machine, measured once in a few seconds and cached.

Two small contacts, a point and a line, are solved with and without rheology and heat; the time of a step is
split into a constant and a part proportional to the nodes, for each model.
"""

import json
import os
import platform
from collections.abc import Sequence
from dataclasses import asdict, astuple, dataclass, replace
from hashlib import sha256
from pathlib import Path
from time import process_time

import numpy as np

from pyworm.io.atomic import whole_file
from pyworm.io.bounded_number import read_json
from pyworm.io.cache import cache_directory
from pyworm.io.given import Names
from pyworm.io.stage import stage
from pyworm.materials.body import Body
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Density, Roelands
from pyworm.planning import error_budget
from pyworm.planning.effects.judgement import simplified
from pyworm.planning.expected_work import Kind, Work
from pyworm.planning.model import Model
from pyworm.planning.plan import Plan, plan_of
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.point import Paraboloid, RigidMotion, Scene
from pyworm.solver.contact import ContactSolver
from pyworm.solver.cost.expected_motion import TimeSteps
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import Level
from pyworm.solver.newton import converge
from pyworm.solver.timing import convolution_seconds

FORMAT = 3
"""Format of the file in which calibrations are cached."""

LEVELS = (5, 9)
"""Levels across the film at which steps are timed; others are interpolated linearly."""

CALIBRATION_HALVINGS = {"point": 1, "line": 4}
"""Halvings from the first grid, the coarsest timed, to the finest."""

REPEATS = 3
"""Number of times that each is timed, of which the shortest counts. What a step takes beside its nodes is a
small difference of both: from single times of grids of 23 000 and 93 000 nodes it was 1.5, 2.4, 2.4 and 13.5
ms for heated points in four calibrations of one machine, and runs on few nodes were expected to take up to
twice as long."""

CALIBRATION_ACCURACY = 0.01

NEWTON_STEPS: dict[Kind, tuple[float, float]] = {"point": (1.4, 2.0), "line": (1.8, 1.0)}
"""Newton steps of a time step, without and with heat: medians of those of the cases that
`benchmarks/accuracy/expected_cost.py` names for it, of heated points the mean of 2.3 and 1.65 of both solves
of `cases/zi_drive.toml` (`benchmarks/accuracy/transient_cost.py`)."""

ROUGH_NEWTON_STEPS = 4.0
"""Those between rough heated points: 3.0 to 4.5 in five of six solves of three worm gear sets (drives
99012:5, 99014:5 and 6 of `tests/hard`). Where films are lost at edges and begun again they are more, and not
foreseen: 9.0 in the sixth, 7.5 to 11.7 in four of 99011:6 and 99014:0."""

TIME_STEP_OVERHEAD: dict[Kind, tuple[float, float]] = {"point": (0.0, 4.7), "line": (1.5, 4.0)}
"""What a time step takes beside its grid and Newton steps, for figures and the heat that surfaces remember,
without and with heat, over setting up the coarsest grid of its life, on which that heat is found. Of points
with heat it was 2.0 to 18 in eight solves of four worm gear sets, 5.4 in the median (`transient_cost.py`);
others are of the same cases as the Newton steps."""


def newton_steps(kind: Kind, model: Model) -> float:
    """Newton steps of a time step."""
    if kind == "point" and model.heated and model.rough:
        return ROUGH_NEWTON_STEPS
    return NEWTON_STEPS[kind][model.heated]


@dataclass(frozen=True)
class Pace:
    """Processor times of one model."""

    step: float
    """Constant part of a Newton step [s]."""
    step_node: float
    """Part of a Newton step for each node [s]."""
    grid: float
    """Constant part of setting up a grid [s]."""
    grid_node: float
    """Part of setting up a grid for each node [s]."""

    @classmethod
    def by(cls, few: tuple[float, float, float], many: tuple[float, float, float]) -> "Pace":
        """The times from nodes, seconds of set-up and seconds of a step on two grids."""
        times = []
        for small, large in ((few[2], many[2]), (few[1], many[1])):
            node = max((large - small) / (many[0] - few[0]), 0.0)
            times += [max(small - few[0] * node, 0.0), node]
        return cls(*times)

    def between(self, other: "Pace", fraction: float) -> "Pace":
        """Interpolate linearly between these times and others, or extrapolate, to a fraction of the way."""
        pairs = zip(astuple(self), astuple(other), strict=True)
        return Pace(*(max(here + fraction * (there - here), 0.0) for here, there in pairs))

    def steps(self, count: float, nodes: float) -> float:
        """Processor time of a number of steps [s]."""
        return count * (self.step + nodes * self.step_node)

    def entry(self, nodes: float) -> float:
        """Processor time of setting up a grid [s]."""
        return self.grid + nodes * self.grid_node


Convolutions = tuple[tuple[float, float], tuple[float, float]]
"""Nodes and seconds of one convolution, on two grids."""


@dataclass(frozen=True)
class Calibration:
    """Processor times of Newton steps on a machine."""

    cold: dict[Kind, Pace]
    """Kind of contact -> pace with a Newtonian oil of one temperature."""
    sheared: dict[Kind, tuple[Pace, Pace]]
    """Kind -> pace at each of `LEVELS` with rheology."""
    heated: dict[Kind, tuple[Pace, Pace]]
    """Kind -> pace at each of `LEVELS` with rheology and heat."""
    convolutions: dict[Kind, tuple[tuple[float, float], tuple[float, float]]]
    """Kind -> nodes and seconds of one convolution, on two grids."""

    def seconds(self, work: Work, model: Model) -> float:
        """Expected processor time of the work, without its past and the sampling of the scene [s]."""
        cold = self.cold[work.kind]
        full = self._full(work.kind, model)
        return sum(
            (full if stage.full else cold).entry(stage.nodes)
            + cold.steps(stage.cold, stage.nodes)
            + full.steps(stage.full, stage.nodes)
            for stage in work.stages
        )

    def motion_seconds(self, kind: Kind, model: Model, steps: Sequence[TimeSteps]) -> float:
        """Expected processor time of time steps, without the sampling of the scene [s]."""
        full = self._full(kind, model)
        return sum(
            step.count
            * (
                full.entry(step.nodes)
                + full.steps(newton_steps(kind, model), step.nodes)
                + TIME_STEP_OVERHEAD[kind][model.heated] * full.entry(step.coarse)
            )
            for step in steps
        )

    def _full(self, kind: Kind, model: Model) -> Pace:
        if not model.levels:
            return self.cold[kind]
        low, high = (self.heated if model.heated else self.sheared)[kind]
        return low.between(high, (model.levels - LEVELS[0]) / (LEVELS[1] - LEVELS[0]))

    def convolution(self, kind: Kind, nodes: float) -> float:
        """Processor time of one convolution [s], by a power law through two measured times."""
        (first, low), (second, high) = self.convolutions[kind]
        power = np.log(high / low) / np.log(second / first)
        return float(low * (nodes / first) ** power)


def calibration() -> Calibration:
    """The calibration of this machine and kernel build: from the user's cache, else measured."""
    path = cache_directory() / f"pace-{_key()}.json"
    try:
        return _read(read_json(path.read_bytes()))
    except (OSError, ValueError, KeyError, TypeError):
        with stage(f"measuring the speed of this machine, to be kept in {path}"):
            measured = calibrate()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with whole_file(path) as partial:
            partial.write_text(json.dumps(asdict(measured)))
    except OSError:
        pass  # where nothing can be kept it is measured again
    return measured


def _key() -> str:
    """Key of a calibration in the cache: machine, kernel build and threads."""
    from pyworm.kernel.core import EXTENSION

    parts = (
        FORMAT,
        platform.node(),
        platform.machine(),
        _processor(),
        os.environ.get("OMP_NUM_THREADS", ""),
        sha256(EXTENSION.read_bytes()).hexdigest(),
    )
    return sha256(repr(parts).encode()).hexdigest()[:16]


def _processor() -> str:
    """The processor's name, where the system gives it."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor()
    return next((line for line in lines if line.startswith("model name")), platform.processor())


def _read(kept: dict) -> Calibration:
    sheared, heated = (
        {kind: (Pace(**few), Pace(**many)) for kind, (few, many) in kept[model].items()}
        for model in ("sheared", "heated")
    )
    return Calibration(
        {kind: Pace(**pace) for kind, pace in kept["cold"].items()},
        sheared,
        heated,
        {kind: (tuple(few), tuple(many)) for kind, (few, many) in kept["convolutions"].items()},
    )


def calibrate() -> Calibration:
    """Measure the calibration of this machine."""
    cold: dict[Kind, Pace] = {}
    sheared: dict[Kind, tuple[Pace, Pace]] = {}
    heated: dict[Kind, tuple[Pace, Pace]] = {}
    convolutions: dict[Kind, Convolutions] = {}
    scenes: dict[Kind, Scene | LineScene] = {"point": _point(), "line": _line()}
    for kind, scene in scenes.items():
        _timed(
            scene, kind, "isothermal", 0
        )  # what is only done the first time is no part of a pace
        cold[kind], convolutions[kind] = _timed(scene, kind, "isothermal", 0)
        for paces, words in (
            (sheared, ("all", "-film-heating", "-surface-heating")),
            (heated, "all"),
        ):
            few, many = (_timed(scene, kind, words, levels)[0] for levels in LEVELS)
            paces[kind] = few, many
    return Calibration(cold, sheared, heated, convolutions)


def _timed(
    scene: Scene | LineScene, kind: Kind, effects: Names, levels: int
) -> tuple[Pace, Convolutions]:
    """Processor times of a model from two grids, and nodes and seconds of a convolution on each."""
    planned = plan_of(scene, CALIBRATION_ACCURACY, effects)
    planned = replace(planned, model=replace(planned.model, levels=levels))
    simple = simplified(scene, planned.on)
    solver = SOLVERS[type(simple)](simple, planned)
    level, _ = solver.begin(planned.grids)
    times, convolutions = [], []
    for halvings in range(CALIBRATION_HALVINGS[kind] + 1):
        if halvings:
            level, _ = solver.refined(level)
        if halvings in (0, CALIBRATION_HALVINGS[kind]):
            times.append((level.grid.nodes, *_shortest(solver, level, planned)))
            convolutions.append((level.grid.nodes, convolution_seconds(level.film)))
        steps_to_convergence(level, planned)
    return Pace.by(*times), (convolutions[0], convolutions[-1])


def _shortest(solver: ContactSolver, level: Level, planned: Plan) -> tuple[float, float]:
    """Processor times of setting up a level's grid and of a Newton step on it [s], each the shortest."""
    entries, steps = [], []
    for _ in range(REPEATS):
        started = process_time()
        again = solver.on_grid(level.grid, level.state())
        entered = process_time()
        taken = steps_to_convergence(again, planned)
        entries.append(entered - started)
        steps.append((process_time() - entered) / taken)
    return min(entries), min(steps)


def steps_to_convergence(level: Level, planned: Plan) -> int:
    """Number of steps until a level settles."""
    taken = converge(
        level, planned.tolerance, planned.target, error_budget.ALGEBRA * planned.accuracy
    )
    return max(len(taken.steps), 1)


_STEEL = Body(210e9, 0.3, 7850.0, 47.0, 450.0, 333.15)


def _oil() -> Oil:
    viscosity = Roelands.from_alpha(0.04, 2e-8)
    return Oil(
        viscosity,
        Density.dowson_higginson(850.0),
        FlowLaw("eyring-limited", stress=5e6, limit=5e6, limit_pressure=0.05),
        OilHeat(333.15, viscosity.s0(0.035, 333.15), 0.14, 2000.0),
    )


def _point() -> Scene:
    """A steel ball on a plane, 1 GPa, sliding."""
    motions = (RigidMotion(3.0, 0.0), RigidMotion(2.0, 0.0))
    radii = (0.01, 0.01)
    return Scene(
        name="",
        gap=Paraboloid(*radii),
        radii=radii,
        motions=motions,
        load=40.0,
        bodies=(_STEEL, _STEEL),
        oil=_oil(),
    )


def _line() -> LineScene:
    """Teeth of a gear near their tips."""
    radius = 0.009
    return LineScene(
        name="",
        gap=Parabola(radius),
        radius=radius,
        velocities=(3.2, 1.1),
        load=1.2e5,
        bodies=(_STEEL, _STEEL),
        oil=_oil(),
    )
