"""Bearings of a case by ISO 281, beside the source's values."""

from math import pi
from pathlib import Path

from pyworm.case.ratings import BearingTable
from pyworm.formulas.bearing_life import (
    REVOLUTIONS,
    BearingRating,
    contamination_factor,
    fatigue_load_limit,
    rate_bearing,
    viscosity_ratio,
)
from pyworm.materials.oil_file import oil_called
from pyworm.ratings.rating import RatedFigure, Rating, Value

# Key, label, attribute of `BearingRating`, scale to the unit shown, unit
_FIGURES = (
    ("reference_viscosity_m2_s", "Viscosity wanted, nu1", "reference_viscosity", 1e6, "mm²/s"),
    ("kappa", "Viscosity ratio kappa", "kappa", 1.0, ""),
    ("contamination", "Contamination e_C", "contamination", 1.0, ""),
    ("modification", "Life modification a_ISO", "modification", 1.0, ""),
    ("reliability_factor", "Reliability factor a1", "reliability_factor", 1.0, ""),
    ("basic_life_rev", "Basic life L10", "basic_life", 1 / REVOLUTIONS, "Mrev"),
    ("basic_life_h", "Basic life L10h", "basic_hours", 1.0, "h"),
    ("modified_life_rev", "Modified life L_nm", "modified_life", 1 / REVOLUTIONS, "Mrev"),
    ("modified_life_h", "Modified life L_nmh", "modified_hours", 1.0, "h"),
)

_PRINTED_IN = {"basic_hours": 3600.0, "modified_hours": 3600.0}
_PRINTED_IN |= {"basic_life": 2 * pi, "modified_life": 2 * pi}
"""What printed figures in SI (s, rad) are divided by."""


def bearing_viscosity(table: BearingTable, directory: Path) -> float:
    """Kinematic viscosity of the oil at the bearing [m2/s]."""
    if table.viscosity is not None:
        return table.viscosity
    return float(oil_called(table.oil, directory).kinematic_viscosity(table.temperature))


def bearing_life(table: BearingTable, directory: Path) -> BearingRating:
    """The bearing by ISO 281; ValueError for what lies outside the standard."""
    viscosity = bearing_viscosity(table, directory)
    contamination = table.contamination
    if contamination is None:
        kappa = viscosity_ratio(viscosity, table.speed, table.mean_diameter)
        contamination = contamination_factor(
            table.lubrication, table.cleanliness, kappa, table.mean_diameter
        )
    limit = table.fatigue_load_limit
    if limit is None:
        limit = fatigue_load_limit(table.static_rating, table.elements, table.mean_diameter)
    return rate_bearing(
        elements=table.elements,
        dynamic_rating=table.dynamic_rating,
        fatigue_load_limit=limit,
        load=table.load,
        speed=table.speed,
        mean_diameter=table.mean_diameter,
        viscosity=viscosity,
        contamination=contamination,
        direction=table.direction,
        additives=table.additives,
        reliability=table.reliability,
    )


def rate_bearing_table(name: str, table: BearingTable, directory: Path) -> Rating:
    """One bearing of a case.

    Parameters
    ----------
    name : str
        Its key in the file.
    table : BearingTable
        Tables of the case file.
    directory : Path
        Where the file lies.
    """
    rated = bearing_life(table, directory)
    viscosity = bearing_viscosity(table, directory)
    columns = ("computed", "printed") if table.published else ("computed",)

    def values(attribute: str, computed: Value) -> tuple[Value, ...]:
        if not table.published:
            return (computed,)
        printed = table.published.get(attribute)
        divisor = _PRINTED_IN.get(attribute, 1.0)
        return computed, None if printed is None else printed.value / divisor

    figures = [
        RatedFigure(
            "viscosity_m2_s", "Viscosity at the bearing", values("viscosity", viscosity), 1e6,
            "mm²/s",
        )
    ]  # fmt: skip
    figures += [
        RatedFigure(key, label, values(attribute, getattr(rated, attribute)), scale, unit)
        for key, label, attribute, scale, unit in _FIGURES
    ]
    return Rating(
        key=f"bearing {name}",
        title=f"Bearing {table.name or name}",
        source=rated.source,
        columns=columns,
        figures=tuple(figures),
        words=(_words(rated.kappa),),
    )


def _words(kappa: float) -> str:
    if kappa < 1:
        return f"kappa = {kappa:.3g} is below 1: the film does not keep rolling elements and raceways apart."
    if kappa < 4:
        return f"kappa = {kappa:.3g}: the oil is thick enough; life grows further up to kappa = 4."
    return f"kappa = {kappa:.3g} is above 4: thicker oil gains no more life."
