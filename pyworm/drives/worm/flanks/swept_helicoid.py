"""Helicoids of any profile at their place in the drive, as points of a curve that moves in a screw.

Parameters are u, the place on the curve over `size`, and the turn of the curve [rad]. Turning the screw by an
angle takes p angle off the advance: a helicoid is carried into itself by its own screw motion.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import cos, sin

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Seated
from pyworm.drives.worm.flanks.screw_generator import (
    Array,
    Components,
    ScrewGenerator,
    cross_product,
)


@dataclass(frozen=True)
class Expansion:
    """Points of a flank and their normals (of any length), with derivatives by u and by the turn."""

    point: Components
    """Places [m]."""
    by_u: Components
    """Derivatives of the places by u."""
    by_turn: Components
    """Derivatives of the places by the turn."""
    normal: Components
    """Normals into the thread."""
    normal_by_u: Components
    """Derivatives of the normals by u."""
    normal_by_turn: Components
    """Derivatives of the normals by the turn."""


@dataclass(frozen=True)
class SweptHelicoid(Seated):
    """A right-hand helicoid of any profile at its place in the drive frame."""

    generator: ScrewGenerator
    """The curve that sweeps it."""
    size: float
    """Length for which the parameter u stands [m]."""
    centre_distance: float
    """Centre distance as of `Seated`."""
    swivel: float = 0.0
    """Swivel as of `Seated`."""
    axial_shift: float = 0.0
    """Axial shift as of `Seated`."""

    @property
    def screw(self) -> float:
        """Advance per radian, lead / 2 pi [m]."""
        return self.generator.screw

    @property
    def start_radius(self) -> float:
        """Radius at which the flank begins [m]."""
        return self.generator.start_radius

    @cached_property
    def bounds(self) -> tuple[float, float]:
        """Parameters u between which the flank exists."""
        low, high = self.generator.bounds
        return low / self.size, high / self.size

    def axial_profile(self, radius: float) -> float:
        """Height [m] of the flank's section with a plane through the axis, over the radius [m]."""
        return float(self.generator.axial_profile(radius))

    def normal_travel(self, radius: float) -> float:
        """Advance of the flank along its normal per radian at a radius [m]."""
        return self.screw * float(self.generator.normal_at(radius)[2])

    def pressure_angle(self, radius: float) -> float:
        """Normal pressure angle at a radius [rad]."""
        return self.generator.pressure_angle(radius)

    def over_centres(self, radius: float) -> tuple[float, float, float]:
        """u and turn of the point on a cylinder [m] over the line of centres, its angle in the mid-plane."""
        u = float(self.generator.at_radius(radius))
        x, y, z = self.generator.curve(u)[0]
        turn = -float(np.arctan2(y, x))
        return u / self.size, turn, turn + float(z) / self.screw

    def _seated(self, turn: Array) -> Callable[..., Components]:
        """What places a vector of the curve, times a scale, after its turn in the drive frame."""
        cosine, sine = np.cos(turn), np.sin(turn)
        upright, tilt = cos(self.swivel), sin(self.swivel)

        def seated(vector: Components, scale: float = 1.0) -> Components:
            x, y, z = vector
            across = scale * (sine * x + cosine * y)
            z = scale * z
            return (
                scale * (cosine * x - sine * y),
                upright * across - tilt * z,
                tilt * across + upright * z,
            )

        return seated

    def bends(self, u: Array, turn: Array) -> tuple[tuple[Components, Components], ...]:
        """Second derivatives of the places, by u and by the turn, of those by u and of those by the turn."""
        (x, y, _), along, bend = self.generator.curve(u * self.size)
        seated = self._seated(turn)
        mixed = seated((-along[1], along[0], 0.0), self.size)
        return (seated(bend, self.size**2), mixed), (mixed, seated((-x, -y, 0.0)))

    def expanded(self, u: Array, turn: Array, angle: Array | float) -> Expansion:
        """Points, normals and derivatives at u, a turn of the curve and an angle of the screw [rad]."""
        place, along, bend = self.generator.curve(u * self.size)
        x, y, z = place
        swept = -y, x, self.screw
        normal = cross_product(along, swept)
        bent, turned = cross_product(bend, swept), cross_product(along, (-along[1], along[0], 0.0))
        swung = bent[0] + turned[0], bent[1] + turned[1], bent[2] + turned[2]
        seated = self._seated(turn)
        placed = seated((x, y, z + self.screw * (turn - angle)))
        return Expansion(
            point=(placed[0] - self.centre_distance, placed[1] + self.axial_shift, placed[2]),
            by_u=seated(along, self.size),
            by_turn=seated(swept),
            normal=seated(normal),
            normal_by_u=seated(swung, self.size),
            normal_by_turn=seated((-normal[1], normal[0], 0.0)),
        )
