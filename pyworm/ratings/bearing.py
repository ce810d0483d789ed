"""Bearings of a case by ISO 281, beside the source's values."""

from dataclasses import dataclass
from math import pi
from pathlib import Path

from pyworm.case.ratings import BearingTable
from pyworm.case.table import plain
from pyworm.drives.forces import BearingForce
from pyworm.formulas.bearing_life import (
    BearingRating,
    RollingBearing,
    contamination_factor,
    fatigue_load_limit,
    viscosity_ratio,
)
from pyworm.formulas.bearing_load import LoadFactors, equivalent_load, load_factors
from pyworm.formulas.ranges import apart
from pyworm.formulas.unknown import Unknown, attempt, known, or_none
from pyworm.io.present import present
from pyworm.materials.oil_file import oil_called
from pyworm.ratings.rating import RatedFigure, Rating, without_value

# Key, label, attribute of `BearingRating`, unit
_FIGURES = (
    ("viscosity_m2_s", "Viscosity at the bearing", "viscosity", "mm²/s"),
    ("reference_viscosity_m2_s", "Viscosity required, nu1", "reference_viscosity", "mm²/s"),
    ("kappa", "Viscosity ratio kappa", "kappa", ""),
    ("contamination", "Contamination e_C", "contamination", ""),
    ("modification", "Life modification a_ISO", "modification", ""),
    ("reliability_factor", "Reliability factor a1", "reliability_factor", ""),
    ("basic_life_rev", "Basic life L10", "basic_life", "Mrev"),
    ("basic_life_h", "Basic life L10h", "basic_hours", "h"),
    ("modified_life_rev", "Modified life L_nm", "modified_life", "Mrev"),
    ("modified_life_h", "Modified life L_nmh", "modified_hours", "h"),
)

_PRINTED_IN = {"basic_hours": 3600.0, "modified_hours": 3600.0}
_PRINTED_IN |= {"basic_life": 2 * pi, "modified_life": 2 * pi}
"""What printed figures in SI (s, rad) are divided by."""


def bearing_viscosity(table: BearingTable, directory: Path) -> float | Unknown:
    """Kinematic viscosity of the oil at the bearing [m2/s]."""
    if table.viscosity is not None:
        return table.viscosity
    if table.oil is None:
        return Unknown("viscosity is missing, or oil with temperature")
    oil = oil_called(table.oil, directory)
    warm = present(table.temperature, "temperature")
    return attempt(lambda: float(oil.kinematic_viscosity(warm)))


@dataclass(frozen=True)
class ShaftLoad:
    """A shaft that a bearing carries."""

    force: BearingForce
    """Load of the bearing from the mesh."""
    speed: float
    """Speed of the shaft [rad/s]."""
    friction: str
    """Origin of the friction in the forces, such as "simulation"."""
    words: str = ""
    """Where load and speed come from if not from the bearings of a shaft; empty if they do."""


@dataclass(frozen=True)
class CarriedLoad:
    """Equivalent load and speed of a bearing, with a sentence about where they come from."""

    load: float
    """Equivalent load P [N]."""
    speed: float
    """Speed [rad/s]."""
    words: str = ""
    """Where they come from; empty where both are given without a shaft."""


def carried_load(table: BearingTable, shaft: ShaftLoad | None) -> CarriedLoad:
    """Load and speed of a bearing, as given or as its shaft has them; ValueError without its factors."""
    if shaft is None:
        return CarriedLoad(present(table.load, "load"), present(table.speed, "speed"))
    speed = shaft.speed if table.speed is None else table.speed
    if table.load is not None:
        return CarriedLoad(
            table.load,
            speed,
            f"The load of {table.load:.4g} N is given and is taken, not that of the {table.shaft} shaft.",
        )
    radial, thrust = shaft.force.radial, shaft.force.thrust if table.locating else 0.0
    load = _equivalent(table, radial, thrust)
    words = shaft.words or (
        f"Radial load {radial:.4g} N and thrust {thrust:.4g} N of the {table.shaft} shaft's bearing on the "
        f"{table.side} side, with the friction of the {shaft.friction}, make {load:.4g} N; what adjusted "
        "bearings push each other is not in it."
    )
    return CarriedLoad(load, speed, words)


