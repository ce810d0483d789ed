"""Oils at ambient pressure in closed form: viscosity, density and pressure-viscosity against temperature.

Kinematic viscosities are in m2/s (1 mm2/s = 1 cSt = 1e-6 m2/s), temperatures in kelvin. Formulas whose
constants belong to other units convert inside.
"""

from math import log, log10

import numpy as np
import scipy

from pyworm.formulas.arrays import Values
from pyworm.formulas.ranges import within
from pyworm.formulas.unit_factors import SQUARE_METRE, ZERO_CELSIUS

WALTHER_SHIFT = 0.7
"""Constant [mm2/s] added to the viscosity in ASTM D341 for viscosities above 2 mm2/s."""

COLDEST, HOTTEST = 200.0, 500.0
"""Temperatures [K] between which oils are liquid and these fits are used."""

THINNEST, THICKEST = 1e-7, 1.0
"""Kinematic viscosities [m2/s] between which a number can be one: 0.1 mm2/s to 1e6 mm2/s."""

ROELANDS_POLE_LOG, ROELANDS_POLE_TEMPERATURE = 9.67, 138.0
"""-ln of viscosity [Pa s] and temperature [K] of Roelands' pole (Sharif et al. 2001, eq. 20)."""


def walther_viscosity(m: float, n: float, temperature: Values) -> Values:
    """Kinematic viscosity [m2/s] by log10 log10(nu + 0.7) = m - n log10 T, nu in mm2/s, T in K.

    Source: C. Walther (1931), as standardised in ASTM D341. Range: 200 to 500 K, viscosities above 2 mm2/s;
    below, the standard corrects the shift of 0.7, which here is 0.02 mm2/s at 1.5 mm2/s.
    """
    within("temperature", temperature, COLDEST, HOTTEST, "K")
    shifted = 10 ** (10 ** (m - n * np.log10(temperature)))
    return (shifted - WALTHER_SHIFT) / SQUARE_METRE


def walther_temperature(m: float, n: float, viscosity: Values) -> Values:
    """Temperature [K] of a kinematic viscosity [m2/s]: the inverse of `walther_viscosity`."""
    within("kinematic viscosity", viscosity, 4e-7, THICKEST, "m2/s")
    return 10 ** ((m - double_log(viscosity)) / n)


def walther_constants(
    viscosity_1: float, temperature_1: float, viscosity_2: float, temperature_2: float
) -> tuple[float, float]:
    """m and n of the law through two measured points; viscosities in m2/s, temperatures in K.

    ValueError for values that are no viscosities in m2/s, or a viscosity that does not fall with temperature.
    """
    within("kinematic viscosity", [viscosity_1, viscosity_2], 4e-7, THICKEST, "m2/s")
    within("temperature", [temperature_1, temperature_2], COLDEST, HOTTEST, "K")
    if (viscosity_1 - viscosity_2) * (temperature_2 - temperature_1) <= 0:
        raise ValueError(
            f"viscosities {viscosity_1:g} m2/s at {temperature_1:g} K and {viscosity_2:g} m2/s at "
            f"{temperature_2:g} K: the viscosity must fall with temperature"
        )
    n = float(
        (double_log(viscosity_1) - double_log(viscosity_2)) / log10(temperature_2 / temperature_1)
    )
    return float(double_log(viscosity_1)) + n * log10(temperature_1), n


def walther_slope(n: float, viscosity: Values, temperature: Values) -> Values:
    """-d ln nu / dT [1/K] by Walther at a viscosity [m2/s]: n (nu + 0.7) ln(nu + 0.7) / (nu T)."""
    nu = np.asarray(viscosity) * SQUARE_METRE
    shifted = nu + WALTHER_SHIFT
    return n * shifted * np.log(shifted) / (nu * temperature)


def double_log(viscosity: Values) -> Values:
    """log log of a kinematic viscosity [m2/s], on whose scale the Walther law is straight."""
    return np.log10(np.log10(np.asarray(viscosity) * SQUARE_METRE + WALTHER_SHIFT))


