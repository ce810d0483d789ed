"""How fast the film of a contact changes as its drive turns."""

from collections.abc import Callable
from dataclasses import replace
from math import log

from pyworm.line.scales import line_scales
from pyworm.line.scene import LineScene
from pyworm.scales import scales
from pyworm.scene import Scene

STEP = 0.005
"""Phases to both sides between which the change is taken."""


def with_film_rate(
    scene_at: Callable[[float], Scene | LineScene], phase: float, phases_per_second: float
) -> Scene | LineScene:
    """The scene at a phase with the rate of its expected film, by formula, at its neighbours.

    Parameters
    ----------
    scene_at : callable
        Phase -> scene; ValueError where there is none.
    phase : float
        Place in the mesh cycle, 0 to 1.
    phases_per_second : float
        How fast the cycle passes [1/s].
    """
    films = {}
    for at in (max(phase - STEP, 0.0), min(phase + STEP, 1.0)):
        try:
            films[at] = _film(scene_at(at))
        except ValueError:  # no contact there, or none that carries: the cycle begins or ends
            films[at] = None
    (before, first), (after, last) = films.items()
    scene = scene_at(phase)
    if first is None or last is None:
        return scene
    return replace(scene, film_rate=log(last / first) / (after - before) * phases_per_second)


def _film(scene: Scene | LineScene) -> float:
    return (line_scales if isinstance(scene, LineScene) else scales)(scene).film
