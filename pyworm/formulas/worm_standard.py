"""Cylindrical worm gears by the methods of DIN 3996:2012 and ISO/TS 14521, as far as they could be checked.

Neither text could be read. Every formula here is from memory and is checked by dimension, by the limits
it must have, and by the worked values of a reference gear; each docstring names the check. Lengths are in
metres, speeds in rad/s, torques in N m, pressures in Pa, temperatures in kelvin; the standards' own
units are used inside only.
"""

from dataclasses import dataclass
from math import atan, pi, sqrt, tan
from typing import Literal

from pyworm.formulas.ranges import one_of, positive, within
from pyworm.formulas.unit_factors import RPM, ZERO_CELSIUS
from pyworm.formulas.worm_gear import REFERENCE_FILM, WormGear

OilKind = Literal["mineral", "PAO", "PAG"]

SOURCE = "methods of DIN 3996:2012, ISO/TS 14521, from memory"

OIL_KINDS: tuple[OilKind, ...] = ("mineral", "PAO", "PAG")
"""Oils that the standards have constants for."""

PRESSURE_VISCOSITY = {"mineral": 1.7e-8, "PAO": 1.4e-8, "PAG": 1.3e-8}
"""c_alpha [1/Pa] of each kind of oil; the values of mineral oil and PAG also stand in the sources."""

PITTING_STRENGTH = {"CuSn12Ni2": 520e6, "CuSn12": 425e6}
"""sigma_HlimT [Pa] of wheel bronzes (centrifugally cast), not checked."""

_OIL_LIFE = {"mineral": 0.89, "PAO": 0.94, "PAG": 1.0}

# a, b, c, d, largest of mu_0T = a + b/(vg + c)^d
_FRICTION = {
    "mineral": (0.028, 0.026, 0.17, 0.76, 0.1),
    "PAO": (0.026, 0.017, 0.17, 0.92, 0.096),
    "PAG": (0.02, 0.02, 0.2, 0.97, 0.094),
}

# factor and exponent of J_0T, and its largest value; wheel of CuSn12Ni2
WEAR_INTENSITIES = {"mineral": (2.4e-11, -3.1, 400e-9), "PAG": (1.27e-10, -2.24, 400e-9)}


STATIC_FRICTION = 0.13
"""mu_0 at rest of steel on tin bronze; aluminium bronze has 0.15 and cast iron 0.18. From a public
transcription of DIN 3996 (the worksheet on worm gears of MITCalc), not checked against its text."""


def minimum_film(
    film_parameter: float,
    pressure_viscosity: float,
    viscosity: float,
    worm_speed: float,
    centre_distance: float,
    reduced_modulus: float,
    torque: float,
) -> float:
    """Mean minimum film between the teeth h_min,m [m].

        21 h* c_alpha^0.6 eta^0.7 n1^0.7 a^1.39 E_red^0.03 / T2^0.13   [um]

    with c_alpha in m2/N, eta in Pa s, n1 in rpm, a in mm, E_red in N/mm2, T2 in N m. Checked: in SI the
    units leave a length and the constant becomes 0.996, so that 21 is nothing but the conversion of
    units; a form in circulation with the exponents 1, 0.43, -0.057 and +0.13 of c_alpha, n1, a and T2 is
    no length. Range: bronze and cast iron wheels, 25 mm to 2 m.

    Parameters
    ----------
    film_parameter : float
        h* [-], `WormGear.film_parameter`.
    pressure_viscosity : float
        c_alpha [1/Pa], `PRESSURE_VISCOSITY`.
    viscosity : float
        Dynamic viscosity at the wheel's bulk temperature [Pa s].
    worm_speed : float
        [rad/s].
    centre_distance : float
        [m].
    reduced_modulus : float
        E_red [Pa], 2/E_red = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
    torque : float
        T2 on the wheel [N m].
    """
    within("h*", film_parameter, 0.005, 0.5, "")
    within("pressure-viscosity coefficient", pressure_viscosity, 1e-9, 1e-7, "1/Pa")
    within("dynamic viscosity", viscosity, 1e-4, 10, "Pa s")
    within("worm speed", worm_speed * RPM, 0.1, 1e5, "rpm")
    within("centre distance", centre_distance, 0.025, 2, "m")
    within("reduced modulus", reduced_modulus, 1e10, 1e12, "Pa")
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
    return micrometres * 1e-6


