"""Micropitting of gear teeth by ISO/TS 6336-22: the specific film at each contact against a permissible one.

The standard's text was not available; its formulas are those of ISO/TR 15144-1 as a public program has them
with equation numbers, and factors from memory are named (`docs/reference/scuffing-and-micropitting.md`). All
arguments are in SI, temperatures in kelvin.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi

import numpy as np

from pyworm.formulas.arrays import Array, Values
from pyworm.formulas.film import line_groups
from pyworm.formulas.ranges import positive, within
from pyworm.formulas.scuffing import flash_temperature

SOURCE = "ISO/TS 6336-22:2018 (as ISO/TR 15144-1), by a public program"

FRICTION_FACTORS = {"mineral": 1.0, "PAO": 0.8, "ester": 0.8, "PAG": 0.7}
"""X_L by base stock (ISO/TR 15144-1, table 3): polyglycols not soluble in water; esters assumed as PAO."""

TEST_FACTOR = 1.4
"""Permissible specific film over that of the test gears at the load stage that fails them."""


@dataclass(frozen=True)
class GearOil:
    """An oil as this rating needs it."""

    viscosity: Callable[[Array], Array]
    """Dynamic viscosity [Pa s] of temperatures [K], at ambient pressure."""
    alpha: Callable[[Array], Array]
    """Pressure-viscosity coefficient [1/Pa] of temperatures [K], at ambient pressure."""
    friction_factor: float
    """X_L, `FRICTION_FACTORS` [-]."""


@dataclass(frozen=True)
class Flanks:
    """Contacts of two flanks along their line of action."""

    radius: Array
    """Relative radius of curvature [m]."""
    unit_load: Array
    """Normal load for each length [N/m]."""
    speed_1: Array
    """Speed of surface 1 across the contact line [m/s]."""
    speed_2: Array
    """Speed of surface 2 across the contact line [m/s]."""
    modulus: float
    """Reduced modulus E' [Pa]."""
    effusivities: tuple[float, float]
    """Thermal contact coefficients of both bodies [N/(m s^0.5 K)]."""
    roughness: float
    """Ra, mean of both flanks [m]."""

    @property
    def half_width(self) -> Array:
        """Half-widths of the Hertz contacts [m]."""
        half_width: Array = np.sqrt(8 * self.unit_load * self.radius / (pi * self.modulus))
        return half_width


@dataclass(frozen=True)
class MicropittingFilms:
    """What the standard makes of contacts along a line of action."""

    friction: float
    """Mean coefficient of friction mu_m [-]."""
    contact_temperature: Array
    """theta_B, bulk plus flash [K]."""
    film: Array
    """Local film h_Y [m]."""
    specific_film: Array
    """lambda_GF, over the mean Ra [-]."""


def mean_friction(
    unit_load: float,
    sum_speed: float,
    radius: float,
    viscosity: float,
    roughness: float,
    friction_factor: float,
) -> float:
    """Mean coefficient of friction mu_m [-], of the pitch point.

        0.045 (w/(v_sum rho))^0.2 (1000 eta)^-0.05 X_R X_L,  X_R = 2.2 (Ra/rho)^0.25

    with w, all load factors in it, in N/mm, v_sum of both surfaces in m/s, rho in mm, eta of the oil as fed
    in Pa s, Ra, mean of both flanks, in um; arguments in SI units. Source: ISO/TR 15144-1, equations 86, 87;
    within 20 % of Schlenk's 0.048 ... eta^-0.05 Ra^0.25 X_L where rho is some 10 mm.
    """
    within("load per length", unit_load, 1, 1e8, "N/m")
    positive("sum of speeds", sum_speed, "m/s")
    within("radius of curvature", radius, 1e-4, 10, "m")
    within("viscosity", viscosity, 1e-4, 100, "Pa s")
    within("roughness", roughness, 1e-9, 1e-4, "m")
    radius_mm, roughness_um = radius * 1e3, roughness * 1e6
    rough = 2.2 * (roughness_um / radius_mm) ** 0.25
    loaded = (unit_load * 1e-3 / (sum_speed * radius_mm)) ** 0.2
    return float(0.045 * loaded * (1e3 * viscosity) ** -0.05 * rough * friction_factor)


