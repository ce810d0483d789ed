"""Flanks whose axial section is a circular arc, as of ZC worms by the arc in the axial plane.

DIN 3975 has such worms as ZC2 beside ZC1, which a disc of that arc grinds. The thread is concave: the centre
of the arc, of a radius rho, lies in the space of the thread, and the flank at the reference radius r_m has
the axial pressure angle alpha_x, tan(alpha_x) = tan(alpha_n) / cos(gamma). With r_c = r_m + rho sin(alpha_x)

    z(r) = sqrt(rho^2 - (r_c - r)^2),    z' = (r_c - r) / z,    z'' = -rho^2 / z^3

up to a constant. Lengths in m, angles in rad.
"""

from dataclasses import dataclass
from math import atan, cos, pi, sin, tan

import numpy as np

from pyworm.drives.worm.flanks.screw_generator import Array, Components, ScrewGenerator
from pyworm.kernel.flank_height import SweptCurve


@dataclass(frozen=True)
class AxialArc(ScrewGenerator):
    """A helicoid swept by an arc in the axial plane over the radius; ValueError if it does not rise."""

    top: float
    """r_c, radius above which the flank would no longer rise [m]."""
    arc_radius: float
    """Radius of the arc, rho [m]."""
    screw: float
    """Advance per radian, lead / 2 pi [m]."""
    lowest: float
    """Radius from which the flank is used [m]."""
    highest: float
    """Radius up to which the flank is used [m]."""

    def __post_init__(self) -> None:
        bottom = self.top - self.arc_radius
        if not bottom < self.lowest < self.highest < self.top:
            raise ValueError(
                f"the arc rises from a radius of {bottom * 1e3:.4g} mm to {self.top * 1e3:.4g} mm only, the "
                f"flank from {self.lowest * 1e3:.4g} mm to {self.highest * 1e3:.4g} mm"
            )

    @property
    def start_radius(self) -> float:
        """Radius at which the flank begins [m]."""
        return self.lowest

    @property
    def bounds(self) -> tuple[float, float]:
        """Radii between which the flank is used [m]."""
        return self.lowest, self.highest

    def curve(self, u: Array | float) -> tuple[Components, Components, Components]:
        """The arc and its derivatives by the radius."""
        below = self.top - np.asarray(u)
        height = np.sqrt(self.arc_radius**2 - below**2)
        bend = -(self.arc_radius**2) / height**3
        return (u, 0.0 * below, height), (1.0, 0.0, below / height), (0.0, 0.0, bend)

    @property
    def swept(self) -> SweptCurve:
        """The arc over the radius."""
        radius = np.array([[1.0, 0.0], [0.0, 0.0], [0.0, 0.0]])
        return SweptCurve(radius, arc=self.arc_radius, top=self.top)

    def at_radius(self, radius: Array | float) -> Array:
        """The radius itself [m]."""
        return np.asarray(radius, float)


def axial_arc(
    lead: float,
    lead_angle: float,
    pressure_angle: float,
    reference: float,
    arc_radius: float,
    radii: tuple[float, float],
) -> AxialArc:
    """The flank with a normal pressure angle and a lead angle on a reference radius [m], between radii."""
    axial = atan(tan(pressure_angle) / cos(lead_angle))
    return AxialArc(reference + arc_radius * sin(axial), arc_radius, lead / (2 * pi), *radii)
