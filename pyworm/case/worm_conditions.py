"""Conditions that a worm gear is rated for, from the tables of its case and its operating point."""

from dataclasses import replace
from pathlib import Path

from pyworm.case.ratings import CompletedRating
from pyworm.drives.duty import WormDuty
from pyworm.formulas.ranges import one_of
from pyworm.formulas.unit_factors import DEGREES_40, RPM
from pyworm.formulas.unknown import Unknown, attempt, known
from pyworm.formulas.worm_curves import OIL_KINDS, OilKind
from pyworm.formulas.worm_losses import sump_temperature
from pyworm.formulas.worm_rating import WormConditions, WormRating
from pyworm.formulas.worm_wheel_material import WheelMaterial, wheel_material
from pyworm.materials.library import NamedOil
from pyworm.materials.oil_file import oil_called

MEAN_TO_RMS = 0.8
"""Ra over Rq where heights are spread normally, sqrt(2/pi); the standards' friction takes Ra."""


def standard_oil(table: CompletedRating, directory: Path) -> NamedOil | Unknown:
    """The oil of a rating, if the standards have constants for it; CaseError for an unknown name."""
    if table.oil is None:
        return Unknown("worm_rating.oil is missing, an oil with a base stock of the standards")
    oil = oil_called(table.oil, directory)
    if oil.stock.name in OIL_KINDS:
        return oil
    return Unknown(
        f'worm_rating.oil = "{table.oil}": the standards know {", ".join(OIL_KINDS)} only'
    )


def _kind(oil: NamedOil) -> OilKind:
    return one_of("oil", oil.stock.name, OIL_KINDS)


def material_of(table: CompletedRating) -> WheelMaterial | Unknown:
    """The wheel's material by the standard."""
    if table.wheel_material is None:
        return Unknown("worm_rating.wheel_material is missing")
    return wheel_material(table.wheel_material)


def sump_by_standard(
    table: CompletedRating,
    duty: WormDuty,
    oil: NamedOil | Unknown,
    torque: float,
    speed: float,
    fan: bool,
) -> float:
    """Temperature of the sump of a usual housing by the standard [K]; ValueError outside its range."""
    found = known(oil)
    return sump_temperature(
        duty.gear,
        speed,
        torque,
        _kind(found),
        float(found.kinematic_viscosity(DEGREES_40)),
        table.ambient_temperature,
        fan,
    )


def conditions(
    table: CompletedRating,
    duty: WormDuty,
    oil: NamedOil | Unknown,
    torque: float,
    speed: float,
    hours: float | Unknown,
) -> WormConditions:
    """Conditions of one load of a worm gear that lasts some hours.

    The torque is the wheel's without its application factor [N m], the speed the worm's [rad/s]. The oil
    between the teeth is as warm as the wheel's flanks, whose temperature follows from friction alone. Those
    of the drive's own operating point are its own.
    """
    at_duty_point = (torque, speed) == (duty.torque, duty.worm_speed)
    rough = duty.roughness[0]
    cold = WormConditions(
        oil=attempt(lambda: _kind(known(oil))),
        viscosity=Unknown("the wheel's bulk temperature is not known"),
        worm_speed=speed,
        torque=torque * table.application_factor,
        reduced_modulus=duty.reduced_modulus,
        roughness=(
            Unknown("bodies.worm.roughness is missing") if rough is None else MEAN_TO_RMS * rough
        ),
        lubrication=table.lubrication,
        material=material_of(table),
        material_factor=table.material_factor,
        life=hours,
        structure_factor=table.structure_factor,
        pressure_factor=table.pressure_factor,
        starts_per_hour=table.starts_per_hour,
        wheel_temperature=duty.wheel_temperature if at_duty_point else None,
        immersion_factor=table.immersion_factor,
        rim=table.rim_over_module,
        bearings=table.bearings,
        other_loss=duty.other_loss,
        driver=duty.driver,
    )
    sump = _sump(table, duty, oil, torque, cold)
    warm = replace(
        cold,
        sump_temperature=sump,
        supplied_viscosity=attempt(lambda: float(known(oil).kinematic_viscosity(known(sump)))),
    )
    hot = attempt(lambda: WormRating(duty.gear, warm).bulk_temperature)
    return replace(warm, viscosity=attempt(lambda: float(known(oil).viscosity(known(hot)))))


def _sump(
    table: CompletedRating,
    duty: WormDuty,
    oil: NamedOil | Unknown,
    torque: float,
    cold: WormConditions,
) -> float | Unknown:
    """Temperature of the oil in the sump [K]: of the drive, given, by its cooling, or the standard's."""
    at_duty_point = (torque, cold.worm_speed) == (duty.torque, duty.worm_speed)
    conductance = duty.conductance
    if conductance is not None and not at_duty_point:
        rated = WormRating(duty.gear, cold)
        return attempt(
            lambda: (
                table.ambient_temperature
                + (rated.nearest_loss.driven_by(duty.driver) + rated.other_power) / conductance
            )
        )
    if duty.oil_temperature is not None:
        return duty.oil_temperature
    if table.sump_temperature is not None:
        return table.sump_temperature
    found = attempt(lambda: sump_by_standard(table, duty, oil, torque, cold.worm_speed, table.fan))
    if not isinstance(found, Unknown):
        return found
    load_text = f"{torque:.4g} N m and {cold.worm_speed * RPM:.4g} rpm"
    return Unknown(
        f"the standard has no temperature of the sump at {load_text} ({found.why}); give "
        "worm_rating.sump_temperature"
    )
