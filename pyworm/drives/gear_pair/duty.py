"""A pair of involute gears as input of ratings by standards."""

from pyworm.drives.duty import GearPairDuty, LineOfAction
from pyworm.drives.gear_pair.film_formulas import contact_coefficient, mean_bulk_temperature
from pyworm.drives.gear_pair.mesh import GearPairMesh


def gear_pair_duty(mesh: GearPairMesh) -> GearPairDuty:
    """The gears of a drive at its operating point."""
    contacts = mesh.contacts(mesh.cycle_phases())
    rated, surfaces = mesh.rating(contacts), mesh.surfaces
    pinion, gear = mesh.bodies
    cold, rough = mesh.oil.heat is None, None
    if pinion.roughness is not None and gear.roughness is not None:
        rough = pinion.roughness, gear.roughness
    return GearPairDuty(
        centre_distance=mesh.teeth.centre_distance,
        power=mesh.power,
        pitch_line_velocity=mesh.pitch_line_velocity,
        loss_factor=mesh.loss_factor,
        reduced_modulus=mesh.reduced_modulus,
        oil=mesh.oil,
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
        bulk_temperature=None if cold else mean_bulk_temperature(mesh.bodies),
        effusivities=None if cold else (contact_coefficient(pinion), contact_coefficient(gear)),
        roughness=rough,
        friction=None if surfaces is None else surfaces.friction_coefficient,
        scuffing_temperature=None if surfaces is None else surfaces.scuffing_temperature,
    )
