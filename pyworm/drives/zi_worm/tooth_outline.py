"""Outline of the wheel's tooth: the rim of its flank, or the flank's own end where that comes first.

The hob cuts the flank with what it has within its tip cylinder: the flank ends where the tip has cut it,
above the root, and a fillet that the tip leaves follows (of spur gears the form circle). The envelope itself
ends at an edge of regression, as an involute ends at its base circle; a tooth whose hob reaches that edge
before its tip is undercut. Radius and place along the axis are a map of the flank's two parameters whose
determinant vanishes at that edge and nowhere else, since no flank normal is perpendicular to the direction of
the wheel's motion (its lever about the wheel's axis is the same everywhere).
"""

from dataclasses import dataclass
from math import inf

import numpy as np

from pyworm.drives.zi_worm.helicoid import Array
from pyworm.drives.zi_worm.meshing import WheelFlank
from pyworm.drives.zi_worm.tooth import WheelTooth, wheel_radius

FIRST_STEP = 0.125
"""First step along the way to the rim, as a fraction of it."""

FOUND = 1e-9
"""Distance from the place aimed at below which a point of the flank is found [m]."""

ENDED = 1e-5
"""Step, as a fraction of the way to the rim, below which the flank ends there."""

MOST_STEPS, MOST_NEWTON = 64, 10

LONGEST = 0.5
"""Newton step of a parameter [rad] at which the iteration leaves the flank."""


@dataclass(frozen=True)
class ToothOutline:
    """The wheel tooth and the path of contact on it, projected on a contact's tangent plane [m].

    Attributes
    ----------
    x, y : ndarray
        Closed outline of the wheel flank: tip, face end, root, face end.
    path_x, path_y : ndarray
        Path of contact on the wheel tooth from phase 0 to 1.
    """

    x: Array
    y: Array
    path_x: Array
    path_y: Array


def flank_outline(
    flank: WheelFlank, tooth: WheelTooth, start: tuple[float, float], count: int
) -> tuple[Array, Array]:
    """Generators and rolls of the closed outline of a wheel's flank, each (4 count + 1,) [rad].

    Parameters
    ----------
    flank : WheelFlank
        The flank.
    tooth : WheelTooth
        Its rim.
    start : tuple of float
        Generator and roll of a point within the rim [rad].
    count : int
        Points on each of the four sides.
    """
    return flank_places(flank, start, np.stack(tooth.rim(count)), tooth.hob_tip_radius)


def flank_places(
    flank: WheelFlank, start: tuple[float, float], target: Array, hob_tip_radius: float = inf
) -> tuple[Array, Array]:
    """Generators and rolls [rad] of places on a wheel's flank, or of where it ends on the way to them.

    Parameters
    ----------
    flank, start
        As of `flank_outline`.
    target : ndarray
        Radii and places along the axis [m], (2, places).
    hob_tip_radius : float
        Radius of the hob's tip cylinder [m], infinite for the whole envelope.
    """
    q = np.repeat(np.array(start)[:, None], target.shape[1], axis=1)
    first, slope = _place(flank, q)
    sign = np.sign(np.linalg.det(np.moveaxis(slope, -1, 0)))
    reach, step = np.zeros(target.shape[1]), np.full(target.shape[1], FIRST_STEP)
    for _ in range(MOST_STEPS):
        there = np.minimum(reach + step, 1.0)
        tried, found = _at(flank, q, first + there * (target - first), sign)
        found &= flank.hob.radius(flank.cut_point(*tried)) < hob_tip_radius
        q = np.where(found, tried, q)
        reach = np.where(found, there, reach)
        step = np.where(found, 2 * step, step / 2)
        if np.all((reach == 1) | (step < ENDED)):
            break
    return q[0], q[1]


def _at(flank: WheelFlank, q: Array, aim: Array, sign: Array) -> tuple[Array, Array]:
    """Newton's method from parameters near a place, and whether it stayed on the same side of the edge."""
    near = np.ones(q.shape[1], dtype=bool)
    for _ in range(MOST_NEWTON):
        place, slope = _place(flank, q)
        (a, b), (c, d) = slope
        determinant = a * d - b * c
        miss = place - aim
        found = (np.abs(miss).max(axis=0) < FOUND) & (determinant * sign > 0)
        if np.all(found | ~near):
            break
        with np.errstate(divide="ignore", invalid="ignore"):
            change = np.stack([d * miss[0] - b * miss[1], a * miss[1] - c * miss[0]]) / determinant
        near &= np.abs(change).max(axis=0) < LONGEST  # false of nan, too
        q = np.where(near & ~found, q - change, q)
    return q, found & near


def _place(flank: WheelFlank, q: Array) -> tuple[Array, Array]:
    """Radius and place along the axis, (2, points) [m], and derivatives by both parameters, (2, 2, points).

    The derivatives are by complex step, exact to rounding.
    """
    tiny = 1e-30
    columns = []
    for part in (0, 1):
        moved = q.astype(complex)
        moved[part] += tiny * 1j
        point = flank.cut_point(*moved)
        columns.append(np.stack([wheel_radius(point), point[1]]))
    return columns[0].real, np.stack([column.imag / tiny for column in columns], axis=1)
