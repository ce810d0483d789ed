"""What simulation and rating of one worm drive do not share, for the headline of the rating."""

from pyworm.case.ratings import CompletedRating
from pyworm.drives.duty import WormDuty
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.formulas.unknown import Unknown, attempt
from pyworm.ratings.worm_loads import RatedLoad, RatedWormGear

TEMPERATURE_TOLERANCE = 1.0
"""Difference of bulk temperatures that is none [K]."""

TOO_COLD = 10.0
"""How far a given temperature of the oil may lie below the standard's of a housing with a fan [K]."""


def differences(gear_set: RatedWormGear) -> tuple[str, ...]:
    """What simulation and rating of a drive do not share; nothing of a worm gear that is only rated."""
    duty, loads = gear_set.duty, gear_set.loads
    at_duty_speed = [load for load in loads if load.worm_speed == duty.worm_speed] or list(loads)
    return (
        *_material(gear_set.table, duty),
        *_bulk(duty, at_duty_speed[0]),
        *_sump(gear_set, at_duty_speed[0]),
    )


def _material(table: CompletedRating, duty: WormDuty) -> tuple[str, ...]:
    """Another casting than that of the contacts, whose constants are the same."""
    if duty.wheel_material in (table.wheel_material, None):
        return ()
    return (
        f"The wheel is rated as {table.wheel_material} (worm_rating.wheel_material) and simulated as "
        f"{duty.wheel_material} (bodies.wheel.material)",
    )


def _bulk(duty: WormDuty, load: RatedLoad) -> tuple[str, ...]:
    """Bulk temperatures of the wheel that differ."""
    simulated = duty.simulated_wheel_temperature
    rated = attempt(lambda: load.rated.bulk_temperature)
    if (
        simulated is None
        or isinstance(rated, Unknown)
        or abs(rated - simulated) < TEMPERATURE_TOLERANCE
    ):
        return ()
    return (
        f"The wheel is simulated at {simulated - ZERO_CELSIUS:.0f} °C and rated at "
        f"{rated - ZERO_CELSIUS:.0f} °C (the standard's balance); "
        "bodies.wheel.bulk_temperature gives both the same",
    )


def _sump(gear_set: RatedWormGear, load: RatedLoad) -> tuple[str, ...]:
    """A temperature of the oil that is given and colder than any balance has it, or one not shared."""
    sump = load.sump
    if isinstance(sump, Unknown):
        return ()
    coldest = attempt(lambda: min(gear_set.standard_sump(load, fan) for fan in (True, False)))
    given = (gear_set.duty.oil_temperature, gear_set.table.sump_temperature) != (None, None)
    if not given or isinstance(coldest, Unknown) or coldest - sump <= TOO_COLD:
        return ()
    return (
        f"The oil is given as {sump - ZERO_CELSIUS:.0f} °C; by the standard's balance of a usual housing it "
        f"has {coldest - ZERO_CELSIUS:.0f} °C",
    )
