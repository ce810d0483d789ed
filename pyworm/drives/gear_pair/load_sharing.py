"""Sharing of the normal force of a gear mesh among its contact lines.

A contact line lies in the plane of action, tilted by the base helix angle against the axes; s is its place on
the line of action in the middle of the face, as the pinion's radius of curvature there. Each rule gives
the load for each length of line as a share of the normal force:

| rule | load for each length / normal force |
|---|---|
| ramp | X / L_min |
| uniform | 1 / L, the same everywhere on the lines that are in contact together, of length L |
| elastic | v / (integral of v over these lines), v(s) the stiffness of a pair of teeth |

**ramp**: X rises from 1/3 to 2/3 while another pair of teeth is in contact, is 1 between the lowest and
the highest point of single contact, and falls from 2/3 to 1/3: the sharing of spur gears with unmodified
profiles in Blok's method (AGMA 925-A03, ISO/TR 13989-1). For helical gears it is the rating practice of
AGMA 2001-B88, on the shortest total line L_min: together the lines then carry more than the normal force.

**elastic**: v = cos[b0 (s - s_m) / p_bt], b0 = [(1 + eps_alpha / 2)^2 / 2 - 1]^(-1/2), s_m the middle of the
path of contact: teeth that bend, shear and shorten under the load (J. I. Pedrero, M. Pleguezuelos, M. Artes
and J. A. Antona, Mech. Mach. Theory 45 (2010) 780-794, for 1 < eps_alpha < 2 and standard tools). The formula
has not been compared with the paper's print; it gives FZG C gears 0.36 at the ends, where the ramp has 1/3.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil, cos, sqrt, tan
from typing import Literal, get_args

import numpy as np

from pyworm.drives.gear_pair.gears import InvolutePair

Array = np.ndarray
SharingRule = Literal["ramp", "uniform", "elastic"]

STRAIGHT = 1e-6
"""Tangent of the base helix angle below which contact lines count as parallel to the axes: the ends of a line
differ in place by so little that the difference of their integrals is rounding."""


@dataclass(frozen=True)
class LoadSharing:
    """One rule for one pair of gears; ValueError if it does not exist or apply."""

    pair: InvolutePair
    """The gears."""
    rule: SharingRule
    """Rule of sharing: "ramp", "uniform" or "elastic"."""

    def __post_init__(self) -> None:
        if self.rule not in get_args(SharingRule):
            raise ValueError(
                f'load_sharing is "{self.rule}"; it must be one of {", ".join(get_args(SharingRule))}'
            )
        ratio = self.pair.transverse_contact_ratio
        if self.rule != "uniform" and ratio >= 2:
            raise ValueError(
                f'load_sharing is "{self.rule}"; it holds for a transverse contact ratio below 2, here it '
                f'is {ratio:.3f}: choose "uniform"'
            )

    def per_length(self, s: Array) -> Array:
        """Load for each length of the line at mid-face place s, over the normal force [1/m]."""
        s = np.asarray(s, float)
        if self.rule == "ramp":
            return self._ramp(s) / self.pair.shortest_line
        touching = (s >= self.pair.start) & (s <= self.pair.end)
        return np.where(touching, self._stiffness[0](s) / self._together(s), 0.0)

    def of_line(self, s: Array) -> Array:
        """Share of the normal force that the whole line through mid-face place s carries [-].

        s may lie off the path of contact: a helical tooth touches near one end of the face first.
        """
        s = np.asarray(s, float)
        if self.rule == "ramp":
            return self._ramp(s) * self.line_length(s) / self.pair.shortest_line
        return self._over_line(s, *self._stiffness) / self._together(s)

    def line_length(self, s: Array) -> Array:
        """Length of the contact line through mid-face place s [m]."""
        return self._over_line(np.asarray(s, float), np.ones_like, lambda place: place)

    def _ramp(self, s: Array) -> Array:
        pair = self.pair
        double = pair.path_length - pair.system.base_pitch
        # As far into the nearer end's double contact as s is.
        inward = np.minimum(s - pair.start, pair.end - s)
        if double <= 0:
            return np.where(inward >= 0, 1.0, 0.0)
        fraction = np.where(inward < double, 1 / 3 + inward / (3 * double), 1.0)
        return np.where(inward >= 0, fraction, 0.0)

    @property
    def _stiffness(self) -> tuple[Callable[[Array], Array], Callable[[Array], Array]]:
        """Relative stiffness v(s) and its integral over s."""
        if self.rule == "uniform":
            return np.ones_like, lambda s: s
        pair = self.pair
        b0 = 1 / sqrt((1 + pair.transverse_contact_ratio / 2) ** 2 / 2 - 1)
        rate, middle = b0 / pair.system.base_pitch, (pair.start + pair.end) / 2
        return (lambda s: np.cos(rate * (s - middle)), lambda s: np.sin(rate * (s - middle)) / rate)

    def _together(self, s: Array) -> Array:
        """Integral of v over all lines that are in contact when one is at s [m]."""
        pair = self.pair
        pitch = pair.system.base_pitch
        reach = ceil(pair.transverse_contact_ratio + pair.overlap_ratio)
        # Counted from the line itself, which so is among them to the last digit, even where it ends.
        before = np.floor((s - pair.start) / pitch)
        together = np.zeros(np.shape(s))
        for number in range(-reach, reach + 1):
            together = together + self._over_line(s + (number - before) * pitch, *self._stiffness)
        return together

    def _over_line(
        self, s: Array, function: Callable[[Array], Array], integral: Callable[[Array], Array]
    ) -> Array:
        """Integral [m] along one contact line of a function of s, given with its own integral over s."""
        pair = self.pair
        tilt, slant = cos(pair.system.base_helix_angle), tan(pair.system.base_helix_angle)
        if slant < STRAIGHT:
            touching = (s >= pair.start) & (s <= pair.end)
            return np.where(touching, function(s) * pair.face_width, 0.0)
        half = pair.face_width / 2 * slant
        low, high = (np.clip(place, pair.start, pair.end) for place in (s - half, s + half))
        return (integral(high) - integral(low)) / (slant * tilt)
