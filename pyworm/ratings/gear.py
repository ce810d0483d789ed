"""Gear pairs by AGMA's closed forms: specific film, wear, scuffing, oil flow, beside the simulation."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from pyworm.case.case_file import PublishedValue
from pyworm.case.ratings import GearRatingTable
from pyworm.drives.drive import Drive
from pyworm.drives.duty import GearPairDuty
from pyworm.formulas import gear_oil, scuffing
from pyworm.formulas.nozzle import jet_discharge
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.formulas.wear_distress import SOURCE as WEAR_SOURCE
from pyworm.formulas.wear_distress import rate_wear
from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES
from pyworm.materials.base_stock import Base
from pyworm.ratings.flank_damage import BASIS, LEAST_SHARE, Spot, hotter_flank, simulated_spots
from pyworm.ratings.gear_damage import GearDamage, mean_scuffing_temperature
from pyworm.ratings.mesh_loss import mesh_loss, with_missing
from pyworm.ratings.rating import SIMULATION, RatedFigure, Rating
from pyworm.result.headline import of_all
from pyworm.result.result import Result
from pyworm.solver.neglected_effects import NeglectedEffects
from pyworm.solver.solution import Solution


def rate_gear_pair(
    drive: Drive,
    duty: GearPairDuty,
    table: GearRatingTable,
    base: Base | None,
    published: dict[str, PublishedValue],
    result: Result | None = None,
) -> tuple[Rating, ...]:
    """Ratings of a gear pair along its line of action, as far as its flanks are known, and of its oil supply.

    With a result also those of each solved contact; what the case's source prints (`published`) is shown
    beside under the same names. ValueError for what lies outside the formulas.
    """
    damage = GearDamage(duty, table, base)
    teeth = _teeth(drive, duty, damage, published, result)
    if result is None:
        return teeth, _supply(duty, table)
    return teeth, damage.at_each(result), _supply(duty, table)


def _teeth(
    drive: Drive,
    duty: GearPairDuty,
    damage: GearDamage,
    published: dict[str, PublishedValue],
    result: Result | None,
) -> Rating:
    closed = _closed_forms(duty, damage.table)
    safeties = damage.safeties(result)
    printed = {
        key: _as_shown(published[name], key) for key, _, name, _ in _TEETH if name in published
    }
    simulated = {} if result is None else _simulated(drive, duty, result)
    given: dict[str, Mapping[str, Any]]
    given = {"closed form": closed, SIMULATION: simulated, "printed": printed}
    columns = {name: values for name, values in given.items() if values}
    figures = tuple(
        RatedFigure(
            key,
            with_missing(key, label, result) if key in simulated else label,
            tuple(column.get(key) for column in columns.values()),
            unit,
        )
        for key, label, _, unit in _TEETH
        if any(column.get(key) is not None for column in columns.values())
    )
    words = ["Phase 0 is the start of the pinion's active profile, 1 its end, at the tip."]
    if simulated:
        words.append(
            "The simulation covers the solved phases only; between them its friction is interpolated. "
            "The probability of scuffing is not judged by its temperatures, since the scuffing temperature "
            "belongs to Blok's formula with the friction of the closed form."
        )
    words += list(
        dict.fromkeys(f"{safety.symbol}: {doubt}" for safety in safeties for doubt in safety.doubts)
    )
    return Rating(
        key="gear teeth",
        title="Gear teeth: film, wear and scuffing",
        source=(
            f"Dowson and Higginson; {WEAR_SOURCE}; {scuffing.SOURCE}; "
            f"{gear_oil.withdrawn('AGMA 2001-B88')}"
        ),
        columns=tuple(columns),
        figures=figures,
        safeties=safeties,
        basis=BASIS,
        words=tuple(words),
        failed=tuple(safety.failure for safety in safeties if safety.failure),
        not_rated=tuple(
            f"{safety.symbol}, {safety.label}: {safety.why}"
            for safety in safeties
            if safety.value is None
        ),
        neglected_effects=NeglectedEffects() if result is None else of_all(result.solutions),
    )


def _row(name: str, key: str = "") -> tuple[str, str, str, str]:
    """A quantity as a row, under a key of its own where that is older."""
    quantity = QUANTITIES[name]
    return key or quantity.key, quantity.title(), quantity.published, quantity.shown


# Key, label, name under [published], unit
_TEETH = (
    ("pitch_line_velocity_m_s", "Pitch line velocity", "pitch_line_velocity", "m/s"),
    _row("film_min"),
    ("film_min_phase", "  at phase", None, ""),
    _row("composite_roughness"),
    _row("specific_film"),
    ("regime", "Lubrication", None, ""),
    ("wear_probability", "Probability of wear distress", "wear_probability", "%"),
    _row("hertz_pressure_max", "hertz_pressure_Pa"),
    ("loss_factor", "Loss factor H_V", None, ""),
    _row("mesh_friction", "friction"),
    _row("mesh_loss", "loss_W"),
    _row("mesh_efficiency", "efficiency"),
    ("flash_temperature_K", "Largest flash temperature", None, "K"),
    ("contact_temperature_C", "Largest contact temperature", "contact_temperature", "°C"),
    ("contact_temperature_phase", "  at phase", None, ""),
    ("scuffing_temperature_C", "Mean scuffing temperature", "scuffing_temperature", "°C"),
    ("scuffing_probability", "Probability of scuffing", "scuffing_probability", "%"),
    ("scuffing_risk", "Risk of scuffing", None, ""),
)


def _closed_forms(duty: GearPairDuty, table: GearRatingTable) -> dict[str, float | str | None]:
    """Film, wear, loss and scuffing by formulas, at the worst place of the line of action."""
    line = duty.line_of_action
    thin = line.thinnest
    closed: dict[str, float | str | None] = {
        "pitch_line_velocity_m_s": duty.pitch_line_velocity,
        "film_min_m": float(line.film_min[thin]),
        "film_min_phase": float(line.phase[thin]),
        **_wear(duty, float(line.film_min[thin])),
        "hertz_pressure_Pa": float(line.hertz_pressure.max()),
        "loss_factor": duty.loss_factor,
    }
    if duty.friction is not None:
        closed |= {
            "friction": duty.friction,
            "loss_W": duty.power * duty.loss_factor * duty.friction,
            "efficiency": 1 - duty.loss_factor * duty.friction,
        }
    if line.contact_temperature is not None and line.flash_temperature is not None:
        hot = int(np.argmax(line.contact_temperature))
        hottest = float(line.contact_temperature[hot])
        closed |= {
            "flash_temperature_K": float(line.flash_temperature[hot]),
            "contact_temperature_C": hottest - ZERO_CELSIUS,
            "contact_temperature_phase": float(line.phase[hot]),
            **_scuffing(hottest, mean_scuffing_temperature(duty, table)),
        }
    return closed


def _as_shown(printed: PublishedValue, key: str) -> float:
    return printed.value - ZERO_CELSIUS if key.endswith("_C") else printed.value


def _scuffing(contact: float, limit: float | None) -> dict[str, float | str]:
    if limit is None:
        return {}
    probability = float(scuffing.scuffing_probability(contact, limit))
    return {
        "scuffing_temperature_C": limit - ZERO_CELSIUS,
        "scuffing_probability": probability,
        "scuffing_risk": scuffing.risk(probability),
    }


def _wear(duty: GearPairDuty, film: float, spots: tuple[Spot, ...] = ()) -> dict[str, float | str]:
    """Specific film and wear of a least film [m]; nothing where the roughness is not known.

    The probability is of films of smooth flanks: none where asperities hold simulated ones apart.
    """
    roughness = duty.composite_roughness
    if roughness is None:
        return {}
    wear = rate_wear(film, roughness, duty.pitch_line_velocity)
    found: dict[str, float | str] = {
        "composite_roughness_m": roughness,
        "specific_film": wear.specific_film_min,
        "regime": wear.regime,
    }
    if all(spot.asperities <= LEAST_SHARE for spot in spots):
        found["wear_probability"] = wear.probability
    return found


def _simulated(drive: Drive, duty: GearPairDuty, result: Result) -> dict[str, float | str | None]:
    """Minimum film thickness, wear, pressure and loss from the solved contacts, by the keys of the rating."""
    solutions = result.solutions
    thin = min(solutions, key=lambda solution: solution.figures.film_min.value)
    film = thin.figures.film_min.value
    values: dict[str, float | str | None] = {
        "film_min_m": film,
        "film_min_phase": thin.phase,
        **_wear(duty, film, simulated_spots(solutions)),
        "hertz_pressure_Pa": max(solution.figures.pressure_max.value for solution in solutions),
    }
    loss = mesh_loss(drive, result)
    if loss is not None:
        values |= {"friction": loss.friction, "loss_W": loss.loss, "efficiency": loss.efficiency}
    if all(solution.figures.temperature_max_body_1 is not None for solution in solutions):
        hottest, phase = max((_surface(solution), solution.phase) for solution in solutions)
        values |= {
            "contact_temperature_C": hottest - ZERO_CELSIUS,
            "contact_temperature_phase": phase,
        }
    return values


def _surface(solution: Solution) -> float:
    return present(hotter_flank(solution), "temperature_max_body").value


def _supply(duty: GearPairDuty, table: GearRatingTable) -> Rating:
    speed = duty.pitch_line_velocity
    wanted = gear_oil.pitch_line_viscosity(speed)
    figures: list[tuple[str, str, float, str]] = [
        ("viscosity_40_m2_s", "Viscosity at 40 °C by speed", wanted, "mm²/s"),
        ("nearest_grade", "  nearest ISO VG", gear_oil.nearest_grade(wanted), ""),
    ]
    for word, (_, use) in gear_oil.FLOWS.items():
        flow = gear_oil.oil_flow(duty.power, word)
        label = f"Oil flow, {word} ({use})"
        figures.append((f"flow_{word}_m3_s", label, flow, "l/min"))
    words = [f"Oil is brought by {gear_oil.application_method(speed)}."]
    if table.flow is not None:
        jets = _jets(duty, table, gear_oil.oil_flow(duty.power, table.flow))
        figures += [
            ("jets", f"Jets, {table.flow} flow", jets.number, ""),
            ("jet_diameter_m", "  diameter", jets.diameter, "mm"),
            ("jet_velocity_m_s", "  velocity", jets.velocity, "m/s"),
        ]
        if table.jet_length is not None:
            figures.append(("jet_discharge", "  discharge coefficient", jets.discharge, ""))
        words += [f"{advice[0].upper()}{advice[1:]}." for advice in jets.advice]
    return Rating(
        key="gear oil supply",
        title="Gear oil: viscosity and flow",
        source=gear_oil.SOURCE,
        columns=("computed",),
        figures=tuple(
            RatedFigure(key, label, (value,), unit) for key, label, value, unit in figures
        ),
        words=tuple(words),
    )


def _jets(duty: GearPairDuty, table: GearRatingTable, flow: float) -> gear_oil.Jets:
    """Jets for a flow [m3/s]; with the length of their holes, for the viscosity of the oil as it enters."""
    pressure = present(table.feed_pressure, "gear_rating.feed_pressure")
    number, density = present(table.jets, "gear_rating.jets"), duty.oil.density.rho0
    if table.jet_length is None:
        return gear_oil.oil_jets(flow, pressure, density, number)
    viscosity = duty.oil.eta(0.0) / density
    discharge = jet_discharge(flow, pressure, density, viscosity, number, table.jet_length)
    return gear_oil.oil_jets(flow, pressure, density, number, discharge)