def mean_pressure(
    pressure_parameter: float, torque: float, reduced_modulus: float, centre_distance: float
) -> float:
    """Mean contact stress sigma_Hm [Pa], (4/pi) sqrt(p_m* T2 E_red/a^3).

    Checked by dimension: a pressure, growing with the square root of the load as of any line contact.

    Parameters
    ----------
    pressure_parameter : float
        p_m* [-], `WormGear.pressure_parameter`.
    torque : float
        T2 [N m].
    reduced_modulus : float
        E_red [Pa].
    centre_distance : float
        [m].
    """
    within("p_m*", pressure_parameter, 0.1, 10, "")
    positive("wheel torque", torque, "N m")
    within("reduced modulus", reduced_modulus, 1e10, 1e12, "Pa")
    within("centre distance", centre_distance, 0.025, 2, "m")
    return 4 / pi * sqrt(pressure_parameter * torque * reduced_modulus / centre_distance**3)


def tooth_friction(
    oil: OilKind,
    sliding_speed: float,
    centre_distance: float,
    film_parameter: float,
    roughness: float,
    material_factor: float = 1.0,
) -> float:
    """Mean coefficient of tooth friction mu_zm [-] = mu_0T Y_S Y_G Y_W Y_R.

        mu_0T   0.028 + 0.026/(vg + 0.17)^0.76 (mineral), 0.026 + 0.017/(vg + 0.17)^0.92 (PAO),
                0.02 + 0.02/(vg + 0.2)^0.97 (PAG), at most 0.1, 0.096, 0.094
        Y_S     sqrt(100 mm/a)
        Y_G     sqrt(0.07/h*)
        Y_R     (Ra/0.5 um)^(1/4)

    Checked: falls with sliding speed to the first number; PAG below PAO below mineral oil from 0.25
    m/s on; 1 is each factor of the reference gear. Range: vg from 0.05 to 25 m/s.

    Parameters
    ----------
    oil : str
        "mineral", "PAO" or "PAG".
    sliding_speed : float
        vg [m/s].
    centre_distance : float
        [m].
    film_parameter : float
        h* [-].
    roughness : float
        Mean roughness Ra of the worm's flanks [m].
    material_factor : float
        Y_W of the wheel's material [-]; 1 for the bronze of the tests.
    """
    one_of("oil", oil, OIL_KINDS)
    within("sliding speed", sliding_speed, 0.05, 25, "m/s")
    within("centre distance", centre_distance, 0.025, 2, "m")
    within("h*", film_parameter, 0.005, 0.5, "")
    within("roughness Ra", roughness, 1e-8, 1e-5, "m")
    within("Y_W", material_factor, 0.5, 2, "")
    a, b, c, d, largest = _FRICTION[oil]
    base = min(a + b / (sliding_speed + c) ** d, largest)
    size = sqrt(0.1 / centre_distance)
    shape = sqrt(REFERENCE_FILM / film_parameter)
    return base * size * shape * material_factor * (roughness / 0.5e-6) ** 0.25


def static_friction(
    centre_distance: float, roughness: float, material_factor: float = 1.0
) -> float:
    """Coefficient of tooth friction at rest [-], mu_0 sqrt(Y_S) Y_W Y_R with `STATIC_FRICTION` as mu_0.

    The factors are those of `tooth_friction`. Source as of `STATIC_FRICTION`. Checked: above the friction of
    running teeth at every speed. Range: tin bronze.

    Parameters
    ----------
    centre_distance : float
        [m].
    roughness : float
        Mean roughness Ra of the worm's flanks [m].
    material_factor : float
        Y_W of the wheel's material [-].
    """
    within("centre distance", centre_distance, 0.025, 2, "m")
    within("roughness Ra", roughness, 1e-8, 1e-5, "m")
    within("Y_W", material_factor, 0.5, 2, "")
    size = (0.1 / centre_distance) ** 0.25
    return STATIC_FRICTION * size * material_factor * (roughness / 0.5e-6) ** 0.25


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


