"""Cylindrical worm gears by the methods of DIN 3996:2012 and ISO/TS 14521, as far as they could be checked.

Neither text could be read. Formulas here are from memory or a public transcription (the worksheet on worm
gears of MITCalc), checked by dimension, by the limits they must have, and by the worked values of a
reference gear; each docstring names the check. Base curves, materials, wear, roots, deflection and losses
have files of their own. Lengths are in metres, speeds in rad/s, torques in N m, pressures in Pa,
temperatures in kelvin; the standards' own units are used inside only.
"""

from dataclasses import dataclass
from math import atan, pi, sqrt, tan

from pyworm.formulas.ranges import one_of, positive, within
from pyworm.formulas.unit_factors import RPM, ZERO_CELSIUS
from pyworm.formulas.worm_curves import OIL_KINDS, Lubrication, OilKind, base_friction
from pyworm.formulas.worm_gear import REFERENCE_FILM, WormGear
from pyworm.formulas.worm_wheel_material import Family

SOURCE = "methods of DIN 3996:2012, ISO/TS 14521, from memory and a public transcription"

PRESSURE_VISCOSITY = {"mineral": 1.7e-8, "PAO": 1.4e-8, "PAG": 1.3e-8}
"""c_alpha [1/Pa] of each kind of oil; the values of mineral oil and PAG also stand in the sources."""

_OIL_LIFE = {"mineral": 0.89, "PAO": 0.94, "PAG": 1.0}

STATIC_FRICTION = {"tin bronze": 0.13, "aluminium bronze": 0.15, "cast iron": 0.18}
"""mu_0 at rest of steel on wheels [-]. From a public transcription of DIN 3996 (the worksheet on worm gears
of MITCalc), not checked against its text."""

OIL_LIMITS = {"mineral": 363.15, "PAO": 373.15, "PAG": 383.15}
"""Usual limits of the sump's temperature [K] (the same transcription). Doubtful: other notes give PAO and
PAG the same limit; the oil's maker decides."""

_REFERENCE_RATIO = 20.5


def minimum_film(
    film_parameter: float,
    pressure_viscosity: float,
    viscosity: float,
    worm_speed: float,
    centre_distance: float,
    reduced_modulus: float,
    torque: float,
) -> float:
    """Mean minimum film between the teeth h_min,m [m]; arguments in SI units.

        21 h* c_alpha^0.6 eta^0.7 n1^0.7 a^1.39 E_red^0.03 / T2^0.13   [um]

    with h* (`WormGear.film_parameter`), c_alpha in m2/N (`PRESSURE_VISCOSITY`), eta at the wheel's bulk
    temperature in Pa s, n1 in rpm, a in mm, E_red in N/mm2, 2/E_red = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, T2 in
    N m. Checked: in SI the units leave a length and the constant becomes 0.996, so that 21 is nothing but the
    conversion of units; a form in circulation with the exponents 1, 0.43, -0.057 and +0.13 of c_alpha, n1, a
    and T2 is no length. Range: bronze and cast iron wheels, 25 mm to 2 m.
    """
    within("h*", film_parameter, 0.005, 0.5, "")
    within("pressure-viscosity coefficient", pressure_viscosity, 1e-9, 1e-7, "1/Pa")
    within("dynamic viscosity", viscosity, 1e-4, 10, "Pa s")
    within("worm speed", worm_speed * RPM, 0.1, 1e5, "rpm")
    within("centre distance", centre_distance, 0.025, 2, "m")
    try:
        within("reduced modulus", reduced_modulus, 1e10, 1e12, "Pa")
    except ValueError as error:
        raise ValueError(
            f"{str(error).rstrip('.')}; films of softer wheels than bronze and iron are not covered by the "
            "worm-gear standard (ISO/TS 14521, DIN 3996)"
        ) from None
    positive("wheel torque", torque, "N m")
    micrometres = (
        21
        * film_parameter
        * pressure_viscosity**0.6
        * viscosity**0.7
        * (worm_speed * RPM) ** 0.7
        * (centre_distance * 1e3) ** 1.39
        * (reduced_modulus * 1e-6) ** 0.03
        / torque**0.13
    )
    return float(micrometres * 1e-6)


