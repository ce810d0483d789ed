"""Geometry of a cylindrical worm gear as the worm-gear standard describes it."""

from dataclasses import dataclass
from math import atan, cos, degrees, pi, sqrt

from pyworm.formulas.ranges import positive, within
from pyworm.io import units
from pyworm.io.plain_values import Count, Number, PositiveNumber

REFERENCE_FILM = 0.07
"""h* of the reference gear, nominal."""


ALLOWED_WEAR = 0.3
"""Depth worn off the wheel's flanks over m_x cos gamma that the standard allows (the same transcription)."""


@dataclass(frozen=True)
class WormGearSizes:
    """Sizes of a worm gear."""

    centre_distance: units.Length
    """Centre distance a [m]; 25 mm to 2 m."""
    starts: Count
    """Starts of the worm, z1."""
    teeth: Count
    """Teeth of the wheel, z2."""
    module: units.Length
    """Axial module m_x [m]."""
    diameter_factor: PositiveNumber
    """q, reference diameter of the worm over the module [-]; above 0.5."""
    face_width: units.FaceWidth
    """b_2H of the wheel [m]."""
    profile_shift: Number = 0.0
    """x2 of the wheel [-]."""


@dataclass(frozen=True)
class WormGear(WormGearSizes):
    """Geometry of a worm gear as the standards see it.

    ValueError for lengths in other units, or parts that do not make up the centre distance within 2 %.
    """

    pressure_angle: float = pi / 9
    """alpha_0 of the tool, normal to the thread (of ZA axial) [rad]."""
    concave: bool = False
    """Whether the worm's flanks are hollow (ZC, ZC2)."""

    def __post_init__(self) -> None:
        """Refuse a geometry that is no worm gear."""
        within("pressure angle", self.pressure_angle, 0.08, 0.8, "rad")
        within("centre distance", self.centre_distance, 0.025, 2, "m")
        within("number of worm starts", self.starts, 1, 12, "")
        within("number of wheel teeth", self.teeth, 15, 300, "")
        within("module", self.module, 5e-4, 0.1, "m")
        within("diameter factor", self.diameter_factor, 4, 40, "")
        within("face width", self.face_width, 2e-3, 1, "m")
        within("profile shift", self.profile_shift, -2, 2, "")
        distance = self.module / 2 * (self.diameter_factor + self.teeth + 2 * self.profile_shift)
        if abs(distance / self.centre_distance - 1) > 0.02:
            raise ValueError(
                f"centre distance = {self.centre_distance:g} m: module, diameter factor, teeth and profile "
                f"shift make {distance:g} m"
            )

    @property
    def ratio(self) -> float:
        """u = z2/z1 [-]."""
        return self.teeth / self.starts

    @property
    def tan_lead(self) -> float:
        """Tangent of the lead angle gamma at the worm's reference cylinder, z1/q [-]."""
        return self.starts / self.diameter_factor

    @property
    def lead_angle(self) -> float:
        """Lead angle gamma at the worm's reference cylinder [rad]."""
        return atan(self.tan_lead)

    @property
    def tooth_thickness(self) -> float:
        """Nominal normal thickness of the wheel's teeth, pi m_x cos(gamma)/2 [m]."""
        return pi / 2 * self.module * cos(self.lead_angle)

    @property
    def wear_limit(self) -> float:
        """Largest depth that may wear off the wheel's flanks, 0.3 m_x cos(gamma) [m]."""
        return ALLOWED_WEAR * self.module * cos(self.lead_angle)

    @property
    def worm_diameter(self) -> float:
        """Reference diameter of the worm d_m1 [m]."""
        return self.diameter_factor * self.module

    @property
    def worm_root_diameter(self) -> float:
        """Root diameter of a worm of usual depth, 2.5 modules below the reference diameter [m]."""
        return (self.diameter_factor - 2.5) * self.module

    @property
    def mean_wheel_diameter(self) -> float:
        """Mean diameter of the wheel d_m2 [m]."""
        return (self.teeth + 2 * self.profile_shift) * self.module

    @property
    def wheel_tip_diameter(self) -> float:
        """Tip diameter of a wheel of usual depth [m]."""
        return self.mean_wheel_diameter + 2 * self.module

    def tangential_force(self, torque: float) -> float:
        """Tangential force F_tm2 [N] of a wheel torque [N m]."""
        return 2 * torque / self.mean_wheel_diameter

    @property
    def film_parameter(self) -> float:
        """Film parameter h* [-]: the influence of the gear's geometry on the film, form of 2012.

            -0.393 + 2.9157e-6 z2^-0.0847 alpha_0^0.0595 (7.947e-7 x2 + 5.927e-5) [(1 - 0.038 q) q + 65.576]
            [(108.8547 z1/q - 1) z1/q - 3294.921] [(0.003291 B + 1) B - 13064.58]

        with B = sqrt(6 m_x d_m1 - 9 m_x^2 + m_x) in mm and alpha_0 in degrees; of hollow flanks -0.511 and
        3.7904e-6. From a public transcription of DIN 3996 (the worksheet on worm gears of MITCalc).
        Checked: 0.0693 for the reference gear, nominally 0.07. Doubtful: B is a length only if m_x stands
        outside the root, where it is the usual face width; that would change h* by 0.2 %. The face width
        itself is not in it. It falls below zero for very thick worms; range: q up to 25.
        """
        within("diameter factor", self.diameter_factor, 4, 25, "")
        q, lead = self.diameter_factor, self.tan_lead
        module = self.module * 1e3
        width = sqrt(6 * module * q * module - 9 * module**2 + module)
        shape = self.teeth**-0.0847 * degrees(self.pressure_angle) ** 0.0595
        shape *= (7.947e-7 * self.profile_shift + 5.927e-5) * ((1 - 0.038 * q) * q + 65.576)
        shape *= (108.8547 * lead - 1) * lead - 3294.921
        shape *= (0.003291 * width + 1) * width - 13064.58
        return float(-0.511 + 3.7904e-6 * shape if self.concave else -0.393 + 2.9157e-6 * shape)

    @property
    def pressure_parameter(self) -> float:
        """p_m* [-] of the mean contact pressure, form of 2012.

            0.1794 + 0.2389 a/d_m1 + 0.0761 x2 |x2|^3.18 + 0.0536 q - 0.00369 z2 - 0.01136 alpha_0
            + 44.9814 (x2 + 0.005657)/z2 (z1/q)^2.6872

        with alpha_0 in degrees; of hollow flanks about 0.78 of it. Source as of `film_parameter`. Checked:
        0.947 for the reference gear, nominally 0.962.
        """
        q, x = self.diameter_factor, self.profile_shift
        slender, angle = self.centre_distance / self.worm_diameter, degrees(self.pressure_angle)
        bent, lead = x * abs(x) ** 3.18, (x + 0.005657) / self.teeth * self.tan_lead**2.6872
        if self.concave:
            straight = 0.1401 + 0.1866 * slender + 0.0595 * bent + 0.0419 * q
            return float(straight - 0.00288 * self.teeth - 0.0089 * angle + 35.1417 * lead)
        straight = 0.1794 + 0.2389 * slender + 0.0761 * bent + 0.0536 * q
        return float(straight - 0.00369 * self.teeth - 0.01136 * angle + 44.9814 * lead)

    @property
    def sliding_parameter(self) -> float:
        """s* of the mean sliding path [-], 0.78 + 0.21 u + 5.6/tan gamma.

        Of hollow flanks 0.94 + 0.25 u + 6.7/tan gamma. Checked: 30.3 for the reference gear, nominally 30.8.
        Source as of `film_parameter`.
        """
        if self.concave:
            return 0.94 + 0.25 * self.ratio + 6.7 / self.tan_lead
        return 0.78 + 0.21 * self.ratio + 5.6 / self.tan_lead

    def sliding_speed(self, worm_speed: float) -> float:
        """Sliding speed at the worm's reference cylinder v_g [m/s], d_m1 omega/(2 cos gamma)."""
        positive("worm speed", worm_speed, "rad/s")
        return self.worm_diameter / 2 * worm_speed * sqrt(1 + self.tan_lead**2)


REFERENCE_GEAR = WormGear(0.1, 2, 41, 4e-3, 9.0, 30e-3)
"""The gear that the standards' test results belong to."""
