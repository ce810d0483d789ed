"""The wheel flank that a hob of any profile cuts: the envelope of the hob's surface.

While the hob turns by psi the wheel turns by roll = ratio psi. A point of the hob lies on the envelope
where its normal has no part of the velocity of hob against wheel, by the roll,

    N . V = 0,    V = Y x point - (p / ratio) hob axis,

of a helicoid x N_y - y N_x + p N_z = 0, so that its rotation is the advance of a screw. The points are found
by Newton's method from this and from where they are sought; no plane, line or table stands for the flank.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyworm.drives.worm.flanks.flank_surface import dot
from pyworm.drives.worm.flanks.helicoid import Array, Components
from pyworm.drives.worm.flanks.swept_helicoid import SweptHelicoid
from pyworm.drives.worm.flanks.wheel_envelope import turned


def across(vector: Components) -> Components:
    """Cross product of the wheel's axis with a vector."""
    return vector[2], 0.0 * vector[1], -vector[0]


@dataclass(frozen=True)
class Cut:
    """Points at which a hob may cut, in the drive frame when cut, with derivatives by (u, turn, roll)."""

    point: Components
    """Points of the hob [m]."""
    ways: tuple[Components, Components, Components]
    """Their derivatives in the wheel's frame, which turns on with the roll."""
    normal: Components
    """Normals of the hob, of any length."""
    swings: tuple[Components, Components, Components]
    """Their derivatives in the wheel's frame."""
    miss: Array
    """N . V, zero where the hob cuts."""
    slopes: tuple[Array, Array, Array]
    """Its derivatives."""


@dataclass(frozen=True)
class SweptWheel:
    """The wheel flank that a hob of any profile cuts; its parameters are u, turn and roll, with N . V = 0."""

    hob: SweptHelicoid
    """The hob at its place on the cutting machine."""
    ratio: float
    """Wheel angle by hob angle, threads / teeth [-]."""

    @cached_property
    def rise(self) -> Components:
        """Way of a hob's point along its axis by the roll [m/rad]."""
        x, y, z = -self.hob.screw / self.ratio * self.hob.axes[:, 2]
        return float(x), float(y), float(z)

    def cut(self, u: Array, turn: Array, roll: Array) -> Cut:
        """Points of the hob at a roll of the wheel [rad], and how far they are from cutting."""
        on = self.hob.expanded(u, turn, roll / self.ratio)
        rise = self.rise
        x, y, z = across(on.point)
        speed = x + rise[0], y + rise[1], z + rise[2]
        return Cut(
            point=on.point,
            ways=(on.by_u, on.by_turn, speed),
            normal=on.normal,
            swings=(on.normal_by_u, on.normal_by_turn, across(on.normal)),
            miss=dot(on.normal, speed),
            slopes=(
                dot(on.normal_by_u, speed) + dot(on.normal, across(on.by_u)),
                dot(on.normal_by_turn, speed) + dot(on.normal, across(on.by_turn)),
                dot(on.normal, across(rise)),
            ),
        )

    def cut_point(self, u: Array, turn: Array, roll: Array) -> Array:
        """Points at which the hob cuts, in the drive frame, (3, ...) [m]."""
        return np.stack(np.broadcast_arrays(*self.cut(u, turn, roll).point))

    def point(self, u: Array, turn: Array, roll: Array, *, wheel_angle: float = 0.0) -> Array:
        """Points of the wheel flank at a wheel angle, in the drive frame, (3, ...) [m]."""
        return turned(self.cut_point(u, turn, roll), np.asarray(roll) - wheel_angle)

    def normal(self, u: Array, turn: Array, roll: Array, *, wheel_angle: float = 0.0) -> Array:
        """Unit normals of the wheel flank, out of the wheel, in the drive frame, (3, ...)."""
        normal = np.stack(np.broadcast_arrays(*self.cut(u, turn, roll).normal))
        normal = normal / np.sqrt(np.sum(normal**2, axis=0))
        return turned(normal, np.asarray(roll) - wheel_angle)

    def place(self, q: Array) -> tuple[Array, Array]:
        """Radius, place along the axis and N . V over a length, (3, points); derivatives (3, 3, points)."""
        cut = self.cut(*q)
        x, y, z = cut.point
        radius = np.hypot(x, z)
        # the way by the roll in the wheel's frame turns about its axis, which changes neither
        radial = [(x * tangent[0] + z * tangent[2]) / radius for tangent in cut.ways]
        axial = [tangent[1] for tangent in cut.ways]
        size = self.hob.size
        rows = np.broadcast_arrays(radius, y, cut.miss / size)
        slopes = [np.broadcast_arrays(*row, radius)[:-1] for row in (radial, axial)]
        slopes.append(tuple(slope / size for slope in np.broadcast_arrays(*cut.slopes)))
        return np.stack(rows), np.stack([np.stack(row) for row in slopes])
