"""Losses of bearings, seals and dipping gear bodies of a gear unit, by closed forms; all arguments in SI.

Bearings: A. Palmgren, Ball and Roller Bearing Engineering (1959), from memory. Seals: ISO/TR 14179-2, from
memory. Gear bodies: discs that turn in oil (T. von Karman, ZAMM 1 (1921) 233; H. Schlichting, Boundary-Layer
Theory), without what teeth add.
"""

from math import acos, cos, pi, sin

from pyworm.formulas.ranges import within
from pyworm.formulas.unit_factors import RPM

IDLE_FACTOR, LOAD_FACTOR = 4.0, 4e-4
"""f_0 of bearings in an oil bath and f_1, tapered roller bearings' [-]; other types have 1 to 6 and 2e-4 to
1e-3."""

SLOW = 2000.0
"""Viscosity times speed [mm2/s times 1/min] up to which a bearing's idle torque does not rise."""

SEAL = 7.69e-6
"""Loss of a radial shaft seal over diameter squared and speed [W/(mm2 1/min)]."""

LAMINAR_DISC = 3e5
"""Reynolds number w R^2/nu to which the flow on a turning disc is laminar [-]."""

SPREAD = 1.0
"""Relative uncertainty of these losses (95 %) [-]: a factor of two is assumed."""


def bearing_idle_torque(viscosity: float, speed: float, mean_diameter: float) -> float:
    """Idle torque of a rolling bearing in oil [N m], 1e-7 f_0 (nu n)^(2/3) d_m^3 N mm.

    By kinematic viscosity [m2/s], speed [rad/s] and mean diameter [m]; nu n in mm2/s and 1/min, 2000 or more.
    """
    within("kinematic viscosity", viscosity, 1e-7, 1.0, "m2/s")
    product = max(viscosity * 1e6 * abs(speed) * RPM, SLOW)
    torque: float = 1e-10 * IDLE_FACTOR * product ** (2 / 3) * (mean_diameter * 1e3) ** 3
    return torque


def bearing_load_torque(load: float, mean_diameter: float) -> float:
    """Torque of a rolling bearing by its load [N m], f_1 P d_m."""
    return LOAD_FACTOR * load * mean_diameter


def seal_loss(diameter: float, speed: float) -> float:
    """Loss of a radial shaft seal [W] on a shaft [m] that turns [rad/s]."""
    return SEAL * (diameter * 1e3) ** 2 * abs(speed) * RPM


def dipping_share(depth: float, diameter: float) -> float:
    """Share of a disc below the level of the oil into which it dips [-]."""
    angle = acos(1 - 2 * min(max(depth / diameter, 0.0), 1.0))
    return (angle - sin(angle) * cos(angle)) / pi


def disc_torque(density: float, viscosity: float, radius: float, speed: float) -> float:
    """Torque of both sides of a disc that turns in a fluid [N m], C_M rho w^2 R^5/2.

    C_M = 3.87 Re^(-1/2), beyond Re = w R^2/nu of 3e5 0.146 Re^(-1/5).
    """
    reynolds = abs(speed) * radius**2 / viscosity
    if reynolds == 0:
        return 0.0
    laminar, turbulent = 3.87 * reynolds**-0.5, 0.146 * reynolds**-0.2
    factor = laminar if reynolds <= LAMINAR_DISC else turbulent
    torque: float = factor * density * speed**2 * radius**5 / 2
    return torque
