"""Requirements of the oil of a drive: from `[oil_choice]` to a `OilDuty`."""

from pyworm.case.ratings import OilChoiceTable
from pyworm.case.table import plain
from pyworm.case.worm_conditions import MEAN_TO_RMS
from pyworm.drives.drive import Drive
from pyworm.drives.duty import GearPairDuty, WormDuty
from pyworm.formulas import gear_oil
from pyworm.formulas.bearing_life import reference_viscosity
from pyworm.formulas.worm_losses import other_losses
from pyworm.formulas.worm_standard import forward_efficiency, mean_pressure, static_friction
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.materials.library import named_oil
from pyworm.materials.oil_requirements import OilRequirements
from pyworm.ratings.no_load import rotors_no_load, worm_no_load
from pyworm.ratings.oil_choice import OilChoice, choose_oil
from pyworm.ratings.oil_grades import GearTeeth, OilDuty, line_film, worm_film
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
        **vars(plain(table, OilRequirements)),
        **_bearing(request),
    }
    duty = request.duty
    if isinstance(duty, GearPairDuty):
        return OilDuty(**common, **_gear_pair(duty, table, present(request.drive, "drive")))
    if isinstance(duty, WormDuty):
        return OilDuty(**common, **_worm(duty, table, request))
    raise CaseError("no oil can be chosen for gears of this kind")


def _worm(duty: WormDuty, table: OilChoiceTable, request: RatingRequest) -> dict:
    """Requirement of a worm gear set."""
    gear, speed = duty.gear, duty.worm_speed
    a, rating = gear.centre_distance, request.worm_rating
    bearings = "adjusted" if rating is None else rating.bearings
    stated = duty.wheel_material or (None if rating is None else rating.wheel_material)
    friction = static_friction(a, MEAN_TO_RMS * present(duty.roughness[0], "bodies.worm.roughness"))
    pressure = mean_pressure(gear.pressure_parameter, duty.torque, duty.reduced_modulus, a)
    return {
        "film": worm_film(gear, speed, duty.torque, duty.reduced_modulus, table.base),
        "roughness": duty.composite_roughness,
        "tables": (
            gear_oil.agma_worm(a, speed, table.ambient_temperature),
            gear_oil.worm_table(a, speed, table.sump_temperature, synthetic=table.base == "PAG"),
            gear_oil.hobbed_wheel(),
        ),
        "teeth": GearTeeth(
            worm=True,
            velocity=gear.sliding_speed(speed),
            pressure=pressure,
            fast_shaft=speed,
            fast_torque=duty.torque / gear.ratio,
            starting_torque=duty.torque / gear.ratio / forward_efficiency(gear.tan_lead, friction),
            wheel_material=stated,
        ),
        "no_load": worm_no_load(duty, bearings, request.mean_diameters).fitted(
            other_losses(gear, speed, duty.torque, bearings).churning,
            named_oil(f"{table.base} VG {table.sump_grade}"),
            table.sump_temperature,
        ),
    }


def _gear_pair(duty: GearPairDuty, table: OilChoiceTable, drive: Drive) -> dict:
    """Requirement of a gear pair, by the thinnest film along the line of action."""
    if duty.composite_roughness is None:
        raise CaseError("bodies.pinion.roughness or bodies.gear.roughness is missing")
    line = duty.line_of_action
    thin, hottest = line.thinnest, line.contact_temperature
    rotors = sorted(present(drive.rotors, "rotors"), key=lambda rotor: -rotor.speed)
    velocity = duty.pitch_line_velocity
    return {
        "film": line_film(
            float(line.radius[thin]),
            float(line.unit_load[thin]),
            duty.reduced_modulus,
            float(line.entrainment[thin]),
        ),
        "roughness": duty.composite_roughness,
        "pitch_line_velocity": velocity,
        "tables": (
            gear_oil.agma_parallel(duty.centre_distance, table.ambient_temperature, velocity),
        ),
        "teeth": GearTeeth(
            worm=False,
            velocity=velocity,
            pressure=float(line.hertz_pressure.max()),
            fast_shaft=rotors[0].speed,
            fast_torque=rotors[0].torque,
            starting_torque=rotors[0].torque,
        ),
        "no_load": rotors_no_load(rotors),
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
