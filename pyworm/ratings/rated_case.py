"""Ratings that a case file asks for."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, partial
from math import cos
from pathlib import Path
from typing import Any, Protocol, runtime_checkable

from pyworm.case.case import Case, case_of, checked, load
from pyworm.case.case_file import PublishedValue
from pyworm.case.kinds import rated
from pyworm.case.oil import OilTable
from pyworm.case.python_input import as_file
from pyworm.case.ratings import (
    RATING_TABLES,
    BearingTable,
    CompletedRating,
    GearRatingTable,
    RatedCase,
    RatingCase,
    StartingTable,
    WormGearTable,
)
from pyworm.case.unusual import unusual
from pyworm.drives.answers import ElementBearing
from pyworm.drives.drive import Drive
from pyworm.drives.duty import Duty, GearPairDuty, WormDuty
from pyworm.drives.gear_unit import GearUnit
from pyworm.formulas.ranges import one_of
from pyworm.formulas.unknown import Unknown, attempt, known, or_none
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.io.toml import read_toml
from pyworm.planning.prediction import predicted
from pyworm.ratings.bearing import ShaftLoad, rate_bearing_table
from pyworm.ratings.element_bearing import element_load, rate_element_bearing
from pyworm.ratings.films import rate_films
from pyworm.ratings.forces import Friction, rate_forces
from pyworm.ratings.gear import rate_gear_pair
from pyworm.ratings.mesh_loss import mesh_loss
from pyworm.ratings.motion import rate_motion
from pyworm.ratings.no_load import worm_no_load
from pyworm.ratings.rating import SIMULATION, Rating
from pyworm.ratings.roots import rate_roots
from pyworm.ratings.scuffing import rate_scuffing
from pyworm.ratings.standard_loss import rated_teeth
from pyworm.ratings.starting import WormStart, rate_start
from pyworm.ratings.temperatures import rate_temperatures
from pyworm.ratings.worm import rate_worm_gear, worm_duty_of_table
from pyworm.ratings.worm_damage import worm_flanks
from pyworm.ratings.worm_loads import RatedWormGear
from pyworm.ratings.worm_verdict import NEVER_RATED
from pyworm.result.headline import of_all
from pyworm.result.result import Result
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.plausibility import beyond_limits
from pyworm.scene.point import Scene
from pyworm.solver.neglected_effects import NeglectedEffects, judged
from pyworm.solver.solution import Solution


@runtime_checkable
class WormRated(Protocol):
    """Tables of a case that standards rate as a worm gear."""

    def rating_as_run(self) -> CompletedRating:
        """`[worm_rating]`, completed by what the drive states."""


@runtime_checkable
class GearRated(Protocol):
    """Tables of a case that standards rate as a pair of gears."""

    gear_rating: GearRatingTable
    oil: OilTable
    published: dict[str, PublishedValue]


@runtime_checkable
class Cooled(Protocol):
    """Tables of a case with `[cooling]`."""

    cooling: object

    def unit_of(self, drive: Any) -> GearUnit:
        """The thermal network of the drive."""


@dataclass(frozen=True)
class RatingRequest:
    """A case file with its requests for ratings."""

    name: str
    """File name without its ending."""
    directory: Path
    """Where it lies; files that it names are relative to it."""
    tables: RatedCase | RatingCase
    """The file, in SI."""
    drive: Drive | None = None
    """Its drive, if it has one that can be rated."""
    warnings: tuple[str, ...] = ()
    """What is unusual in it, as `Case.warnings`."""
    places: tuple[ContactIndex, ...] = ()
    """Contacts of the drive that it lists."""

    @property
    def rated_as(self) -> type[Duty] | None:
        """What the standards rate it as, the type of its `duty`; None where they know no such drive."""
        if self.drive is not None:
            return self.drive.rated_as
        return None if self._worm_gear is None else WormDuty

    @cached_property
    def duty(self) -> Duty | None:
        """Its gears as the standards see them; ValueError where these do not know such gears."""
        if self.drive is not None and isinstance(self.tables, RatedCase):
            return self.tables.rated_duty(self.drive)
        table = self._worm_gear
        return None if table is None else worm_duty_of_table(table)

    @property
    def worm_duty(self) -> WormDuty:
        """Its worm gear as the standards see it; ValueError where it has none."""
        if not isinstance(self.duty, WormDuty):
            raise ValueError("the case has no worm gear that standards know")
        return self.duty

    @property
    def mean_diameters(self) -> dict[float, float]:
        """Speed of the shaft of each bearing whose size is given [rad/s] -> its mean diameter [m]."""
        return {
            self.bearing_speed(bearing): bearing.mean_diameter
            for bearing in self.tables.bearings.values()
            if bearing.mean_diameter is not None
        }

    def bearing_speed(self, bearing: BearingTable) -> float:
        """Speed of a bearing [rad/s], as given or that of its shaft; ValueError of an unknown shaft."""
        if bearing.speed is not None:
            return bearing.speed
        if (element := self.bearing_element(bearing)) is not None:
            return element.speed
        speeds = {} if self.drive is None else self.drive.shaft_speeds
        return speeds[one_of("shaft", bearing.shaft or "", speeds)]

    def bearing_element(self, bearing: BearingTable) -> ElementBearing | None:
        """The element on whose pin a bearing is; None of a bearing of a shaft."""
        if bearing.side is not None or bearing.shaft is None or self.drive is None:
            return None
        element = self.drive.element_bearing()
        names = () if element is None else (element.name,)
        one_of("shaft without a side", bearing.shaft, names)
        return element

    @property
    def _worm_gear(self) -> WormGearTable | None:
        return self.tables.worm_gear if isinstance(self.tables, RatingCase) else None

    @property
    def beyond_limits(self) -> tuple[str, ...]:
        """Bodies of its drive that are hotter than their material bears, a sentence each."""
        if self.drive is None:
            return ()
        return beyond_limits(self.drive.body_names, self.drive.bodies)

    @property
    def rating_is_asked(self) -> bool:
        """True if the case asks for a rating."""
        return self.worm_rating is not None or bool(self.tables.bearings)

    @property
    def worm_rating(self) -> CompletedRating | None:
        """`[worm_rating]`, completed by what the drive states; None where the case has none."""
        table = getattr(self.tables, "worm_rating", None)
        if table is None:
            return None
        if isinstance(self.tables, WormRated):
            return self.tables.rating_as_run()
        return table.completed()


def _sound(result: Result | None) -> Result | None:
    """The result with its converged solutions; None where there are none."""
    sound = result and result.sound
    return sound if sound and sound.solutions else None


def _thinnest(
    request: RatingRequest, result: Result | None
) -> tuple[Scene | LineScene, Solution | None]:
    """The contact with the thinnest film: of those solved, else of those listed, by closed form."""
    drive = present(request.drive, "drive")
    if result is not None:
        solution = min(result.solutions, key=lambda solution: solution.figures.film_min.value)
        return drive.scene(**ContactIndex.of(solution).given), solution
    scenes = [drive.scene(**place.given) for place in request.places]
    return min(scenes, key=lambda scene: predicted(scene).film_central), None


def neglected_effects(request: RatingRequest, result: Result | None = None) -> NeglectedEffects:
    """Effects left out of the solved contacts of a case; without any, the lubrication by closed forms."""
    result = _sound(result)
    if result is not None:
        return of_all(result.solutions)
    if request.drive is not None:
        scene, _ = _thinnest(request, None)
        prediction = predicted(scene)
        films = prediction.film_central, prediction.film_min
        at_worst = judged((), 0.0, films, scene.composite_roughness)
        return replace(at_worst, contacts=len(request.places), by_formula=True)
    table = request.worm_rating
    if table is None:
        return NeglectedEffects()

    def lubricated() -> NeglectedEffects:
        duty = request.worm_duty
        film = RatedWormGear(table, duty, request.directory).hardest.rated.film  # a mean of lines
        found = judged((), 0.0, (film, film), duty.composite_roughness)
        return replace(found, by_formula=True)

    return or_none(attempt(lubricated)) or NeglectedEffects()


def load_rating_request(source: str | Path | Mapping[str, Any]) -> RatingRequest:
    """Read a case file, or its tables, for its ratings; CaseError for whatever is wrong first."""
    if isinstance(source, Mapping):
        if "drive" in source or "contact" in source:
            return rating_request(load(source))
        return _ratings_alone(as_file(source, "case", RatingCase), "case", Path())
    path = Path(source)
    data = read_toml(path)
    try:
        if "drive" in data or "contact" in data:
            return rating_request(case_of(data, path.stem, path.parent))
        return _ratings_alone(data, path.stem, path.parent)
    except CaseError as error:
        raise CaseError(f"{path}: {error}") from error


def _ratings_alone(data: dict[str, Any], name: str, directory: Path) -> RatingRequest:
    """The requests of a file without a contact."""
    if not any(table in data for table in RATING_TABLES):
        raise CaseError("give a [drive], [bearings.NAME] or [worm_gear] to be rated")
    tables = checked(RatingCase, data)
    return RatingRequest(name, directory, tables, warnings=unusual(tables, data))


def rating_request(case: Case) -> RatingRequest:
    """Requests for ratings of a solvable case; CaseError if nothing can be rated."""
    if not isinstance(case.tables, RatedCase):
        kinds = ", ".join(f'"{kind}"' for kind in rated())
        raise CaseError(f"only drives of kind {kinds} and bearings are rated")
    return RatingRequest(
        case.name, case.directory, case.tables, case.drive, case.warnings, case.places()
    )


def ratings(request: RatingRequest, result: Result | None = None) -> tuple[Rating, ...]:
    """Every rating that a case asks for and that is possible; the others are in `not_rated`.

    Contacts of a result that did not converge are left out (`unconverged`). CaseError for a file or a name in
    the case that there is not.
    """
    return tuple(
        rating
        for _, outcome in _attempts(request, _sound(result))
        if not isinstance(outcome, Unknown)
        for rating in outcome
    )


def _attempts(
    request: RatingRequest, result: Result | None
) -> Iterator[tuple[str, tuple[Rating, ...] | Unknown]]:
    """Name of each rating that a case asks for, and the rating or why there is none."""
    tables, drive, table = request.tables, request.drive, request.worm_rating
    if table is not None:

        def worm_gear() -> tuple[Rating, ...]:
            gear_set = RatedWormGear(table, request.worm_duty, request.directory)
            return (rate_worm_gear(gear_set, drive, result),)

        yield "Worm gear", _attempt(worm_gear)
        if drive is not None and result is not None:
            yield "Contacts", _attempt(lambda: (worm_flanks(request.worm_duty, drive.oil, result),))
    if table is not None and tables.starting is not None:
        yield "Starting", _attempt(partial(_start, request, table, tables.starting))
    if drive is not None and request.rated_as is GearPairDuty:
        yield "Gears", _attempt(partial(_gear_pair, request, drive, result))
    if drive is not None:
        yield "Films by formula", _attempt(lambda: (rate_films(*_thinnest(request, result)),))
    if drive is not None:
        yield "Forces", _attempt(partial(_forces, request, drive, result))
        if isinstance(tables, RatedCase) and tables.scuffing is not None:
            yield "Scuffing", _attempt(partial(_scuffing, drive, tables, result))
        yield "Roots", _attempt(partial(_roots, drive))
        yield "Rollers", _attempt(partial(_element_bearing, drive))
        yield "Motion", _attempt(partial(_motion, drive))
    if getattr(tables, "cooling", None) is not None:
        yield "Temperatures", _attempt(lambda: (rate_temperatures(thermal_unit(request)),))
    for name, bearing in tables.bearings.items():
        yield (
            f"Bearing {bearing.name or name}",
            _attempt(partial(_bearing, request, name, bearing, result)),
        )


def _attempt(rate: Callable[[], tuple[Rating, ...]]) -> tuple[Rating, ...] | Unknown:
    """Ratings, or why a method has none; what is wrong in the case itself is raised."""
    try:
        return rate()
    except CaseError:
        raise
    except ValueError as error:
        return Unknown(str(error))


def _start(
    request: RatingRequest, rating: CompletedRating, table: StartingTable
) -> tuple[Rating, ...]:
    duty = request.worm_duty
    resistance = worm_no_load(duty, rating.bearings, request.mean_diameters)
    gear_set = RatedWormGear(rating, duty, request.directory)
    unit = None
    if getattr(request.tables, "cooling", None) is not None:
        warmed = thermal_unit(request)
        unit = warmed if warmed.cooling.housing is not None else None
    return (rate_start(WormStart(gear_set, table, resistance, unit)),)


def _gear_pair(request: RatingRequest, drive: Drive, result: Result | None) -> tuple[Rating, ...]:
    tables, duty = request.tables, request.duty
    if not (isinstance(duty, GearPairDuty) and isinstance(tables, GearRated)):
        raise ValueError("the case has no pair of gears that standards know")
    table, base = tables.gear_rating, tables.gear_rating.base or tables.oil.base
    return tuple(rate_gear_pair(drive, duty, table, base, tables.published, result))


def _friction(request: RatingRequest, drive: Drive, result: Result | None) -> Friction:
    """Friction of the mesh by the standard and as simulated; that of the balance of torques without."""
    simulated = None if result is None else mesh_loss(drive, result)
    tables, running = request.tables, {}
    starting: float | Unknown = Unknown("no standard has the friction at rest")
    if isinstance(tables, WormRated) and isinstance(request.duty, WormDuty):
        table, duty = tables.rating_as_run(), request.duty
        by_standard = attempt(lambda: rated_teeth(table, request.directory, duty))
        # the standard's is the tangent of the friction angle, in a plane; the flank's normal is steeper
        upright = cos(duty.gear.pressure_angle)
        friction = attempt(lambda: upright * known(by_standard).friction)
        starting = attempt(lambda: upright * known(by_standard).static_friction)
        running = {} if isinstance(friction, Unknown) else {"standard": friction}
    if simulated is not None:
        running[SIMULATION] = simulated.friction
    balanced = drive.mesh_forces()
    assumed = 0.0 if balanced is None else balanced.friction
    return Friction(running or {"computed": assumed}, starting)


def thermal_unit(request: RatingRequest) -> GearUnit:
    """The thermal network of a case; ValueError without `[cooling]`."""
    tables = request.tables
    if not isinstance(tables, Cooled) or tables.cooling is None:
        raise ValueError("temperatures need [cooling]")
    return tables.unit_of(present(request.drive, "drive"))


def _forces(request: RatingRequest, drive: Drive, result: Result | None) -> tuple[Rating, ...]:
    found = rate_forces(drive, _friction(request, drive, result))
    return () if found is None else (found,)


def _scuffing(drive: Drive, tables: RatedCase, result: Result | None) -> tuple[Rating, ...]:
    table = present(tables.scuffing, "scuffing")
    if result is None:
        return ()
    return (rate_scuffing(drive, table, table.base or tables.oil.base, result),)


def _roots(drive: Drive) -> tuple[Rating, ...]:
    found = rate_roots(drive)
    return () if found is None else (found,)


def _element_bearing(drive: Drive) -> tuple[Rating, ...]:
    found = drive.element_bearing()
    return () if found is None else (rate_element_bearing(found),)


def _motion(drive: Drive) -> tuple[Rating, ...]:
    found = drive.motion_figures()
    return () if found is None else (rate_motion(found),)


def _bearing(
    request: RatingRequest, name: str, table: BearingTable, result: Result | None
) -> tuple[Rating, ...]:
    drive, shaft = request.drive, None
    if table.shaft is not None and table.side is not None and drive is not None:
        speed = request.bearing_speed(table)
        friction, coefficient = _friction(request, drive, result).decisive
        force = present(drive.mesh_forces(coefficient), "forces").on(table.shaft)
        if table.shaft not in drive.supports:
            raise ValueError(
                f"the distance of the {table.shaft} shaft's bearings is not given, bearing_span"
            )
        bearing = force.bearings(drive.supports[table.shaft])[table.side]
        shaft = ShaftLoad(bearing, speed, friction)
    elif (element := request.bearing_element(table)) is not None:
        shaft = element_load(element)
    return (rate_bearing_table(name, table, request.directory, shaft),)


def unconverged(result: Result | None) -> tuple[str, ...]:
    """Contacts of a result that did not converge, one sentence each."""
    if result is None:
        return ()
    return tuple(
        f"{ContactIndex.of(solution)} did not converge and is not included: {solution.stop_reason}."
        for solution in result.unsound
    )


def not_rated(request: RatingRequest, possible: tuple[Rating, ...]) -> tuple[str, ...]:
    """Ratings, and parts of ratings, that a case leaves out, each with the reason."""
    left = [sentence for rating in possible for sentence in rating.not_rated]
    failed = [
        (name, outcome)
        for name, outcome in _attempts(request, None)
        if isinstance(outcome, Unknown)
    ]
    left += [f"{name}: {outcome.why.rstrip('.')}." for name, outcome in failed]
    if request.rated_as is WormDuty and request.worm_rating is None:
        left += ["Worm gear: the case has no [worm_rating].", *NEVER_RATED]
    if request.rated_as is GearPairDuty:
        left.append("Pitting and tooth root strength: no formulas of them are known here.")
    if request.drive is not None and request.rated_as is None:
        left.append("Teeth or rollers: no standard that is known here covers this kind of gears.")
    if not request.tables.bearings:
        left.append("Bearings: the case has no [bearings.NAME].")
    return tuple(left)
