"""The drive of a case file."""

from collections.abc import Callable
from math import inf, pi
from typing import Any

from pyworm.case_error import CaseError
from pyworm.drives import tooth_boundary
from pyworm.drives.drive import Drive
from pyworm.drives.gear_pair import GearPairDrive, TipRelief
from pyworm.drives.gear_rating import Surfaces
from pyworm.drives.involute import Gear, InvolutePair, ToothSystem
from pyworm.drives.roller_motion import FREE_OF_FRICTION, Pin
from pyworm.drives.roller_profile import Crown, RollerProfile
from pyworm.drives.roller_worm import Rollers, RollerWorm, RollerWormDrive
from pyworm.drives.zi_load import Transmission
from pyworm.drives.zi_worm import Assembly, Hob, Wheel, Worm, ZiWormDrive
from pyworm.schema.case import CaseTable
from pyworm.schema.gear_pair import GearPairCase, GearTable
from pyworm.schema.roller_worm import RollerWormCase
from pyworm.schema.zi_worm import WheelTable, WormTable, ZiWormCase
from pyworm.thermal_balance import Cooling, drive_temperatures


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
    oil, operation = tables.oil.oil(), tables.operation
    bodies = tables.bodies.pair(oil)
    ratio = tables.drive.worm.threads / tables.drive.wheel.teeth
    speed = operation.worm_speed or operation.wheel_speed / ratio
    if tables.cooling is not None:
        loss = tables.cooling.tooth_loss
        if loss is None:
            loss = _first_loss(_transmission(tables, speed, ratio), speed, ratio)
        cooling = Cooling(**tables.cooling.model_dump(exclude={"tooth_loss"}))
        wheel = tables.drive.wheel
        rim = wheel.face_width * (wheel.teeth * tables.drive.worm.axial_pitch / pi)
        warm = drive_temperatures(cooling, rim, speed, loss)
        oil, bodies = warm.oil(oil), warm.bodies(bodies)
    return ZiWormDrive(
        worm=Worm(**_relieved(tables.drive.worm)),
        wheel=Wheel(**_relieved(tables.drive.wheel)),
        hob=Hob(**dict(tables.drive.hob)),
        centre_distance=tables.drive.centre_distance,
        speed=speed,
        load=operation.load or _transmission(tables, speed, ratio),
        bodies=bodies,
        oil=oil,
        assembly=Assembly(**dict(tables.drive.assembly)),
        driver=operation.driver,
    )


def _relieved(table: WormTable | WheelTable) -> dict[str, Any]:
    """Entries of a design table, its tip relief as one."""
    entries = dict(table)
    relief = tooth_boundary.TipRelief(entries.pop("tip_relief"), entries.pop("tip_relief_length"))
    return entries | {"tip_relief": relief}


def _transmission(tables: ZiWormCase, worm_speed: float, ratio: float) -> Transmission:
    """What the teeth of a ZI worm drive share; with a power, the torque of the shaft that drives."""
    operation = tables.operation
    if operation.power is not None:
        shaft = operation.driver
        torque = operation.power / (worm_speed if shaft == "worm" else worm_speed * ratio)
    else:
        shaft = "wheel" if operation.worm_torque is None else "worm"
        torque = operation.worm_torque or operation.wheel_torque
    return Transmission(
        torque=torque,
        shaft=shaft,
        sharing=operation.sharing or "elastic",
        friction=FIRST_FRICTION if operation.friction is None else operation.friction,
        stiffness=tables.drive.stiffness or inf,
        lifts=operation.lifts or (),
    )


def _first_loss(transmission: Transmission, worm_speed: float, ratio: float) -> float:
    """Loss between the teeth before it is known [W]."""
    speed = worm_speed if transmission.shaft == "worm" else worm_speed * ratio
    return FIRST_LOSS * transmission.torque * speed


FIRST_LOSS = 0.03
"""Share of the power that is lost between worm teeth before it is known."""

FIRST_FRICTION = 0.01
"""Friction of worm teeth in the balance of torques before it is known."""


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