def deflection_limit(module: float) -> float:
    """Largest deflection of the worm's shaft at the mesh, delta_lim [m], 0.04 sqrt(m_x) mm with m_x in mm.

    From memory, not checked. The help of a design program (Autodesk Inventor, worm gears component generator)
    allows 0.004 m_x with hardened worms and 0.01 m_x with heat-treated ones: 0.016 and 0.04 mm instead of
    0.08 mm at m_x = 4 mm.
    """
    positive("module", module, "m")
    return 0.04e-3 * sqrt(module * 1e3)


def pitting_safety(
    mean_pressure: float,
    strength: float,
    life: float,
    sliding_speed: float,
    centre_distance: float,
    oil: OilKind,
) -> float:
    """Safety against pitting of the wheel S_H [-], sigma_HlimT Z_h Z_v Z_S Z_oil / sigma_Hm.

    Z_h = (25000 h/Lh)^(1/6), at most 1.6; Z_v = sqrt(5/(4 + vg)); Z_S = sqrt(3000/(2900 + a)), a in mm;
    Z_oil of PAG 1, PAO 0.94, mineral 0.89. Checked: 1 is each factor of the reference test (25000 h, 1
    m/s, 100 mm, PAG).

    Parameters
    ----------
    mean_pressure : float
        sigma_Hm [Pa], `mean_pressure`.
    strength : float
        sigma_HlimT of the wheel's material [Pa], such as in `PITTING_STRENGTH`.
    life : float
        Wanted life [h].
    sliding_speed : float
        vg [m/s].
    centre_distance : float
        [m].
    oil : str
        "mineral", "PAO" or "PAG".
    """
    positive("mean contact stress", mean_pressure, "Pa")
    within("pitting strength", strength, 5e7, 2e9, "Pa")
    within("life", life, 1, 1e6, "h")
    within("sliding speed", sliding_speed, 0, 25, "m/s")
    within("centre distance", centre_distance, 0.025, 2, "m")
    one_of("oil", oil, OIL_KINDS)
    lasting = min((25000 / life) ** (1 / 6), 1.6)
    speed = sqrt(5 / (4 + sliding_speed))
    size = sqrt(3000 / (2900 + centre_distance * 1e3))
    return strength * lasting * speed * size * _OIL_LIFE[oil] / mean_pressure


def wear_intensity(
    oil: OilKind, film: float, structure_factor: float, pressure_factor: float = 1.0
) -> float:
    """Wear of a CuSn12Ni2 wheel per sliding path J_0T [-].

    2.4e-11 K_W^-3.1 (mineral), 1.27e-10 K_W^-2.24 (PAG), at most 400e-9, K_W = h_min,m W_S W_H with the
    film in um. Only its fall with the film and its cap could be checked. Range: mineral oil and PAG; PAO
    has no constants here.

    Parameters
    ----------
    oil : str
        "mineral" or "PAG".
    film : float
        h_min,m [m].
    structure_factor, pressure_factor : float
        W_S of the oil's structure and W_H of the pressure [-], from the standard; 1 is mineral oil at
        moderate pressure.
    """
    one_of("oil of the wear rating", oil, tuple(WEAR_INTENSITIES))
    within("mean minimum film", film, 1e-9, 1e-4, "m")
    positive("W_S", structure_factor, "")
    positive("W_H", pressure_factor, "")
    factor, exponent, largest = WEAR_INTENSITIES[oil]
    return min(factor * (film * 1e6 * structure_factor * pressure_factor) ** exponent, largest)


