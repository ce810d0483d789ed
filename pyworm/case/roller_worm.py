"""A case about a roller enveloping worm drive."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from math import inf
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from pyworm.case.bodies import Bodies, BodyTable
from pyworm.case.cooled_case import CooledCase
from pyworm.case.shafts import SupportsTable, supports_of
from pyworm.case.table import Table, plain
from pyworm.drives.roller_worm.design import Rollers, RollerWorm
from pyworm.drives.roller_worm.drive import RollerWormDrive
from pyworm.drives.roller_worm.gears import SectionName
from pyworm.drives.roller_worm.meridian import FEWEST_POINTS, Meridian, read_formula
from pyworm.drives.roller_worm.motion import FREE_OF_FRICTION, Pin, Spinning
from pyworm.drives.roller_worm.profile import Crown, RollerProfile
from pyworm.drives.torque_sharing import Sharing
from pyworm.io import units
from pyworm.io.plain_values import Count, Phase
from pyworm.io.present import present


class RollerBodies(Bodies):
    """`[bodies]` of a roller enveloping worm drive."""

    worm: BodyTable
    rollers: BodyTable


class CrownTable(Table, Crown):
    """`[drive.rollers.crown]`: crown of the rollers, not of the tool that cuts the worm."""


class MeridianTable(Table, Meridian):
    """`[drive.rollers.meridian]`: rise of the radius along rollers of the shape "revolved"."""

    def flaws(self) -> Iterator[str]:
        """Not one of formula and points, or a formula or points that give no curve."""
        if bool(self.formula) == bool(self.places or self.rises):
            yield "give either formula or places and rises, one of the two"
        if self.formula:
            read_formula(self.formula)
            return
        if len(self.places) != len(self.rises):
            yield f"{len(self.places)} places need as many rises, not {len(self.rises)}"
        if len(self.places) < FEWEST_POINTS:
            yield f"give {FEWEST_POINTS} points or more"
        if any(after <= before for before, after in pairwise(self.places)):
            yield "places must rise"


class PinTable(Table, Pin):
    """`[drive.rollers.pin]`: pin on which a roller turns."""


class RollersTable(Table, RollerProfile):
    """`[drive.rollers]`: position on the wheel, shape and size."""

    count: Count
    tilt: units.Tilt = 0.0
    height: units.Offset = 0.0
    meridian: MeridianTable | None = None
    crown: CrownTable | None = None
    pin: PinTable | None = None
    stiffness: units.Stiffness | None = None
    inertia: units.Inertia | None = None

    def flaws(self) -> Iterator[str]:
        """A shape without what it needs."""
        if (self.shape == "cone") != (self.half_angle != 0):
            yield "give a half_angle other than zero to a cone, and to a cone only"
        if self.shape == "ball" and not self.length < 2 * self.radius:
            yield "a ball's length must be less than twice its radius"
        if (self.shape == "revolved") != (self.meridian is not None):
            yield 'give a meridian to a roller of the shape "revolved", and to such a roller only'
        if self.meridian is not None:
            yield from self._curve(self.meridian)

    def _curve(self, meridian: MeridianTable) -> Iterator[str]:
        """A meridian that does not reach both ends, or has no radius somewhere."""
        half = self.length / 2
        if meridian.places and not (
            meridian.places[0] <= -half * (1 - 1e-9) and meridian.places[-1] >= half * (1 - 1e-9)
        ):
            yield f"meridian.places must reach both ends of the roller, {half * 1e3:.4g} mm from its middle"
        with np.errstate(all="ignore"):
            rise, slope, bend = meridian(np.linspace(-half, half, 101), self.radius, self.length)
        if not (np.isfinite(rise + slope + bend).all() and (self.radius + rise > 0).all()):
            yield "meridian gives no smooth curve of positive radius over the roller's length"


class RollerWormTable(Table, RollerWorm):
    """`[drive.worm]`: the thread that the rollers envelop, divided at the throat or between two rows."""

    def flaws(self) -> Iterator[str]:
        """A throat angle of a worm that is not divided, or none of one that is."""
        if (self.arrangement == "divided") != (self.throat_angle > 0):
            yield "give a throat_angle above zero to a divided worm, and to such a worm only"


class RollerDriveTable(Table):
    """`[drive]`, kind = "roller-worm"."""

    kind: Literal["roller-worm"]
    centre_distance: units.Length
    worm: RollerWormTable
    rollers: RollersTable
    shaft: SupportsTable | None = None
    wheel_shaft: SupportsTable | None = None


POWERS = ("power", "worm_torque", "wheel_torque")
"""Keys of `[operation]` of which one gives what the drive carries."""


class RollerOperationTable(Table):
    """`[operation]`: how the drive runs, and which of its contacts are to be solved.

    `stations` are places along a contact line at which line contacts are solved; without them each contact
    line is one point contact, its ends included.
    """

    worm_speed: units.Speed
    power: units.Power | None = None
    worm_torque: units.Torque | None = None
    wheel_torque: units.Torque | None = None
    preload: units.TorqueOrZero
    sharing: Sharing = "elastic"
    rolling: Spinning = "free"
    driving: SectionName = "left"
    sections: Annotated[tuple[SectionName, ...], Field(min_length=1)] = ("right", "left")
    phases: Annotated[tuple[Phase, ...], Field(min_length=1)]
    stations: Annotated[tuple[Phase, ...], Field(min_length=1)] | None = None

    def flaws(self) -> Iterator[str]:
        """Not one power, or a section without load."""
        yield from self.unless_one(*POWERS)
        idle = "right" if self.driving == "left" else "left"
        if self.preload == 0 and idle in self.sections:
            yield (
                f'sections has "{idle}", the idling section, which carries no load where preload is 0; give '
                f'sections = ["{self.driving}"], or a preload'
            )

    def torque(self, ratio: float) -> float:
        """Torque of the worm [N m]; of the wheel's without friction, by rollers over threads."""
        if self.wheel_torque is not None:
            return self.wheel_torque / ratio
        if self.worm_torque is not None:
            return self.worm_torque
        return present(self.power, "operation.power") / self.worm_speed


