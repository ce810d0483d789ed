"""A pair of involute gears as input of ratings by standards."""

from typing import TYPE_CHECKING

from pyworm.drives.duty import GearPairDuty, LineOfAction
from pyworm.formulas.scuffing import effusivity
from pyworm.materials.body import Body

if TYPE_CHECKING:
    from pyworm.drives.gear_pair.drive import GearPairDrive


def gear_pair_duty(drive: "GearPairDrive") -> GearPairDuty:
    """The gears of a drive at its operating point."""
    contacts = drive.contacts(drive.cycle_phases())
    rated, surfaces = drive.rating(contacts), drive.surfaces
    pinion, gear = drive.bodies
    rough, cold = (pinion.roughness, gear.roughness), drive.oil.heat is None
    return GearPairDuty(
        centre_distance=drive.teeth.centre_distance,
        power=drive.power,
        pitch_line_velocity=drive.pitch_line_velocity,
        loss_factor=drive.loss_factor,
        reduced_modulus=drive.reduced_modulus,
        oil=drive.oil,
        line_of_action=LineOfAction(
            phase=contacts.phase,
            radius=contacts.radius,
            unit_load=contacts.unit_load,
            pinion_velocity=contacts.pinion_velocity,
            gear_velocity=contacts.gear_velocity,
            hertz_pressure=rated.hertz_pressure,
            film_min=rated.film_min,
            flash_temperature=rated.flash_temperature,
            contact_temperature=rated.contact_temperature,
        ),
        bulk_temperature=None if cold else (pinion.bulk_temperature + gear.bulk_temperature) / 2,
        effusivities=None if cold else (_effusivity(pinion), _effusivity(gear)),
        roughness=None if None in rough else rough,
        friction=None if surfaces is None else surfaces.friction_coefficient,
        scuffing_temperature=None if surfaces is None else surfaces.scuffing_temperature,
    )


def _effusivity(body: Body) -> float:
    return float(effusivity(body.conductivity, body.density, body.specific_heat))
