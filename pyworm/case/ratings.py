"""Tables of ratings, with or without a drive: bearings, worm gear, gear pair, oil."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal, get_args

from pydantic import AfterValidator, Field

from pyworm.case.case_file import FileTable, Published
from pyworm.case.drive_case import DriveCase
from pyworm.case.duty import DutyTable
from pyworm.case.one_oil import second_oil
from pyworm.case.running_in import RunningInTable
from pyworm.case.table import Table
from pyworm.drives.forces import Side
from pyworm.formulas.bearing_life import RollingBearing
from pyworm.formulas.fzg_test_gears import TEST_TEMPERATURE
from pyworm.formulas.oil_life import UsedOil
from pyworm.formulas.worm_curves import Lubrication, OilKind
from pyworm.formulas.worm_gear import WormGearSizes
from pyworm.formulas.worm_losses import Bearings
from pyworm.io import units
from pyworm.io.plain_values import Count, NumberOrZero, PositiveNumber, Text
from pyworm.materials.base_stock import Base
from pyworm.materials.oil_requirements import OilRequirements
from pyworm.materials.solids import named_material

_UpToOne = Annotated[float, Field(strict=True, ge=0, le=1)]


ELEMENT = "roller"
"""Name under `shaft` of the bearings of rollers on their pins, one in each."""


class BearingTable(Table, RollingBearing):
    """`[bearings.NAME]`: a rolling bearing for ISO 281.

    Dynamic rating, load and speed give the basic life; the modified one needs the rest. Load and speed that
    are not given are those of a `shaft` of the drive at one `side`, or of each "roller" on its pin; a
    `locating` bearing takes the thrust, with factors by its `contact_angle` or as given. The oil is given by
    the viscosity at the bearing or by name and temperature; dirt by the factor e_C, or by lubrication and
    cleanliness, of which the standard makes e_C.
    """

    name: Text | None = None
    load: units.Force | None = None
    speed: units.Speed | None = None
    shaft: Text | None = None
    side: Side | None = None
    locating: bool = False
    contact_angle: units.AngleOrZero = 0.0
    thrust_limit: PositiveNumber | None = None
    radial_factor: PositiveNumber | None = None
    thrust_factor: PositiveNumber | None = None
    static_rating: units.Force | None = None
    fatigue_load_limit: units.Force | None = None
    mean_diameter: units.Length | None = None
    viscosity: units.KinematicViscosity | None = None
    oil: Text | None = None
    temperature: units.Temperature | None = None
    contamination: _UpToOne | None = None
    lubrication: Literal["inline filter", "oil bath", "grease"] | None = None
    cleanliness: Text | None = None
    published: Published = Field(default_factory=dict)

    def flaws(self) -> Iterator[str]:
        """Two statements about one thing, or half of one, and no load or speed."""
        for key in ("load", "speed"):
            if getattr(self, key) is None and self.shaft is None:
                yield f"{key} is missing; or give shaft and side, of which it follows"
        if self.shaft != ELEMENT:
            yield from self.unless_together("shaft", "side")
        elif self.side is not None:
            yield f"a bearing of each {ELEMENT} has no side"
        yield from self.unless_together("thrust_limit", "radial_factor", "thrust_factor")
        yield from self.unless_either("fatigue_load_limit", "static_rating", needed=False)
        if None not in (self.viscosity, self.oil):
            yield "give either viscosity or oil with temperature, one of the two"
        yield from self.unless_together("oil", "temperature")
        if None not in (self.contamination, self.lubrication):
            yield "give either contamination or lubrication with cleanliness"
        yield from self.unless_together("lubrication", "cleanliness")


class UsedOilTable(Table, UsedOil):
    """`[oil_choice.used_oil]`: analysis of the oil in the sump."""


class OilChoiceTable(Table, OilRequirements):
    """`[oil_choice]`: requirements of an oil (`OilDuty`); drive and bodies give the rest."""

    used_oil: UsedOilTable | None = None

    def flaws(self) -> Iterator[str]:
        """A price of energy without the loss, or the time in which it is lost."""
        if self.energy_price is not None and None in (self.loss, self.yearly_operation):
            yield "energy_price needs loss and yearly_operation"
        if self.motor_torque is not None and self.coldest_start is None:
            yield "motor_torque needs coldest_start"


class StartingTable(Table):
    """`[starting]`: a start of a worm gear set that `[worm_rating]` rates, in oil as cold as the unit.

    `load_share` of the wheel's torque is on during the start. `mass` of the whole unit, as of iron, gives the
    time of its warming.
    """

    temperature: units.Temperature
    load_share: units.Share = 1.0
    motor_torque: units.Torque | None = None
    mass: units.Mass | None = None


class LoadStepTable(Table):
    """One of `[[worm_rating.spectrum]]`: a torque and speed that last some hours of the life."""

    wheel_torque: units.Torque
    worm_speed: units.Speed
    duration: units.Duration


_Starts = Annotated[float, Field(strict=True, ge=0, le=1e4)]
_Rim = Annotated[float, Field(strict=True, ge=1, le=100)]


_LoadStage = Annotated[int, Field(strict=True, ge=1, le=14)]
_MicropittingStage = Annotated[int, Field(strict=True, ge=5, le=10)]


class DamageLimits(Table):
    """What an oil bears before flanks scuff or pit minutely, by its tests; what is not given is not rated.

    `required_...` are the least safeties, which the standards leave to those who agree on them.
    """

    scuffing_load_stage: _LoadStage | None = None
    scuffing_structure_factor: PositiveNumber = 1.0
    required_scuffing: PositiveNumber = 2.0
    micropitting_load_stage: _MicropittingStage | None = None
    micropitting_test_temperature: units.Temperature = TEST_TEMPERATURE
    micropitting_material_factor: PositiveNumber = 1.0
    permissible_specific_film: PositiveNumber | None = None
    required_micropitting: PositiveNumber = 1.0

    def flaws(self) -> Iterator[str]:
        """Two permissible films."""
        if None not in (self.permissible_specific_film, self.micropitting_load_stage):
            yield "give either permissible_specific_film or micropitting_load_stage, of which it is made"


class ScuffingTable(Table):
    """`[scuffing]`: scuffing temperature of the oil, given or by its load stage in the FZG test.

    `scuffing_structure_factor` is X_W of the standard, by the flanks' steel or coating; `base` the stock of
    an oil that `[oil]` does not name from the list.
    """

    temperature: units.ScuffingTemperature | None = None
    scuffing_load_stage: _LoadStage | None = None
    scuffing_structure_factor: PositiveNumber = 1.0
    required_scuffing: PositiveNumber = 2.0
    base: Base | None = None

    def flaws(self) -> Iterator[str]:
        """Two limits or none."""
        yield from self.unless_one("temperature", "scuffing_load_stage")


USUAL_AMBIENT = 293.15
"""Temperature of the surroundings where none is given [K]."""


class WormRatingTable(Table):
    """`[worm_rating]`: data that the worm gear standards need beside the drive.

    What is not given is not rated. A drive gives oil, its temperature and way to the teeth, the wheel's
    material, roughness and cooling; what is written here too must be the same. Beside a `[worm_gear]` the oil
    is a named one, or a file of one's own, and without `sump_temperature` that of the standard is taken, of a
    usual housing with or without `fan`. A `spectrum` of loads takes the place of the drive's own torque and
    speed, and of `life`.
    """

    oil: Text | None = None
    lubrication: Lubrication | None = None
    sump_temperature: units.Temperature | None = None
    ambient_temperature: units.Temperature | None = None
    fan: bool = False
    temperature_limit: units.Temperature | None = None
    material_factor: PositiveNumber | None = None
    wheel_material: Annotated[str, AfterValidator(named_material)] | None = None
    life: units.Duration | None = None
    spectrum: tuple[LoadStepTable, ...] = ()
    application_factor: PositiveNumber = 1.0
    starts_per_hour: _Starts = 0.0
    structure_factor: PositiveNumber | None = None
    pressure_factor: PositiveNumber | None = None
    immersion_factor: PositiveNumber | None = None
    rim_over_module: _Rim = 2.0
    bearings: Bearings | None = None

    def completed(self, **others: Any) -> "CompletedRating":
        """The table with other statements, and then usual values, for keys that it does not give."""
        given = {key: value for key, value in self if value is not None}
        stated = {key: value for key, value in others.items() if value is not None}
        return CompletedRating.model_construct(**stated | given)

    def flaws(self) -> Iterator[str]:
        """Two lives."""
        if self.spectrum and self.life is not None:
            yield "give either life or spectrum, whose durations make it up"


class CompletedRating(WormRatingTable):
    """`[worm_rating]` with usual values for what every rating needs."""

    lubrication: Lubrication = "bath"
    ambient_temperature: units.Temperature = USUAL_AMBIENT
    immersion_factor: PositiveNumber = 1.0
    bearings: Bearings = "adjusted"


class GearRatingTable(DamageLimits):
    """`[gear_rating]`: oil of a pair of gears, its supply and tests; drive and `[surfaces]` give the rest.

    `base` is the stock of an oil that `[oil]` does not name from the list. With `jet_length`, that of the
    jets' holes over their diameter, jets are sized for the viscosity of the oil at its temperature.
    """

    base: Base | None = None
    viscosity_40: units.KinematicViscosity | None = None
    anti_scuff: bool = False
    flow: Literal["copious", "adequate", "lean", "starved"] | None = None
    feed_pressure: units.Pressure | None = None
    jets: Count | None = None
    jet_length: NumberOrZero | None = None

    def flaws(self) -> Iterator[str]:
        """Jets in part."""
        yield from super().flaws()
        yield from self.unless_together("flow", "feed_pressure", "jets")
        if self.jet_length is not None and self.jets is None:
            yield "jet_length has no effect without jets"


class WormGearTable(Table, WormGearSizes):
    """`[worm_gear]`: a worm gear as the standards see it, where no drive is given; roughness as Rq."""

    worm_speed: units.Speed
    wheel_torque: units.Torque
    reduced_modulus: units.Modulus
    worm_roughness: units.Roughness
    wheel_roughness: units.Roughness


def _oils_named(worm: WormRatingTable | None, bearings: dict[str, BearingTable]) -> dict[str, str]:
    """Oils of a drive's sump that its ratings name, by their keys; a bearing in grease has its own."""
    named = {} if worm is None or worm.oil is None else {"worm_rating.oil": worm.oil}
    return named | {
        f"bearings.{name}.oil": table.oil
        for name, table in bearings.items()
        if table.oil is not None and table.lubrication != "grease"
    }


