"""Worm gears by the standards' methods, beside the simulation of the same drive."""

from collections.abc import Iterator
from functools import partial

import numpy as np

from pyworm.case.ratings import WormGearTable
from pyworm.case.table import plain
from pyworm.case.worm_conditions import MEAN_TO_RMS
from pyworm.drives.drive import Drive
from pyworm.drives.duty import WormDuty
from pyworm.formulas.ranges import within
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.formulas.unknown import Unknown, attempt, known, or_none
from pyworm.formulas.wear_distress import regime, specific_film
from pyworm.formulas.worm_gear import WormGear, WormGearSizes
from pyworm.formulas.worm_rating import WormRating
from pyworm.io.input_error import CaseError
from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES
from pyworm.ratings.flank_damage import hotter_flank
from pyworm.ratings.mesh_loss import mesh_loss, with_missing
from pyworm.ratings.rating import SIMULATION, RatedFigure, Rating, Safety, without_value
from pyworm.ratings.worm_basis import BASIS, outside_scope
from pyworm.ratings.worm_differences import differences
from pyworm.ratings.worm_loads import RatedWormGear
from pyworm.ratings.worm_safeties import safeties
from pyworm.ratings.worm_verdict import CANNOT_DRIVE, NEVER_RATED, failures, locking
from pyworm.result.headline import of_all
from pyworm.result.result import Result
from pyworm.solver.neglected_effects import NeglectedEffects


def worm_duty_of_table(table: WormGearTable) -> WormDuty:
    """The worm gear of `[worm_gear]`; CaseError if it is none."""
    try:
        within("reduced modulus", table.reduced_modulus, 3e8, 1e12, "Pa")
        return _duty(table)
    except ValueError as error:
        raise CaseError(f"worm_gear: {error}") from error


def _duty(table: WormGearTable) -> WormDuty:
    return WormDuty(
        gear=WormGear(**vars(plain(table, WormGearSizes))),
        worm_speed=table.worm_speed,
        torque=table.wheel_torque,
        reduced_modulus=table.reduced_modulus,
        roughness=(table.worm_roughness, table.wheel_roughness),
    )


def rate_worm_gear(
    gear_set: RatedWormGear, drive: Drive | None = None, result: Result | None = None
) -> Rating:
    """The worm gear of a case, with a column of the simulation if drive and result are given."""
    rated = safeties(gear_set)
    simulated = {} if result is None or drive is None else _simulated(gear_set.duty, drive, result)
    figures = tuple(_figures(gear_set, simulated, result))
    return Rating(
        key="worm",
        title="Worm gear",
        source=WormRating.source,
        columns=("standard", SIMULATION) if simulated else ("standard",),
        figures=figures,
        safeties=rated,
        words=tuple(_words(gear_set, rated, bool(simulated))),
        failed=failures(gear_set, rated),
        not_rated=(
            *(f"{labels}: {why}." for why, labels in without_value(figures).items()),
            *(
                f"{safety.symbol}, {safety.label}: {safety.why}"
                for safety in rated
                if safety.value is None
            ),
            *NEVER_RATED,
        ),
        neglected_effects=of_all(result.solutions)
        if simulated and result is not None
        else NeglectedEffects(),
        basis=(*BASIS, *outside_scope(gear_set)),
        differs=differences(gear_set),
    )


