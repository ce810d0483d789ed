"""Entrainment lent to a film that heat alone can hold.

Surfaces that slide without entraining oil carry load by the wedge of viscosity across the film that unequal
heat makes (Guo, Yang and Qu 2001). No isothermal film leads there: one that is entrained a little does, while
what was lent is taken back bit by bit.
"""

from dataclasses import dataclass, replace
from math import hypot

import numpy as np

from pyworm.scene.point import Array, Motion, Scene

SCARCE = 0.02
"""Entrainment over sliding speed at the contact point below which some is lent."""

LENT = 0.1
"""What is lent, along the sliding, over its speed."""

TAKEN_BACK = (0.5, 0.25, 0.1, 0.0)
"""Shares of it that are left, one after another."""


@dataclass(frozen=True)
class _Carried:
    """A motion with a uniform velocity on top of it [m/s]."""

    motion: Motion
    velocity: tuple[float, float]

    def __call__(self, x: Array, y: Array) -> tuple[Array, Array]:
        u, v = self.motion(x, y)
        return u + self.velocity[0], v + self.velocity[1]


def lent(scene: Scene, share: float = 1.0) -> Scene:
    """The scene with a share of what it needs lent; itself if it entrains enough, or does not slide."""
    entrained, slid = (
        [float(component) for component in of(np.array(0.0), np.array(0.0))]
        for of in (scene.entrainment, scene.sliding)
    )
    if hypot(*entrained) >= SCARCE * hypot(*slid):
        return scene
    velocity = (share * LENT * slid[0], share * LENT * slid[1])
    body_1, body_2 = scene.motions
    return replace(scene, motions=(_Carried(body_1, velocity), _Carried(body_2, velocity)))
