"""Expected processor time of a plan on this machine."""

from collections import defaultdict
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from math import inf
from time import process_time

import numpy as np

from pyworm.planning.effects.squeeze import SQUEEZE
from pyworm.planning.grid import Grid
from pyworm.planning.plan import Plan
from pyworm.scene.line import LineScene
from pyworm.scene.point import Paraboloid, Scene
from pyworm.solver.cost.calibration import calibration
from pyworm.solver.cost.expected_motion import TimeSteps, motion, time_grid_if_any
from pyworm.solver.transient.time_grid import TimeGrid
from pyworm.solver.transient.transient import Part

SAMPLES = 64
"""Points along each direction on which the sampling of a gap is timed."""

OUTCOME = {"point": 30.0, "line": 0.0}
"""Cost of the dry contact and the fields, in convolutions on the last grid; negligible for lines. 26 to 31 on
contacts of M 20 to 1000, round and slender."""

FIELDS = 3
"""Number of times that velocities are sampled for the fields of a solution."""


SCENES_A_STEP = 3
"""Contacts of its life that a time step makes: its own, and those by which the axes and the grid move on."""


@dataclass(frozen=True)
class ExpectedStretch:
    """Cost of a finer transient solve for one contact, of which overlapping ones serve others as well."""

    begin: float
    """Where it begins [transits]."""
    end: float
    """Where it ends [transits]."""
    seconds: float
    """Processor time [s]."""


@dataclass(frozen=True)
class Expectation:
    """Expected cost of a solve."""

    seconds: float
    """Processor time [s]."""
    convolutions: float
    """Processor time in convolutions on the expected finest grid."""
    past: float = 0.0
    """Part of the time for the transient solves of its past [s]."""
    shared: float = 0.0
    """Processor time of those of a whole part of its life, which serve other contacts as well [s]."""
    part: Part | None = None
    """That part; None of a contact that shares it with none."""
    sampling: float = 0.0
    """Processor time of the gap at a point [s]."""
    stretches: tuple[ExpectedStretch, ...] = ()
    """Finer transient solves of its own, the coarsest first."""


def expectation(
    scene: Scene | LineScene, plan: Plan, time_grid: TimeGrid | None = None
) -> Expectation:
    """Estimate the cost of solving a scene by a plan on this machine, with its time grid if known.

    The first call on a machine, or with another build of the kernel, measures a calibration in some seconds.
    """
    pace = calibration()
    unit = pace.convolution(plan.work.kind, plan.work.finest)
    gap, motions = _sampling(plan.simplified(scene), plan)
    times = gap + (1 + (plan.model.levels > 0) + plan.model.heated) * motions
    nodes = sum(stage.nodes for stage in plan.work.stages)
    film = pace.seconds(plan.work, plan.model) + nodes * times
    film += FIELDS * plan.work.finest * motions + OUTCOME[plan.work.kind] * unit
    moving = motion(scene, plan, time_grid)
    if moving is None:
        return Expectation(film, film / unit, sampling=gap)
    making = _making(scene)

    def taken(steps: Sequence[TimeSteps]) -> float:
        each = SCENES_A_STEP * making
        sampled = sum(step.count * (step.nodes * times + each) for step in steps)
        return pace.motion_seconds(plan.work.kind, moving.model, steps) + sampled

    film += sum(chance * taken(steps) for chance, steps in moving.further)
    stretches = tuple(
        ExpectedStretch(stretch.begin, stretch.end, taken(stretch.steps))
        for stretch in moving.stretches
    )
    past = taken(moving.up_to_present) + sum(stretch.seconds for stretch in stretches)
    shared = taken(moving.shared)
    return Expectation(film + past, (film + past) / unit, past, shared, moving.part, gap, stretches)


def expectations(
    contacts: Sequence[tuple[Scene | LineScene, Plan]], lives: Sequence[Hashable]
) -> list[Expectation]:
    """Expected cost of each of several contacts with their plans; each life's time grid is found once."""
    time_grids: dict[Hashable, TimeGrid | None] = {}
    for (scene, plan), life in zip(contacts, lives, strict=True):
        if SQUEEZE.name in plan.on and life not in time_grids:
            time_grids[life] = time_grid_if_any(scene, plan)
    return [
        expectation(scene, plan, time_grids.get(life))
        for (scene, plan), life in zip(contacts, lives, strict=True)
    ]


def together(expected: Sequence[Expectation], lives: Sequence[Hashable]) -> float:
    """Processor time of several solves, each of a life, whose transient solves they share [s]."""
    seconds = sum(solve.seconds - solve.past for solve in expected)
    by_life = defaultdict(list)
    for number, (solve, life) in enumerate(zip(expected, lives, strict=True)):
        by_life[number if solve.part is None else life].append(solve)
    for some in by_life.values():
        if len(some) == 1:
            seconds += some[0].past
        else:
            seconds += sum({solve.part: solve.shared for solve in some}.values())
            seconds += sum(map(_joined, zip(*(solve.stretches for solve in some), strict=True)))
    return seconds


def _joined(stretches: Sequence[ExpectedStretch]) -> float:
    """Processor time of stretches of several contacts of a life: each goes on from the one before [s]."""
    seconds, last = 0.0, -inf
    for stretch in sorted(stretches, key=lambda stretch: stretch.end):
        length = stretch.end - stretch.begin
        seconds += stretch.seconds * (stretch.end - max(stretch.begin, last)) / length
        last = stretch.end
    return seconds


def _making(scene: Scene | LineScene) -> float:
    """Processor time of making a contact of its life [s]."""
    started = process_time()
    if scene.past is not None:
        scene.past.before(0.0)
    return process_time() - started


def _sampling(scene: Scene | LineScene, plan: Plan) -> tuple[float, float]:
    """Processor time of sampling gap and velocities at a node [s], velocities for film, shear and heat."""
    if isinstance(scene, LineScene) or isinstance(scene.gap, Paraboloid):
        return 0.0, 0.0
    grid = plan.grids[-1]
    axes = (grid.x, grid.y) if isinstance(grid, Grid) else (grid.x,)
    x, y = (np.linspace(along[0], along[-1], SAMPLES) for along in axes)
    places = np.meshgrid(x, y, indexing="ij")
    started = process_time()
    scene.gap(*places)
    gap = process_time() - started
    scene.entrainment(*places)
    motions = process_time() - started - gap
    return gap / SAMPLES**2, motions / SAMPLES**2