class RatedCase(DriveCase):
    """Tables of ratings in case files about drives."""

    bearings: dict[str, BearingTable] = Field(default_factory=dict)
    oil_choice: OilChoiceTable | None = None
    scuffing: ScuffingTable | None = None
    duty: DutyTable | None = None
    starting: StartingTable | None = None
    running_in: RunningInTable | None = None

    def flaws(self) -> Iterator[str]:
        """A second oil, a duty of what does not warm, or a start of gears that are not rated."""
        yield from super().flaws()
        for key in self.given("duty", "running_in"):
            if getattr(self, "cooling", None) is None:
                yield f"[{key}] asks for [cooling] with the sizes of its housing"
        worm = getattr(self, "worm_rating", None)
        if self.starting is not None and worm is None:
            yield "[starting] needs [worm_rating]"
        yield from second_oil(self.oil, _oils_named(worm, self.bearings))


class RatingCase(FileTable):
    """A case file that asks for ratings only, with nothing to be solved."""

    bearings: dict[str, BearingTable] = Field(default_factory=dict)
    worm_gear: WormGearTable | None = None
    worm_rating: WormRatingTable | None = None
    oil_choice: OilChoiceTable | None = None
    starting: StartingTable | None = None

    def flaws(self) -> Iterator[str]:
        """Ratings without a worm gear or an oil, or with a second oil, and shafts of no drive."""
        yield from super().flaws()
        for name, bearing in self.bearings.items():
            if bearing.shaft is not None:
                yield f"bearings.{name}.shaft has no effect without a [drive]"
        for key in self.given("worm_rating", "oil_choice") if self.worm_gear is None else ():
            yield f"[{key}] needs a [worm_gear] or a [drive]"
        if self.starting is not None and self.worm_rating is None:
            yield "[starting] needs [worm_rating]"
        if self.worm_rating is not None and self.worm_rating.oil is None:
            yield 'worm_rating.oil is missing, such as "PAG VG 220"'
        if self.worm_gear is not None:
            yield from second_oil(None, _oils_named(self.worm_rating, self.bearings))


RATING_TABLES = ("bearings", "worm_gear", "worm_rating", "gear_rating", "oil_choice", "starting")
"""Tables of a case file that ask for ratings."""

OIL_KINDS: tuple[OilKind, ...] = get_args(OilKind)
"""Base stocks that the standards of worm gears know."""