def mean_pressure(
    pressure_parameter: float, torque: float, reduced_modulus: float, centre_distance: float
) -> float:
    """Mean contact stress sigma_Hm [Pa], (4/pi) sqrt(p_m* T2 E_red/a^3), of `WormGear.pressure_parameter`.

    Checked by dimension: a pressure, growing with the square root of the load and of the modulus as of any
    line contact, so that it is that of soft wheels, too, as long as their teeth do not bend.
    """
    within("p_m*", pressure_parameter, 0.1, 10, "")
    positive("wheel torque", torque, "N m")
    within("reduced modulus", reduced_modulus, 3e8, 1e12, "Pa")
    within("centre distance", centre_distance, 0.025, 2, "m")
    return 4 / pi * sqrt(pressure_parameter * torque * reduced_modulus / centre_distance**3)


def tooth_friction(
    oil: OilKind,
    sliding_speed: float,
    centre_distance: float,
    film_parameter: float,
    roughness: float,
    material_factor: float = 1.0,
    lubrication: Lubrication = "injection",
    family: Family = "tin bronze",
) -> float:
    """Mean coefficient of tooth friction mu_zm [-] = mu_0T Y_S Y_G Y_W Y_R; arguments in SI units.

        mu_0T   `pyworm.formulas.worm_curves.base_friction`, at the sliding speed vg
        Y_S     sqrt(100 mm/a), a at least 65 and at most 250 mm
        Y_G     sqrt(0.07/h*), at most 2
        Y_W     of the wheel's material, 1 for the bronze of the tests
        Y_R     (Ra/0.5 um)^(1/4), Ra of the worm's flanks

    Checked: falls with sliding speed; PAG below PAO below mineral oil from 0.25 m/s on; 1 is each factor of
    the reference gear. The bounds of Y_S and Y_G are those of the transcription. Range: vg from 0.05 to 25
    m/s.
    """
    base = base_friction(oil, sliding_speed, lubrication, family)
    within("h*", film_parameter, 0.005, 0.5, "")
    shape = min(sqrt(REFERENCE_FILM / film_parameter), 2.0)
    size = _size_factor(centre_distance)
    return base * size * shape * _rubbing(roughness, material_factor)


def _size_factor(centre_distance: float) -> float:
    """Y_S [-]."""
    within("centre distance", centre_distance, 0.025, 2, "m")
    return sqrt(0.1 / min(max(centre_distance, 0.065), 0.25))


def _rubbing(roughness: float, material_factor: float) -> float:
    """Y_W Y_R [-]."""
    within("roughness Ra", roughness, 1e-8, 1e-5, "m")
    within("Y_W", material_factor, 0.5, 2, "")
    return float(material_factor * (roughness / 0.5e-6) ** 0.25)


def static_friction(
    centre_distance: float,
    roughness: float,
    material_factor: float = 1.0,
    family: Family = "tin bronze",
) -> float:
    """Coefficient of tooth friction at rest [-], mu_0 sqrt(Y_S) Y_W Y_R with `STATIC_FRICTION` as mu_0.

    The factors are those of `tooth_friction`. Source as of `STATIC_FRICTION`. Checked: above the friction of
    running teeth at every speed.
    """
    size = sqrt(_size_factor(centre_distance))
    return STATIC_FRICTION[family] * size * _rubbing(roughness, material_factor)


def forward_efficiency(tan_lead: float, friction: float) -> float:
    """Efficiency of the teeth with the worm driving [-], tan gamma/tan(gamma + atan mu)."""
    positive("tangent of the lead angle", tan_lead, "")
    within("tooth friction", friction, 0, 0.5, "")
    return tan_lead / tan(atan(tan_lead) + atan(friction))