_INDEX_OILS = (
    (2.0, 1.14673, 1.7576, -0.109, 0.84155, 1.5521, -0.077),
    (3.8, 3.38095, -15.4952, 33.196, 0.78571, 1.7929, -0.183),
    (4.4, 2.5, -7.2143, 13.812, 0.82143, 1.5679, 0.119),
    (5.0, 0.101, 16.635, -45.469, 0.04985, 9.1613, -18.557),
    (6.4, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656),
    (7.0, 0.01191, 21.475, -72.870, 0.79762, -0.7321, 14.610),
    (7.7, 0.41858, 16.1558, -56.040, 0.05794, 10.5156, -28.240),
    (9.0, 0.88779, 7.5527, -16.600, 0.26665, 6.7015, -10.810),
    (12.0, 0.7672, 10.7972, -38.180, 0.20073, 8.4658, -22.490),
    (15.0, 0.97305, 5.3135, -2.200, 0.28889, 5.9741, -4.930),
    (18.0, 0.97256, 5.25, -0.980, 0.24504, 7.416, -16.730),
    (22.0, 0.91413, 7.4759, -21.820, 0.20323, 9.1267, -34.230),
    (28.0, 0.87031, 9.7157, -50.770, 0.18411, 10.1015, -46.750),
    (40.0, 0.84703, 12.6752, -133.310, 0.17029, 11.4866, -80.620),
    (55.0, 0.85921, 11.1009, -83.190, 0.1713, 11.368, -76.940),
    (70.0, 0.83531, 14.6731, -216.246, 0.16841, 11.8493, -96.947),
)
"""Viscosity at 100 degC from which a row holds, and L, H as a Y^2 + b Y + c in it [mm2/s]."""


def viscosity_index(viscosity_40: float, viscosity_100: float) -> float:
    """Viscosity index [-] from the kinematic viscosities [m2/s] at 40 and 100 degC.

    With Y at 100 degC and U at 40 degC in mm2/s, L and H those of the reference oils of index 0 and 100 with
    the same Y:

        VI = 100 (L - U)/(L - H)                                up to 100,
        VI = (10^N - 1)/0.00715 + 100, N = log(H/U)/log Y        above.

    Source: ASTM D2270, the polynomials for L and H. From memory; checked by their continuity at all joints
    (0.1 mm2/s or 0.1 %) and by the standard's two examples (92 and 156). Range: Y of 2 mm2/s or more.
    """
    y = viscosity_100 * SQUARE_METRE
    u = viscosity_40 * SQUARE_METRE
    within("kinematic viscosity at 100 degC", viscosity_100, 2e-6, THICKEST, "m2/s")
    if not u > y:
        raise ValueError(
            f"viscosities {viscosity_40:g} m2/s at 40 degC and {viscosity_100:g} m2/s at 100 degC: "
            "the viscosity must fall with temperature"
        )
    _, *constants = max(row for row in _INDEX_OILS if row[0] <= y)
    low = (constants[0] * y + constants[1]) * y + constants[2]
    high = (constants[3] * y + constants[4]) * y + constants[5]
    if u >= high:
        return 100 * (low - u) / (low - high)
    return (10 ** (log(high / u) / log(y)) - 1) / 0.00715 + 100


def viscosity_100_of_index(viscosity_40: float, index: float) -> float:
    """Kinematic viscosity at 100 degC from that at 40 degC [m2/s] and the viscosity index, 0 to 400."""
    within("viscosity index", index, 0, 400, "")
    within("kinematic viscosity at 40 degC", viscosity_40, 6e-6, 1e-2, "m2/s")
    return float(
        scipy.optimize.brentq(
            lambda hot: viscosity_index(viscosity_40, hot) - index,
            2e-6,
            0.9 * viscosity_40,
            xtol=1e-12,
        )
    )


