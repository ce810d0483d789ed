"""A scene: one lubricated point contact at one instant, the input of the point solver.

The tangent plane carries x and y with their origin at the contact point; z points from body 1 to body 2.
Velocities are those of the surfaces relative to the (moving) contact point, projected on the plane.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2

import numpy as np

from pyworm.scene.contact import Array, Contact, require_radii

Gap = Callable[[Array, Array], tuple[Array, Array]]
"""(x, y) [m] -> undeformed gap [m] and a boolean, true where both surfaces exist.

The gap is zero at the contact point and finite everywhere: outside the teeth it continues the surfaces, since
oil still flows there."""

Motion = Callable[[Array, Array], tuple[Array, Array]]
"""(x, y) [m] -> velocity components (u, v) [m/s] of one surface."""


@dataclass(frozen=True)
class Paraboloid:
    """The gap x^2 / 2 Rx + y^2 / 2 Ry without edges.

    Attributes
    ----------
    radius_x, radius_y : float
        Relative radii of curvature along x and y [m].
    """

    radius_x: float
    radius_y: float

    @property
    def radii(self) -> tuple[float, float]:
        """Relative radii of curvature along x and y [m]."""
        return self.radius_x, self.radius_y

    def __call__(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Gap [m] and where both surfaces exist (everywhere)."""
        gap = x**2 / (2 * self.radius_x) + y**2 / (2 * self.radius_y)
        return gap, np.ones(gap.shape, dtype=bool)


@dataclass(frozen=True)
class RigidMotion:
    """Translation and spin of one surface in the tangent plane.

    Attributes
    ----------
    u, v : float
        Velocity at the contact point [m/s].
    spin : float
        Angular velocity about the common normal [rad/s], positive from x to y.
    """

    u: float
    v: float
    spin: float = 0.0

    def __call__(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Velocity components [m/s] at (x, y)."""
        return self.u - self.spin * y, self.v + self.spin * x


@dataclass(frozen=True, kw_only=True)
class Scene(Contact):
    """One lubricated point contact at one instant.

    Attributes
    ----------
    gap : Gap
        Undeformed gap and where both surfaces exist.
    radii : tuple of float
        Relative radii of curvature along x and y at the contact point [m]: the scale of the contact.
    motions : tuple of Motion
        Velocity field of body 1 and of body 2.

    Raises
    ------
    ValueError
        Radii other than those of the gap, or an oil or a body of a class unknown to the kernel.

    Notes
    -----
    The other attributes are those of `pyworm.scene.contact.Contact`.
    """

    gap: Gap
    radii: tuple[float, float]
    motions: tuple[Motion, Motion]

    def __post_init__(self) -> None:
        """Refuse radii other than those of the gap."""
        super().__post_init__()
        require_radii(self.radii, getattr(self.gap, "radii", self.radii))

    def velocities_at(self, x: Array, y: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """Velocity components [m/s] of body 1's and of body 2's surface at (x, y)."""
        body_1, body_2 = self.motions
        return body_1(x, y), body_2(x, y)

    @property
    def motion_angles(self) -> tuple[float, float]:
        """Directions of both surfaces' velocities at the contact point, from the x axis [rad]."""
        first, second = self.velocities_at(np.zeros(()), np.zeros(()))
        return atan2(first[1], first[0]), atan2(second[1], second[0])

    entrainment = Contact.entrainment_at
    sliding = Contact.sliding_at
