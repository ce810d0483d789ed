"""Worm gears by the standards' methods, beside the simulation of the same drive."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from pyworm.case.ratings import WormGearTable, WormRatingTable
from pyworm.drives.drive import Drive
from pyworm.drives.duty import WormDuty
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.formulas.wear_distress import regime, specific_film
from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_rating import WormConditions, WormRating, rate_worm
from pyworm.formulas.worm_standard import OIL_KINDS, PITTING_STRENGTH
from pyworm.io.input_error import CaseError
from pyworm.materials.oil_file import oil_called
from pyworm.ratings.mesh_loss import mesh_loss
from pyworm.ratings.rating import SIMULATION, RatedFigure, Rating
from pyworm.ratings.worm_verdict import failures, left_unrated, locking
from pyworm.result.headline import of_all
from pyworm.result.result import Result
from pyworm.solver.left_out import LeftOut

MEAN_TO_RMS = 0.8
"""Ra over Rq where heights are spread normally, sqrt(2/pi); the standards' friction takes Ra."""


def worm_duty_of_table(table: WormGearTable) -> WormDuty:
    """The worm gear of `[worm_gear]`; ValueError if it is none."""
    return WormDuty(
        gear=WormGear(
            table.centre_distance,
            table.starts,
            table.teeth,
            table.module,
            table.diameter_factor,
            table.face_width,
            table.profile_shift,
        ),
        worm_speed=table.worm_speed,
        torque=table.wheel_torque,
        reduced_modulus=table.reduced_modulus,
        roughness=(table.worm_roughness, table.wheel_roughness),
    )


def standard_rating(table: WormRatingTable, duty: WormDuty, directory: Path) -> WormRating:
    """The worm gear by the standards, with the oil at the temperature of the wheel's flanks.

    Raises
    ------
    CaseError
        An oil that the standards have no constants for.
    ValueError
        What lies outside the methods.
    """
    oil = oil_called(table.oil, directory)
    kind = oil.stock.name
    if kind not in OIL_KINDS:
        raise CaseError(
            f'worm_rating.oil = "{table.oil}": the standards know {", ".join(OIL_KINDS)} only'
        )
    strength = None if table.wheel_material is None else PITTING_STRENGTH[table.wheel_material]

    conditions = WormConditions(
        oil=kind,
        viscosity=float(oil.viscosity(table.sump_temperature)),
        worm_speed=duty.worm_speed,
        torque=duty.torque,
        reduced_modulus=duty.reduced_modulus,
        roughness=MEAN_TO_RMS * duty.roughness[0],
        material_factor=table.material_factor,
        pitting_strength=strength,
        life=None if table.life is None else table.life / 3600,
        structure_factor=table.structure_factor,
        pressure_factor=table.pressure_factor,
        sump_temperature=table.sump_temperature,
        immersion_factor=table.immersion_factor,
        temperature_limit=table.temperature_limit,
    )
    # The bulk temperature follows from friction, in which the standards see no viscosity.
    hot = rate_worm(duty.gear, conditions).bulk_temperature
    return rate_worm(duty.gear, replace(conditions, viscosity=float(oil.viscosity(hot))))


def rate_worm_table(
    table: WormRatingTable,
    duty: WormDuty,
    directory: Path,
    drive: Drive | None = None,
    result: Result | None = None,
) -> Rating:
    """The worm gear of a case, with a column of the simulation if a result of the same drive is given.

    Parameters
    ----------
    table : WormRatingTable
        Rating tables of the case.
    duty : WormDuty
        Its worm gear.
    directory : Path
        Where the case lies.
    drive : Drive, optional
        The drive; needed for the simulation.
    result : Result, optional
        Its solved mesh phases.
    """
    rated = standard_rating(table, duty, directory)
    simulated = {} if result is None or drive is None else _simulated(duty, drive, result)
    oil = oil_called(table.oil, directory)
    figures = []
    for key, label, value, scale, unit in _rows(duty, rated):
        if value is not None or key in simulated:
            others = (simulated.get(key),) if simulated else ()
            figures.append(RatedFigure(key, label, (value, *others), scale, unit))
    words = [*duty.words]
    if simulated:
        words.append(
            "Simulated films are means over the solved mesh phases, of one tooth at a time; pressure "
            "and temperature are the largest ones, the temperature that of a flank in contact, not of "
            "the bulk. The standard's film is a mean over the contact lines of an oil as warm as the "
            "wheel, the simulated minimum that of the thinnest place of an oil with the case's own "
            "inlet temperature, viscosity and pressure-viscosity coefficient."
        )
    worm, wheel = (height * 1e6 for height in duty.roughness)
    words.append(
        f"Roughness Rq {worm:.3g} µm of the worm and {wheel:.3g} µm of the wheel, "
        f"{duty.composite_roughness * 1e6:.3g} µm together; Ra of the worm taken as {MEAN_TO_RMS:g} Rq."
    )
    words.append(
        f"{oil.name}: {oil.viscosity(rated.bulk_temperature) * 1e3:.0f} mPa s on the wheel's flanks of "
        f"{rated.bulk_temperature - ZERO_CELSIUS:.0f} °C."
    )
    words.append(locking(duty.gear, rated))
    return Rating(
        key="worm",
        title="Worm gear",
        source=rated.source,
        columns=("standard", SIMULATION) if simulated else ("standard",),
        figures=tuple(figures),
        words=tuple(words),
        failed=failures(duty, rated),
        not_rated=left_unrated(table, duty, rated),
        left_out=of_all(result.solutions) if simulated else LeftOut(),
    )


