"""Deflection of a worm's shaft by the worm-gear standard, and the largest it allows."""

from math import atan, cos, hypot, sqrt, tan

from pyworm.formulas.beam import bending, second_moment
from pyworm.formulas.ranges import positive
from pyworm.formulas.worm_gear import WormGear

STIFF_DIAMETER = 1.1
"""Diameter of the shaft that counts over that of the worm's root [-] (the same transcription)."""

STEEL = 210e9
"""Young's modulus of the worm [Pa]."""


def deflection_limit(module: float) -> float:
    """Largest deflection of the worm's shaft at the mesh, delta_lim [m], 0.04 sqrt(m_x) mm with m_x in mm.

    Also in a public transcription of DIN 3996 (the worksheet on worm gears of MITCalc). The help of a design
    program (Autodesk Inventor, worm gears component generator) allows 0.004 m_x with hardened worms and 0.01
    m_x with heat-treated ones: 0.016 and 0.04 mm instead of 0.08 mm at m_x = 4 mm.
    """
    positive("module", module, "m")
    return 0.04e-3 * sqrt(module * 1e3)


def shaft_deflection(gear: WormGear, torque: float, friction: float) -> float:
    """Deflection of the worm's shaft at the mesh delta_m [m] between bearings at the usual places.

        F_tm2 sqrt(tan^2(gamma + atan mu) + tan^2(alpha_0)/cos^2(gamma)) l^3/(48 E I)

    with mu = mu_zm, I of 1.1 times the worm's root diameter and l the wheel's tip diameter. Formula and usual
    places are those of a public transcription of DIN 3996 (the worksheet on worm gears of MITCalc), whose
    constant of 0.006592 stands for 64/(3 pi)/1000 = 0.00679 of a beam: 3 % apart.
    """
    lead = gear.lead_angle
    across = hypot(tan(lead + atan(friction)), tan(gear.pressure_angle) / cos(lead))
    force = gear.tangential_force(torque) * across
    rigidity = STEEL * second_moment(STIFF_DIAMETER * gear.worm_root_diameter)
    half = gear.wheel_tip_diameter / 2
    return bending(force, 0.0, half, half, rigidity).deflection
