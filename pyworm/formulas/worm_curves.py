"""Base friction and base wear of worm gears: curves of the standard's reference gear, by oil and lubrication.

From a public transcription of DIN 3996 (the worksheet on worm gears of MITCalc); the standard's own text
could not be read. The curves of tin bronze with injected oil agree with those remembered before it was
found. For mineral oil in a bath the transcription has b = 0.079, a misprint of 0.0079: bath over injection at
1 m/s is then 0.76, as 0.77 of PAO and 0.73 of PAG, and 1.8 otherwise.
"""

from typing import Literal

from pyworm.formulas.ranges import one_of, positive, within
from pyworm.formulas.worm_wheel_material import FAMILIES, Family

OilKind = Literal["mineral", "PAO", "PAG"]
Lubrication = Literal["injection", "bath"]

OIL_KINDS: tuple[OilKind, ...] = ("mineral", "PAO", "PAG")
"""Oils that the standards have constants for."""

LUBRICATIONS: tuple[Lubrication, ...] = ("injection", "bath")
"""Ways that oil comes to the teeth."""

SLIDING_RANGE = 0.05, 25.0
"""Sliding speeds at which the base friction is known [m/s]."""

# a, b, c, d, largest of mu_0T = a + b/(vg + c)^d, of bronzes
_FRICTION = {
    ("injection", "mineral"): (0.028, 0.026, 0.17, 0.76, 0.1),
    ("injection", "PAO"): (0.026, 0.017, 0.17, 0.92, 0.096),
    ("injection", "PAG"): (0.02, 0.02, 0.2, 0.97, 0.094),
    ("bath", "mineral"): (0.033, 0.0079, 0.2, 1.55, 0.1),
    ("bath", "PAO"): (0.027, 0.0056, 0.15, 1.63, 0.096),
    ("bath", "PAG"): (0.024, 0.0032, 0.1, 1.71, 0.094),
}

# the same of cast iron, however it is lubricated
_FRICTION_OF_IRON = {
    "mineral": (0.055, 0.015, 0.2, 0.87, 0.1),
    "PAO": (0.055, 0.015, 0.2, 0.87, 0.1),
    "PAG": (0.034, 0.015, 0.19, 0.97, 0.1),
}

_MOST_WEAR = 400e-9

# factor, exponent and largest value of J_0T = factor K_W^exponent, of tin bronze
_WEAR = {
    ("injection", "mineral"): (2.4e-11, -3.1, _MOST_WEAR),
    ("injection", "PAO"): (3.18e-10, -2.24, None),
    ("injection", "PAG"): (1.27e-10, -2.24, None),
    ("bath", "mineral"): (6.5e-11, -2.68, _MOST_WEAR),
    ("bath", "PAO"): (5.58e-10, -1.91, None),
    ("bath", "PAG"): (2.23e-10, -1.91, None),
}

# the same of other families, however they are lubricated
_WEAR_OF = {
    ("aluminium bronze", "mineral"): (9e-11, -3.7, _MOST_WEAR),
    ("aluminium bronze", "PAO"): (9e-11, -3.7, _MOST_WEAR),
    ("aluminium bronze", "PAG"): (5.8e-11, -1.58, None),
    ("cast iron", "mineral"): (5.45e-9, -1.23, _MOST_WEAR),
    ("cast iron", "PAO"): (1.66e-8, -1.17, None),
    ("cast iron", "PAG"): (1.66e-8, -1.17, None),
}


def base_friction(
    oil: OilKind,
    sliding_speed: float,
    lubrication: Lubrication = "injection",
    family: Family = "tin bronze",
) -> float:
    """Base friction mu_0T [-] at a sliding speed [m/s] = a + b/(vg + c)^d, at most 0.094 to 0.1.

    Lubrication makes no difference to cast iron; both bronzes have the same curves. Checked by its neighbours
    and AGMA 6034's curve (docs/reference/constants.md). Range: vg from 0.05 to 25 m/s.
    """
    one_of("oil", oil, OIL_KINDS)
    one_of("lubrication", lubrication, LUBRICATIONS)
    one_of("family of the wheel's material", family, FAMILIES)
    within("sliding speed", sliding_speed, *SLIDING_RANGE, "m/s")
    iron = family == "cast iron"
    a, b, c, d, largest = _FRICTION_OF_IRON[oil] if iron else _FRICTION[lubrication, oil]
    return float(min(a + b / (sliding_speed + c) ** d, largest))


def wear_exponent(
    oil: OilKind, lubrication: Lubrication = "injection", family: Family = "tin bronze"
) -> float:
    """Exponent of K_W in `base_wear` below its largest value [-]; arguments as there."""
    return _wear_curve(oil, lubrication, family)[1]


def base_wear(
    oil: OilKind,
    parameter: float,
    lubrication: Lubrication = "injection",
    family: Family = "tin bronze",
) -> float:
    """Base wear J_0T, depth per sliding path [-], a power of K_W; with mineral oil at most 400e-9.

    K_W is the film in micrometres times W_S and W_H (`pyworm.formulas.worm_wear`); lubrication makes a
    difference to tin bronze only. Checked: falls with the film. The transcription bounds it for mineral oil
    (and PAO on aluminium bronze) only.
    """
    positive("K_W", parameter, "")
    factor, exponent, largest = _wear_curve(oil, lubrication, family)
    worn = factor * parameter**exponent
    return float(worn if largest is None else min(worn, largest))


def _wear_curve(
    oil: OilKind, lubrication: Lubrication, family: Family
) -> tuple[float, float, float | None]:
    """Factor, exponent and largest value of J_0T."""
    one_of("oil", oil, OIL_KINDS)
    one_of("lubrication", lubrication, LUBRICATIONS)
    one_of("family of the wheel's material", family, FAMILIES)
    return _WEAR[lubrication, oil] if family == "tin bronze" else _WEAR_OF[family, oil]