def _rows(duty: WormDuty, rated: WormRating) -> list[tuple]:
    """Key, label, the standard's value, scale and unit of every row."""
    ratio = float(specific_film(rated.film, duty.composite_roughness))
    bulk = None if rated.bulk_temperature is None else rated.bulk_temperature - ZERO_CELSIUS
    worn = rated.wear_depth
    return [
        ("wheel_torque_Nm", "Wheel torque T2", duty.torque, 1e-3, "kN m"),
        ("sliding_speed_m_s", "Sliding speed v_g", rated.sliding_speed, 1.0, "m/s"),
        ("film_parameter", "Film parameter h*", rated.film_parameter, 1.0, ""),
        ("film_m", "Mean minimum film h_min,m", rated.film, 1e6, "µm"),
        ("film_central_m", "Central film", None, 1e6, "µm"),
        ("specific_film", "Specific film lambda", ratio, 1.0, ""),
        ("regime", "Lubrication", regime(ratio), 1.0, ""),
        ("mean_pressure_Pa", "Mean contact stress sigma_Hm", rated.mean_pressure, 1e-6, "MPa"),
        ("pressure_max_Pa", "Largest pressure of the film", None, 1e-6, "MPa"),
        ("friction", "Tooth friction mu_zm", rated.friction, 1.0, ""),
        ("efficiency", "Efficiency, worm driving", rated.forward_efficiency, 100.0, "%"),
        ("efficiency_back", "Efficiency, wheel driving", rated.backward_efficiency, 100.0, "%"),
        ("locking", "mu/tan gamma (locks above 1)", rated.self_locking_margin, 1.0, ""),
        ("friction_rest", "Tooth friction at rest", rated.static_friction, 1.0, ""),
        (
            "locking_rest",
            "mu/tan gamma at rest (locks above 1)",
            rated.static_locking_margin,
            1.0,
            "",
        ),
        ("loss_W", "Loss between the teeth", rated.tooth_loss, 1e-3, "kW"),
        ("bulk_temperature_C", "Wheel's bulk temperature", bulk, 1.0, "°C"),
        ("surface_temperature_max_C", "Largest flank temperature", None, 1.0, "°C"),
        ("pitting_safety", "Safety against pitting S_H", rated.pitting_safety, 1.0, ""),
        ("wear_depth_m", "Wear in its life", rated.wear_depth, 1e6, "µm"),
        ("wear_limit_m", "Wear allowed", worn and duty.gear.wear_limit, 1e6, "µm"),
        ("wear_safety", "Safety against wear S_W", rated.wear_safety, 1.0, ""),
        ("temperature_safety", "Safety of temperature S_T", rated.temperature_safety, 1.0, ""),
        ("shaft_deflection_m", "Deflection of the worm's shaft", duty.deflection, 1e6, "µm"),
        ("deflection_safety", "Safety of deflection S_delta", duty.deflection_safety, 1.0, ""),
    ]


def _simulated(duty: WormDuty, drive: Drive, result: Result) -> dict[str, float | str]:
    """The same figures of the solved phases, means over these."""
    solutions = result.solutions
    figures = [solution.figures for solution in solutions]
    film = float(np.mean([of.film_min.value for of in figures]))
    ratio = float(specific_film(film, duty.composite_roughness))
    values: dict[str, float | str] = {
        "wheel_torque_Nm": duty.torque,
        "film_m": film,
        "film_central_m": float(np.mean([of.film_central.value for of in figures])),
        "pressure_max_Pa": float(max(of.pressure_max.value for of in figures)),
        "sliding_speed_m_s": _sliding(solutions),
        "specific_film": ratio,
        "regime": regime(ratio),
    }
    lost = mesh_loss(drive, solutions)
    if lost is not None:
        values |= {
            "friction": lost.friction,
            "efficiency": lost.efficiency,
            "efficiency_back": 1 - lost.loss / (lost.power - lost.loss),
            "locking": lost.friction / duty.gear.tan_lead,
            "loss_W": lost.loss,
        }
    if all(of.temperature_max_body_1 is not None for of in figures):
        hottest = max(
            max(of.temperature_max_body_1.value, of.temperature_max_body_2.value) for of in figures
        )
        values["surface_temperature_max_C"] = hottest - ZERO_CELSIUS
    return values


def _sliding(solutions: tuple) -> float:
    """Sliding speed at the contact point, mean over the phases [m/s]."""
    speeds = []
    for solution in solutions:
        there = solution.fields[["sliding_x", "sliding_y"]].sel(x=0, y=0, method="nearest")
        speeds.append(float(np.hypot(there["sliding_x"], there["sliding_y"])))
    return float(np.mean(speeds))
