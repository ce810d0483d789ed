"""A scene: one lubricated point contact at one instant, the input of the point solver.

The tangent plane carries x and y with their origin at the contact point; z points from body 1 to body 2.
Velocities are those of the surfaces relative to the (moving) contact point, projected on the plane.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import atan2
from typing import TYPE_CHECKING, Any

import numpy as np

from pyworm.formulas.arrays import Array, Flags
from pyworm.formulas.ranges import positive, within
from pyworm.io import units
from pyworm.io.given import Given, WithUnit, take
from pyworm.io.shown import ShownFields
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.scene.contact import FROM_GAP, Contact, as_arrays, radii_of
from pyworm.scene.life import Past

Gap = Callable[[Array, Array], tuple[Array, Flags]]
"""(x, y) [m] -> undeformed gap [m] and a boolean, true where both surfaces exist.

The gap is zero at the contact point and finite everywhere: outside the teeth it continues the surfaces, since
oil still flows there."""

Motion = Callable[[Array, Array], tuple[Array, Array]]
"""(x, y) [m] -> velocity components (u, v) [m/s] of one surface."""


MAX_SPEED = 1e12
"""Largest speed [m/s] or speed of rotation [rad/s] that is no slip."""


@dataclass(frozen=True, repr=False)
class Paraboloid(ShownFields):
    """The gap x^2 / 2 Rx + y^2 / 2 Ry without edges."""

    radius_x: units.Radius
    """Relative radius of curvature along x [m]."""
    radius_y: units.Radius
    """Relative radius of curvature along y [m]."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI

        def __init__(self, radius_x: WithUnit, radius_y: WithUnit) -> None: ...

    def __post_init__(self) -> None:
        """Refuse radii that there are not."""
        take(self)
        positive("radius_x, radius_y", self.radii, "m")

    @property
    def radii(self) -> tuple[float, float]:
        """Relative radii of curvature along x and y [m]."""
        return self.radius_x, self.radius_y

    def __call__(self, x: Given, y: Given) -> tuple[Array, Flags]:
        """Gap [m] at (x, y) [m], and where both surfaces exist (everywhere)."""
        x, y = as_arrays(x, y)
        gap = x**2 / (2 * self.radius_x) + y**2 / (2 * self.radius_y)
        return gap, np.ones(gap.shape, dtype=bool)


@dataclass(frozen=True, repr=False)
class RigidMotion(ShownFields):
    """Translation and spin of one surface in the tangent plane."""

    u: units.Velocity
    """Velocity along x at the contact point [m/s]."""
    v: units.Velocity
    """Velocity along y at the contact point [m/s]."""
    spin: units.Spin = 0.0
    """Angular velocity about the common normal [rad/s], positive from x to y."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI

        def __init__(self, u: WithUnit, v: WithUnit, spin: WithUnit = ...) -> None: ...

    def __post_init__(self) -> None:
        """Refuse velocities that there are not."""
        take(self)
        within("u, v, spin", (self.u, self.v, self.spin), -MAX_SPEED, MAX_SPEED, "")

    def __call__(self, x: Given, y: Given) -> tuple[Array, Array]:
        """Velocity components [m/s] at (x, y) [m]."""
        x, y = as_arrays(x, y)
        return self.u - self.spin * y, self.v + self.spin * x


@dataclass(frozen=True, kw_only=True, repr=False)
class Scene(Contact):
    """One lubricated point contact at one instant.

    Raises:
        ValueError: Radii other than those of the gap, or an oil or a body of a class unknown to the kernel.

    The other attributes are those of `pyworm.scene.contact.Contact`.
    """

    load: units.Force
    """Normal load [N]."""
    gap: Gap
    """Undeformed gap and where both surfaces exist."""
    radii: tuple[float, float] = FROM_GAP
    """Relative radii of curvature along x and y at the contact point [m]: the scale of the contact. By
    default those of the gap, which a `Paraboloid` and a `SampledGap` have."""
    motions: tuple[Motion, Motion]
    """Velocity field of body 1 and of body 2."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI
        # fmt: off
        def __init__(
            self, *, name: str = ..., gap: Gap, load: WithUnit, bodies: tuple[Body, Body], oil: Oil,
            phase: float | None = ..., slide_roll_ratio: float | None = ..., section: str | None = ...,
            station: float | None = ..., separation: WithUnit | None = ..., past: Past[Any] | None = ...,
            rigid: bool = ..., smooth: bool = ..., travelled: Sequence[Sequence[WithUnit]] | None = ...,
            radii: tuple[WithUnit, WithUnit] = ..., motions: tuple[Motion, Motion]
        ) -> None: ...
        # fmt: on

    def __post_init__(self) -> None:
        """Take the radii of the gap; refuse others, and what is no motion."""
        super().__post_init__()
        object.__setattr__(self, "radii", radii_of(self.gap, self.radii))
        if not (
            isinstance(self.motions, tuple)
            and len(self.motions) == 2
            and all(map(callable, self.motions))
        ):
            raise ValueError(
                "motions: must be a tuple of two, of body 1 and of body 2, such as RigidMotion"
            )

    @property
    def radii_along(self) -> tuple[float, float]:
        """Relative radii along x and y [m]."""
        return self.radii

    def velocities_at(self, *places: Given) -> tuple[tuple[Array, ...], tuple[Array, ...]]:
        """Velocity components [m/s] of body 1's and of body 2's surface at places (x, y) [m]."""
        x, y = as_arrays(*places)
        body_1, body_2 = self.motions
        return body_1(x, y), body_2(x, y)

    @property
    def motion_angles(self) -> tuple[float, float]:
        """Directions of both surfaces' velocities at the contact point, from the x axis [rad]."""
        first, second = self.velocities_at(np.zeros(()), np.zeros(()))
        return atan2(first[1], first[0]), atan2(second[1], second[0])

    entrainment = Contact.entrainment_at
    sliding = Contact.sliding_at


def require_point(scene: object) -> None:
    """Refuse what is no point contact; ValueError."""
    if not isinstance(scene, Scene):
        raise ValueError(f"scene is a {type(scene).__name__}: must be a Scene, of a point contact")
