"""The gap between two involute flanks over the tangent plane of their contact line.

x runs across the contact line towards the pinion's tip, y along it, z along the common normal from pinion to
gear. An involute helicoid is the envelope of planes that roll off its base cylinder; in the plane turned by
theta from the one that touches at the contact point, z is

    T = cos(b) [A (1 - cos theta) + r_b (theta - sin theta) - x sin theta] / (cos^2 b cos theta + sin^2 b),

A = rho + y sin b, with rho the radius of curvature at the contact point and b the base helix angle; the
flank is where T is stationary,

    x = L sin theta - r_b (1 - cos theta),
    L = [A (1 + q) + r_b (theta + q sin theta)] / (1 + q cos theta),    q = tan^2 b,

L being the radius of curvature there. To second order z = -cos(b) x^2 / 2A: the flanks touch all along x = 0.
The gear's flank is the pinion's, inverted through the contact point.
"""

from dataclasses import dataclass
from math import cos, sin, tan

import numpy as np

Array = np.ndarray

TURN = 1.0
"""Angle [rad] beyond which an involute, long past any tip, continues as its tangent plane."""

NEAR_BASE = 0.05
"""Radius of curvature, over that at the contact point, below which an involute continues as tangent plane."""

STEPS = 40
"""Largest number of Newton steps; 3 to 6 are typical."""


@dataclass(frozen=True)
class Flank:
    """One involute helicoid at its contact point."""

    base: float
    """Radius of the base circle [m]."""
    length: float
    """Radius of curvature at the contact point, in the transverse section [m]."""
    helix: float
    """Base helix angle [rad]."""
    form_length: float
    """Radius of curvature where the flank begins [m]."""
    tip_length: float
    """Radius of curvature where the flank ends [m]."""
    relief: float = 0.0
    """How much of the flank is taken off at the tip, along the normal [m]."""
    relief_length: float = 0.0
    """Length on the line of action over which that grows, linearly, up to the tip [m]."""

    def height(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Height [m] over the tangent plane, zero or less, and where the flank exists.

        Both ends are continued smoothly: the tip by the involute, the root by its last tangent plane.
        """
        tilt = cos(self.helix)
        squared = tan(self.helix) ** 2
        start = self.length + y * sin(self.helix)
        lowest = np.minimum((NEAR_BASE * self.length - start) / self.base, TURN)
        theta = np.clip(x / np.maximum(start, NEAR_BASE * self.length), lowest, TURN)
        for _ in range(STEPS):
            sine, cosine = np.sin(theta), np.cos(theta)
            below = 1 + squared * cosine
            length = (start * (1 + squared) + self.base * (theta + squared * sine)) / below
            slope = self.base + squared * length * sine / below
            miss = length * sine - self.base * (1 - cosine) - x
            step = -miss / (slope * sine + length * cosine - self.base * sine)
            ahead = np.clip(theta + step, lowest, TURN)
            moved = np.max(np.abs(ahead - theta), initial=0.0)
            theta = ahead
            if moved < 1e-14:
                break
        sine, versine = np.sin(theta), 2 * np.sin(theta / 2) ** 2
        height = tilt * (start * versine + self.base * _angle_less_sine(theta) - x * sine)
        height /= tilt**2 * (1 - versine) + sin(self.helix) ** 2
        length = (start * (1 + squared) + self.base * (theta + squared * sine)) / (
            1 + squared * (1 - versine)
        )
        exists = (length >= self.form_length) & (length <= self.tip_length * (1 + 1e-12))
        # Convex as they are, flanks stay below the plane; their continuations are kept there.
        height = np.minimum(height, 0.0) - self._taken_off(length)
        return height, exists & (theta > lowest) & (theta < TURN)

    def _taken_off(self, length: Array) -> Array:
        """Tip relief [m] where the radius of curvature is `length`."""
        if self.relief == 0:
            return np.zeros(length.shape)
        into = length - (self.tip_length - self.relief_length)
        return self.relief * np.maximum(into, 0.0) / self.relief_length


@dataclass(frozen=True)
class GearGap:
    """Undeformed gap of a pair of teeth of finite width."""

    pinion: Flank
    """Flank of the pinion at its contact point."""
    gear: Flank
    """Flank of the gear at its contact point."""
    face_width: float
    """Common face width [m]; the contact point is in its middle."""
    crowning: float = 0.0
    """Height removed from both flanks together at the ends of the face, as a parabola [m]."""

    def __call__(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Gap [m], zero at the contact point, and where both teeth exist."""
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        gap, exists = self._between(x, y)
        origin = np.zeros(1)
        along = y * cos(self.pinion.helix) / (self.face_width / 2)
        gap = gap - self._between(origin, origin)[0][0] + self.crowning * along**2
        return gap, exists & (np.abs(along) <= 1)

    def _between(self, x: Array, y: Array) -> tuple[Array, Array]:
        below, pinion = self.pinion.height(x, y)
        above, gear = self.gear.height(-x, -y)
        return -above - below, pinion & gear


@dataclass(frozen=True)
class GearSection:
    """The gap in the section across the contact line at the contact point, for a line contact."""

    gap: GearGap
    """The gap of the pair of teeth."""

    def __call__(self, x: Array) -> tuple[Array, Array]:
        """Gap [m] and where both teeth exist."""
        return self.gap(x, np.zeros(np.shape(x)))


def _angle_less_sine(angle: Array) -> Array:
    """Evaluate angle - sin(angle) without cancellation at small angles."""
    series = angle**3 / 6 * (1 - angle**2 / 20 * (1 - angle**2 / 42 * (1 - angle**2 / 72)))
    return np.where(np.abs(angle) < 0.2, series, angle - np.sin(angle))