def wear_depth(
    intensity: float,
    sliding_parameter: float,
    mean_pressure: float,
    centre_distance: float,
    reduced_modulus: float,
    cycles: float,
) -> float:
    """Depth [m] worn off the wheel's flanks, J s* sigma_Hm a/E_red N_L.

    Checked by dimension.

    Parameters
    ----------
    intensity : float
        J_W [-], `wear_intensity` times the factor of the wheel's material.
    sliding_parameter : float
        s* [-].
    mean_pressure : float
        sigma_Hm [Pa].
    centre_distance : float
        [m].
    reduced_modulus : float
        [Pa].
    cycles : float
        Turns of the wheel N_L in its life [-].
    """
    positive("wear intensity", intensity, "")
    within("wear intensity", intensity, 0, 1e-4, "")
    positive("s*", sliding_parameter, "")
    within("mean contact stress", mean_pressure, 1e6, 1e10, "Pa")
    within("centre distance", centre_distance, 0.025, 2, "m")
    within("reduced modulus", reduced_modulus, 1e10, 1e12, "Pa")
    positive("load cycles", cycles, "")
    path = sliding_parameter * mean_pressure * centre_distance / reduced_modulus * cycles
    return intensity * path


def bulk_temperature(
    sump_temperature: float,
    tooth_loss: float,
    worm_speed: float,
    cooled_area: float,
    immersion_factor: float,
) -> float:
    """Bulk temperature of the wheel theta_M [K], sump temperature + P_Vz/(alpha_L A_R).

    alpha_L = c_k (1940 + 15 n1) W/(m2 K), n1 in rpm. Checked by dimension and by its limit without loss.

    Parameters
    ----------
    sump_temperature : float
        [K].
    tooth_loss : float
        Power lost between the teeth P_Vz [W].
    worm_speed : float
        [rad/s].
    cooled_area : float
        A_R, face width times reference diameter of the wheel [m2].
    immersion_factor : float
        c_k [-], 1 where the wheel dips into the oil and less where it does not, from the standard.
    """
    within("sump temperature", sump_temperature, 230, 470, "K")
    within("tooth loss", tooth_loss, 0, 1e7, "W")
    within("worm speed", worm_speed * RPM, 0.1, 1e5, "rpm")
    within("cooled area", cooled_area, 1e-5, 1, "m2")
    within("c_k", immersion_factor, 0.1, 2, "")
    transfer = immersion_factor * (1940 + 15 * worm_speed * RPM)
    return sump_temperature + tooth_loss / (transfer * cooled_area)


def temperature_safety(sump_temperature: float, limit: float) -> float:
    """S_T [-], limiting over actual sump temperature, both in degC inside; arguments in kelvin.

    The limit is a property of the oil, given by its maker; 90 degC is usual for mineral oils, 100 degC
    for PAO and PAG.
    """
    within("sump temperature", sump_temperature, 273.16, 470, "K")
    within("limit of the sump temperature", limit, 273.16, 470, "K")
    return (limit - ZERO_CELSIUS) / (sump_temperature - ZERO_CELSIUS)


@dataclass(frozen=True)
class TeethLoss:
    """Friction, efficiency and loss of worm gear teeth with the worm driving.

    Attributes
    ----------
    friction : float
        mu_zm [-].
    forward_efficiency, backward_efficiency : float
        Of the teeth [-]; backward zero or less where the wheel cannot drive.
    power : float
        Lost between the teeth, worm driving [W].
    """

    friction: float
    forward_efficiency: float
    backward_efficiency: float
    power: float


def teeth_loss(
    gear: WormGear,
    oil: OilKind,
    worm_speed: float,
    torque: float,
    roughness: float,
    material_factor: float = 1.0,
) -> TeethLoss:
    """Loss between the teeth by `tooth_friction`; arguments as of `WormConditions`."""
    friction = tooth_friction(
        oil,
        gear.sliding_speed(worm_speed),
        gear.centre_distance,
        gear.film_parameter,
        roughness,
        material_factor,
    )
    forward = forward_efficiency(gear.tan_lead, friction)
    output = torque * worm_speed / gear.ratio
    return TeethLoss(
        friction, forward, backward_efficiency(gear.tan_lead, friction), output * (1 / forward - 1)
    )
