"""Losses of a gear unit's bearings under load and of its seals, and the part of a body that dips into oil.

Idle torques of bearings and dipping bodies: `pyworm.formulas.no_load_torque`.
"""

from math import acos, cos, pi, sin

from pyworm.formulas.unit_factors import RPM

LOAD_FACTOR = 4e-4
"""f_1 of tapered roller bearings [-] (Palmgren 1959, from memory); other types have 2e-4 to 1e-3."""

SEAL = 7.69e-6
"""Loss of a shaft seal over diameter squared and speed [W/(mm2 1/min)] (ISO/TR 14179-2, from memory)."""

LOSS_SPREAD = 1.0
"""Relative uncertainty of losses besides the teeth (95 %) [-]: a factor of two is assumed."""


def bearing_load_torque(load: float, mean_diameter: float) -> float:
    """Torque of a rolling bearing by its load [N m], f_1 P d_m (Palmgren)."""
    return LOAD_FACTOR * load * mean_diameter


def seal_loss(diameter: float, speed: float) -> float:
    """Loss of a radial shaft seal [W] on a shaft [m] that turns [rad/s]."""
    return SEAL * (diameter * 1e3) ** 2 * abs(speed) * RPM


def dipping_share(depth: float, diameter: float) -> float:
    """Share of a disc below the level of the oil into which it dips [-]."""
    angle = acos(1 - 2 * min(max(depth / diameter, 0.0), 1.0))
    return (angle - sin(angle) * cos(angle)) / pi
