"""Reduction of the film by heating of the oil in the inlet: factors on the isothermal film.

All take the thermal loading L = eta0 beta um^2/k with the mean speed um; forms with the sum of both
speeds have other constants. None is larger than 1.
"""

import numpy as np

from pyworm.formulas.arrays import Values
from pyworm.formulas.ranges import positive, within


def thermal_loading(
    viscosity: Values, slope: Values, speed: Values, conductivity: Values
) -> Values:
    """Thermal loading L [-], eta0 beta um^2/k, beta = -d ln eta/dT [1/K], um the mean surface speed."""
    within("dynamic viscosity", viscosity, 1e-4, 1e3, "Pa s")
    within("fall of viscosity with temperature", slope, 0, 0.5, "1/K")
    within("mean speed", speed, 0, 1000, "m/s")
    within("conductivity of the oil", conductivity, 0.05, 1, "W/(m K)")
    return viscosity * slope * np.square(speed) / conductivity


def wilson_sheu(loading: Values, slide_roll_ratio: Values) -> Values:
    """Wilson and Sheu's factor [-], 1/[1 + 0.241 (1 + 14.8 Z^0.83) L^0.64], Z = SRR/2.

    Source: W. R. D. Wilson and S. Sheu, J. Lubr. Technol. 105 (1983) 187-188. The same with 0.1 holds for the
    loading with u1 + u2 instead of um (0.241/4^0.64 = 0.0992). Range: line contacts, surfaces moving the same
    way (SRR, sliding over mean speed, up to 2); negligible below L = 0.1.
    """
    _check(loading, slide_roll_ratio)
    sliding = 1 + 14.8 * (np.abs(slide_roll_ratio) / 2) ** 0.83
    return 1 / (1 + 0.241 * sliding * np.power(loading, 0.64))


def murch_wilson(loading: Values) -> Values:
    """Murch and Wilson's factor of pure rolling [-], 1/(1 + 0.254 L^0.62).

    Source: L. E. Murch and W. R. D. Wilson, J. Lubr. Technol. 97 (1975) 212-216.
    """
    _check(loading, 0.0)
    return 1 / (1 + 0.254 * np.power(loading, 0.62))


def gupta(loading: Values, slide_roll_ratio: Values, pressure_ratio: Values) -> Values:
    """Gupta's factor [-], [1 - 13.2 (p_H/E') L^0.42]/[1 + 0.213 (1 + 2.23 S^0.83) L^0.64], S = SRR.

    Source: P. K. Gupta, H. S. Cheng, D. Zhu, N. H. Forster and J. B. Schrand, Tribol. Trans. 35 (1992)
    269-274; from memory. Checked by its limit 1 without heating and, without pressure, by Wilson and Sheu's
    factor, which it meets within 7 % in pure rolling up to L = 10; in sliding it is far milder (0.49 against
    0.21 at L = 1 and S = 2). Range: until its numerator reaches zero.
    """
    _check(loading, slide_roll_ratio)
    within("p_H/E'", pressure_ratio, 0, 0.05, "")
    pressed = 1 - 13.2 * np.asarray(pressure_ratio) * np.power(loading, 0.42)
    positive("Gupta's numerator 1 - 13.2 (p_H/E') L^0.42", pressed, "")
    sliding = 1 + 2.23 * np.abs(slide_roll_ratio) ** 0.83
    return pressed / (1 + 0.213 * sliding * np.power(loading, 0.64))


def hsu_lee(loading: Values, slide_roll_ratio: Values, material: Values, load: Values) -> Values:
    """Hsu and Lee's factor [-], 1/(1 + 0.0766 G^0.687 W^0.447 L^0.527 e^(0.875 S)), S = SRR.

    G = alpha E' and W = w/(E' R). Source: C. H. Hsu and R. T. Lee, J. Tribol. 116 (1994) 540-548; from
    memory, checked by its limit 1 without heating only. Range: line contacts.
    """
    _check(loading, slide_roll_ratio)
    within("G", material, 0, 2e4, "")
    within("W", load, 0, 1e-2, "")
    groups = 0.0766 * np.power(material, 0.687) * np.power(load, 0.447)
    return 1 / (1 + groups * np.power(loading, 0.527) * np.exp(0.875 * np.abs(slide_roll_ratio)))


def _check(loading: Values, slide_roll_ratio: Values) -> None:
    within("thermal loading L", loading, 0, 1e4, "")
    within("slide-roll ratio", slide_roll_ratio, -2, 2, "")