def micropitting_films(
    flanks: Flanks, oil: GearOil, oil_temperature: float, bulk_temperature: float
) -> MicropittingFilms:
    """Local films and specific films by the standard, at temperatures of oil as fed and of flanks [K].

        h_Y = 1600 rho G^0.6 U^0.7 W^-0.13 S^0.22

    of the oil at the flanks' bulk temperature: Dowson and Higginson's 1.6 G^0.6 U^0.7 W^-0.13 of 1966, since
    2 pi (p/E')^2 is w/(E' rho). S is alpha eta at the local contact temperature over that at the bulk's; the
    flash temperature is Blok's (`scuffing.flash_temperature`) with the mean friction.
    """
    within("bulk temperature", bulk_temperature, 200, 700, "K")
    pitch = int(np.argmin(np.abs(flanks.speed_1 - flanks.speed_2)))
    friction = mean_friction(
        float(flanks.unit_load.max()),
        float(flanks.speed_1[pitch] + flanks.speed_2[pitch]),
        float(flanks.radius[pitch]),
        float(oil.viscosity(np.asarray(oil_temperature))),
        flanks.roughness,
        oil.friction_factor,
    )
    flash = flash_temperature(
        friction,
        flanks.unit_load,
        flanks.speed_1,
        flanks.speed_2,
        *flanks.effusivities,
        flanks.half_width,
    )
    hot, bulk = np.asarray(bulk_temperature + flash), np.asarray(bulk_temperature)
    groups = line_groups(
        flanks.radius,
        flanks.unit_load,
        flanks.modulus,
        (flanks.speed_1 + flanks.speed_2) / 2,
        float(oil.viscosity(bulk)),
        float(oil.alpha(bulk)),
    )
    thinned = oil.viscosity(hot) * oil.alpha(hot) / (oil.viscosity(bulk) * oil.alpha(bulk))
    isothermal = 1.6 * groups.material**0.6 * groups.speed**0.7 * groups.load**-0.13
    film = flanks.radius * isothermal * thinned**0.22
    return MicropittingFilms(friction, hot, film, film / flanks.roughness)


def bulk_rise(
    power: float, friction: float, loss_factor: float, centre_distance: float, face_width: float
) -> float:
    """Rise of the teeth's bulk over oil that is injected [K], without tip relief; arguments in SI units.

    7400 (P mu_m H_v/(a b))^0.72 X_S/(1.2 X_Ca), P in kW, a and b in mm, X_S = 1.2 and X_Ca = 1. Source:
    ISO/TR 15144-1, equation 84.
    """
    within("centre distance", centre_distance, 1e-3, 10, "m")
    within("face width", face_width, 1e-4, 10, "m")
    positive("power", power, "W")
    specific_loss = power * 1e-3 * friction * loss_factor / (centre_distance * face_width * 1e6)
    return float(7400 * specific_loss**0.72)


def permissible_specific_film(tested: float, material_factor: float = 1.0) -> float:
    """lambda_GFP [-], 1.4 W_W lambda_GFT, that of `fzg_test_gears.film_at_load_stage`.

    W_W, the `material_factor`, is 1 of case carburised steel (0.95 with more than 25 % of retained
    austenite), 1.5 nitrided, 0.65 induction or flame hardened, 0.5 through hardened.
    """
    positive("specific film thickness of the test", tested, "")
    within("material factor", material_factor, 0.1, 3, "")
    return TEST_FACTOR * material_factor * tested


def micropitting_safety(specific_film: Values, permissible: float) -> Values:
    """S_lambda [-], specific film over the permissible one."""
    positive("permissible specific film thickness", permissible, "")
    return np.asarray(specific_film) / permissible
