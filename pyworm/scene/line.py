"""A line scene: one lubricated line contact at one instant, the input of the line solver.

The contact is the same all along the line. x runs across the line with its origin at the contact point;
velocities are those of the surfaces along x, relative to the (moving) contact point.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pyworm.formulas.arrays import Array, Flags
from pyworm.formulas.ranges import positive
from pyworm.io import units
from pyworm.io.given import Given, WithUnit, kind_of, number, take
from pyworm.io.shown import ShownFields
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.scene.contact import FROM_GAP, Contact, as_arrays, radii_of
from pyworm.scene.life import Past

LineGap = Callable[[Array], tuple[Array, Flags]]
"""x [m] -> undeformed gap [m] and a boolean, true where both surfaces exist. The gap is finite everywhere."""


@dataclass(frozen=True, repr=False)
class Parabola(ShownFields):
    """The gap x^2 / 2R without edges."""

    radius: units.Radius
    """Relative radius of curvature [m]."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI

        def __init__(self, radius: WithUnit) -> None: ...

    def __post_init__(self) -> None:
        """Refuse a radius that there is not."""
        take(self)
        positive("radius", self.radius, "m")

    @property
    def radii(self) -> tuple[float]:
        """The relative radius of curvature [m]."""
        return (self.radius,)

    def __call__(self, x: Given) -> tuple[Array, Flags]:
        """Gap [m] at x [m], and where both surfaces exist (everywhere)."""
        (x,) = as_arrays(x)
        return x**2 / (2 * self.radius), np.ones(x.shape, dtype=bool)


@dataclass(frozen=True, kw_only=True, repr=False)
class LineScene(Contact):
    """One lubricated line contact at one instant.

    Raises:
        ValueError: A radius other than that of the gap, or an oil or a body of a class unknown to the kernel.

    The other attributes are those of `pyworm.scene.contact.Contact`, the load for each length [N/m].
    """

    load: units.ForcePerLength
    """Normal load for each length [N/m]."""
    gap: LineGap
    """Undeformed gap and where both surfaces exist."""
    radius: float = FROM_GAP
    """Relative radius of curvature at the contact point [m]: the scale of the contact, and the gap beyond the
    grid. By default that of the gap, which a `Parabola` has."""
    velocities: tuple[float, float]
    """Velocity of body 1 and of body 2 [m/s]."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI
        # fmt: off
        def __init__(
            self, *, name: str = ..., gap: LineGap, load: WithUnit, bodies: tuple[Body, Body], oil: Oil,
            phase: float | None = ..., slide_roll_ratio: float | None = ..., section: str | None = ...,
            station: float | None = ..., separation: WithUnit | None = ..., past: Past[Any] | None = ...,
            rigid: bool = ..., smooth: bool = ..., travelled: Sequence[Sequence[WithUnit]] | None = ...,
            radius: WithUnit = ..., velocities: tuple[WithUnit, WithUnit]
        ) -> None: ...
        # fmt: on

    def __post_init__(self) -> None:
        """Take the radius of the gap; refuse another one, and what are no velocities."""
        super().__post_init__()
        given = None if self.radius is None else (self.radius,)
        object.__setattr__(self, "radius", radii_of(self.gap, given)[0])
        if not (isinstance(self.velocities, tuple) and len(self.velocities) == 2):
            raise ValueError("velocities: must be a tuple of two, of body 1 and of body 2 [m/s]")
        kind = kind_of(units.Velocity)
        velocities = tuple(number("velocities", velocity, kind) for velocity in self.velocities)
        object.__setattr__(self, "velocities", velocities)

    @property
    def radii_along(self) -> tuple[float]:
        """Relative radius across the line [m]."""
        return (self.radius,)

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

    def velocities_at(self, *places: Given) -> tuple[tuple[Array, ...], tuple[Array, ...]]:
        """Velocity [m/s] of body 1's and of body 2's surface, the same at each place x [m]."""
        (x,) = as_arrays(*places)
        first, second = ((np.full(x.shape, velocity),) for velocity in self.velocities)
        return first, second
