"""Expected processor time of a plan on this machine."""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from time import process_time

import numpy as np

from pyworm.planning.plan import Plan
from pyworm.scene.line import LineScene
from pyworm.scene.point import Paraboloid, Scene
from pyworm.solver.cost.calibration import calibration

SAMPLES = 64
"""Points along each direction on which the sampling of a gap is timed."""

OUTCOME = {"point": 30.0, "line": 0.0}
"""Cost of the dry contact and the fields, in convolutions on the last grid; negligible for lines. 26 to 31 on
contacts of M 20 to 1000, round and slender."""

FIELDS = 3
"""Number of times that velocities are sampled for the fields of a solution."""

PARTS = 2
"""Parts of a whole life, over that of a lone contact."""


@dataclass(frozen=True)
class Expectation:
    """Expected cost of a solve.

    Attributes
    ----------
    seconds : float
        Processor time [s].
    convolutions : float
        Processor time in convolutions on the expected finest grid.
    past : float
        Part of the time for the transient solve of its past, which contacts of one life share [s].
    """

    seconds: float
    convolutions: float
    past: float = 0.0


def expectation(scene: Scene | LineScene, plan: Plan) -> Expectation:
    """Estimate the cost of solving a scene by a plan on this machine.

    The first call on a machine, or with another build of the kernel, measures a calibration in some seconds.
    """
    pace = calibration()
    unit = pace.convolution(plan.work.kind, plan.work.finest)
    gap, motions = _sampling(plan.simplified(scene), plan)
    times = gap + (1 + (plan.model.levels > 0) + plan.model.heated) * motions
    nodes = sum(stage.nodes for stage in plan.work.stages)
    film = pace.seconds(plan.work, plan.model) + nodes * times
    film += FIELDS * plan.work.finest * motions + OUTCOME[plan.work.kind] * unit
    past = pace.past_seconds(plan.work, plan.model)
    past += sum(one.count * (one.nodes * times + _making(scene)) for one in plan.work.past)
    return Expectation(film + past, (film + past) / unit, past)


def together(expected: Sequence[Expectation], lives: Sequence[Hashable]) -> float:
    """Processor time of several solves, each of a life, whose transient solves they share [s]."""
    alone = sum(of.seconds - of.past for of in expected)
    pasts: dict[Hashable, float] = {}
    for of, life in zip(expected, lives, strict=True):
        pasts[life] = max(pasts.get(life, 0.0), of.past)
    count = {life: list(lives).count(life) for life in pasts}
    return alone + sum(past * (PARTS if count[life] > 1 else 1) for life, past in pasts.items())


def _making(scene: Scene | LineScene) -> float:
    """Processor time of making a contact of its life [s]."""
    started = process_time()
    scene.past.before(0.0)
    return process_time() - started


def _sampling(scene: Scene | LineScene, plan: Plan) -> tuple[float, float]:
    """Processor time of sampling the gap and the velocities at a node, from those of a few nodes [s].

    Velocities are sampled for the film, for its shear and for its heat, and once more on the last grid.
    """
    if isinstance(scene, LineScene) or isinstance(scene.gap, Paraboloid):
        return 0.0, 0.0
    grid = plan.grids[-1]
    x, y = (np.linspace(along[0], along[-1], SAMPLES) for along in (grid.x, grid.y))
    places = np.meshgrid(x, y, indexing="ij")
    started = process_time()
    scene.gap(*places)
    gap = process_time() - started
    scene.entrainment(*places)
    motions = process_time() - started - gap
    return gap / SAMPLES**2, motions / SAMPLES**2
