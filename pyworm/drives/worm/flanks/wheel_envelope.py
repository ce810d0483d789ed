"""The wheel flank that an involute hob cuts, as the envelope of its tangent planes.

Let the hob turn by psi and the wheel by ratio psi.  In the wheel's frame the hob's tangent planes are a
family with two parameters: theta (the generator) and roll = ratio psi,

    n(theta, roll) . x = support(theta) - lever roll,     n = turn(roll) n_hob(theta),

lever = base_travel / ratio.  The wheel flank is the envelope of this family; its points solve the three
equations of the plane and of its two derivatives, which are linear in x.  The roll derivative is the
meshing equation: the moment arm of the normal about the wheel's axis is the lever, whatever the angle.
So the envelope is exact and needs no iteration.
"""

from dataclasses import dataclass

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array, Helicoid

WHEEL_AXIS = np.array([0.0, 1.0, 0.0])


def turned(vector: Array, angle: Array | float) -> Array:
    """Vectors (3, ...) turned by an angle [rad] about the wheel's axis Y.

    The wheel itself turns the other way about Y: positive wheel angles are turns by minus the angle.
    """
    cos, sin = np.cos(angle), np.sin(angle)
    return np.stack(
        [cos * vector[0] + sin * vector[2], vector[1] + 0 * cos, cos * vector[2] - sin * vector[0]]
    )


def across_axis(vector: Array) -> Array:
    """Cross product of the wheel's axis with vectors (3, ...)."""
    return np.stack([vector[2], 0 * vector[1], -vector[0]])


@dataclass(frozen=True)
class WheelFlank:
    """The wheel flank that a hob cuts."""

    hob: Helicoid
    """The hob at its place on the cutting machine."""
    ratio: float
    """Wheel angle by hob angle, threads / teeth [-]."""

    @property
    def lever(self) -> float:
        """Moment arm of every flank normal about the wheel's axis [m]."""
        return self.hob.base_travel / self.ratio

    def cut_point(self, theta: Array, roll: Array) -> Array:
        """Points (3, ...) [m] where hob and wheel touch, in the drive frame, by generator and roll [rad]."""
        theta, roll = np.broadcast_arrays(np.asarray(theta), np.asarray(roll))
        normal, slope, _ = self.hob.normals(theta)
        support, support_slope, _ = self.hob.supports(theta)
        rows = np.stack([normal, slope, across_axis(normal)])
        right = np.stack([support - self.lever * roll, support_slope, 0 * roll - self.lever])
        rows = np.moveaxis(rows, (0, 1), (-2, -1))
        right = np.moveaxis(right, 0, -1)
        return np.moveaxis(np.linalg.solve(rows, right[..., None])[..., 0], -1, 0)

    def point(self, theta: Array, roll: Array, *, wheel_angle: float = 0.0) -> Array:
        """Point of the wheel flank at a wheel angle, in the drive frame, (3, ...) [m]."""
        return turned(self.cut_point(theta, roll), np.asarray(roll) - wheel_angle)

    def normal(self, theta: Array, roll: Array, *, wheel_angle: float = 0.0) -> Array:
        """Unit normal of the wheel flank, out of the wheel, in the drive frame, (3, ...)."""
        return turned(self.hob.normals(theta)[0], np.asarray(roll) - wheel_angle)

    def place(self, q: Array) -> tuple[Array, Array]:
        """Radius and axial place (2, points) [m], their derivatives by theta and roll, by complex step."""
        tiny = 1e-30
        columns = []
        for part in (0, 1):
            moved = q.astype(complex)
            moved[part] += tiny * 1j
            x, y, z = self.cut_point(*moved)
            columns.append(np.stack([np.sqrt(x * x + z * z), y]))
        return columns[0].real, np.stack([column.imag / tiny for column in columns], axis=1)
