"""One section of the worm: its part of the enveloped flank, and the rollers that touch it.

A section is cut off square to the worm's axis at both ends. A roller is at phase 0 where the middle of its
bearing length comes to the section's first face and at phase 1 where it comes to the last; a little before
and after that part of its length still touches.
"""

from dataclasses import dataclass
from functools import cached_property
from math import ceil, floor, pi

import numpy as np

from pyworm.drives.roller_worm.envelope import Array, LineContact, RollerEnvelope

SECANTS = 7
"""Largest number of secant steps to the intersection of a face and a contact line."""

ROUNDING = 1e-15
"""Distance from the face at which the steps end [m]."""

_QUARTERS = ((floor, pi / 2), (ceil, -pi / 2))
"""Rounding and bound by which the rollers on the worm's side of the wheel are counted."""


@dataclass(frozen=True)
class WormSection:
    """A section of the worm."""

    name: str
    """Name: "left" or "right"."""
    envelope: RollerEnvelope
    """The flank."""
    first: float
    """Wheel angle at which a roller's middle is at the section's first face [rad]."""
    last: float
    """Wheel angle at which a roller's middle is at the section's other face [rad]; first < last."""
    lowest: float
    """Lower end of the bearing length along the roller, from its middle [m]."""
    highest: float
    """Upper end of the bearing length along the roller, from its middle [m]."""
    rollers: int
    """Number of rollers round the whole wheel."""

    @property
    def pitch(self) -> float:
        """Angle between neighbouring rollers [rad]."""
        return 2 * pi / self.rollers

    @property
    def middle(self) -> float:
        """Middle of the bearing length along the roller [m]."""
        return (self.lowest + self.highest) / 2

    @cached_property
    def faces(self) -> tuple[float, float]:
        """Ends of the section along the worm's axis [m]."""
        first, last = (self.along(self.middle, angle) for angle in (self.first, self.last))
        return float(first), float(last)

    def wheel_angle(self, phase: Array | float) -> Array:
        """Wheel angle of a roller at a phase of the section [rad]."""
        return np.asarray(self.first + phase * (self.last - self.first))

    def phase(self, wheel_angle: Array) -> Array:
        """Phase of a roller at a wheel angle [rad]."""
        return (wheel_angle - self.first) / (self.last - self.first)

    def span(self, wheel_angle: Array) -> tuple[Array, Array]:
        """Ends of the contact line along rollers at wheel angles [m]; equal where a roller does not touch."""
        phi = np.asarray(wheel_angle, float)
        low, high = (np.full(phi.shape, end) for end in (self.lowest, self.highest))
        before, after = self.faces
        for face, wanted in ((before, 1), (after, -1)):
            outside = [wanted * (self.along(end, phi) - face) < 0 for end in (low, high)]
            if not (outside[0] ^ outside[1]).any() and not (outside[0] & outside[1]).any():
                continue
            cut = self._cut(face, phi, low, high)
            low, high = (np.where(outside[0], cut, low), np.where(outside[1], cut, high))
            nowhere = outside[0] & outside[1]
            low, high = np.where(nowhere, self.middle, low), np.where(nowhere, self.middle, high)
        return low, high

    def in_mesh(self, wheel_angle: float) -> Array:
        """Wheel angles of all rollers that touch, one of them being at this angle [rad], in order."""
        ahead, behind = (round_((side - wheel_angle) / self.pitch) for round_, side in _QUARTERS)
        angles = wheel_angle + self.pitch * np.arange(behind, ahead + 1)
        low, high = self.span(angles)
        return angles[high - low > 1e-9 * (self.highest - self.lowest)]

    def line(self, wheel_angle: Array, fraction: Array) -> LineContact:
        """Contacts at fractions of lines, from the end nearer the wheel's axis, at wheel angles [rad]."""
        return self.within(self.span(wheel_angle), wheel_angle, fraction)

    def within(self, span: tuple[Array, Array], wheel_angle: Array, fraction: Array) -> LineContact:
        """Contacts at fractions of contact lines whose ends are known (`line`, `span`)."""
        low, high = span
        return self.envelope.contact(low + fraction * (high - low), wheel_angle)

    def along(self, place: Array | float, wheel_angle: Array | float) -> Array:
        """Place along the worm's axis of contacts [m]."""
        return self.envelope.point(place, wheel_angle)[0]

    def _cut(self, face: float, wheel_angle: Array, low: Array, high: Array) -> Array:
        """Intersection of a face with contact lines, which are nearly straight, by secants from both ends."""
        first, other = low, high
        off_one, off_other = (self.along(end, wheel_angle) - face for end in (low, high))
        with np.errstate(divide="ignore", invalid="ignore"):
            for _ in range(SECANTS):
                new = other - off_other * (other - first) / (off_other - off_one)
                parallel = ~np.isfinite(new)
                first, off_one = other, off_other
                other = np.clip(np.where(parallel, other, new), low, high)
                off_other = self.along(other, wheel_angle) - face
                if np.all(np.abs(off_other) <= ROUNDING):
                    break
        return other