def backward_efficiency(tan_lead: float, friction: float) -> float:
    """Efficiency of the teeth with the wheel driving [-], tan(gamma - atan mu)/tan gamma.

    At zero or less the wheel cannot drive the worm.
    """
    positive("tangent of the lead angle", tan_lead, "")
    within("tooth friction", friction, 0, 0.5, "")
    return tan(atan(tan_lead) - atan(friction)) / tan_lead


def self_locking_margin(tan_lead: float, friction: float) -> float:
    """mu/tan gamma [-]: above 1 the teeth hold the load at this friction, below 1 the wheel drives the worm.

    Friction is that of running teeth (`tooth_friction`) or that at rest (`static_friction`); shaking and the
    rise of the film can release teeth that lock at rest.
    """
    positive("tangent of the lead angle", tan_lead, "")
    within("tooth friction", friction, 0, 0.5, "")
    return friction / tan_lead


def pitting_safety(
    mean_pressure: float,
    strength: float,
    life: float,
    sliding_speed: float,
    centre_distance: float,
    oil: OilKind,
    ratio: float = _REFERENCE_RATIO,
) -> float:
    """Safety against pitting of the wheel S_H [-], sigma_HlimT Z_h Z_v Z_S Z_u Z_oil / sigma_Hm.

    sigma_Hm is `mean_pressure` [Pa]; Z_h = (25000 h/Lh)^(1/6) of the wanted life [h], at most 1.6; Z_v =
    sqrt(5/(4 + vg)); Z_S = sqrt(3000/(2900 + a)), a in mm; Z_u = (u/20.5)^(1/6) below 20.5, else 1; Z_oil of
    PAG 1, PAO 0.94, mineral 0.89; sigma_HlimT [Pa] as in `PITTING_STRENGTH`. Checked: 1 is each factor of the
    reference test (25000 h, 1 m/s, 100 mm, PAG, u = 20.5).
    """
    positive("mean contact stress", mean_pressure, "Pa")
    within("pitting strength", strength, 5e7, 2e9, "Pa")
    within("life", life, 1, 1e6, "h")
    within("sliding speed", sliding_speed, 0, 25, "m/s")
    within("centre distance", centre_distance, 0.025, 2, "m")
    positive("u", ratio, "")
    one_of("oil", oil, OIL_KINDS)
    lasting = min((25000 / life) ** (1 / 6), 1.6)
    speed = sqrt(5 / (4 + sliding_speed))
    size = sqrt(3000 / (2900 + centre_distance * 1e3))
    turns = min(ratio / _REFERENCE_RATIO, 1.0) ** (1 / 6)
    return float(strength * lasting * speed * size * turns * _OIL_LIFE[oil] / mean_pressure)


def bulk_temperature(
    sump_temperature: float,
    tooth_loss: float,
    worm_speed: float,
    cooled_area: float,
    immersion_factor: float,
) -> float:
    """Bulk temperature of a wheel in a bath theta_M [K], sump temperature + P_Vz/(alpha_L A_R).

    P_Vz is lost between the teeth [W]; alpha_L = c_k (1940 + 15 n1) W/(m2 K), n1 in rpm and at least 150, c_k
    1 where the wheel dips into the oil, less where it does not; A_R is the wheel's face width times reference
    diameter. Checked by dimension and by its limit without loss.
    """
    within("sump temperature", sump_temperature, 230, 470, "K")
    within("tooth loss", tooth_loss, 0, 1e7, "W")
    within("worm speed", worm_speed * RPM, 0.1, 1e5, "rpm")
    within("cooled area", cooled_area, 1e-5, 1, "m2")
    within("c_k", immersion_factor, 0.1, 2, "")
    transfer = rim_heat_transfer(worm_speed, immersion_factor)
    return sump_temperature + tooth_loss / (transfer * cooled_area)


