"""External involute gears on parallel axes, spur and helical, in their transverse plane.

Everything along the line of action is measured from where it touches the base circle of the pinion: that
distance is the pinion's radius of curvature, and grows from its root to its tip. Lengths in m, angles in rad;
coefficients are in normal modules. Symbols and formulas are those of ISO 21771 (2007).
"""

from dataclasses import dataclass
from functools import cached_property
from math import acos, asin, atan, cos, pi, sin, sqrt, tan

import scipy

from pyworm.io import units
from pyworm.io.plain_values import Count, Number, NumberOrZero, PositiveNumber


def involute(angle: float) -> float:
    """inv(angle) = tan(angle) - angle, the polar angle of an involute [rad]."""
    return tan(angle) - angle


def inverse_involute(value: float) -> float:
    """Pressure angle [rad] whose involute function is a value above zero."""
    return scipy.optimize.brentq(
        lambda angle: involute(angle) - value, 0.0, pi / 2 - 1e-6, xtol=1e-15
    )


@dataclass(frozen=True)
class ToothSystem:
    """Data common to both gears: the basic rack's size and angles."""

    module: units.Length
    """Normal module m_n [m]."""
    pressure_angle: units.Angle
    """Normal pressure angle alpha_n [rad]."""
    helix_angle: units.AngleOrZero = 0.0
    """Helix angle beta at the reference cylinder [rad]; 0 for spur gears."""

    @property
    def transverse_module(self) -> float:
        """m_t = m_n / cos(beta) [m]."""
        return self.module / cos(self.helix_angle)

    @property
    def transverse_pressure_angle(self) -> float:
        """alpha_t, tan(alpha_t) = tan(alpha_n) / cos(beta) [rad]."""
        return atan(tan(self.pressure_angle) / cos(self.helix_angle))

    @property
    def base_helix_angle(self) -> float:
        """beta_b, sin(beta_b) = sin(beta) cos(alpha_n) [rad]."""
        return asin(sin(self.helix_angle) * cos(self.pressure_angle))

    @property
    def base_pitch(self) -> float:
        """Transverse base pitch p_bt [m]: from tooth to tooth along the line of action."""
        return pi * self.transverse_module * cos(self.transverse_pressure_angle)

    @property
    def axial_pitch(self) -> float:
        """p_x = pi m_n / sin(beta) [m]; infinite for spur gears."""
        tilt = sin(self.helix_angle)
        return pi * self.module / tilt if tilt else float("inf")


@dataclass(frozen=True)
class Gear:
    """One gear as its basic rack makes it, coefficients in normal modules."""

    teeth: Count
    """Number of teeth z."""
    profile_shift: Number = 0.0
    """x, positive away from the axis."""
    addendum: PositiveNumber = 1.0
    """Addendum h_aP* of the basic rack."""
    dedendum: PositiveNumber = 1.25
    """Its dedendum h_fP*."""
    fillet: NumberOrZero = 0.38
    """Radius rho_fP* of its root fillet."""


@dataclass(frozen=True)
class Cylinders:
    """Radii of one gear of a pair [m]."""

    reference: float
    """Reference cylinder, r."""
    base: float
    """Base cylinder, r_b."""
    pitch: float
    """Pitch cylinder, r_w (where it rolls on the other one)."""
    tip: float
    """Tip cylinder, r_a."""
    root: float
    """Root cylinder, r_f."""
    form_length: float
    """Radius of curvature where the involute begins above the fillet [m]; negative if it is undercut."""
    tip_length: float
    """Radius of curvature at the tip [m]."""
    tip_thickness: float
    """Transverse thickness at the tip [m]; zero or less if the flanks meet before it."""
    pitch_thickness: float
    """Transverse thickness at the pitch circle [m]."""


