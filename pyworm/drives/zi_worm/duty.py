"""A ZI worm drive as input of ratings by standards of worm gears."""

from dataclasses import replace
from typing import TYPE_CHECKING

from pyworm.drives.duty import WormDuty
from pyworm.drives.zi_worm.load_sharing import Transmission
from pyworm.formulas.worm_gear import WormGear
from pyworm.materials.body import reduced_modulus

if TYPE_CHECKING:
    from pyworm.drives.zi_worm.drive import ZiWormDrive
    from pyworm.drives.zi_worm.gears import ZiWormGears


def geometry_of(gears: "ZiWormGears") -> WormGear:
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


def operating_point(drive: "ZiWormDrive", torque: float) -> WormDuty:
    """The worm gear of a drive under a torque of its wheel [N m], without what only its mesh cycle gives."""
    wheel = drive.bodies[1]
    return WormDuty(
        gear=geometry_of(drive),
        worm_speed=drive.speed,
        torque=torque,
        reduced_modulus=reduced_modulus(*drive.bodies),
        roughness=(drive.bodies[0].roughness, wheel.roughness),
        driver=drive.driver,
        oil_temperature=None if drive.oil.heat is None else drive.oil.heat.inlet_temperature,
        simulated_wheel_temperature=wheel.bulk_temperature,
        wheel_limit=wheel.temperature_limit,
        wheel_modulus=None if wheel.temperature_limit is None else wheel.youngs_modulus,
    )


def worm_duty(drive: "ZiWormDrive") -> WormDuty:
    """The worm gear of a drive.

    The module is the axial pitch over pi. Unless it is given the worm's reference cylinder lies one module
    below its tip, as usual (DIN 3975); the profile shift of the wheel gives the centre distance. The torque
    is the wheel's; for a given tooth load it is that of the mean number of teeth in contact.
    """
    point = operating_point(drive, drive.wheel_torque)
    factor = point.gear.diameter_factor
    as_drawn = drive.worm.reference_radius is not None
    reference = "as drawn" if as_drawn else "the reference cylinder one module below the worm's tip"
    torque = "wheel torque as the drive has it"
    if not isinstance(drive.load, Transmission):
        torque = (
            f"wheel torque of {drive.load / 1e3:.3g} kN on each of {drive.mean_teeth_in_contact:.2f} "
            f"teeth in contact on average, on an arm of {drive.load_arm * 1e3:.1f} mm"
        )
    return replace(
        point,
        deflection=None if drive.bent is None else drive.bent.deflection,
        contact_ratio=drive.mean_teeth_in_contact,
        words=(
            f"Derived from the drive: axial module {drive.module * 1e3:.3f} mm; diameter factor "
            f"{factor:.2f}, {reference}; profile shift of the wheel {drive.profile_shift:.3f}; {torque}.",
        ),
    )