def rim_heat_transfer(worm_speed: float, immersion_factor: float) -> float:
    """alpha_L of `bulk_temperature` [W/(m2 K)]."""
    return immersion_factor * (1940 + 15 * max(worm_speed * RPM, 150))


def injected_bulk_temperature(
    oil_temperature: float,
    tooth_loss: float,
    worm_speed: float,
    gear: WormGear,
    kinematic_viscosity: float,
) -> float:
    """Bulk temperature of a wheel with injected oil theta_M [K], theta_E + 16 K_n K_nu K_S P_Vz in kW.

    K_n = (72.5 u/n1)^0.35 with n1 at least 150 rpm, K_nu = (nu/55 mm2/s)^0.35, K_S = (160 mm/a)^0.6;
    arguments in SI units. From a public transcription of DIN 3996 (the worksheet on worm gears of MITCalc).
    Checked by its limit without loss.
    """
    within("oil temperature", oil_temperature, 230, 470, "K")
    within("tooth loss", tooth_loss, 0, 1e7, "W")
    within("viscosity of the injected oil", kinematic_viscosity, 1e-6, 1e-2, "m2/s")
    speed = (72.5 * gear.ratio / max(worm_speed * RPM, 150)) ** 0.35
    thick = (kinematic_viscosity / 55e-6) ** 0.35
    size = (0.16 / gear.centre_distance) ** 0.6
    return float(oil_temperature + 16 * speed * thick * size * tooth_loss * 1e-3)


def temperature_safety(sump_temperature: float, limit: float) -> float:
    """S_T [-], limiting over actual sump temperature, both in degC inside; arguments in kelvin.

    The limit is a property of the oil, given by its maker; `OIL_LIMITS` are usual.
    """
    within("sump temperature", sump_temperature, 273.16, 470, "K")
    within("limit of the sump temperature", limit, 273.16, 470, "K")
    return (limit - ZERO_CELSIUS) / (sump_temperature - ZERO_CELSIUS)


@dataclass(frozen=True)
class TeethLoss:
    """Friction, efficiency and loss of worm gear teeth."""

    friction: float
    """Mean coefficient of friction mu_zm [-]."""
    forward_efficiency: float
    """Efficiency of the teeth, worm driving [-]."""
    backward_efficiency: float
    """Efficiency of the teeth, wheel driving [-]; zero or less where the wheel cannot drive."""
    output: float
    """Power at the wheel [W]."""

    @property
    def power(self) -> float:
        """Lost between the teeth, worm driving [W]."""
        return self.output * (1 / self.forward_efficiency - 1)

    def driven_by(self, driver: str) -> float:
        """Lost between the teeth with worm or wheel driving [W].

        Where the wheel cannot drive its power is lost, and what the worm has to add.
        """
        return self.power if driver == "worm" else self.output * (1 - self.backward_efficiency)


def teeth_loss(
    gear: WormGear,
    oil: OilKind,
    worm_speed: float,
    torque: float,
    roughness: float,
    material_factor: float = 1.0,
    lubrication: Lubrication = "injection",
    family: Family = "tin bronze",
    sliding_speed: float | None = None,
) -> TeethLoss:
    """Loss between the teeth by `tooth_friction`; arguments as of `WormConditions`.

    Friction is that at `sliding_speed` [m/s] in place of the gear's own, if that is given.
    """
    friction = tooth_friction(
        oil,
        gear.sliding_speed(worm_speed) if sliding_speed is None else sliding_speed,
        gear.centre_distance,
        gear.film_parameter,
        roughness,
        material_factor,
        lubrication,
        family,
    )
    return TeethLoss(
        friction,
        forward_efficiency(gear.tan_lead, friction),
        backward_efficiency(gear.tan_lead, friction),
        torque * worm_speed / gear.ratio,
    )
