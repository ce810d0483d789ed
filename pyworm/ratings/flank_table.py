"""Scuffing and micropitting at every solved contact: closed forms of the place, and the simulation."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pyworm.formulas.micropitting import SOURCE as MICROPITTING_SOURCE
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.quantities import QUANTITIES
from pyworm.ratings.flank_damage import LEAST_SHARE, Limit, Spot
from pyworm.ratings.rating import RatedFigure, Rating
from pyworm.solver.neglected_effects import NeglectedEffects


@dataclass(frozen=True)
class ClosedForms:
    """Closed forms along the line of action, arrays over phase; None where they are not known."""

    phase: np.ndarray
    """Place in the mesh."""
    temperature: np.ndarray | None
    """Contact temperature with the case's friction [K]."""
    film: np.ndarray | None
    """Film of ISO/TS 6336-22 [m]."""
    flash_over_friction: np.ndarray | None
    """Flash temperature for each unit of friction [K]."""
    bulk: float | None
    """Bulk temperature [K]."""

    def at(self, name: str, phase: float | None) -> float | None:
        """One of the arrays at a phase."""
        values = getattr(self, name)
        return (
            None if values is None or phase is None else float(np.interp(phase, self.phase, values))
        )


def flank_table(
    spots: tuple[Spot, ...],
    limits: tuple[Limit, Limit],
    oil_temperature: float | None,
    roughness: float | None,
    neglected_effects: NeglectedEffects,
    closed: ClosedForms | None = None,
    words: tuple[str, ...] = (),
    title: str = "Scuffing and micropitting at each solved contact",
    source: str = f"Blok 1937, ISO/TS 6336-20; {MICROPITTING_SOURCE}",
) -> Rating:
    """Contact temperatures and specific films of all solved contacts against what the oil bears.

    By the oil before the mesh [K] and Ra, mean of both flanks [m].
    """
    rows = _rows(limits, oil_temperature, roughness, closed)
    figures = []
    for key, label, unit, value_of in rows:
        found = [value_of(spot) for spot in spots]
        if any(value is not None for value, _ in found):
            values, error_bars = zip(*found, strict=True)
            figures.append(RatedFigure(key, label, values, unit, error_bars))
    return Rating(
        key="flanks",
        title=title,
        source=source,
        columns=tuple(spot.name for spot in spots),
        figures=tuple(figures),
        words=(
            "Simulated temperatures are the largest of both flanks in a contact, simulated films the least; "
            "specific film thickness is over Ra, mean of both flanks.",
            *words,
        ),
        neglected_effects=neglected_effects,
    )


_Barred = tuple[float | None, tuple[float, float | None] | None]
_Row = tuple[str, str, str, Callable[[Spot], _Barred]]


def _rows(
    limits: tuple[Limit, Limit],
    oil: float | None,
    roughness: float | None,
    closed: ClosedForms | None,
) -> list[_Row]:
    """Key, label, unit and value of each row."""
    scuffing, permissible = limits[0].value, limits[1].value

    def celsius(spot: Spot) -> _Barred:
        if spot.temperature is None or oil is None:
            return None, None
        rise, (error, model) = spot.temperature - oil, spot.bars[0]
        return spot.temperature - ZERO_CELSIUS, (
            error * rise,
            None if model is None else model * rise,
        )

    def safety(spot: Spot) -> _Barred:
        if spot.temperature is None or scuffing is None or oil is None or spot.temperature <= oil:
            return None, None
        return _barred((scuffing - oil) / (spot.temperature - oil), spot.bars[0])

    def specific(spot: Spot) -> _Barred:
        return (None, None) if roughness is None else _barred(spot.film / roughness, spot.bars[1])

    def film_safety(spot: Spot) -> _Barred:
        if roughness is None or permissible is None or spot.asperities > LEAST_SHARE:
            return None, None
        return _barred(spot.film / roughness / permissible, spot.bars[1])

    carried = QUANTITIES["asperity_load_fraction"]
    simulated = [
        ("friction_simulated", "Friction, simulated", "", lambda spot: (spot.friction, None)),
        ("asperity_share", f"{carried.title()}, simulated", carried.shown, _asperities),
        ("contact_temperature_simulated_C", "Contact temperature, simulated", "°C", celsius),
        ("S_B_simulated", "S_B, simulated", "", safety),
        ("specific_film_simulated", "Specific film thickness, simulated", "", specific),
        ("S_lambda_simulated", "S_lambda, simulated", "", film_safety),
    ]
    return (
        simulated if closed is None else [*_closed_rows(limits, oil, roughness, closed), *simulated]
    )


def _asperities(spot: Spot) -> _Barred:
    return spot.asperities, None


def _barred(value: float, bars: tuple[float, float | None]) -> _Barred:
    """A value with its relative bars made absolute."""
    return value, (value * bars[0], None if bars[1] is None else value * bars[1])


def _closed_rows(
    limits: tuple[Limit, Limit], oil: float | None, roughness: float | None, closed: ClosedForms
) -> list[_Row]:
    scuffing, permissible = limits[0].value, limits[1].value

    def celsius(spot: Spot) -> _Barred:
        kelvin = closed.at("temperature", spot.phase)
        return (None if kelvin is None else kelvin - ZERO_CELSIUS), None

    def blok(spot: Spot) -> _Barred:
        flash = closed.at("flash_over_friction", spot.phase)
        if flash is None or spot.friction is None or closed.bulk is None:
            return None, None
        return closed.bulk + flash * spot.friction - ZERO_CELSIUS, None

    def safety(spot: Spot) -> _Barred:
        kelvin = closed.at("temperature", spot.phase)
        if kelvin is None or scuffing is None or oil is None or kelvin <= oil:
            return None, None
        return (scuffing - oil) / (kelvin - oil), None

    def specific(spot: Spot) -> _Barred:
        film = closed.at("film", spot.phase)
        return (None if film is None or roughness is None else film / roughness), None

    def film_safety(spot: Spot) -> _Barred:
        found = specific(spot)[0]
        return (None if found is None or permissible is None else found / permissible), None

    return [
        ("contact_temperature_C", "Contact temperature, Blok", "°C", celsius),
        ("S_B", "S_B", "", safety),
        ("specific_film", "Specific film thickness, ISO/TS 6336-22", "", specific),
        ("S_lambda", "S_lambda", "", film_safety),
        (
            "contact_temperature_blok_C",
            "Contact temperature, Blok with the simulated friction",
            "°C",
            blok,
        ),
    ]
