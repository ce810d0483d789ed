"""A line scene: one lubricated line contact at one instant, the input of the line solver.

The contact is the same all along the line. x runs across the line with its origin at the contact point;
velocities are those of the surfaces along x, relative to the (moving) contact point.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pyworm.scene.contact import Array, Contact, require_radii

LineGap = Callable[[Array], tuple[Array, Array]]
"""x [m] -> undeformed gap [m] and a boolean, true where both surfaces exist. The gap is finite everywhere."""


@dataclass(frozen=True)
class Parabola:
    """The gap x^2 / 2R without edges.

    Attributes
    ----------
    radius : float
        Relative radius of curvature [m].
    """

    radius: float

    def __call__(self, x: Array) -> tuple[Array, Array]:
        """Gap [m] and where both surfaces exist (everywhere)."""
        return x**2 / (2 * self.radius), np.ones(x.shape, dtype=bool)


@dataclass(frozen=True, kw_only=True)
class LineScene(Contact):
    """One lubricated line contact at one instant.

    Attributes
    ----------
    gap : LineGap
        Undeformed gap and where both surfaces exist.
    radius : float
        Relative radius of curvature at the contact point [m]: the scale of the contact, and the gap beyond
        the grid.
    velocities : tuple of float
        Velocity of body 1 and of body 2 [m/s].

    Raises
    ------
    ValueError
        A radius other than that of the gap, or an oil or a body of a class unknown to the kernel.

    Notes
    -----
    The other attributes are those of `pyworm.scene.contact.Contact`, the load for each length [N/m].
    """

    gap: LineGap
    radius: float
    velocities: tuple[float, float]

    def __post_init__(self) -> None:
        """Refuse a radius other than that of the gap."""
        super().__post_init__()
        require_radii((self.radius,), (getattr(self.gap, "radius", self.radius),))

    @property
    def entrainment(self) -> float:
        """Mean surface velocity [m/s]."""
        return sum(self.velocities) / 2

    @property
    def sliding(self) -> float:
        """Velocity of body 1 relative to body 2 [m/s]."""
        return self.velocities[0] - self.velocities[1]

    @property
    def motion_angles(self) -> tuple[float, float]:
        """Directions of both surfaces' velocities from the x axis; against it is all one to a lay."""
        return 0.0, 0.0

    def velocities_at(self, x: Array) -> tuple[tuple[Array], tuple[Array]]:
        """Velocity [m/s] of body 1's and of body 2's surface, the same at each x."""
        return tuple((np.full(np.shape(x), velocity),) for velocity in self.velocities)
