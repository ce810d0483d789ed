"""A roller as a rigid body that turns on its pin."""

from dataclasses import dataclass
from math import hypot, pi

import numpy as np

from pyworm.drives.roller_worm.design import Rollers
from pyworm.drives.rotor import STEEL_DENSITY
from pyworm.materials.body import Body

GRAVITY = 9.80665
"""Standard acceleration of free fall [m/s2], ISO 80000-3."""

POINTS = 32
"""Points of the quadrature over the roller's length (Gauss and Legendre)."""


@dataclass(frozen=True)
class RollerBody:
    """A roller as a rigid body on its pin."""

    inertia: float
    """Moment of inertia about its axis [kg m2]."""
    mass: float
    """Mass [kg]."""
    orbit: float
    """Radius of its middle about the wheel's axis [m]."""
    pin_arm: float
    """Friction of the pin over its load: coefficient times radius [m]."""

    def pin_friction(self, force: float, wheel_speed: float) -> float:
        """Moment by which the pin can brake [N m] under a load [N], at least weight and centrifugal force."""
        rest = hypot(self.mass * GRAVITY, self.mass * self.orbit * wheel_speed**2)
        return self.pin_arm * max(force, rest)


def roller_body(rollers: Rollers, body: Body, orbit: float) -> RollerBody:
    """The roller as a solid of revolution, bored for its pin; of steel where its density is not given.

    A given moment of inertia replaces that of the solid.
    """
    profile, density = rollers.profile, body.density or STEEL_DENSITY
    points, weights = np.polynomial.legendre.leggauss(POINTS)
    place, share = points * profile.length / 2, weights * profile.length / 2
    radius = profile(place)[0] - profile.relief(place)
    bore = min(rollers.pin.radius, float(radius.min()))
    mass, inertia = (
        density * pi / order * float(np.sum(share * (radius ** (2 * order) - bore ** (2 * order))))
        for order in (1, 2)
    )
    return RollerBody(
        inertia=inertia if rollers.inertia is None else rollers.inertia,
        mass=mass,
        orbit=orbit,
        pin_arm=rollers.pin.radius * rollers.pin.friction,
    )
