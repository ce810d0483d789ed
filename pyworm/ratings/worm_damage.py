"""Flanks of a worm gear against what their oil bears between steel gears: for comparison, not a rating."""

import numpy as np

from pyworm.case.ratings import WormRatingTable
from pyworm.drives.duty import WormDuty
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.materials.base_stock import Base
from pyworm.materials.oil import Oil
from pyworm.ratings.flank_damage import Limit, film_limit, scuffing_limit, simulated_spots
from pyworm.ratings.flank_table import flank_table
from pyworm.ratings.rating import Rating
from pyworm.ratings.worm_loads import MEAN_TO_RMS
from pyworm.result.flank_map import flank_map
from pyworm.result.headline import of_all
from pyworm.result.result import Result

NO_RATING = (
    "ISO/TS 14521 and DIN 3996 rate neither scuffing nor micropitting of worm gears. S_B and S_lambda are "
    "those that steel gears would have with this oil: bronze seizes at other temperatures and wears before "
    "it pits, so that they compare variants and decide nothing."
)


def worm_flanks(
    table: WormRatingTable, duty: WormDuty, oil: Oil, base: Base, result: Result
) -> Rating:
    """Simulated contact temperatures and specific films of a worm gear at every solved contact.

    Parameters
    ----------
    table : WormRatingTable
        Tests of the oil.
    duty : WormDuty
        The worm gear.
    oil : Oil
        Its oil, as it enters the contacts.
    base : str
        Base stock of the oil.
    result : Result
        Solved contacts that converged.
    """
    limits = scuffing_limit(table, oil, base), film_limit(table, oil, base)
    roughness = MEAN_TO_RMS * float(np.mean(duty.roughness))
    return flank_table(
        simulated_spots(result.solutions),
        limits,
        None if oil.heat is None else oil.heat.inlet_temperature,
        roughness,
        of_all(result.solutions),
        words=(NO_RATING, *_limits(limits), *_over_the_flank(limits, roughness, result)),
    )


def _limits(limits: tuple[Limit, Limit]) -> tuple[str, ...]:
    """What the oil bears, or why that is not known."""
    hot, thin = limits
    return (
        f"No S_B: {hot.why}."
        if hot.value is None
        else f"Scuffing temperature {hot.value - ZERO_CELSIUS:.0f} °C ({hot.by}).",
        f"No S_lambda: {thin.why}."
        if thin.value is None
        else f"Permissible specific film {thin.value:.3g} ({thin.by}).",
    )


def _over_the_flank(
    limits: tuple[Limit, Limit], roughness: float, result: Result
) -> tuple[str, ...]:
    """Fractions of the wheel's flank in contact that are beyond the limits, over the solved cycle."""
    places = flank_map(result)
    if places is None:
        return ()
    touched = places["film"].notnull()
    told = []
    if limits[0].value is not None and "temperature_body_2" in places:
        beyond = (places["temperature_body_2"] > limits[0].value).where(touched)
        told.append(f"{float(beyond.mean()):.1%} is hotter than the scuffing temperature")
    if limits[1].value is not None:
        beyond = (places["film"] / roughness < limits[1].value).where(touched)
        told.append(f"{float(beyond.mean()):.1%} has less than the permissible specific film")
    return (f"Of the wheel's flank in contact, {' and '.join(told)}.",) if told else ()
