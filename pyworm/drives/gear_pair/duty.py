"""A pair of involute gears as input of ratings by standards."""

from typing import TYPE_CHECKING

from pyworm.drives.duty import GearPairDuty, LineOfAction
from pyworm.materials.body import composite_roughness

if TYPE_CHECKING:
    from pyworm.drives.gear_pair.drive import GearPairDrive


def gear_pair_duty(drive: "GearPairDrive") -> GearPairDuty:
    """The gears of a drive at its operating point."""
    contacts = drive.contacts(drive.cycle_phases())
    rated, surfaces = drive.rating(contacts), drive.surfaces
    return GearPairDuty(
        centre_distance=drive.teeth.centre_distance,
        power=drive.power,
        pitch_line_velocity=drive.pitch_line_velocity,
        loss_factor=drive.loss_factor,
        reduced_modulus=drive.reduced_modulus,
        oil_density=drive.oil.density.rho0,
        line_of_action=LineOfAction(
            phase=contacts.phase,
            radius=contacts.radius,
            unit_load=contacts.unit_load,
            entrainment=contacts.entrainment,
            hertz_pressure=rated.hertz_pressure,
            film_min=rated.film_min,
            flash_temperature=rated.flash_temperature,
            contact_temperature=rated.contact_temperature,
        ),
        composite_roughness=composite_roughness(*drive.bodies),
        friction=None if surfaces is None else surfaces.friction_coefficient,
        scuffing_temperature=None if surfaces is None else surfaces.scuffing_temperature,
    )
