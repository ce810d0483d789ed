"""A worm drive as input of ratings by standards of worm gears."""

from dataclasses import replace

from pyworm.drives.duty import WormDuty
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.formulas.worm_gear import WormGear
from pyworm.materials.body import reduced_modulus


def geometry_of(gears: WormGears) -> WormGear:
    """The geometry of worm and wheel as the standards see it."""
    radius, module = gears.reference_radius, gears.module
    return WormGear(
        centre_distance=gears.centre_distance,
        starts=gears.worm.threads,
        teeth=gears.wheel.teeth,
        module=module,
        diameter_factor=2 * radius / module,
        face_width=gears.wheel.face_width,
        profile_shift=gears.profile_shift,
        pressure_angle=gears.worm_flank.pressure_angle(radius),
        concave=gears.worm.profile in ("ZC", "ZC2"),
    )


def operating_point(mesh: WormMesh, torque: float) -> WormDuty:
    """The worm gear of a drive under a torque of its wheel [N m], without what only its mesh cycle gives."""
    wheel = mesh.bodies[1]
    return WormDuty(
        gear=geometry_of(mesh),
        worm_speed=mesh.speed,
        torque=torque,
        reduced_modulus=reduced_modulus(*mesh.bodies),
        roughness=(mesh.bodies[0].roughness, wheel.roughness),
        driver=mesh.driver,
        oil_temperature=None if mesh.oil.heat is None else mesh.oil.heat.inlet_temperature,
        simulated_wheel_temperature=wheel.bulk_temperature,
        wheel_limit=wheel.temperature_limit,
        wheel_modulus=None if wheel.temperature_limit is None else wheel.youngs_modulus,
    )


def worm_duty(mesh: WormMesh) -> WormDuty:
    """The worm gear of a drive.

    The module is the axial pitch over pi. Unless it is given the worm's reference cylinder lies one module
    below its tip, as usual (DIN 3975); the profile shift of the wheel gives the centre distance. The torque
    is the wheel's; for a given tooth load it is that of the mean number of teeth in contact.
    """
    point = operating_point(mesh, mesh.wheel_torque)
    factor = point.gear.diameter_factor
    as_drawn = mesh.worm.reference_radius is not None
    reference = "as drawn" if as_drawn else "the reference cylinder one module below the worm's tip"
    torque = "wheel torque of the gear set"
    if mesh.tooth_load is not None:
        torque = (
            f"wheel torque of {mesh.tooth_load / 1e3:.3g} kN on each of {mesh.mean_teeth_in_contact:.2f} "
            f"teeth in contact on average, on an arm of {mesh.load_arm * 1e3:.1f} mm"
        )
    return replace(
        point,
        deflection=None if mesh.shaft_deflection is None else mesh.shaft_deflection.deflection,
        contact_ratio=mesh.mean_teeth_in_contact,
        words=(
            f"Derived from the gears: axial module {mesh.module * 1e3:.3f} mm; diameter factor "
            f"{factor:.2f}, {reference}; profile shift of the wheel {mesh.profile_shift:.3f}; {torque}.",
        ),
    )