def _equivalent(table: BearingTable, radial: float, thrust: float) -> float:
    """Equivalent load [N] of a radial load and a thrust [N]."""
    if table.direction == "thrust":
        return thrust
    if thrust == 0:
        return radial
    given = table.thrust_limit, table.radial_factor, table.thrust_factor
    limit, across, along = given
    if limit is None or across is None or along is None:
        factors = load_factors(table.elements, table.contact_angle, thrust, table.static_rating)
    else:
        factors = LoadFactors(limit, across, along)
    return equivalent_load(radial, thrust, factors)


def bearing_life(table: BearingTable, directory: Path, carried: CarriedLoad) -> BearingRating:
    """The bearing by ISO 281 under its load; CaseError where it names an oil that there is not."""
    viscosity = bearing_viscosity(table, directory)
    diameter = table.mean_diameter
    size = Unknown("mean_diameter is missing") if diameter is None else diameter
    return BearingRating(
        **vars(plain(table, RollingBearing)),
        load=carried.load,
        speed=carried.speed,
        fatigue_load_limit=_fatigue_load_limit(table, size),
        mean_diameter=size,
        viscosity=viscosity,
        contamination=_contamination(table, viscosity, size, carried.speed),
    )


def _fatigue_load_limit(table: BearingTable, size: float | Unknown) -> float | Unknown:
    """C_u [N], as given or as it follows from C_0."""
    limit, static = table.fatigue_load_limit, table.static_rating
    if limit is not None:
        return limit
    if static is None:
        return Unknown("fatigue_load_limit is missing, or static_rating")
    return attempt(lambda: fatigue_load_limit(static, table.elements, known(size)))


def _contamination(
    table: BearingTable, viscosity: float | Unknown, size: float | Unknown, speed: float
) -> float | Unknown:
    """e_C [-], as given or as it follows from lubrication and cleanliness."""
    if table.contamination is not None:
        return table.contamination
    if table.lubrication is None or table.cleanliness is None:
        return Unknown("contamination is missing, or lubrication with cleanliness")
    how = table.lubrication, table.cleanliness

    def by_cleanliness() -> float:
        kappa = viscosity_ratio(known(viscosity), speed, known(size))
        return contamination_factor(*how, kappa, known(size))

    return attempt(by_cleanliness)


def rate_bearing_table(
    name: str, table: BearingTable, directory: Path, shaft: ShaftLoad | None = None
) -> Rating:
    """One bearing of a case, with the load of its shaft."""
    carried = carried_load(table, shaft)
    rated = bearing_life(table, directory, carried)
    columns = ("computed", "printed") if table.published else ("computed",)
    load = (RatedFigure("equivalent_load_N", "Equivalent load P", (carried.load,), "N"),)
    figures = tuple(_figure(rated, table, *row) for row in _FIGURES)
    figures = (*(load if carried.words else ()), *figures)
    kappa = attempt(lambda: rated.kappa)
    return Rating(
        key=f"bearing {name}",
        title=f"Bearing {table.name or name}",
        source=rated.source,
        columns=columns,
        figures=figures,
        words=tuple(
            filter(None, (carried.words, "" if isinstance(kappa, Unknown) else _words(kappa)))
        ),
        not_rated=tuple(
            f"bearings.{name}, {labels}: {why}." for why, labels in without_value(figures).items()
        ),
    )


def _figure(
    rated: BearingRating, table: BearingTable, key: str, label: str, attribute: str, unit: str
) -> RatedFigure:
    """A figure beside the printed one, or why there is none."""
    found = attempt(lambda: known(getattr(rated, attribute)))
    printed = table.published.get(attribute)
    beside = None if printed is None else printed.value / _PRINTED_IN.get(attribute, 1.0)
    values = (or_none(found), beside) if table.published else (or_none(found),)
    why = found.why if isinstance(found, Unknown) else ""
    return RatedFigure(key, label, values, unit, why=why)


def _words(kappa: float) -> str:
    if kappa < 1:
        return (
            f"kappa = {apart(kappa, 1, 3)} is below 1: the film does not keep rolling elements and raceways "
            "apart."
        )
    if kappa < 4:
        return f"kappa = {apart(kappa, 4, 3)}: the oil is thick enough; life grows further up to kappa = 4."
    return f"kappa = {apart(kappa, 4, 3)} is above 4: a higher viscosity does not extend the life."
