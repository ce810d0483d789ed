"""A case about a pair of involute gears on parallel axes."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated, Literal

from pydantic import Field

from pyworm.case.bodies import Bodies, BodyTable
from pyworm.case.cooled_case import CooledCase
from pyworm.case.ratings import GearRatingTable
from pyworm.case.shafts import SupportsTable, supports_of
from pyworm.case.table import Table, plain
from pyworm.drives.gear_pair.design import LinearRelief
from pyworm.drives.gear_pair.drive import GearPairDrive
from pyworm.drives.gear_pair.film_formulas import Surfaces
from pyworm.drives.gear_pair.gears import Gear, InvolutePair, ToothSystem
from pyworm.drives.gear_pair.inspection import AS_DRAWN, MeasuredGear, PairInspection
from pyworm.io import units
from pyworm.io.plain_values import Phase, PositiveNumber


class GearBodies(Bodies):
    """`[bodies]` of a pair of gears."""

    pinion: BodyTable
    gear: BodyTable


class GearTable(Table, Gear):
    """`[drive.pinion]` and `[drive.gear]`; coefficients in normal modules, as of the basic rack.

    The tips are shortened by what the centre distance lacks of the sum of the profile shifts (ISO 21771).
    """

    tip_relief: units.Relief = 0.0
    tip_relief_length: units.LengthOrZero = 0.0


class MeasuredGearTable(Table, MeasuredGear):
    """`[drive.inspection.pinion]` and `[drive.inspection.gear]`."""


class InspectionTable(Table, PairInspection):
    """`[drive.inspection]`: balls, spans and deviations for the inspection sheet."""

    pinion: MeasuredGearTable = MeasuredGearTable()
    gear: MeasuredGearTable = MeasuredGearTable()


class GearPairTable(Table, ToothSystem):
    """`[drive]`, kind = "gear-pair"."""

    kind: Literal["gear-pair"]
    centre_distance: units.Length
    face_width: units.FaceWidth
    lead_crowning: units.Relief = 0.0
    load_sharing: Literal["ramp", "uniform", "elastic"] = "ramp"
    contact: Literal["line", "point"] = "line"
    pinion: GearTable
    gear: GearTable
    inspection: InspectionTable | None = None
    pinion_shaft: SupportsTable | None = None
    gear_shaft: SupportsTable | None = None


class GearOperationTable(Table):
    """`[operation]`: how the gears run, and which contacts of their line of action are to be solved."""

    driver: Literal["pinion", "gear"]
    pinion_speed: units.Speed
    power: units.Power
    load_factor: PositiveNumber = 1.0
    phases: Annotated[tuple[Phase, ...], Field(min_length=1)]


class SurfacesTable(Table, Surfaces):
    """`[surfaces]`: what the closed forms of friction and scuffing need."""


class GearPairCase(CooledCase):
    """A case file about a pair of gears."""

    drive: GearPairTable
    operation: GearOperationTable
    bodies: GearBodies
    surfaces: SurfacesTable | None = None
    gear_rating: GearRatingTable = Field(default_factory=GearRatingTable)

    def flaws(self) -> Iterator[str]:
        """Scuffing without heat."""
        yield from super().flaws()
        if self.oil.heat is None and self.surfaces and self.surfaces.scuffing_temperature:
            yield "surfaces.scuffing_temperature has no effect without [oil.heat]"

    def make_drive(self) -> GearPairDrive:
        """The drive of a case file about a pair of gears."""
        oil, table, operation = self.oil.oil(), self.drive, self.operation
        teeth = InvolutePair(
            system=plain(table, ToothSystem),
            pinion=plain(table.pinion, Gear),
            gear=plain(table.gear, Gear),
            centre_distance=table.centre_distance,
            face_width=table.face_width,
        )
        surfaces = self.surfaces
        drive = GearPairDrive(
            teeth=teeth,
            driver=operation.driver,
            pinion_speed=operation.pinion_speed,
            power=operation.power,
            bodies=self.bodies.pair(oil),
            oil=oil,
            load_factor=operation.load_factor,
            load_sharing=table.load_sharing,
            contact=table.contact,
            tip_relief=(_relief(table.pinion), _relief(table.gear)),
            lead_crowning=table.lead_crowning,
            surfaces=None if surfaces is None else plain(surfaces, Surfaces),
            lubrication=self.brought_by,
            pinion_shaft=supports_of(table.pinion_shaft),
            gear_shaft=supports_of(table.gear_shaft),
            inspection=(
                AS_DRAWN if table.inspection is None else plain(table.inspection, PairInspection)
            ),
        )
        warm = self.temperatures_of(drive)
        if warm is None:
            return drive
        return replace(drive, oil=warm.oil(oil), bodies=warm.warm(drive.bodies))


def _relief(table: GearTable) -> LinearRelief:
    return LinearRelief(table.tip_relief, table.tip_relief_length)


CASE = GearPairCase
"""Tables and keys of a case file of this kind of drive."""