def density(density_15: float, coefficient: float, temperature: Values) -> Values:
    """Density [kg/m3] at a temperature [K] by that at 15 degC, rho15 [1 - c (T - 15 degC)], c in 1/K."""
    within("density at 15 degC", density_15, 600, 2000, "kg/m3")
    within("temperature coefficient of density", coefficient, 0, 2e-3, "1/K")
    within("temperature", temperature, COLDEST, HOTTEST, "K")
    return density_15 * (1 - coefficient * (np.asarray(temperature) - ZERO_CELSIUS - 15))


def dynamic_viscosity(viscosity: Values, density: Values) -> Values:
    """Dynamic viscosity [Pa s], the kinematic one [m2/s] times the density [kg/m3]."""
    within("kinematic viscosity", viscosity, THINNEST, THICKEST, "m2/s")
    within("density", density, 500, 2000, "kg/m3")
    return viscosity * density


def conductivity(density_15: float, temperature: Values) -> Values:
    """Thermal conductivity [W/(m K)] of petroleum oils, 0.12 (1 - 0.0005 t/3)/s.

    s is the density at 15 degC in kg/l, t the temperature in degC. Source: C. S. Cragoe, US Bureau of
    Standards Misc. Publ. 97 (1929), usually printed as 0.117 (1 - 0.00054 t)/s; the constants here are
    those of gear software (GEARpie), 5 % above these at 60 degC. Range: petroleum and other
    hydrocarbons.
    """
    within("density at 15 degC", density_15, 600, 2000, "kg/m3")
    within("temperature", temperature, COLDEST, HOTTEST, "K")
    return 120 / density_15 * (1 - 0.0005 * (np.asarray(temperature) - ZERO_CELSIUS) / 3)


def gold_alpha(viscosity: Values, s: float, t: float) -> Values:
    """Gold's pressure-viscosity coefficient [1/Pa], s nu^t 1e-9 with nu in mm2/s.

    Falls with temperature as the viscosity does. Source: P. W. Gold et al., Tribologie +
    Schmierungstechnik 48 (2001), constants of the base oils in `pyworm/data/oils.toml`. Checked by its
    size: s and t exchanged, as found in print, give 290 /GPa at 220 mm2/s. Range: 1 to 10000 mm2/s;
    measured up to about 200 MPa.
    """
    within("kinematic viscosity", viscosity, 1e-6, 1e-2, "m2/s")
    within("s of Gold's law", s, 3, 20, "")
    within("t of Gold's law", t, 0.05, 0.3, "")
    return s * (np.asarray(viscosity) * SQUARE_METRE) ** t * 1e-9


def agma_alpha(viscosity: Values, k: float, s: float) -> Values:
    """AGMA's pressure-viscosity coefficient [1/Pa], k eta^s in mm2/N with eta in mPa s; the argument in Pa s.

    Source: AGMA 925-A03, section 6.2; from memory, checked against the two values of Errichello's case
    history (mineral oil, 6.6 and 10 cP: 1.02e-4 and 1.09e-4 in2/lb), which it meets within 10 %.
    """
    within("dynamic viscosity", viscosity, 1e-4, 1e3, "Pa s")
    within("k of AGMA's law", k, 1e-3, 0.1, "mm2/N")
    within("s of AGMA's law", s, 0.01, 0.5, "")
    return k * (np.asarray(viscosity) * 1e3) ** s * 1e-6


def eyring_stress(alpha: Values, limit: float) -> Values:
    """Eyring stress [Pa] of an oil whose traction is limited, 2 Lambda/alpha.

    With the viscosity growing as exp(alpha p), Eyring's law makes the stress grow with pressure by tau_E
    alpha per pressure; Arana et al. take the limiting traction coefficient Lambda, limiting stress over
    pressure, for half of it: naphthenic 0.047, paraffinic 0.040, PAO 0.035, ester 0.030.
    """
    within("pressure-viscosity coefficient", alpha, 1e-9, 1e-7, "1/Pa")
    within("limiting traction coefficient", limit, 0.01, 0.2, "")
    return 2 * limit / np.asarray(alpha)
