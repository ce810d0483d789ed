"""A worm gear rated by the standards under each load of its life."""

from dataclasses import dataclass, replace
from pathlib import Path

from pyworm.case.ratings import WormRatingTable
from pyworm.drives.duty import WormDuty
from pyworm.formulas.unit_factors import DEGREES_40
from pyworm.formulas.worm_curves import OIL_KINDS
from pyworm.formulas.worm_losses import sump_temperature
from pyworm.formulas.worm_rating import WormConditions, WormRating, rate_worm
from pyworm.formulas.worm_wheel_material import WHEEL_MATERIALS, WheelMaterial
from pyworm.io.input_error import CaseError
from pyworm.materials.library import NamedOil
from pyworm.materials.oil_file import oil_called

MEAN_TO_RMS = 0.8
"""Ra over Rq where heights are spread normally, sqrt(2/pi); the standards' friction takes Ra."""

HOUR = 3600.0
"""[s]."""


@dataclass(frozen=True)
class RatedLoad:
    """A load of a worm gear's life and what the standards make of it.

    Attributes
    ----------
    torque, worm_speed : float
        T2 with its application factor [N m], and speed of the worm [rad/s].
    hours : float or None
        How long it lasts [h]; None where no life is given.
    sump : float
        Temperature of the oil in the sump, or injected [K].
    conditions : WormConditions
        What it was rated for.
    rated : WormRating
        Its figures.
    """

    torque: float
    worm_speed: float
    hours: float | None
    sump: float
    conditions: WormConditions
    rated: WormRating


def standard_oil(table: WormRatingTable, directory: Path) -> NamedOil:
    """The oil of `[worm_rating]`; CaseError for one that the standards have no constants for."""
    oil = oil_called(table.oil, directory)
    if oil.stock.name not in OIL_KINDS:
        raise CaseError(
            f'worm_rating.oil = "{table.oil}": the standards know {", ".join(OIL_KINDS)} only'
        )
    return oil


def wheel_material(table: WormRatingTable) -> WheelMaterial | None:
    """The wheel's material; None where the case does not give it."""
    return None if table.wheel_material is None else WHEEL_MATERIALS[table.wheel_material]


def sump_by_standard(
    table: WormRatingTable, duty: WormDuty, oil: NamedOil, torque: float, speed: float, fan: bool
) -> float:
    """Temperature of the sump of a usual housing by the standard [K]."""
    return sump_temperature(
        duty.gear,
        speed,
        torque,
        oil.stock.name,
        float(oil.kinematic_viscosity(DEGREES_40)),
        table.ambient_temperature,
        fan,
    )


def rated_loads(table: WormRatingTable, duty: WormDuty, directory: Path) -> tuple[RatedLoad, ...]:
    """The worm gear under each load of its spectrum, else under that of the drive in the life that is given.

    Raises
    ------
    CaseError
        An oil that the standards have no constants for.
    ValueError
        What lies outside the methods.
    """
    oil = standard_oil(table, directory)
    if table.spectrum:
        steps = [(of.wheel_torque, of.worm_speed, of.duration / HOUR) for of in table.spectrum]
    else:
        life = None if table.life is None else table.life / HOUR
        steps = [(duty.torque, duty.worm_speed, life)]
    return tuple(_rated(table, duty, oil, *step) for step in steps)


def _rated(
    table: WormRatingTable,
    duty: WormDuty,
    oil: NamedOil,
    torque: float,
    speed: float,
    hours: float | None,
) -> RatedLoad:
    """The oil is as warm as the wheel's flanks, whose temperature follows from friction alone."""
    sump = table.sump_temperature
    if sump is None:
        sump = sump_by_standard(table, duty, oil, torque, speed, table.fan)
    conditions = WormConditions(
        oil=oil.stock.name,
        viscosity=float(oil.viscosity(sump)),
        worm_speed=speed,
        torque=torque * table.application_factor,
        reduced_modulus=duty.reduced_modulus,
        roughness=MEAN_TO_RMS * duty.roughness[0],
        lubrication=table.lubrication,
        material=wheel_material(table),
        material_factor=table.material_factor,
        life=hours,
        structure_factor=table.structure_factor,
        pressure_factor=table.pressure_factor,
        starts_per_hour=table.starts_per_hour,
        sump_temperature=sump,
        supplied_viscosity=float(oil.kinematic_viscosity(sump)),
        immersion_factor=table.immersion_factor,
        rim=table.rim_over_module,
        bearings=table.bearings,
    )
    hot = rate_worm(duty.gear, conditions).bulk_temperature
    conditions = replace(conditions, viscosity=float(oil.viscosity(hot)))
    rated = rate_worm(duty.gear, conditions)
    return RatedLoad(conditions.torque, speed, hours, sump, conditions, rated)


def hardest(loads: tuple[RatedLoad, ...]) -> RatedLoad:
    """The load with the largest torque."""
    return max(loads, key=lambda of: of.torque)
