"""A scene: one lubricated contact at one instant, and all that the solver may know of it.

The tangent plane carries x and y with their origin at the contact point; z points from body 1 to body 2.
Velocities are those of the surfaces relative to the (moving) contact point, projected on the plane.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

import numpy as np

from pyworm.materials.body import Body, composite_roughness, reduced_modulus
from pyworm.materials.oil import Oil, require_kinds
from pyworm.scene.past import Past

Array = np.ndarray
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


SAME = 0.01
"""Largest relative difference between the radii of a scene and those of its gap."""


def require_radii(radii: tuple[float, ...], of_gap: tuple[float, ...]) -> None:
    """Refuse radii that are not those of the gap: window, far field and grids follow from them.

    Raises
    ------
    ValueError
        One differs.
    """
    if any(abs(given - own) > SAME * own for given, own in zip(radii, of_gap, strict=True)):
        given, own = (", ".join(f"{radius:g}" for radius in of) for of in (radii, of_gap))
        raise ValueError(f"radii {given} m contradict the gap, whose radii are {own} m; give these")


def require_simulated(oil: Oil, bodies: tuple[Body, Body]) -> None:
    """Refuse an oil or a body whose formulas the kernel would ignore; ValueError."""
    require_kinds("oil", oil, Oil)
    for body in bodies:
        require_kinds("a body", body, Body)


@dataclass(frozen=True)
class Scene:
    """One lubricated contact at one instant.

    Attributes
    ----------
    name : str
        What tables and pictures call it.
    gap : Gap
        Undeformed gap and where both surfaces exist.
    radii : tuple of float
        Relative radii of curvature along x and y at the contact point [m]: the scale of the contact.
    motions : tuple of Motion
        Velocity field of body 1 and of body 2.
    load : float
        Normal load [N].
    bodies : tuple of Body
        Body 1 and body 2.
    oil : Oil
        The oil at its inlet temperature.
    phase : float or None
        Place in the mesh cycle, 0 to 1; None outside a drive.
    slide_roll_ratio : float or None
        Place on a traction curve: sliding over entrainment [-]; None outside one.
    section, station : str or None, float or None
        Section of a worm that has two, and place along the contact line, 0 to 1; None elsewhere.
    past : Past or None
        What the contact was earlier, as the drive turns; None where nothing changes.
    rigid : bool
        Whether the bodies keep their shape under the film.

    Raises
    ------
    ValueError
        Radii that are not those of a gap that knows its own, or an oil or a body of a class that the kernel
        does not know.
    """

    name: str
    gap: Gap
    radii: tuple[float, float]
    motions: tuple[Motion, Motion]
    load: float
    bodies: tuple[Body, Body]
    oil: Oil
    phase: float | None = None
    slide_roll_ratio: float | None = None
    section: str | None = None
    station: float | None = None
    past: "Past[Scene] | None" = None
    rigid: bool = False

    def __post_init__(self) -> None:
        """Refuse what would be solved as something else."""
        require_simulated(self.oil, self.bodies)
        require_radii(self.radii, getattr(self.gap, "radii", self.radii))

    @property
    def bending_modulus(self) -> float:
        """Reduced modulus by which the bodies bend under the film [Pa]; infinite of rigid ones."""
        return inf if self.rigid else self.reduced_modulus

    @property
    def reduced_modulus(self) -> float:
        """Reduced modulus E' of the two bodies [Pa]."""
        return reduced_modulus(*self.bodies)

    @property
    def composite_roughness(self) -> float | None:
        """Root mean square height of both surfaces together [m]; None if it is not known."""
        return composite_roughness(*self.bodies)

    def entrainment(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Mean surface velocity components [m/s] at (x, y)."""
        (u1, v1), (u2, v2) = (motion(x, y) for motion in self.motions)
        return (u1 + u2) / 2, (v1 + v2) / 2

    def sliding(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Velocity components of body 1 relative to body 2 [m/s] at (x, y)."""
        (u1, v1), (u2, v2) = (motion(x, y) for motion in self.motions)
        return u1 - u2, v1 - v2
