"""A case about a ZI worm drive."""

from typing import Annotated, Literal

from pydantic import Field

from pyworm import units
from pyworm.schema.bodies import Bodies, BodyTable
from pyworm.schema.rating import RatedCase, WormRatingTable
from pyworm.schema.table import Count, Phase, Table


class WormBodies(Bodies):
    """`[bodies]` of a worm drive."""

    worm: BodyTable
    wheel: BodyTable


class _Helicoid(Table):
    """What worm and hob share: the involute helicoid between its cylinders."""

    tip_radius: units.Length
    root_radius: units.Length
    base_radius: units.Length
    axial_pitch: units.Length
    lead: units.Length
    base_lead_angle: units.Angle


class WormTable(_Helicoid):
    """`[drive.worm]`."""

    threads: Count


class WheelTable(Table):
    """`[drive.wheel]`."""

    teeth: Count
    face_width: units.Length
    tip_radius: units.Length
    throat_radius: units.Length


class HobTable(_Helicoid):
    """`[drive.hob]`: the cutter and how it was set up when it cut the wheel."""

    centre_distance: units.Length
    swivel: units.Tilt
    axial_shift: units.Offset


class ZiWormTable(Table):
    """`[drive]`, kind = "zi-worm"."""

    kind: Literal["zi-worm"]
    centre_distance: units.Length
    worm: WormTable
    wheel: WheelTable
    hob: HobTable


class OperationTable(Table):
    """`[operation]`: how the drive runs, and which phases of its mesh cycle are to be solved."""

    worm_speed: units.Speed
    load: units.Force
    phases: Annotated[tuple[Phase, ...], Field(min_length=1)]


class ZiWormCase(RatedCase):
    """A case file about a ZI worm drive."""

    drive: ZiWormTable
    operation: OperationTable
    bodies: WormBodies
    worm_rating: WormRatingTable | None = None
