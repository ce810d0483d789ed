"""A pair of involute gears as input of ratings by standards."""

from typing import TYPE_CHECKING

from pyworm.drives.duty import GearPairDuty, LineOfAction
from pyworm.drives.gear_pair.film_formulas import contact_coefficient, mean_bulk_temperature

if TYPE_CHECKING:
    from pyworm.drives.gear_pair.drive import GearPairDrive


def gear_pair_duty(drive: "GearPairDrive") -> GearPairDuty:
    """The gears of a drive at its operating point."""
    contacts = drive.contacts(drive.cycle_phases())
    rated, surfaces = drive.rating(contacts), drive.surfaces
    pinion, gear = drive.bodies
    cold, rough = drive.oil.heat is None, None
    if pinion.roughness is not None and gear.roughness is not None:
        rough = pinion.roughness, gear.roughness
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
        bulk_temperature=None if cold else mean_bulk_temperature(drive.bodies),
        effusivities=None if cold else (contact_coefficient(pinion), contact_coefficient(gear)),
        roughness=rough,
        friction=None if surfaces is None else surfaces.friction_coefficient,
        scuffing_temperature=None if surfaces is None else surfaces.scuffing_temperature,
    )