@dataclass(frozen=True)
class InvolutePair:
    """Two external gears at their real centre distance."""

    system: ToothSystem
    """Module and angles."""
    pinion: Gear
    """The pinion."""
    gear: Gear
    """The gear."""
    centre_distance: float
    """Distance a of the axes [m]."""
    face_width: float
    """Common face width b [m]."""

    @property
    def ratio(self) -> float:
        """u = z2 / z1, speed of the pinion over that of the gear."""
        return self.gear.teeth / self.pinion.teeth

    @property
    def reference_centre_distance(self) -> float:
        """Distance a_d at which the reference circles touch [m]."""
        return (self.pinion.teeth + self.gear.teeth) * self.system.transverse_module / 2

    @property
    def tight_centre_distance(self) -> float:
        """Centre distance without backlash [m], inv(a_w) = inv(a_t) + 2 tan(a_n) (x1 + x2) / (z1 + z2)."""
        system = self.system
        angle = system.transverse_pressure_angle
        shifts = self.pinion.profile_shift + self.gear.profile_shift
        teeth = self.pinion.teeth + self.gear.teeth
        tight = inverse_involute(involute(angle) + 2 * tan(system.pressure_angle) * shifts / teeth)
        return self.reference_centre_distance * cos(angle) / cos(tight)

    @property
    def pressure_angle(self) -> float:
        """Operating transverse pressure angle alpha_wt [rad], cos = a_d cos(alpha_t) / a."""
        shrunk = self.reference_centre_distance / self.centre_distance
        return acos(shrunk * cos(self.system.transverse_pressure_angle))

    @property
    def tip_shortening(self) -> float:
        """k [-], 0 or more: cut of both addenda that gives tips the clearance of the rack from the roots."""
        pulled = (self.centre_distance - self.reference_centre_distance) / self.system.module
        return max(self.pinion.profile_shift + self.gear.profile_shift - pulled, 0.0)

    @property
    def backlash(self) -> float:
        """Transverse backlash on the pitch circles [m]."""
        pitch = 2 * pi * self.cylinders[0].pitch / self.pinion.teeth
        return pitch - sum(cylinder.pitch_thickness for cylinder in self.cylinders)

    @cached_property
    def cylinders(self) -> tuple[Cylinders, Cylinders]:
        """Radii of pinion and gear."""
        return _cylinders(self, self.pinion), _cylinders(self, self.gear)

    @cached_property
    def base_tangent(self) -> float:
        """Length of the line of action between the base circles, a sin(alpha_wt) [m]."""
        return self.centre_distance * sin(self.pressure_angle)

    @property
    def start(self) -> float:
        """Pinion's radius of curvature where its active profile starts (SAP), set by the gear's tip [m]."""
        return self.base_tangent - self.cylinders[1].tip_length

    @property
    def end(self) -> float:
        """Pinion's radius of curvature at the end of its active profile (EAP), its tip [m]."""
        return self.cylinders[0].tip_length

    @property
    def lowest_single(self) -> float:
        """Pinion's radius of curvature at its lowest point of single tooth contact (LPSTC) [m]."""
        return self.end - self.system.base_pitch

    @property
    def highest_single(self) -> float:
        """Pinion's radius of curvature at its highest point of single tooth contact (HPSTC) [m]."""
        return self.start + self.system.base_pitch

    @property
    def pitch_point(self) -> float:
        """Pinion's radius of curvature at the pitch point [m]."""
        return self.base_tangent / (1 + self.ratio)

    @property
    def path_length(self) -> float:
        """Length g_alpha of the path of contact [m]."""
        return self.end - self.start

    @property
    def transverse_contact_ratio(self) -> float:
        """epsilon_alpha = g_alpha / p_bt."""
        return self.path_length / self.system.base_pitch

    @property
    def overlap_ratio(self) -> float:
        """epsilon_beta = b / p_x."""
        return self.face_width / self.system.axial_pitch

    @property
    def shortest_line(self) -> float:
        """Least total length of the contact lines over the mesh cycle [m].

        With n_r and n_a the fractions of the transverse contact ratio and of the overlap ratio,
        (eps_alpha b - n_a n_r p_x) / cos(beta_b) for n_a + n_r <= 1, else
        (eps_alpha b - (1 - n_a)(1 - n_r) p_x) / cos(beta_b) (AGMA 908-B89, section 6); of spur gears
        the face width times the pairs that are always in contact.
        """
        transverse, overlap = self.transverse_contact_ratio, self.overlap_ratio
        tilt = cos(self.system.base_helix_angle)
        if overlap == 0:
            return int(transverse) * self.face_width
        part_r, part_a = transverse % 1, overlap % 1
        if part_a + part_r <= 1:
            missing = part_a * part_r
        else:
            missing = (1 - part_a) * (1 - part_r)
        return (transverse * self.face_width - missing * self.system.axial_pitch) / tilt


def _cylinders(pair: InvolutePair, gear: Gear) -> Cylinders:
    system = pair.system
    module, angle = system.module, system.transverse_pressure_angle
    reference = gear.teeth * system.transverse_module / 2
    base = reference * cos(angle)
    tip = reference + module * (gear.addendum + gear.profile_shift - pair.tip_shortening)
    # The straight part of the rack's flank ends where its fillet begins (ISO 21771, section 5.5).
    straight = gear.dedendum - gear.fillet * (1 - sin(system.pressure_angle))
    half_tooth = (pi / 2 + 2 * gear.profile_shift * tan(system.pressure_angle)) / gear.teeth

    def thickness(radius: float) -> float:
        return 2 * radius * (half_tooth + involute(angle) - involute(acos(base / radius)))

    pitch = base / cos(pair.pressure_angle)
    return Cylinders(
        reference=reference,
        base=base,
        pitch=pitch,
        tip=tip,
        root=reference - module * (gear.dedendum - gear.profile_shift),
        form_length=reference * sin(angle) - module * (straight - gear.profile_shift) / sin(angle),
        tip_length=sqrt(max(tip**2 - base**2, 0.0)),
        tip_thickness=thickness(max(tip, base)),
        pitch_thickness=thickness(pitch),
    )