class RollerWormCase(CooledCase):
    """A case file about a roller enveloping worm drive."""

    first_loss = 0.05
    drive: RollerDriveTable
    operation: RollerOperationTable
    bodies: RollerBodies

    def flaws(self) -> Iterator[str]:
        """Free rollers without a flow law, or sharp ends that are solved."""
        yield from super().flaws()
        if self.operation.rolling in ("free", "dynamic") and self.oil.shear is None:
            yield (
                "[oil.shear] is missing: free rollers are driven by the film's shear; give it, or "
                'operation.rolling = "rolling" or "locked"'
            )
        if self.operation.stations is None and self.drive.rollers.crown is None:
            yield (
                "drive.rollers.crown is missing: sharp ends press without bound, no film with ends can "
                "be solved; give a crown, or operation.stations for line contacts"
            )

    def make_drive(self) -> RollerWormDrive:
        """The drive of a case file about a roller enveloping worm."""
        oil = self.oil.oil()
        worm, rollers, operation = self.drive.worm, self.drive.rollers, self.operation
        drive = RollerWormDrive(
            worm=plain(worm, RollerWorm),
            rollers=Rollers(
                count=rollers.count,
                profile=plain(rollers, RollerProfile),
                tilt=rollers.tilt,
                height=rollers.height,
                pin=FREE_OF_FRICTION if rollers.pin is None else plain(rollers.pin, Pin),
                stiffness=rollers.stiffness or inf,
                inertia=rollers.inertia,
            ),
            centre_distance=self.drive.centre_distance,
            speed=operation.worm_speed,
            torque=operation.torque(rollers.count / worm.threads),
            preload=operation.preload,
            sharing=operation.sharing,
            rolling=operation.rolling,
            driving=operation.driving,
            bodies=self.bodies.pair(oil),
            oil=oil,
            lubrication=self.brought_by,
            shaft=supports_of(self.drive.shaft),
            wheel_shaft=supports_of(self.drive.wheel_shaft),
        )
        warm = self.temperatures_of(drive)
        if warm is None:
            return drive
        return replace(drive, oil=warm.oil(oil), bodies=warm.warm(drive.bodies))


CASE = RollerWormCase
"""Tables and keys of a case file of this kind of drive."""
