"""Ruled helicoids, the flanks of ZA, ZN and ZI worms: a straight line that moves in a screw.

The line passes the axis at a distance and is inclined to the transverse plane; with a line along the tangent
of its base helix the surface is the involute helicoid (F. L. Litvin and A. Fuentes, Gear Geometry and Applied
Theory, 2004, chapter 19). Lengths in m, angles in rad.
"""

from dataclasses import dataclass
from math import atan2, cos, inf, pi, sin, sqrt, tan

import numpy as np

from pyworm.drives.worm.flanks.involute_helicoid import base_lead_angle, base_radius
from pyworm.drives.worm.flanks.screw_generator import Array, Components, ScrewGenerator
from pyworm.kernel.flank_height import SweptCurve


@dataclass(frozen=True)
class RuledHelicoid(ScrewGenerator):
    """A right-hand ruled helicoid; the line rises outwards, its parameter is the way across the axis."""

    offset: float
    """Distance of the line from the axis [m], negative where it leans against the hand of the screw."""
    slope: float
    """Tangent of its inclination to the transverse plane [-]."""
    screw: float
    """Advance per radian, lead / 2 pi [m]."""

    @property
    def start_radius(self) -> float:
        """Radius at which the line is nearest the axis [m]; of the involute its base cylinder."""
        return abs(self.offset)

    @property
    def bounds(self) -> tuple[float, float]:
        """The half of the line that rises outwards [m]."""
        return 0.0, inf

    def curve(self, u: Array | float) -> tuple[Components, Components, Components]:
        """The line and its derivatives."""
        return (self.offset, u, self.slope * u), (0.0, 1.0, self.slope), (0.0, 0.0, 0.0)

    @property
    def swept(self) -> SweptCurve:
        """The line."""
        return SweptCurve(np.array([[0.0, self.offset], [1.0, 0.0], [self.slope, 0.0]]))

    def at_radius(self, radius: Array | float) -> Array:
        """Way across the axis along the line at a distance from the axis [m]."""
        return np.sqrt(np.asarray(radius) ** 2 - self.offset**2)


def straight_axial(lead: float, lead_angle: float, pressure_angle: float) -> RuledHelicoid:
    """The flank of a ZA worm, straight in the axial plane, with its normal pressure angle."""
    return RuledHelicoid(0.0, tan(pressure_angle) / cos(lead_angle), lead / (2 * pi))


def straight_normal(
    lead: float, lead_angle: float, pressure_angle: float, apex: float
) -> RuledHelicoid:
    """The flank of a ZN worm, straight in the plane normal to the thread, where its blade has an angle.

    `apex` is the radius at which the line meets the middle of the thread or of its space [m].
    """
    across = sqrt(cos(pressure_angle) ** 2 + (sin(pressure_angle) * sin(lead_angle)) ** 2)
    return RuledHelicoid(
        offset=-apex * sin(pressure_angle) * sin(lead_angle) / across,
        slope=sin(pressure_angle) * cos(lead_angle) / across,
        screw=lead / (2 * pi),
    )


def blade_angle(flank: RuledHelicoid, lead_angle: float) -> float:
    """Angle of the straight blade of a ZN flank, which `straight_normal` turns into its slope s.

    From s = sin(a) cos(g) / sqrt(cos(a)^2 + (sin(a) sin(g))^2) follows
    tan(a) = s / sqrt(cos(g)^2 - (s sin(g))^2).
    """
    across = cos(lead_angle) ** 2 - (flank.slope * sin(lead_angle)) ** 2
    return atan2(flank.slope, sqrt(across))


def involute(lead: float, lead_angle: float, pressure_angle: float) -> RuledHelicoid:
    """The flank of a ZI worm: the line is tangent to the base helix."""
    base = base_radius(lead, base_lead_angle(lead_angle, pressure_angle))
    screw = lead / (2 * pi)
    return RuledHelicoid(base, screw / base, screw)
