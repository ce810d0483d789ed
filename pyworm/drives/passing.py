"""A contact with those that it comes from and goes to as its drive turns."""

from collections.abc import Callable
from dataclasses import replace

from pyworm.line.scene import LineScene
from pyworm.neighbours import Neighbours
from pyworm.scene import Scene

STEP = 0.005
"""Phases to both sides at which the neighbours are."""


def with_neighbours(
    scene_at: Callable[[float], Scene | LineScene], phase: float, phases_per_second: float
) -> Scene | LineScene:
    """The scene at a phase with its neighbours; without them where the cycle begins or ends.

    Parameters
    ----------
    scene_at : callable
        Phase -> scene; ValueError where there is none.
    phase : float
        Place in the mesh cycle, 0 to 1.
    phases_per_second : float
        How fast the cycle passes [1/s], negative where it does so backwards.
    """
    scene = scene_at(phase)
    first, last = max(phase - STEP, 0.0), min(phase + STEP, 1.0)
    try:
        before, after = scene_at(first), scene_at(last)
    except ValueError:  # no contact there, or none that carries
        return scene
    seconds = (last - first) / phases_per_second
    if seconds < 0:
        before, after, seconds = after, before, -seconds
    return replace(scene, neighbours=Neighbours(before, after, seconds))
