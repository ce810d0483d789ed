"""Scuffing of gear teeth: Blok's contact temperature against the oil's scuffing temperature.

Temperatures are in kelvin, all else in SI; formulas fitted in degrees Celsius or Fahrenheit convert inside.
"""

import numpy as np
import scipy

from pyworm.formulas.arrays import Values
from pyworm.formulas.ranges import positive, within
from pyworm.formulas.unit_factors import ZERO_CELSIUS

SOURCE = "Blok 1937; AGMA 2001-B88 and 925-A03"

FLASH_CONSTANT = 0.80
"""Constant of `flash_temperature` in AGMA 925-A03.

A semi-elliptic heat source on a fast half-space has 0.786, a uniform one sqrt(2/pi) = 0.798.
"""

TEMPERATURE_DEVIATION = 0.15
"""Standard deviation of the scuffing temperature over its mean in degrees Fahrenheit (AGMA 2001-B88)."""

LOW_RISK, HIGH_RISK = 0.10, 0.30
"""Probabilities up to which the risk is low, and above which it is high (AGMA 925-A03, from memory)."""

# a, b of the mean scuffing temperature a + b ln(nu40) in degC, without and with anti-scuff additives
_SCUFFING = {False: (63.0, 33.0), True: (118.0, 33.0)}


def effusivity(conductivity: Values, density: Values, specific_heat: Values) -> Values:
    """Thermal contact coefficient B [N/(m s^0.5 K)], sqrt(k rho c); arguments in W/(m K), kg/m3, J/(kg K)."""
    within("conductivity", conductivity, 0.01, 1000, "W/(m K)")
    within("density", density, 100, 25000, "kg/m3")
    within("specific heat", specific_heat, 50, 10000, "J/(kg K)")
    return np.sqrt(conductivity * density * specific_heat)


def flash_temperature(
    friction: Values,
    load_per_length: Values,
    speed_1: Values,
    speed_2: Values,
    effusivity_1: float,
    effusivity_2: float,
    half_width: Values,
) -> Values:
    """Flash temperature of a line contact [K]: how far both surfaces rise above their bulk, at most.

        0.80 mu w |v1 - v2| / [(B1 sqrt v1 + B2 sqrt v2) sqrt b]

    with b the half-width of Hertz's contact and speeds across it above zero, in SI; for equal B
    (`effusivity`) the same as AGMA 925's 0.80 mu w |sqrt v1 - sqrt v2|/(B sqrt b). All heat goes into the two
    bodies, so shared that their largest temperatures agree.

    Source: H. Blok, IMechE General Discussion on Lubrication 2 (1937) 222-235. Verified by dimension, and by
    integrating the heat of a semi-elliptic source, whose constant is 0.786. Two forms in circulation do not
    agree with it: one with |sqrt v1 - sqrt v2| and different B over B1 sqrt v1 + B2 sqrt v2 lacks a root of a
    speed, and 0.62 before w/sqrt b belongs before w^(3/4) (E'/R)^(1/4) instead. Range: fast bodies, b v/(2
    diffusivity) above about 5.
    """
    within("friction coefficient", friction, 0, 1, "")
    within("load per length", load_per_length, 0, 1e8, "N/m")
    positive("speed of surface 1", speed_1, "m/s")
    positive("speed of surface 2", speed_2, "m/s")
    within("thermal contact coefficient", [effusivity_1, effusivity_2], 10, 1e5, "N/(m s^0.5 K)")
    within("half-width of the contact", half_width, 1e-7, 1e-2, "m")
    heat = friction * load_per_length * np.abs(np.subtract(speed_1, speed_2))
    drain = effusivity_1 * np.sqrt(speed_1) + effusivity_2 * np.sqrt(speed_2)
    return FLASH_CONSTANT * heat / (drain * np.sqrt(half_width))


