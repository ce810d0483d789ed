"""A case about an eccentric cam against a flat tappet."""

from typing import Annotated, Literal

from pydantic import Field

from eccentric_cam.drive import Cam, EccentricCam
from pyworm.case.bodies import Bodies, BodyTable
from pyworm.case.drive_case import DriveCase
from pyworm.case.table import Table, plain
from pyworm.io import units
from pyworm.io.plain_values import Phase


class CamBodies(Bodies):
    """`[bodies]` of a cam and its tappet."""

    cam: BodyTable
    tappet: BodyTable


class CamTable(Table, Cam):
    """`[drive]`, kind = "eccentric-cam"."""

    kind: Literal["eccentric-cam"]


class CamOperationTable(Table):
    """`[operation]`: how the cam runs, and which phases of its turn are to be solved."""

    speed: units.Speed
    load: units.Force
    phases: Annotated[tuple[Phase, ...], Field(min_length=1)]


class EccentricCamCase(DriveCase):
    """A case file about an eccentric cam."""

    drive: CamTable
    operation: CamOperationTable
    bodies: CamBodies

    def make_drive(self) -> EccentricCam:
        """The cam of a case file."""
        oil = self.oil.oil()
        return EccentricCam(
            cam=plain(self.drive, Cam),
            speed=self.operation.speed,
            load=self.operation.load,
            bodies=self.bodies.pair(oil),
            oil=oil,
        )


CASE = EccentricCamCase
"""Tables and keys of a case file of this kind of gears."""
