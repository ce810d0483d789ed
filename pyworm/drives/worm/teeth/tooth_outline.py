"""Outline of the wheel's tooth: the rim of its flank, or the flank's own end where that comes first.

The hob cuts the flank with what it has below the rounded edge of its tip: the flank ends where the last of it
has cut, above the root, and a fillet that the tip leaves follows (of spur gears the form circle). The
envelope itself ends at an edge of regression, as an involute ends at its base circle; a tooth whose hob
reaches that edge before its tip is undercut. Radius and place along the axis (and the hob's condition of
cutting, where that is not solved in closed form) are a map of the flank's parameters whose determinant
vanishes at that edge and nowhere else, since no flank normal is perpendicular to the direction of the wheel's
motion: it has a lever about the wheel's axis.
"""

from dataclasses import dataclass, field
from functools import lru_cache
from math import inf

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.flanks.surfaces import WheelSurface
from pyworm.drives.worm.teeth.tooth import WheelTooth

FIRST_STEP = 0.125
"""First step along the way to the rim, as a fraction of it."""

FOUND = 1e-9
"""Distance from the place aimed at below which a point of the flank is found [m]."""

ENDED = 1e-5
"""Step, as a fraction of the way to the rim, below which the flank ends there."""

MOST_STEPS, MOST_NEWTON = 64, 10

MAX_NEWTON_STEP = 0.5
"""Newton step of a parameter at which the iteration leaves the flank."""


@dataclass(frozen=True)
class ToothOutline:
    """The wheel tooth and the path of contact on it, projected on a contact's tangent plane [m]."""

    x: Array
    """Closed outline of the wheel flank along x: tip, face end, root, face end."""
    y: Array
    """Closed outline of the wheel flank along y, likewise."""
    path_x: Array
    """Path of contact on the wheel tooth along x from phase 0 to 1."""
    path_y: Array
    """Path of contact on the wheel tooth along y from phase 0 to 1."""


@dataclass(frozen=True)
class RimmedFlank:
    """A wheel's flank with its rim."""

    flank: WheelSurface
    """The flank."""
    tooth: WheelTooth
    """Its rim."""
    start: tuple[float, ...] = field(compare=False)
    """Parameters of any point within the rim, from which it is found."""


@lru_cache(maxsize=4)
def flank_outline(rimmed: RimmedFlank, count: int) -> Array:
    """Parameters of the closed outline of a wheel's flank, (parameters, 4 count + 1).

    Cached, since it does not depend on where the worm is assembled.
    """
    tooth = rimmed.tooth
    target = np.stack(tooth.rim(count))
    places = flank_places(rimmed.flank, rimmed.start, target, tooth.hob_form_radius)
    places.flags.writeable = False
    return places


def flank_places(
    flank: WheelSurface, start: tuple[float, ...], target: Array, hob_form_radius: float = inf
) -> Array:
    """Parameters (parameters, places) of radii and axial places on a wheel's flank [m], or of its end before.

    The hob has its flank up to a radius [m], infinite for the whole envelope.
    """
    q = np.repeat(np.array(start)[:, None], target.shape[1], axis=1)
    first, slope = flank.place(q)
    # what the flank asks for beside radius and place along the axis is zero, the condition of cutting
    target = np.concatenate([target, np.zeros((len(first) - 2, target.shape[1]))])
    sign = np.sign(np.linalg.det(np.moveaxis(slope, -1, 0)))
    reach, step = np.zeros(target.shape[1]), np.full(target.shape[1], FIRST_STEP)
    for _ in range(MOST_STEPS):
        there = np.minimum(reach + step, 1.0)
        tried, found = _at(flank, q, first + there * (target - first), sign)
        found &= flank.hob.radius(flank.cut_point(*tried)) < hob_form_radius
        q = np.where(found, tried, q)
        reach = np.where(found, there, reach)
        step = np.where(found, 2 * step, step / 2)
        if np.all((reach == 1) | (step < ENDED)):
            break
    return q


def _at(flank: WheelSurface, q: Array, target: Array, sign: Array) -> tuple[Array, Array]:
    """Newton's method from parameters near a place, and whether it stayed on the same side of the edge."""
    near = np.ones(q.shape[1], dtype=bool)
    for _ in range(MOST_NEWTON):
        place, slope = flank.place(q)
        slope = np.moveaxis(slope, -1, 0)
        determinant = np.linalg.det(slope)
        miss = place - target
        found = (np.abs(miss).max(axis=0) < FOUND) & (determinant * sign > 0)
        if np.all(found | ~near):
            break
        sound = np.where((determinant != 0)[:, None, None], slope, np.eye(len(place)))
        change = np.linalg.solve(sound, miss.T[..., None])[..., 0].T
        near &= (determinant != 0) & (np.abs(change).max(axis=0) < MAX_NEWTON_STEP)
        q = np.where(near & ~found, q - change, q)
    return q, found & near
