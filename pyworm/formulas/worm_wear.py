"""Wear of worm wheels by the worm-gear standard: factors, intensity and depth in a life.

From a public transcription of DIN 3996 (the worksheet on worm gears of MITCalc).
"""

from pyworm.formulas.ranges import positive, within
from pyworm.formulas.worm_curves import Lubrication, OilKind, base_wear
from pyworm.formulas.worm_wheel_material import Family

MOST_STARTS = 4.0
"""Largest W_NS [-]."""


def structure_factor(oil: OilKind, viscosity: float, family: Family = "tin bronze") -> float:
    """W_S of the oil's structure [-], eta^-0.35; 1 of mineral oil, and of PAO on cast iron.

    eta, at the wheel's bulk temperature, counts in Pa s, so that W_S is no pure number: a factor of a
    regression.
    """
    within("dynamic viscosity", viscosity, 1e-4, 10, "Pa s")
    if oil == "mineral" or (oil == "PAO" and family == "cast iron"):
        return 1.0
    return float(viscosity**-0.35)


def pressure_factor(mean_pressure: float, family: Family = "tin bronze") -> float:
    """W_H of the pressure [-]: 1 to 450 MPa, (450 MPa/sigma_Hm)^4.5 above.

    Of cast iron (300 MPa/sigma_Hm)^1.4.
    """
    within("mean contact stress", mean_pressure, 1e6, 1e10, "Pa")
    if family == "cast iron":
        return float((300e6 / mean_pressure) ** 1.4)
    return float(min((450e6 / mean_pressure) ** 4.5, 1.0))


def start_factor(starts_per_hour: float) -> float:
    """W_NS of starts [-], 1 + 0.015 N_S, at most 4."""
    within("starts per hour", starts_per_hour, 0, 1e5, "1/h")
    return min(1 + 0.015 * starts_per_hour, MOST_STARTS)


def wear_intensity(
    oil: OilKind,
    film: float,
    structure: float = 1.0,
    pressure: float = 1.0,
    lubrication: Lubrication = "injection",
    family: Family = "tin bronze",
) -> float:
    """Base wear J_0T [-] at K_W = h_min,m W_S W_H with the film, given in m, in micrometres."""
    within("mean minimum film thickness", film, 1e-9, 1e-4, "m")
    positive("W_S", structure, "")
    positive("W_H", pressure, "")
    return base_wear(oil, film * 1e6 * structure * pressure, lubrication, family)


def sliding_path(
    sliding_parameter: float,
    mean_pressure: float,
    centre_distance: float,
    reduced_modulus: float,
    cycles: float,
) -> float:
    """Path s_Wm [m] that the worm slides over a place of the wheel's flanks, s* sigma_Hm a/E_red N_L.

    N_L is the number of turns of the wheel. Checked by dimension.
    """
    positive("s*", sliding_parameter, "")
    within("mean contact stress", mean_pressure, 1e6, 1e10, "Pa")
    within("centre distance", centre_distance, 0.025, 2, "m")
    within("reduced modulus", reduced_modulus, 1e10, 1e12, "Pa")
    positive("load cycles", cycles, "")
    return sliding_parameter * mean_pressure * centre_distance / reduced_modulus * cycles


def wear_depth(
    intensity: float,
    sliding_parameter: float,
    mean_pressure: float,
    centre_distance: float,
    reduced_modulus: float,
    cycles: float,
) -> float:
    """Depth [m] worn off the wheel's flanks: J_W (`wear_intensity`, W_NS, W_ML) times `sliding_path`."""
    within("wear intensity", intensity, 1e-30, 1e-3, "")
    return intensity * sliding_path(
        sliding_parameter, mean_pressure, centre_distance, reduced_modulus, cycles
    )