def scuffing_temperature(viscosity_40: Values, anti_scuff: bool) -> Values:
    """Mean scuffing temperature [K] of a mineral gear oil by its viscosity at 40 degC [m2/s].

    63 degC + 33 K ln nu40, with anti-scuff (EP) additives 118 degC + 33 K ln nu40, nu40 in mm2/s. Source:
    AGMA 925-A03; Errichello prints it as 146 degF + 59 ln nu40 and 245 degF + 59 ln nu40, the same within 3
    degF. Range: mineral oils of 32 to 1000 mm2/s.
    """
    within("kinematic viscosity at 40 degC", viscosity_40, 25e-6, 1.2e-3, "m2/s")
    base, slope = _SCUFFING[anti_scuff]
    return base + slope * np.log(np.asarray(viscosity_40) * 1e6) + ZERO_CELSIUS


def scuffing_temperature_of_stage(
    stage: int, viscosity: float, friction_factor: float = 1.0, structure_factor: float = 1.0
) -> float:
    """Scuffing temperature [K] of an oil that fails at a load stage S, 1 to 14, of the FZG test A/8.3/90.

        80 degC + (0.85 + 1.4 X_W) X_L S^2,  X_L = f (1000 eta)^-0.05

    eta is that of the oil as it is fed [Pa s], f that of its kind (`micropitting.FRICTION_FACTORS`). X_W is 1
    of case carburised steel with 10 to 20 % of austenite and of through hardened steel, 1.15 with less, 0.85
    with more, 1.25 phosphated, 1.5 nitrided or copper plated. Source: ISO/TS 6336-20 (before, ISO/TR
    13989-1), equations 99 and 27, by a public program that gives equation numbers
    (Iso13989FlashTemperature.cs, mekanika.org), whose scuffing temperatures are told to be within 0.2 % of
    two reports of a commercial one. Range: steel on steel.
    """
    within("load stage of the scuffing test", stage, 1, 14, "")
    within("viscosity", viscosity, 1e-4, 100, "Pa s")
    within("lubricant factor", friction_factor, 0.1, 3, "")
    within("structure factor", structure_factor, 0.1, 3, "")
    lubricant = friction_factor * (1e3 * viscosity) ** -0.05
    return float(80 + (0.85 + 1.4 * structure_factor) * lubricant * stage**2 + ZERO_CELSIUS)


def scuffing_safety(contact: Values, oil: float, scuffing: float) -> Values:
    """S_B [-], (theta_S - theta_oil)/(theta_B - theta_oil) (ISO/TS 6336-20); temperatures in kelvin."""
    within("oil temperature", oil, 200, 600, "K")
    within("scuffing temperature", scuffing, 300, 1000, "K")
    rise = np.asarray(contact) - oil
    positive("rise of the contact above the oil", rise, "K")
    return (scuffing - oil) / rise


def scuffing_probability(contact: Values, scuffing: Values) -> Values:
    """Probability of scuffing [-]: of a normal scuffing temperature that the contact temperature [K] exceeds.

    The standard deviation is 15 % of the mean in degrees Fahrenheit. Source: AGMA 2001-B88, from memory;
    verified by Errichello's two cases (439 degF against 418 degF: 63 %; 302 against 563: below 5 %). With the
    mean in degrees Celsius, as AGMA 925 has it, the first is 64 %.
    """
    within("contact temperature", contact, 200, 3000, "K")
    within("scuffing temperature", scuffing, 300, 1000, "K")
    mean = (np.asarray(scuffing) - ZERO_CELSIUS) * 1.8 + 32
    excess = (np.asarray(contact) - np.asarray(scuffing)) * 1.8
    scuffing_probability: Values = scipy.special.ndtr(excess / (TEMPERATURE_DEVIATION * mean))
    return scuffing_probability


def risk(probability: float) -> str:
    """The probability in a word: "low" to 10 %, "moderate" to 30 %, "high" above."""
    within("probability", probability, 0, 1, "")
    if probability <= LOW_RISK:
        return "low"
    return "moderate" if probability <= HIGH_RISK else "high"
