"""One wheel, one sump and one cooling in one file: a rating states nothing that the drive contradicts."""

from collections.abc import Iterator
from math import exp, log

from pyworm.case.bodies import BodyTable
from pyworm.case.oil import OilTable
from pyworm.case.ratings import WormRatingTable
from pyworm.case.worm_cooling import WormCoolingTable
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.materials.body import Body
from pyworm.materials.solids import alloy

ONE_MODULUS = 1.5
"""Ratio of Young's moduli from which two materials are not the same: bronzes and irons differ by less."""

ONE_TEMPERATURE = 0.5
"""Difference below which two temperatures are the same [K]."""


def other_material(rating: WormRatingTable, wheel: BodyTable) -> Iterator[str]:
    """Sentences on a second material of the wheel.

    Another casting of the same alloy has other strengths and the same contacts: the rating says so.
    """
    rated, body = rating.wheel_material, wheel.material
    if rated is None:
        return
    if body is not None and alloy(rated) != alloy(body):
        yield (
            f'worm_rating.wheel_material = "{rated}", but bodies.wheel.material = "{body}": one wheel is of '
            "one material; leave the first out, and change the second to compare materials"
        )
    softest, stiffest = _moduli(Body.from_name(rated))
    modulus = min(max(wheel.youngs_modulus, softest), stiffest)
    if exp(abs(log(wheel.youngs_modulus / modulus))) > ONE_MODULUS:
        yield (
            f'worm_rating.wheel_material = "{rated}" has {modulus / 1e9:.4g} GPa, but '
            f"bodies.wheel.youngs_modulus is {wheel.youngs_modulus / 1e9:.4g} GPa: one wheel is of one "
            "material"
        )


def _moduli(body: Body) -> tuple[float, float]:
    """Smallest and largest Young's modulus of a solid, hot and cold [Pa]."""
    moduli = [modulus for _, modulus in body.modulus_by_temperature] or [body.youngs_modulus]
    return min(moduli), max(moduli)


def other_temperature(rating: WormRatingTable, oil: OilTable, cooled: bool) -> Iterator[str]:
    """Sentences on a second temperature of the oil in the sump."""
    sump = rating.sump_temperature
    if sump is None or oil.heat is None:
        return
    if cooled:
        yield "worm_rating.sump_temperature has no effect with [cooling], which finds it"
    inlet = oil.heat.inlet_temperature
    if abs(sump - inlet) > ONE_TEMPERATURE:
        yield (
            f"worm_rating.sump_temperature = {sump - ZERO_CELSIUS:.4g} degC, but the oil enters at "
            f"{inlet - ZERO_CELSIUS:.4g} degC (oil.temperature or oil.heat.inlet_temperature): one sump has "
            "one temperature; leave the first out"
        )


def other_cooling(rating: WormRatingTable, cooling: WormCoolingTable) -> Iterator[str]:
    """Sentences on a second statement about what cools the drive, or about its bearings."""
    pairs = {
        "ambient_temperature": ("ambient_temperature", ONE_TEMPERATURE),
        "immersion_factor": ("immersion", 0.0),
        "bearings": ("bearings", None),
    }
    for key, (name, apart) in pairs.items():
        rated, balanced = getattr(rating, key), getattr(cooling, name)
        if rated is None or rated == balanced:
            continue
        if apart is None or abs(rated - balanced) > apart:
            yield (
                f"worm_rating.{key} = {rated!r} differs from cooling.{name} = {balanced!r}: leave the "
                "first out"
            )