def _words(gear_set: RatedWormGear, rated: tuple[Safety, ...], simulated: bool) -> list[str]:
    """What the figures mean, and what was assumed."""
    words, loads = [*gear_set.duty.words], gear_set.loads
    if len(loads) > 1:
        hours = sum(known(load.hours) for load in loads)
        words.append(
            f"Spectrum of {len(loads)} loads, {hours:.5g} h together: figures are "
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
    for sentences_of in (_rough_words, _oil_words, locking):
        found = attempt(partial(sentences_of, gear_set))
        words += [] if isinstance(found, Unknown) else [found]
    return words + [f"{safety.symbol}: {doubt}" for safety in rated for doubt in safety.doubts]


def _rough_words(gear_set: RatedWormGear) -> str:
    duty = gear_set.duty
    together = duty.composite_roughness
    worm, wheel = (present(height, "roughness") * 1e6 for height in duty.roughness)
    return (
        f"Roughness Rq {worm:.3g} µm of the worm and {wheel:.3g} µm of the wheel, "
        f"{together * 1e6:.3g} µm together; Ra of the worm taken as {MEAN_TO_RMS:g} Rq."
    )


def _oil_words(gear_set: RatedWormGear) -> str:
    under, rated = gear_set.hardest.conditions, gear_set.hardest.rated
    material = under.material
    wheel = (
        "material of the wheel not known, its friction taken as of tin bronze"
        if isinstance(material, Unknown)
        else f"wheel of {material.name}"
    )
    return (
        f"{known(gear_set.oil).name}, {gear_set.table.lubrication} lubrication, {wheel}: "
        f"{known(under.viscosity) * 1e3:.0f} mPa s on the wheel flanks at "
        f"{rated.bulk_temperature - ZERO_CELSIUS:.0f} °C."
    )


def _figures(
    gear_set: RatedWormGear, simulated: dict[str, float | str], result: Result | None
) -> Iterator[RatedFigure]:
    """Every row with the standard's value, or why it has none, and the simulated one."""
    for key, label, compute, unit in _rows(gear_set):
        value = attempt(compute)
        if value is None and key not in simulated:
            continue
        others = (simulated.get(key),) if simulated else ()
        why = value.why if isinstance(value, Unknown) else ""
        if result is not None and key in simulated:
            label = with_missing(key, label, result)
        yield RatedFigure(key, label, (or_none(value), *others), unit, why=why)


def _rows(gear_set: RatedWormGear) -> list[tuple]:
    """Key, label, how the standard's value is computed, and unit of every row."""
    worst, duty, gear = gear_set.hardest, gear_set.duty, gear_set.duty.gear
    rated = worst.rated
    thin, central, specific, highest = (
        QUANTITIES[name] for name in ("film_min", "film_central", "specific_film", "pressure_max")
    )

    def ratio() -> float:
        return float(specific_film(rated.film, duty.composite_roughness))

    def worn() -> float | None:
        given = isinstance(worst.conditions.material, Unknown) or isinstance(worst.hours, Unknown)
        return None if given else gear_set.total_wear

    return [
        ("wheel_torque_Nm", "Wheel torque T2", lambda: worst.torque, "kN m"),
        ("sliding_speed_m_s", "Sliding speed v_g", lambda: rated.sliding_speed, "m/s"),
        ("film_parameter", "Film parameter h*", lambda: gear.film_parameter, ""),
        ("film_m", f"Mean {thin.words()} h_min,m", lambda: rated.film, thin.shown),
        (central.key, central.title(), lambda: None, central.shown),
        (specific.key, specific.title(), ratio, specific.shown),
        ("regime", "Lubrication", lambda: regime(ratio()), ""),
        ("mean_pressure_Pa", "Mean contact stress sigma_Hm", lambda: rated.mean_pressure, "MPa"),
        (highest.key, highest.title(), lambda: None, highest.shown),
        *_friction_rows(rated),
        (
            "bulk_temperature_C",
            "Wheel bulk temperature",
            lambda: rated.bulk_temperature - ZERO_CELSIUS,
            "°C",
        ),
        *_material_rows(duty),
        ("surface_temperature_max_C", "Largest flank temperature", lambda: None, "°C"),
        ("wear_depth_m", "Wear over service life", worn, "µm"),
        ("wear_limit_m", "Permissible wear", lambda: worn() and gear.wear_limit, "µm"),
        ("shaft_deflection_m", "Deflection of the worm shaft", lambda: duty.deflection, "µm"),
        *_gearbox_rows(rated),
    ]


def _material_rows(duty: WormDuty) -> list[tuple]:
    """Rows about a wheel that softens; none of one whose material has no temperature limit."""
    if duty.wheel_limit is None or duty.wheel_modulus is None:
        return []
    limit, modulus = duty.wheel_limit, duty.wheel_modulus
    return [
        (
            "wheel_temperature_limit_C",
            "Temperature limit of the wheel's material",
            lambda: limit - ZERO_CELSIUS,
            "°C",
        ),
        ("wheel_modulus_Pa", "Young's modulus of the wheel", lambda: modulus, "GPa"),
    ]


def _friction_rows(rated: WormRating) -> list[tuple]:
    return [
        ("friction", "Tooth friction mu_zm", lambda: rated.friction, ""),
        ("efficiency", "Efficiency, worm driving", lambda: rated.forward_efficiency, "%"),
        (
            "efficiency_back",
            "Efficiency, wheel driving",
            lambda: _driven_back(rated.backward_efficiency),
            "%",
        ),
        ("locking", "mu/tan gamma (teeth lock above 1)", lambda: rated.self_locking_margin, ""),
        ("friction_rest", "Static tooth friction", lambda: rated.static_friction, ""),
        (
            "locking_rest",
            "mu/tan gamma at rest (teeth lock above 1)",
            lambda: rated.static_locking_margin,
            "",
        ),
        (
            "loss_W",
            f"Power loss of the teeth, {rated.under.driver} driving",
            lambda: rated.tooth_loss,
            "kW",
        ),
    ]


def _driven_back(efficiency: float) -> float | str:
    """Efficiency with the wheel driving, or that it cannot."""
    return efficiency if efficiency > 0 else CANNOT_DRIVE


def _gearbox_rows(rated: WormRating) -> list[tuple]:
    """Rows about the whole gearbox: losses besides the teeth, and efficiencies with them."""
    given = rated.under.other_loss is not None
    by_standard = (
        ("churning", "Churning loss"),
        ("bearings", "Bearing loss"),
        ("seals", "Seal loss"),
    )
    parts: list[tuple] = [
        (f"loss_{name}_W", label, lambda part=name: getattr(rated.standard_losses, part), "kW")
        for name, label in by_standard
    ]
    if given:
        parts = [("loss_other_W", "Losses besides the teeth", lambda: rated.other_power, "kW")]
    return [
        *parts,
        (
            "loss_gearbox_W",
            f"Power loss of the gearbox, {rated.under.driver} driving",
            lambda: rated.loss,
            "kW",
        ),
        (
            "efficiency_gearbox",
            "Efficiency of the gearbox, worm driving",
            lambda: rated.gearbox_efficiency,
            "%",
        ),
        (
            "efficiency_gearbox_back",
            "Efficiency of the gearbox, wheel driving",
            lambda: _driven_back(rated.gearbox_efficiency_back),
            "%",
        ),
    ]


def _simulated(duty: WormDuty, drive: Drive, result: Result) -> dict[str, float | str]:
    """Film thickness, pressure, sliding and friction, means over the solved phases, by the rating's keys."""
    solutions = result.solutions
    figures = [solution.figures for solution in solutions]
    film = float(np.mean([figure.film_min.value for figure in figures]))
    values: dict[str, float | str] = {
        "wheel_torque_Nm": duty.torque,
        "film_m": film,
        "film_central_m": float(np.mean([figure.film_central.value for figure in figures])),
        "pressure_max_Pa": float(max(figure.pressure_max.value for figure in figures)),
        "sliding_speed_m_s": _sliding(solutions),
    }
    if None not in duty.roughness:
        ratio = float(specific_film(film, duty.composite_roughness))
        values |= {"specific_film": ratio, "regime": regime(ratio)}
    loss = mesh_loss(drive, result)
    if loss is not None:
        values |= {
            "friction": loss.friction,
            "efficiency": loss.efficiency,
            "efficiency_back": 1 - loss.loss / (loss.power - loss.loss),
            "locking": loss.friction / duty.gear.tan_lead,
            "loss_W": loss.loss,
        }
    hot = [
        temperature.value
        for solution in solutions
        if (temperature := hotter_flank(solution)) is not None
    ]
    if len(hot) == len(solutions):
        values["surface_temperature_max_C"] = max(hot) - ZERO_CELSIUS
    return values


def _sliding(solutions: tuple) -> float:
    """Sliding speed at the contact point, mean over the phases [m/s]."""
    speeds = []
    for solution in solutions:
        there = solution.fields[["sliding_x", "sliding_y"]].sel(x=0, y=0, method="nearest")
        speeds.append(float(np.hypot(there["sliding_x"], there["sliding_y"])))
    return float(np.mean(speeds))
