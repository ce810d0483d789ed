"""Bending of a thread, a tooth or a pin at its root: cantilever beams and plates.

Nominal stresses without notch and fatigue factors.
"""

from math import hypot, pi

from pyworm.formulas.ranges import within

PLATE_SPREAD = 1.96
"""Width that bears a concentrated load at the free edge of a long cantilever plate over its height [-].

1/0.509, of the largest moment at the clamped edge, 0.509 F for nu = 0.3 (Jaramillo, J. Appl. Mech. 17, 1950,
67; the number from memory)."""


def bearing_width(arm: float, line: float, width: float) -> float:
    """Width of a root that bears a line load [m]: its length and `PLATE_SPREAD` of its arm, within the tooth.

    Exact for a concentrated load on a long plate, and for a long line.
    """
    return min(line + PLATE_SPREAD * arm, width)


def plate_root_stress(force: float, arm: float, thickness: float, width: float) -> float:
    """Equivalent stress of bending and shear at the root of a plate [Pa].

        sqrt(sigma^2 + 3 tau^2),  sigma = 6 F h/(b s^2),  tau = F/(b s)

    Arguments: force across the plate [N], its arm h, thickness s and width b [m] (`bearing_width`).
    Source: Bernoulli and Euler. Range: arms of half to five thicknesses; shorter ones are sheared rather than
    bent.
    """
    within("force", force, 0, 1e9, "N")
    within("thickness of the root", thickness, 1e-5, 1, "m")
    bent = 6 * force * arm / (width * thickness**2)
    return hypot(bent, 3**0.5 * force / (width * thickness))


def pin_root_stress(force: float, arm: float, diameter: float) -> float:
    """Equivalent stress of bending and shear at the root of a round pin [Pa], held at one end.

    sigma = 32 F h/(pi d^3) and the mean shear 4 F/(pi d^2); arguments as of `plate_root_stress`.
    """
    within("force", force, 0, 1e9, "N")
    within("diameter of the pin", diameter, 1e-5, 1, "m")
    bent = 32 * force * arm / (pi * diameter**3)
    return hypot(bent, 3**0.5 * 4 * force / (pi * diameter**2))
