"""What an oil has to do in the drive of a case: from `[oil_choice]` to a `Duty`."""

import numpy as np

from pyworm.case.ratings import BearingTable, OilChoiceTable
from pyworm.drives.gear_pair.drive import GearPairDrive
from pyworm.formulas import gear_oil
from pyworm.formulas.bearing_life import reference_viscosity
from pyworm.io.input_error import CaseError
from pyworm.materials.body import composite_roughness
from pyworm.ratings.oil_choice import OilChoice, choose_oil
from pyworm.ratings.oil_grades import Duty, line_film, worm_film
from pyworm.ratings.rated_case import Asked
from pyworm.ratings.worm import WormDuty


def oil_choice(asked: Asked) -> OilChoice:
    """The oil for the drive of a case, and how it was found.

    Raises
    ------
    CaseError
        The case does not say what the oil is to do, or no oil does it.
    """
    try:
        return choose_oil(oil_duty(asked))
    except ValueError as error:
        raise CaseError(f"{asked.name}: {error}") from error


def oil_duty(asked: Asked) -> Duty:
    """What the oil has to do in the drive of a case; ValueError where the case does not say it."""
    table = asked.tables.oil_choice
    if table is None:
        raise CaseError("[oil_choice] is missing; it says what the oil is to do")
    common = {
        "name": asked.tables.title,
        **table.model_dump(),
        **_bearing(asked.tables.bearings),
    }
    if isinstance(asked.drive, GearPairDrive):
        return Duty(**common, **_gear_pair(asked.drive, table))
    return Duty(**common, **_worm(asked.worm_duty, table))


def _worm(duty: WormDuty, table: OilChoiceTable) -> dict:
    a, speed = duty.gear.centre_distance, duty.worm_speed
    return {
        "film": worm_film(duty.gear, speed, duty.torque, duty.reduced_modulus, table.base),
        "roughness": duty.composite_roughness,
        "tables": (
            gear_oil.agma_worm(a, speed, table.ambient_temperature),
            gear_oil.worm_table(a, speed, table.sump_temperature, synthetic=table.base == "PAG"),
        ),
    }


def _gear_pair(drive: GearPairDrive, table: OilChoiceTable) -> dict:
    """The thinnest film along the line of action is what counts."""
    roughness = composite_roughness(*drive.bodies)
    if roughness is None:
        raise CaseError("bodies.pinion.roughness or bodies.gear.roughness is missing")
    phases = drive.cycle_phases()
    contacts = drive.contacts(phases)
    rated = drive.rating(contacts)
    thin = int(np.argmin(rated.film_min))
    hottest = rated.contact_temperature
    return {
        "film": line_film(
            float(contacts.radius[thin]),
            float(contacts.unit_load[thin]),
            drive.reduced_modulus,
            float(contacts.entrainment[thin]),
        ),
        "roughness": roughness,
        "pitch_line_velocity": drive.pitch_line_velocity,
        "tables": (gear_oil.agma_parallel(drive.teeth.centre_distance, table.ambient_temperature),),
        "contact_temperature": None if hottest is None else float(hottest.max()),
    }


def _bearing(bearings: dict[str, BearingTable]) -> dict[str, float]:
    """The bearing that wants the thickest oil."""
    if not bearings:
        return {}
    thirsty = max(
        bearings.values(), key=lambda one: reference_viscosity(one.speed, one.mean_diameter)
    )
    return {"bearing_speed": thirsty.speed, "bearing_diameter": thirsty.mean_diameter}
