"""Rollers as surfaces of revolution: the profile that envelops the worm, and its crown relief.

A cylinder, a cone and a ball are closed forms; any other roller is "revolved", with its own meridian.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from pyworm.drives.roller_worm.meridian import Jet, Meridian
from pyworm.io import units
from pyworm.io.present import present

Array = np.ndarray

Shape = Literal["cylinder", "cone", "ball", "revolved"]


@dataclass(frozen=True)
class Crown:
    """Crown relief: beyond a straight middle the radius falls by (|s| - straight/2)^2 / 2 radius."""

    radius: units.Radius
    """Radius of the crown along the roller [m]."""
    straight: units.LengthOrZero = 0.0
    """Length of the middle part without relief [m]."""

    def __call__(self, place: Array) -> Array:
        """Relief of the radius [m] at a place along the axis [m] from the roller's middle."""
        beyond = np.maximum(np.abs(place) - self.straight / 2, 0.0)
        return beyond**2 / (2 * self.radius)


@dataclass(frozen=True)
class RollerProfile:
    """Radius of a roller along its axis: rho(s), with s from the roller's middle [m]."""

    radius: units.Length
    """Radius in the middle [m]."""
    length: units.Length
    """Length along the axis [m]; of a ball the part between two planes."""
    shape: Shape = "cylinder"
    """Shape of the roller: "cylinder", "cone", "ball" or "revolved"."""
    half_angle: units.Tilt = 0.0
    """Angle of a cone's side to its axis [rad], positive where the radius grows with s."""
    crown: Crown | None = None
    """Crown of the roller, which the tool that cuts the worm does not have."""
    meridian: Meridian | None = None
    """Rise of the radius along a roller that is "revolved"."""

    def __call__(self, place: Array) -> tuple[Array, Array]:
        """Radius [m] and angle gamma [rad] of the side to the axis, tan(gamma) = d rho/ds."""
        place = np.asarray(place)
        if self.shape == "ball":
            radius = np.sqrt(self.radius**2 - place**2)
            return radius, -np.arcsin(place / self.radius)
        if self.shape == "revolved":
            rise, slope, _ = self._revolved(place)
            return self.radius + rise, np.arctan(slope)
        angle = self.half_angle if self.shape == "cone" else 0.0
        return self.radius + place * np.tan(angle), np.full(np.shape(place), angle)

    def turning(self, place: Array) -> Array:
        """Change of the angle of the side along the axis, d gamma/ds [1/m]."""
        if self.shape == "ball":
            return -1 / np.sqrt(self.radius**2 - np.asarray(place) ** 2)
        if self.shape == "revolved":
            _, slope, bend = self._revolved(np.asarray(place))
            return np.asarray(bend / (1 + slope**2))
        return np.zeros(np.shape(place))

    def _revolved(self, place: Array) -> Jet:
        """Rise [m], slope and second derivative [1/m] of the meridian."""
        meridian = present(self.meridian, "rollers.meridian")
        return meridian(place, self.radius, self.length)

    def relief(self, place: Array) -> Array:
        """Crown relief of the radius [m]."""
        return np.zeros(np.shape(place)) if self.crown is None else self.crown(np.asarray(place))
