"""The drive of a case file."""

from collections.abc import Callable
from math import inf

from pyworm.case_error import CaseError
from pyworm.drives.drive import Drive
from pyworm.drives.gear_pair import GearPairDrive, TipRelief
from pyworm.drives.gear_rating import Surfaces
from pyworm.drives.involute import Gear, InvolutePair, ToothSystem
from pyworm.drives.roller_motion import FREE_OF_FRICTION, Pin
from pyworm.drives.roller_profile import Crown, RollerProfile
from pyworm.drives.roller_worm import Rollers, RollerWorm, RollerWormDrive
from pyworm.drives.zi_worm import Hob, Wheel, Worm, ZiWormDrive
from pyworm.schema.case import CaseTable
from pyworm.schema.gear_pair import GearPairCase, GearTable
from pyworm.schema.roller_worm import RollerWormCase
from pyworm.schema.zi_worm import ZiWormCase


def case_drive(tables: CaseTable) -> Drive:
    """The machine that a case file describes.

    Parameters
    ----------
    tables : CaseTable
        The file, in SI; one of the kinds about a drive.

    Raises
    ------
    CaseError
        The parts do not make a drive.
    """
    try:
        return _DRIVES[type(tables)](tables)
    except ValueError as error:
        raise CaseError(f"drive.{error}") from error


def _zi_worm(tables: ZiWormCase) -> ZiWormDrive:
    oil = tables.oil.oil()
    return ZiWormDrive(
        worm=Worm(**dict(tables.drive.worm)),
        wheel=Wheel(**dict(tables.drive.wheel)),
        hob=Hob(**dict(tables.drive.hob)),
        centre_distance=tables.drive.centre_distance,
        speed=tables.operation.worm_speed,
        load=tables.operation.load,
        bodies=tables.bodies.pair(oil),
        oil=oil,
    )


def _roller_worm(tables: RollerWormCase) -> RollerWormDrive:
    oil = tables.oil.oil()
    worm, rollers, operation = tables.drive.worm, tables.drive.rollers, tables.operation
    profile = RollerProfile(
        shape=rollers.shape,
        radius=rollers.radius,
        length=rollers.length,
        half_angle=rollers.half_angle,
        crown=None if rollers.crown is None else Crown(**dict(rollers.crown)),
    )
    return RollerWormDrive(
        worm=RollerWorm(**dict(worm) | {"hand": 1 if worm.hand == "left" else -1}),
        rollers=Rollers(
            count=rollers.count,
            profile=profile,
            tilt=rollers.tilt,
            height=rollers.height,
            pin=FREE_OF_FRICTION if rollers.pin is None else Pin(**dict(rollers.pin)),
            stiffness=rollers.stiffness or inf,
        ),
        centre_distance=tables.drive.centre_distance,
        speed=operation.worm_speed,
        torque=operation.torque,
        preload=operation.preload,
        sharing=operation.sharing,
        rolling=operation.rolling,
        bodies=tables.bodies.pair(oil),
        oil=oil,
    )


def _gear_pair(tables: GearPairCase) -> GearPairDrive:
    oil, table, operation = tables.oil.oil(), tables.drive, tables.operation
    teeth = InvolutePair(
        system=ToothSystem(table.module, table.pressure_angle, table.helix_angle),
        pinion=_gear(table.pinion),
        gear=_gear(table.gear),
        centre_distance=table.centre_distance,
        face_width=table.face_width,
    )
    surfaces = tables.surfaces
    return GearPairDrive(
        teeth=teeth,
        driver=operation.driver,
        pinion_speed=operation.pinion_speed,
        power=operation.power,
        bodies=tables.bodies.pair(oil),
        oil=oil,
        load_factor=operation.load_factor,
        load_sharing=table.load_sharing,
        contact=table.contact,
        tip_relief=tuple(
            TipRelief(gear.tip_relief, gear.tip_relief_length)
            for gear in (table.pinion, table.gear)
        ),
        lead_crowning=table.lead_crowning,
        surfaces=surfaces and Surfaces(**dict(surfaces)),
    )


def _gear(table: GearTable) -> Gear:
    return Gear(
        teeth=table.teeth,
        profile_shift=table.profile_shift,
        addendum=table.addendum,
        dedendum=table.dedendum,
        fillet=table.fillet,
    )


_DRIVES: dict[type[CaseTable], Callable[..., Drive]] = {
    ZiWormCase: _zi_worm,
    GearPairCase: _gear_pair,
    RollerWormCase: _roller_worm,
}
"""What makes the drive of each kind of case."""
