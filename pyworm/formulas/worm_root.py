"""Shear at the roots of a worm wheel's teeth by the worm-gear standard, its nominal stress.

From a public transcription of DIN 3996 (the worksheet on worm gears of MITCalc).
"""

from math import cos, log, pi, tan

from pyworm.formulas.ranges import positive, within
from pyworm.formulas.worm_gear import WormGear

CONTACT_FACTOR = 0.5
"""Y_epsilon [-]: two teeth share the load."""

DEDENDUM = 1.25
"""Of the wheel, over the axial module [-]; usual."""

FULL_RIM = 2.0
"""Thickness of the rim over the axial module from which it counts as stiff [-]."""


def root_thickness(gear: WormGear, worn: float = 0.0) -> float:
    """Mean thickness of the wheel's teeth at their root s_f2 [m], a depth delta_W [m] worn off their flanks.

        1.06 [pi m_x/2 - delta_W/cos gamma + (d_m2 - d_f2) tan(alpha_0)/cos(gamma)]

    with d_m2 - d_f2 twice `DEDENDUM` modules.
    """
    within("worn depth", worn, 0, 1, "m")
    cosine, depth = cos(gear.lead_angle), 2 * DEDENDUM * gear.module
    flank = depth * tan(gear.pressure_angle) / cosine
    return 1.06 * (pi / 2 * gear.module - worn / cosine + flank)


def rim_factor(thickness: float) -> float:
    """Y_K [-] of a rim as thick as so many modules: 1.043 ln(5.218/thickness) below 2 of them, else 1.

    The transcription has 5.281, with which Y_K would jump by 1.3 % at two modules; 5.218 is continuous there.
    Range: 1 module and more.
    """
    within("rim over module", thickness, 1, 1e3, "")
    return 1.043 * log(5.218 / thickness) if thickness < FULL_RIM else 1.0


def root_shear(gear: WormGear, torque: float, worn: float = 0.0, rim: float = FULL_RIM) -> float:
    """Nominal shear at the root of the wheel's teeth [Pa], F_tm2/(b_2H m_x) Y_eps Y_F Y_gamma Y_K.

    F_tm2 = 2 T2/d_m2, Y_F = 2.9 m_x/s_f2 of teeth worn by a depth [m], Y_gamma = 1/cos gamma, Y_eps = 0.5,
    Y_K by the rim over the module. Checked by dimension.
    """
    positive("wheel torque", torque, "N m")
    form = 2.9 * gear.module / root_thickness(gear, worn)
    area = gear.face_width * gear.module
    shear = gear.tangential_force(torque) / area * CONTACT_FACTOR * form
    return shear / cos(gear.lead_angle) * rim_factor(rim)
