"""Wear of sliding surfaces: Archard's law, the energy form, and what running in leaves of a roughness."""

from math import exp, pi, sqrt

import numpy as np
import scipy

from pyworm.formulas.arrays import Values
from pyworm.formulas.ranges import positive, within

WEAR_COEFFICIENT = 7e-18
"""k of steel on tin bronze between asperities that touch [m2/N], depth over their pressure and path.

Derived, not measured: the worm standard's base wear of 1e-9 (bath and injected oils at some 0.5 um of film),
which counts the whole pressure, over asperities that carry half of 300 MPa. Its spread is that of the
standard's curves and of the share: a factor of `WEAR_SPREAD` either way."""

STEEL_WEAR_COEFFICIENT = 1e-18
"""k of ground, hard steel gears in oil between asperities that touch [m2/N]: of the order of what is
published for them (9.65e-19 over the whole pressure, P. Bajpai, A. Kahraman and N. E. Anderson, J. Tribol.
126 (2004) 597, from memory); known to a factor of 10."""

WEAR_ACCURACY = "10 %"
"""Accuracy of simulated contacts that is enough for wear, as its coefficient is known to a factor of 3."""

WEAR_TOLERANCE = 0.25e-6
"""Error of the depth in a time step that is small against the depths that standards allow [m]."""

WEAR_SPREAD = 3.0
"""Factor by which `WEAR_COEFFICIENT` may be too large or too small [-]."""

HARDNESS_EXPONENT = 2.0
"""Exponent of the ratio of hardnesses in `harder_ratio` [-]."""

WORM_HARDNESS, WHEEL_HARDNESS = 6.7e9, 0.93e9
"""Indentation hardness of case hardened worms, 680 HV, and of tin bronze, 95 HB [Pa], of bodies without."""

RUN_IN = 0.6
"""Rq of hobbed flanks after running in over before [-]; a program's manual: 20-45 of 30-80 uin."""


def archard_depth(coefficient: float, pressure: Values, path: Values) -> Values:
    """Depth worn off [m], k p s (J. F. Archard, J. Appl. Phys. 24 (1953) 981), s the path slid [m].

    k is the wear coefficient over hardness [m2/N], p the pressure of asperities over the nominal area [Pa].
    """
    positive("wear coefficient", coefficient, "m2/N")
    within("wear coefficient", coefficient, 1e-24, 1e-9, "m2/N")
    archard_depth: Values = coefficient * np.asarray(pressure) * np.asarray(path)
    return archard_depth


def pass_depth(coefficient: float, unit_load: float, sliding: float, velocity: float) -> float:
    """Depth that a line contact wears off a surface as it passes once [m], k w |dv|/|v|.

    Archard's law over the time that a place of the surface, which moves at v over the contact line [m/s], is
    in contact: the pressure integrates to w, the load that asperities carry for each length [N/m]; dv is the
    sliding velocity [m/s].
    """
    positive("wear coefficient", coefficient, "m2/N")
    positive("velocity", abs(velocity), "m/s")
    return coefficient * unit_load * abs(sliding / velocity)


def harder_ratio(hardness: float, softer: float, exponent: float = HARDNESS_EXPONENT) -> float:
    """k of the harder of two surfaces over that of the softer one [-], (H_soft/H_hard)^n.

    Both bear the same asperities over the same path, so this is the ratio of their worn volumes too. Source:
    E. Rabinowicz, Friction and Wear of Materials: n = 2 through tests that scatter widely; a hardness in
    Archard's law alone, with one constant for both, is n = 1 and bounds it from above.
    """
    positive("hardness", softer, "Pa")
    within("hardness of the harder surface", hardness, softer, 1e11, "Pa")
    within("exponent of the hardness", exponent, 0, 4, "")
    return float((softer / hardness) ** exponent)


def energy_coefficient(energy: float, friction: float) -> float:
    """k of Archard's law [m2/N] that wears as much as a work of friction e_R for each volume [J/m3], mu/e_R.

    Depth is mu p s/e_R then, mu that of asperities: both forms are one as long as it is one number.
    """
    positive("wear energy", energy, "J/m3")
    within("friction of asperities", friction, 1e-3, 1, "")
    return friction / energy


def truncated_roughness(roughness: float, removed: float, run_in: float = RUN_IN) -> float:
    """Rq [m] of a surface, cut with a roughness, whose summits are worn off by a mean depth `removed` [m].

    Heights z spread normally become min(z, t); t is where a mean depth is removed. It ends at `run_in` times
    what it was: the other surface and debris leave grooves of their own.
    """
    within("roughness", roughness, 1e-10, 1e-4, "m")
    within("worn depth", removed, 0, 1, "m")
    within("run-in roughness", run_in, 0, 1, "")
    share = removed / roughness
    if share == 0:
        return roughness
    lowest, highest = -8.0, 8.0
    if share >= _removed(lowest):
        return run_in * roughness
    level = scipy.optimize.brentq(lambda t: _removed(t) - share, lowest, highest)
    above = scipy.special.ndtr(-level)
    square = 1 - above - level * _density(level) + level**2 * above
    return max(sqrt(max(square - share**2, 0.0)), run_in) * roughness


def _density(level: float) -> float:
    return exp(-(level**2) / 2) / sqrt(2 * pi)


def _removed(level: float) -> float:
    """Mean of what of a normal height lies above a level, over its deviation [-]."""
    return float(_density(level) - level * scipy.special.ndtr(-level))
