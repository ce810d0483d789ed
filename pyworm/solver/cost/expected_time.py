"""Expected processor time of a plan on this machine."""

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


@dataclass(frozen=True)
class Expectation:
    """Expected cost of a solve.

    Attributes
    ----------
    seconds : float
        Processor time [s].
    convolutions : float
        Processor time in convolutions on the expected finest grid.
    """

    seconds: float
    convolutions: float


def expectation(scene: Scene | LineScene, plan: Plan) -> Expectation:
    """Estimate the cost of solving a scene by a plan on this machine.

    The first call on a machine, or with another build of the kernel, measures a calibration in some seconds.
    """
    pace = calibration()
    unit = pace.convolution(plan.work.kind, plan.work.finest)
    film = pace.seconds(plan.work, plan.model) + _sampling(plan.simplified(scene), plan)
    seconds = film + OUTCOME[plan.work.kind] * unit
    return Expectation(seconds, seconds / unit)


def _sampling(scene: Scene | LineScene, plan: Plan) -> float:
    """Processor time of sampling gap and velocities on all grids, extrapolated from a few nodes [s].

    Velocities are sampled for the film, for its shear and for its heat, and once more on the last grid.
    """
    if isinstance(scene, LineScene) or isinstance(scene.gap, Paraboloid):
        return 0.0
    grid = plan.grids[-1]
    x, y = (np.linspace(along[0], along[-1], SAMPLES) for along in (grid.x, grid.y))
    places = np.meshgrid(x, y, indexing="ij")
    started = process_time()
    scene.gap(*places)
    gap = process_time() - started
    scene.entrainment(*places)
    motions = process_time() - started - gap
    times = 1 + (plan.model.levels > 0) + plan.model.heated
    nodes = sum(stage.nodes for stage in plan.work.stages)
    whole = nodes * (gap + times * motions) + FIELDS * plan.work.finest * motions
    return whole / SAMPLES**2
