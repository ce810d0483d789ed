"""Auxiliary entrainment for a film that heat alone can hold, removed by continuation.

Surfaces that slide without entraining oil carry load by the viscosity wedge across the film, which unequal
heating makes (Guo, Yang and Qu 2001). No isothermal film is an initial guess for it; one with auxiliary
entrainment is, which is then removed by continuation.
"""

from dataclasses import dataclass, replace
from math import hypot

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.scene.point import Motion, Scene

MIN_ENTRAINMENT_RATIO = 0.02
"""Entrainment over sliding speed at the contact point below which auxiliary entrainment is added."""

AUXILIARY = 0.1
"""Auxiliary entrainment, along the sliding, over the sliding speed."""

FRACTIONS_LEFT = (0.5, 0.25, 0.1, 0.0)
"""Successive fractions of the auxiliary entrainment in the continuation."""


@dataclass(frozen=True)
class _Carried:
    """A motion plus a uniform velocity [m/s]."""

    motion: Motion
    velocity: tuple[float, float]

    def __call__(self, x: Array, y: Array) -> tuple[Array, Array]:
        u, v = self.motion(x, y)
        return u + self.velocity[0], v + self.velocity[1]


def with_auxiliary_entrainment(scene: Scene, fraction: float = 1.0) -> Scene:
    """The scene with a fraction of its auxiliary entrainment; itself where none is needed."""
    entrained, slid = (
        [float(component) for component in velocity_at(np.array(0.0), np.array(0.0))]
        for velocity_at in (scene.entrainment, scene.sliding)
    )
    if hypot(*entrained) >= MIN_ENTRAINMENT_RATIO * hypot(*slid):
        return scene
    velocity = (fraction * AUXILIARY * slid[0], fraction * AUXILIARY * slid[1])
    body_1, body_2 = scene.motions
    return replace(scene, motions=(_Carried(body_1, velocity), _Carried(body_2, velocity)))
