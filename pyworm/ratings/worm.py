"""Worm gears by the standards' methods, beside the simulation of the same drive."""

from pathlib import Path

import numpy as np

from pyworm.case.ratings import WormGearTable, WormRatingTable
from pyworm.drives.drive import Drive
from pyworm.drives.duty import WormDuty
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.formulas.wear_distress import regime, specific_film
from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_rating import WormRating
from pyworm.ratings.mesh_loss import mesh_loss, with_missing
from pyworm.ratings.rating import SIMULATION, RatedFigure, Rating
from pyworm.ratings.worm_loads import MEAN_TO_RMS, RatedLoad, hardest, rated_loads, standard_oil
from pyworm.ratings.worm_safeties import safeties, total_wear
from pyworm.ratings.worm_verdict import NEVER_RATED, failures, locking
from pyworm.result.headline import of_all
from pyworm.result.result import Result
from pyworm.solver.left_out import LeftOut


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
    """The worm gear by the standards under its largest torque; errors as of `rated_loads`."""
    return hardest(rated_loads(table, duty, directory)).rated


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
    loads = rated_loads(table, duty, directory)
    rated = hardest(loads).rated
    made = safeties(table, duty, loads, directory)
    simulated = {} if result is None or drive is None else _simulated(duty, drive, result)
    figures = []
    for key, label, value, scale, unit in _rows(duty, loads):
        if value is not None or key in simulated:
            others = (simulated.get(key),) if simulated else ()
            label = with_missing(key, label, result) if key in simulated else label
            figures.append(RatedFigure(key, label, (value, *others), scale, unit))
    return Rating(
        key="worm",
        title="Worm gear",
        source=rated.source,
        columns=("standard", SIMULATION) if simulated else ("standard",),
        figures=tuple(figures),
        safeties=made,
        words=tuple(_words(table, duty, loads, directory, bool(simulated))),
        failed=failures(duty, made, total_wear(loads)),
        not_rated=(
            *(f"{of.symbol}, {of.label}: {of.why}" for of in made if of.value is None),
            *NEVER_RATED,
        ),
        left_out=of_all(result.solutions) if simulated else LeftOut(),
    )


def _words(
    table: WormRatingTable,
    duty: WormDuty,
    loads: tuple[RatedLoad, ...],
    directory: Path,
    simulated: bool,
) -> list[str]:
    """What the figures mean, and what was assumed."""
    oil, rated = standard_oil(table, directory), hardest(loads).rated
    words = [*duty.words]
    if len(loads) > 1:
        words.append(
            f"Spectrum of {len(loads)} loads, {sum(of.hours for of in loads):.5g} h together: figures are "
            "those of its largest torque, pitting adds up by Miner's rule, wear adds up, roots and shaft are "
            "rated for the largest torque, the oil for its hottest."
        )
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
        f"{oil.name}, {table.lubrication} lubrication: "
        f"{oil.viscosity(rated.bulk_temperature) * 1e3:.0f} mPa s on the wheel's flanks of "
        f"{rated.bulk_temperature - ZERO_CELSIUS:.0f} °C."
    )
    words.append(locking(duty.gear, rated))
    words += [
        f"{of.symbol}: {doubt}"
        for of in safeties(table, duty, loads, directory)
        for doubt in of.doubts
    ]
    return words


def _rows(duty: WormDuty, loads: tuple[RatedLoad, ...]) -> list[tuple]:
    """Key, label, the standard's value, scale and unit of every row."""
    worst = hardest(loads)
    rated, worn = worst.rated, total_wear(loads)
    ratio = float(specific_film(rated.film, duty.composite_roughness))
    bulk = None if rated.bulk_temperature is None else rated.bulk_temperature - ZERO_CELSIUS
    return [
        ("wheel_torque_Nm", "Wheel torque T2", worst.torque, 1e-3, "kN m"),
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
        ("wear_depth_m", "Wear in its life", worn, 1e6, "µm"),
        ("wear_limit_m", "Wear allowed", worn and duty.gear.wear_limit, 1e6, "µm"),
        ("shaft_deflection_m", "Deflection of the worm's shaft", duty.deflection, 1e6, "µm"),
        *_gearbox_rows(rated),
    ]


def _gearbox_rows(rated: WormRating) -> list[tuple]:
    """Rows about the whole gearbox: losses besides the teeth, and efficiencies with them."""
    other, back = rated.other, rated.gearbox_efficiency_back
    return [
        ("loss_churning_W", "Loss of churning", other.churning, 1e-3, "kW"),
        ("loss_bearings_W", "Loss of bearings", other.bearings, 1e-3, "kW"),
        ("loss_seals_W", "Loss of seals", other.seals, 1e-3, "kW"),
        ("loss_gearbox_W", "Loss of the gearbox", rated.loss, 1e-3, "kW"),
        (
            "efficiency_gearbox",
            "Efficiency of the gearbox, worm driving",
            rated.gearbox_efficiency,
            100.0,
            "%",
        ),
        ("efficiency_gearbox_back", "Efficiency of the gearbox, wheel driving", back, 100.0, "%"),
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
    lost = mesh_loss(drive, result)
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
