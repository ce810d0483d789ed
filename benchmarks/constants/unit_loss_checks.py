"""Losses of bearings and seals, and the life of worm wheel roots, against catalogues and another standard."""

from math import pi

from chapter import MEMORY, Chapter, Clause, within_factor
from constant_slips import Check, ModuleNumbers

from pyworm.formulas.worm_gear import REFERENCE_GEAR
from pyworm.formulas.worm_losses import SEALS, other_losses

RPM = pi / 30
BORE, MEAN = 0.05, 0.07
TAPERED = 0.0018
"""Friction coefficient of tapered roller bearings in catalogues, M = mu P d/2 (from memory) [-]."""


def _catalogue(of):
    """Bearings in the range of catalogues: half of that coefficient to twice it."""
    torque = of.bearing_load_torque(1e4, MEAN)
    return within_factor(torque, TAPERED * 1e4 * BORE / 2, 2.0)


def _worm_seals(of):
    """Seals as those of the worm standard within a factor of two."""
    diameter = REFERENCE_GEAR.worm_diameter
    standard = other_losses(REFERENCE_GEAR, 1500 * RPM, 300.0).seals / SEALS
    return within_factor(of.seal_loss(diameter, 1500 * RPM), standard, 2.0)


UNIT = Chapter(
    "Losses of bearings under load and of seals",
    ModuleNumbers("pyworm.formulas.unit_losses", only=("LOAD_FACTOR", "SEAL")),
    "Palmgren (1959); [ISO/TR 14179-2](bibliography.md#iso-tr-14179-2)",
    {
        "LOAD_FACTOR": Clause("f_1 of tapered roller bearings", MEMORY),
        "SEAL": Clause("loss of a radial shaft seal", MEMORY),
    },
    (
        Check("torque of catalogues within 2", _catalogue),
        Check("seals of the worm standard within 2", _worm_seals),
    ),
    lambda of: [of.bearing_load_torque(1e4, MEAN), of.seal_loss(BORE, 1500 * RPM)],
)


def _life_factor(of):
    """Y_NL of 8.3e5 cycles is between 1.2 and 1.25, and 1 from the endurance on."""
    strong = (of.ENDURANCE_CYCLES / 8.3e5) ** of.ROOT_POWER
    return 1.2 < strong < 1.25 and of.root_damage(3e6, 1 - 1e-9) > 0.999


ROOT_LIFE = Chapter(
    "Life of the roots of worm wheels",
    ModuleNumbers("pyworm.ratings.worm_safeties", only=("ENDURANCE_CYCLES", "ROOT_POWER")),
    "[DIN 3996:2012](bibliography.md#din-3996), life factor Y_NL",
    {
        "ENDURANCE_CYCLES": Clause("cycles from which Y_NL is 1", MEMORY),
        "ROOT_POWER": Clause("exponent of Y_NL", MEMORY),
    },
    (Check("Y_NL of 8.3e5 cycles from 1.2 to 1.25", _life_factor),),
    lambda of: [of.root_damage(1e5, 0.9)],
)

CHAPTERS = (UNIT, ROOT_LIFE)
