"""Ruled helicoids, the flanks of ZA, ZN and ZI worms: a straight line that moves in a screw.

The line passes the axis at a distance and is inclined to the transverse plane; with a line along the tangent
of its base helix the surface is the involute helicoid (F. L. Litvin and A. Fuentes, Gear Geometry and Applied
Theory, 2004, chapter 19). Lengths in m, angles in rad.
"""

from dataclasses import dataclass
from math import cos, pi, sin, sqrt, tan

import numpy as np

from pyworm.formulas.involute_helicoid import base_lead_angle, base_radius

Array = np.ndarray


@dataclass(frozen=True)
class RuledHelicoid:
    """A right-hand ruled helicoid, about z; the line falls outwards.

    Attributes
    ----------
    offset : float
        Distance of the line from the axis [m], negative where it leans against the hand of the screw.
    slope : float
        Tangent of its inclination to the transverse plane [-].
    screw : float
        Advance per radian, lead / 2 pi [m].
    """

    offset: float
    slope: float
    screw: float

    def point(self, turn: Array, across: Array) -> Array:
        """Points, (3, ...) [m], after a turn [rad] at distances across the axis along the line [m]."""
        cosine, sine = np.cos(turn), np.sin(turn)
        return np.stack(
            [
                self.offset * cosine + across * sine,
                self.offset * sine - across * cosine,
                self.screw * turn - across * self.slope,
            ]
        )

    def normal(self, turn: Array, across: Array) -> Array:
        """Unit normals there, (3, ...)."""
        cosine, sine = np.cos(turn), np.sin(turn)
        along = np.stack([sine, -cosine, -self.slope + 0 * sine])
        point = self.point(turn, across)
        moved = np.stack([-point[1], point[0], self.screw + 0 * sine])
        normal = np.cross(along, moved, axis=0)
        return normal / np.linalg.norm(normal, axis=0)

    def axial_profile(self, radius: Array) -> Array:
        """Height along the axis [m] of the section with a plane through the axis, over the radius [m]."""
        across = np.sqrt(np.asarray(radius) ** 2 - self.offset**2)
        return self.screw * np.arctan2(across, self.offset) - across * self.slope


def straight_axial(lead: float, lead_angle: float, pressure_angle: float) -> RuledHelicoid:
    """The flank of a ZA worm, straight in the axial plane, with its normal pressure angle."""
    return RuledHelicoid(0.0, tan(pressure_angle) / cos(lead_angle), lead / (2 * pi))


def straight_normal(
    lead: float, lead_angle: float, pressure_angle: float, apex: float
) -> RuledHelicoid:
    """The flank of a ZN worm, straight in the plane normal to the thread.

    Parameters
    ----------
    lead, lead_angle, pressure_angle : float
        Lead [m], lead angle on the reference cylinder and normal pressure angle.
    apex : float
        Radius at which the line meets the middle of the thread or of its space [m].
    """
    across = sqrt(cos(pressure_angle) ** 2 + (sin(pressure_angle) * sin(lead_angle)) ** 2)
    return RuledHelicoid(
        offset=-apex * sin(pressure_angle) * sin(lead_angle) / across,
        slope=sin(pressure_angle) * cos(lead_angle) / across,
        screw=lead / (2 * pi),
    )


def involute(lead: float, lead_angle: float, pressure_angle: float) -> RuledHelicoid:
    """The flank of a ZI worm: the line is tangent to the base helix."""
    base = base_radius(lead, base_lead_angle(lead_angle, pressure_angle))
    screw = lead / (2 * pi)
    return RuledHelicoid(base, screw / base, screw)


def apart(
    one: RuledHelicoid, other: RuledHelicoid, reference: float, radii: tuple[float, float]
) -> float:
    """Largest distance along the axis [m] of two flanks between two radii, laid together at a third [m]."""
    radius = np.append(np.linspace(*radii, 101), reference)
    height = one.axial_profile(radius) - other.axial_profile(radius)
    return float(np.abs(height - height[-1]).max())
