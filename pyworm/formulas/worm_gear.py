"""Geometry of a cylindrical worm gear as the worm-gear standard describes it."""

from dataclasses import dataclass
from math import atan, cos, pi, sqrt

from pyworm.formulas.ranges import positive, within

REFERENCE_FILM = 0.07
"""h* of the reference gear, nominal."""


ALLOWED_WEAR = 0.3
"""Depth worn off the wheel's flanks over m_x cos gamma that the standard allows (the same transcription)."""


@dataclass(frozen=True)
class WormGear:
    """Geometry of a worm gear as the standards see it.

    Attributes
    ----------
    centre_distance : float
        a [m]; 25 mm to 2 m.
    starts, teeth : int
        z1 of the worm, z2 of the wheel.
    module : float
        Axial module m_x [m].
    diameter_factor : float
        q, reference diameter of the worm over the module [-]; above 0.5.
    face_width : float
        b_2H of the wheel [m].
    profile_shift : float
        x2 of the wheel [-].

    Raises
    ------
    ValueError
        Lengths in other units, or parts that do not make up the centre distance within 2 %.
    """

    centre_distance: float
    starts: int
    teeth: int
    module: float
    diameter_factor: float
    face_width: float
    profile_shift: float = 0.0

    def __post_init__(self) -> None:
        """Refuse a geometry that is no worm gear."""
        within("centre distance", self.centre_distance, 0.025, 2, "m")
        within("number of worm starts", self.starts, 1, 12, "")
        within("number of wheel teeth", self.teeth, 15, 300, "")
        within("module", self.module, 5e-4, 0.1, "m")
        within("diameter factor", self.diameter_factor, 4, 40, "")
        within("face width", self.face_width, 2e-3, 1, "m")
        within("profile shift", self.profile_shift, -2, 2, "")
        made = self.module / 2 * (self.diameter_factor + self.teeth + 2 * self.profile_shift)
        if abs(made / self.centre_distance - 1) > 0.02:
            raise ValueError(
                f"centre distance = {self.centre_distance:g} m: module, diameter factor, teeth and profile "
                f"shift make {made:g} m"
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
    def film_parameter(self) -> float:
        """Film parameter h* [-]: the influence of the gear's geometry on the film.

        0.018 + q/[7.86 (q + z2)] + 1/z2 + x2/110 - u/36300 + b2H/(370.4 mx) - sqrt(2 q - 1)/213.9.
        Checked: 0.0657 for the reference gear, nominally 0.07.
        """
        q, z2 = self.diameter_factor, self.teeth
        return (
            0.018
            + q / (7.86 * (q + z2))
            + 1 / z2
            + self.profile_shift / 110
            - self.ratio / 36300
            + self.face_width / (370.4 * self.module)
            - sqrt(2 * q - 1) / 213.9
        )

    @property
    def pressure_parameter(self) -> float:
        """p_m* [-] of the mean contact pressure.

        1.03 {0.4 + x2/u + 0.01 z2 - 0.083 b2H/mx + sqrt(2 q - 1)/6.9 + [q + 50 (u + 1)/u]/(15.9 + 37.5
        q)}. Checked: 0.988 for the reference gear, nominally 0.962.
        """
        q, u = self.diameter_factor, self.ratio
        return 1.03 * (
            0.4
            + self.profile_shift / u
            + 0.01 * self.teeth
            - 0.083 * self.face_width / self.module
            + sqrt(2 * q - 1) / 6.9
            + (q + 50 * (u + 1) / u) / (15.9 + 37.5 * q)
        )

    @property
    def sliding_parameter(self) -> float:
        """s* [-] of the mean sliding path, 0.78 + 0.21 u + 5.6/tan gamma.

        Checked: 30.3 for the reference gear, nominally 30.8.
        """
        return 0.78 + 0.21 * self.ratio + 5.6 / self.tan_lead

    def sliding_speed(self, worm_speed: float) -> float:
        """Sliding speed at the worm's reference cylinder v_g [m/s], d_m1 omega/(2 cos gamma)."""
        positive("worm speed", worm_speed, "rad/s")
        diameter = self.diameter_factor * self.module
        return diameter / 2 * worm_speed * sqrt(1 + self.tan_lead**2)


REFERENCE_GEAR = WormGear(0.1, 2, 41, 4e-3, 9.0, 30e-3)
"""The gear that the standards' test results belong to."""
