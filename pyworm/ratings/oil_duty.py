"""Requirements of the oil of a drive: from `[oil_choice]` to a `OilDuty`."""

from pyworm.case.ratings import OilChoiceTable
from pyworm.drives.duty import GearPairDuty, WormDuty
from pyworm.formulas import gear_oil
from pyworm.formulas.bearing_life import reference_viscosity
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.ratings.oil_choice import OilChoice, choose_oil
from pyworm.ratings.oil_grades import OilDuty, line_film, worm_film
from pyworm.ratings.rated_case import RatingRequest


def oil_choice(request: RatingRequest) -> OilChoice:
    """The oil for a case's drive, with the steps; CaseError without its duty or a fitting oil."""
    try:
        return choose_oil(oil_duty(request))
    except ValueError as error:
        raise CaseError(f"{request.name}: {error}") from error


def oil_duty(request: RatingRequest) -> OilDuty:
    """Requirements of the oil in the drive of a case; ValueError where they are not given."""
    table = request.tables.oil_choice
    if table is None:
        raise CaseError("[oil_choice] is missing; it says what the oil is to do")
    common = {
        "name": request.tables.title,
        **table.model_dump(),
        **_bearing(request),
    }
    duty = request.duty
    if isinstance(duty, GearPairDuty):
        return OilDuty(**common, **_gear_pair(duty, table))
    if isinstance(duty, WormDuty):
        return OilDuty(**common, **_worm(duty, table))
    raise CaseError("no oil can be chosen for gears of this kind")


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


def _gear_pair(duty: GearPairDuty, table: OilChoiceTable) -> dict:
    """Requirement of a gear pair, by the thinnest film along the line of action."""
    if duty.composite_roughness is None:
        raise CaseError("bodies.pinion.roughness or bodies.gear.roughness is missing")
    line = duty.line_of_action
    thin, hottest = line.thinnest, line.contact_temperature
    return {
        "film": line_film(
            float(line.radius[thin]),
            float(line.unit_load[thin]),
            duty.reduced_modulus,
            float(line.entrainment[thin]),
        ),
        "roughness": duty.composite_roughness,
        "pitch_line_velocity": duty.pitch_line_velocity,
        "tables": (gear_oil.agma_parallel(duty.centre_distance, table.ambient_temperature),),
        "contact_temperature": None if hottest is None else float(hottest.max()),
    }


def _bearing(request: RatingRequest) -> dict[str, float]:
    """The bearing that needs the highest viscosity."""
    bearings = request.tables.bearings
    if not bearings:
        return {}
    runs = [
        (
            request.bearing_speed(bearing),
            present(bearing.mean_diameter, f"bearings.{name}.mean_diameter"),
        )
        for name, bearing in bearings.items()
    ]
    speed, diameter = max(runs, key=lambda run: reference_viscosity(*run))
    return {"bearing_speed": speed, "bearing_diameter": diameter}
