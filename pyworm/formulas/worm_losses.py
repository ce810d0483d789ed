"""Losses of a worm gearbox besides its teeth, and the temperature of its sump, by the worm-gear standard.

From a public transcription of DIN 3996 (the worksheet on worm gears of MITCalc). The regressions hold numbers
in millimetres, rpm, N m and mm2/s and are no laws of physics.
"""

from dataclasses import dataclass
from math import pi, sqrt
from typing import Literal

from pyworm.formulas.ranges import one_of, positive, within
from pyworm.formulas.unit_factors import RPM
from pyworm.formulas.worm_curves import OIL_KINDS, OilKind
from pyworm.formulas.worm_gear import WormGear

Bearings = Literal["adjusted", "fixed and floating"]

BEARINGS: tuple[Bearings, ...] = ("adjusted", "fixed and floating")
"""Rolling bearings of the worm: two for axial force one way each, or one for both ways."""

SEALS = 2
"""Seals of the worm's shaft that the transcription counts."""

REFERENCE_SIZE = 63.0
"""Centre distance [mm] at which c1 counts the torque in N m."""

_BEARING_LOSS = {"adjusted": 0.03, "fixed and floating": 0.013}


@dataclass(frozen=True)
class OtherLosses:
    """Losses of a worm gearbox besides its teeth."""

    churning: float
    """P_V0 without load [W]."""
    bearings: float
    """P_VLP of rolling bearings under load [W]."""
    seals: float
    """P_VD of the worm's seals [W]."""

    @property
    def power(self) -> float:
        """All of them [W]."""
        return self.churning + self.bearings + self.seals


def other_losses(
    gear: WormGear, worm_speed: float, torque: float, bearings: Bearings = "adjusted"
) -> OtherLosses:
    """Losses besides the teeth [W]; arguments in SI units, T2 [N m].

    churning   8.9e-5 a n1^(4/3), a in mm, n1 in rpm
    bearings   0.03 P2 a^0.44 u/d_m2 (adjusted), 0.013 (fixed and floating); P2 in W, d_m2 in mm
    seals      1.178e-5 d_m1^2 n1, two of them
    """
    one_of("bearings", bearings, BEARINGS)
    positive("wheel torque", torque, "N m")
    rpm, distance = worm_speed * RPM, gear.centre_distance * 1e3
    within("worm speed", rpm, 0.1, 1e5, "rpm")
    output = torque * worm_speed / gear.ratio
    share = _BEARING_LOSS[bearings] * distance**0.44 * gear.ratio
    return OtherLosses(
        churning=8.9e-5 * distance * rpm ** (4 / 3),
        bearings=output * share / (gear.mean_wheel_diameter * 1e3),
        seals=SEALS * 1.178e-5 * (gear.worm_diameter * 1e3) ** 2 * rpm,
    )


def oil_factor(oil: OilKind, ratio: float, worm_speed: float) -> float:
    """c2 of the sump's rise of temperature [-], 1 with PAG, 1 + 9/(...) mineral, 1 + 5/(...) PAO.

    Doubtful: the transcription subtracts. Mineral oil rubs more than polyglycol and so warms the sump more;
    its fraction is added here, which is also the safe side. Its value, not its sign, is at most 0.15.
    """
    one_of("oil", oil, OIL_KINDS)
    if oil == "PAG":
        return 1.0
    part = (0.012 * ratio + 0.092) * sqrt(worm_speed * RPM) - 0.745 * ratio + 82.877
    within("denominator of c2", part, 20, 1e4, "")
    return 1 + (9 if oil == "mineral" else 5) / part


def sump_temperature(
    gear: WormGear,
    worm_speed: float,
    torque: float,
    oil: OilKind,
    viscosity_40: float,
    ambient_temperature: float,
    fan: bool,
) -> float:
    """Temperature of a bath of oil theta_S [K], theta_0 + [c1 T2/(a/63)^3 + c0] c2 of a usual finned housing.

    A fan on the worm's shaft never warms the oil: where its regression is above that without fan, as at 60
    rpm, the latter holds. Range: a from 50 to 500 mm, 60 to 3000 rpm, 10 to 1000 mm2/s at 40 degC; arguments
    in SI units.
    """
    within("centre distance", gear.centre_distance, 0.05, 0.5, "m")
    within("worm speed", worm_speed * RPM, 60, 3000, "rpm")
    within("viscosity at 40 degC", viscosity_40, 1e-5, 1e-3, "m2/s")
    within("ambient temperature", ambient_temperature, 220, 340, "K")
    positive("wheel torque", torque, "N m")
    second = worm_speed / (2 * pi)
    rise = _rise_without_fan(gear, second, torque, viscosity_40 * 1e4)
    if fan:
        rise = min(rise, _rise_with_fan(gear, second, torque, viscosity_40 * 1e4))
    return ambient_temperature + rise * oil_factor(oil, gear.ratio, worm_speed)


def _rise_without_fan(gear: WormGear, second: float, torque: float, thick: float) -> float:
    """c1 T2/(a/63)^3 + c0 [K] without a fan; speed in 1/s, viscosity over 100 mm2/s.

    The transcription's |nu_40/100 - 2.203|^0.0237 in c0, 0.99 to 1.05 for all oils but those near VG 220,
    would be zero at 220.3 mm2/s, as if nothing were lost without load: there it counts as 1, as of VG 150 and
    VG 320.
    """
    distance = gear.centre_distance * 1e3
    idle = 0.0523 * (second + 0.28) ** 0.68 * max(abs(thick - 2.203), 1.0) ** 0.0237
    idle *= (distance + 22.36) ** 0.915
    loaded = 0.034 * (second + 0.22) ** 0.43 * (10.8 - thick) ** -0.0636
    loaded *= gear.ratio**-0.18 * (distance - 20.4) ** 0.26
    return float(loaded * torque / (distance / REFERENCE_SIZE) ** 3 + idle)


def _rise_with_fan(gear: WormGear, second: float, torque: float, thick: float) -> float:
    """c1 T2/(a/63)^3 + c0 [K] with a fan on the worm's shaft; speed in 1/s, viscosity over 100 mm2/s."""
    distance = gear.centre_distance * 1e3
    idle = 0.081 * (second - 0.23) ** 0.7 * thick**0.41 * (distance + 32) ** 0.63
    loaded = 0.039 * (second + 2) ** 0.34 * thick**-0.17
    loaded *= gear.ratio**-0.22 * (distance - 48) ** 0.34
    return float(loaded * torque / (distance / REFERENCE_SIZE) ** 3 + idle)
