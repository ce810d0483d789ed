"""A contact with what it was earlier, as its drive turns."""

from collections.abc import Callable
from dataclasses import replace
from math import atan2

import numpy as np

from pyworm.line.scene import LineScene
from pyworm.past import Earlier, Past
from pyworm.scene import Array, Scene


def with_past(
    scene_at: Callable[[float], Scene | LineScene],
    phase: float,
    phases_per_second: float,
    axes_at: Callable[[float], Array] = lambda phase: np.eye(3),
) -> Scene | LineScene:
    """The scene at a phase with its past.

    Parameters
    ----------
    scene_at : callable
        Phase -> scene; ValueError where there is none.
    phase : float
        Place in the mesh cycle, 0 to 1.
    phases_per_second : float
        How fast the cycle passes [1/s], negative where it does so backwards.
    axes_at : callable
        Phase -> x, y and normal of the tangent plane, rows in axes that velocities are relative to.
    """

    def before(seconds: float) -> Earlier:
        then = phase - seconds * phases_per_second
        x_axis, y_axis, _ = axes_at(phase)
        x_then = axes_at(then)[0]
        return Earlier(
            seconds, scene_at(then), atan2(float(x_then @ y_axis), float(x_then @ x_axis))
        )

    passed = phase if phases_per_second > 0 else 1 - phase
    return replace(scene_at(phase), past=Past(passed / abs(phases_per_second), before))
