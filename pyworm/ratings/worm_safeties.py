"""The five safeties of the worm-gear standard, over all loads of a life, each with what it was made of."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from pyworm.case.ratings import CompletedRating
from pyworm.case.worm_conditions import material_of
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.formulas.unknown import Unknown, attempt, known
from pyworm.formulas.worm_curves import SLIDING_RANGE
from pyworm.formulas.worm_deflection import deflection_limit
from pyworm.formulas.worm_losses import oil_factor
from pyworm.formulas.worm_root import root_shear
from pyworm.formulas.worm_standard import OIL_LIMITS, temperature_safety
from pyworm.ratings.rating import Safety
from pyworm.ratings.worm_basis import CLAUSES
from pyworm.ratings.worm_loads import RatedLoad, RatedWormGear

REQUIRED = {"S_W": 1.1, "S_H": 1.0, "S_delta": 1.0, "S_F": 1.1, "S_T": 1.1, "S_M": 1.0}
"""Least safeties (a public transcription of DIN 3996, the worksheet on worm gears of MITCalc); S_M is none of
the standard's."""

_LABELS = {
    "S_W": "wear of the wheel flanks",
    "S_H": "pitting of the wheel flanks",
    "S_delta": "deflection of the worm shaft",
    "S_F": "shear at the roots of the wheel teeth",
    "S_T": "temperature of the oil",
    "S_M": "temperature of the wheel material",
}

AS_IF_BRONZE = (
    "The friction of the wheel's material is not known: that of tin bronze is taken, which changes the "
    "result little."
)

_PITTING_POWER = 6
"""Hours of pitting fall with this power of the stress: Z_h = (25000 h/Lh)^(1/6)."""

ENDURANCE_CYCLES = 3e6
"""Cycles from which roots endure [-] (DIN 3996, from memory)."""

ROOT_POWER = 0.16
"""Power of fewer cycles with which the strength of roots falls [-] (DIN 3996, from memory)."""

_MOST_LASTING = 1.6
"""Largest Z_h [-]."""


def safeties(rated: RatedWormGear) -> tuple[Safety, ...]:
    """S_W, S_H, S_delta, S_F and S_T of a worm gear, and S_M of a wheel with a temperature limit.

    Each by itself, or with the reason why there is none.
    """
    found = []
    for symbol, rate in _RATES.items():
        if symbol == "S_M" and rated.duty.wheel_limit is None:
            continue
        lacking = _missing(rated.table, *_REQUIRED_KEYS.get(symbol, ()))
        safety = Unknown(lacking) if lacking else attempt(partial(rate, rated))
        if isinstance(safety, Unknown):
            safety = _safety(symbol, why=f"{safety.why.rstrip('.')}.")
        found.append(safety)
    return tuple(found)


def _safety(symbol: str, **given: Any) -> Safety:
    return Safety(symbol, _LABELS[symbol], REQUIRED[symbol], clause=CLAUSES[symbol], **given)


def _missing(table: CompletedRating, *keys: str) -> str:
    """What of a table is not given, in a clause; empty where nothing is missing."""
    gone = [
        key
        for key in keys
        if getattr(table, key) is None and not (key == "life" and table.spectrum)
    ]
    return ", ".join(f"worm_rating.{key} is missing" for key in gone)


def _wear(gear_set: RatedWormGear) -> Safety:
    depth = gear_set.total_wear
    limit, worst = gear_set.duty.gear.wear_limit, gear_set.hardest
    wear = worst.rated.wear
    inputs = {
        "delta_Wlim_um": limit * 1e6,
        "delta_W_um": depth * 1e6,
        "h_min_m_um": worst.rated.film * 1e6,
        "W_S": wear.structure_factor,
        "W_H": wear.pressure_factor,
        "K_W_um": wear.parameter,
        "J_0T": wear.base,
        "J_W": wear.intensity,
        "s*": worst.rated.gear.sliding_parameter,
        "lubrication": gear_set.table.lubrication,
    }
    doubts = []
    if wear.base >= 400e-9:
        doubts.append("J_0T is at or beyond 400e-9, where the curve ends: boundary lubrication.")
    if gear_set.table.lubrication == "bath":
        doubts.append("The wear curve for bath lubrication is known from one transcription only.")
    doubts += [
        f"The teeth slide at {load.rated.sliding_speed:.3g} m/s, and their friction is known from "
        f"{SLIDING_RANGE[0]:g} to {SLIDING_RANGE[1]:g} m/s: the wheel is warmed by that of the nearest speed."
        for load in gear_set.loads
        if not load.rated.within_friction
    ]
    return _safety("S_W", value=limit / depth, inputs=inputs, doubts=tuple(doubts))


def _pitting(gear_set: RatedWormGear) -> Safety:
    """Miner's sum of hours over those endured at the stress divided by the safety is 1."""
    rated = [load.rated.pitting_safety for load in gear_set.loads]
    value = rated[0] if len(rated) == 1 else _miner(gear_set.loads)
    worst = gear_set.hardest
    inputs = {
        "sigma_HlimT_MPa": known(known(material_of(gear_set.table)).pitting_strength) * 1e-6,
        "sigma_Hm_MPa": worst.rated.mean_pressure * 1e-6,
        "L_h": sum(known(load.hours) for load in gear_set.loads),
        "v_gm_m_s": worst.rated.sliding_speed,
        "p_m*": gear_set.duty.gear.pressure_parameter,
        "oil": worst.rated.oil,
    }
    return _safety("S_H", value=value, inputs=inputs)


def _miner(loads: tuple[RatedLoad, ...]) -> float:
    """S_H over several loads [-]; hours and safeties of each are of its own share of the life."""
    damage, bound = 0.0, float("inf")
    for load in loads:
        hours = known(load.hours)
        lasting = min((25000 / hours) ** (1 / _PITTING_POWER), _MOST_LASTING)
        endured = load.rated.pitting_safety / lasting  # over 25000 h
        damage += pitting_damage(hours, endured)
        bound = min(bound, endured * _MOST_LASTING)
    return min(damage ** (-1 / _PITTING_POWER), bound)


def pitting_damage(hours: float, endured: float) -> float:
    """Share of a flank's life that some hours take [-], by its safety over 25000 h, `endured`."""
    return hours / 25000 * endured**-_PITTING_POWER


def root_damage(cycles: float, endured: float) -> float:
    """Share of a root's life that some load cycles take [-], by its safety over unlimited ones, `endured`.

    None above it; below it cycles endured are 3e6 S^(1/0.16), the life factor Y_NL of DIN 3996 (from memory).
    """
    return 0.0 if endured >= 1 else cycles / (ENDURANCE_CYCLES * endured ** (1 / ROOT_POWER))


def _deflection(gear_set: RatedWormGear) -> Safety:
    worst, limit = gear_set.hardest, deflection_limit(gear_set.duty.gear.module)
    if gear_set.duty.deflection is not None:
        bent = gear_set.duty.deflection * worst.torque / gear_set.duty.torque
        doubts: tuple[str, ...] = ()
        where = "[drive.shaft]"
    else:
        bent = worst.rated.shaft_deflection
        where = "half the wheel's tip diameter to each side"
        doubts = (
            "Bearings assumed half the wheel's tip diameter to each side of the line of centres, the shaft "
            "1.1 times as thick as a root 1.25 modules deep; [drive.shaft] gives the real ones.",
            *(() if worst.conditions.friction_is_known else (AS_IF_BRONZE,)),
        )
    inputs = {"delta_lim_um": limit * 1e6, "delta_m_um": bent * 1e6, "bearings": where}
    return _safety("S_delta", value=limit / bent, inputs=inputs, doubts=doubts)


def _root(gear_set: RatedWormGear) -> Safety:
    """Teeth are worn as far as they wear in the life, by what is allowed where that is not rated."""
    strength = known(known(material_of(gear_set.table)).root_strength)
    worst, gear = gear_set.hardest, gear_set.duty.gear
    depth = attempt(lambda: gear_set.total_wear)
    worn = gear.wear_limit if isinstance(depth, Unknown) else min(gear.wear_limit, depth)
    shear = root_shear(gear, worst.torque, worn, gear_set.table.rim_over_module)
    inputs = {
        "tau_FlimT_MPa": strength * 1e-6,
        "tau_F_MPa": shear * 1e-6,
        "F_tm2_kN": gear.tangential_force(worst.torque) * 1e-3,
        "worn_um": worn * 1e6,
        "rim_over_module": gear_set.table.rim_over_module,
    }
    doubts = [
        "Life factor Y_NL of 1, that of endurance; dedendum 1.25 modules; rim as given or 2 modules."
    ]
    if isinstance(depth, Unknown):
        doubts.append("Wear is not rated: teeth are taken as worn as far as the standard allows.")
    return _safety("S_F", value=strength / shear, inputs=inputs, doubts=tuple(doubts))


def _temperature(gear_set: RatedWormGear) -> Safety:
    hot = max(gear_set.loads, key=lambda load: known(load.sump))
    sump, given = known(hot.sump), gear_set.table.temperature_limit
    limit = OIL_LIMITS[hot.rated.oil] if given is None else given
    inputs: dict[str, float | str] = {
        "theta_Slim_C": limit - ZERO_CELSIUS,
        "theta_S_C": sump - ZERO_CELSIUS,
    }
    doubts = []
    if given is None:
        doubts.append(
            f"Limit of {hot.rated.oil} oils as the transcription has it; the oil's maker decides."
        )
    else:
        inputs["limit"] = "given"
    inputs |= _sumps(gear_set, hot, doubts)
    value = temperature_safety(sump, limit)
    return _safety("S_T", value=value, inputs=inputs, doubts=tuple(doubts))


def _material(gear_set: RatedWormGear) -> Safety:
    """The limit of the wheel's material over its bulk temperature under the hottest load, both in degC."""
    limit = known(
        Unknown("it has no limit")
        if gear_set.duty.wheel_limit is None
        else gear_set.duty.wheel_limit
    )
    hot = max(gear_set.loads, key=lambda load: load.rated.bulk_temperature)
    bulk = hot.rated.bulk_temperature
    inputs = {"theta_lim_C": limit - ZERO_CELSIUS, "theta_M_C": bulk - ZERO_CELSIUS}
    if gear_set.duty.wheel_modulus is not None:
        inputs["E_wheel_MPa"] = gear_set.duty.wheel_modulus * 1e-6
    doubts = ["Limit by ageing in air: stiffness and strength fall long before."]
    if not hot.conditions.friction_is_known:
        doubts.append(
            "The wheel's temperature is by the standard's balance with the friction of tin bronze."
        )
    if bulk <= ZERO_CELSIUS:
        raise ValueError("the wheel is not warmer than 0 °C")
    value = inputs["theta_lim_C"] / inputs["theta_M_C"]
    return _safety("S_M", value=value, inputs=inputs, doubts=tuple(doubts))


def _sumps(gear_set: RatedWormGear, hot: RatedLoad, doubts: list[str]) -> Mapping[str, float | str]:
    """The sump's temperature by the standard with and without fan, for S_T's inputs."""
    given = gear_set.table.sump_temperature is not None or gear_set.duty.oil_temperature is not None
    balanced = gear_set.duty.conductance is not None
    taken = "by [cooling]" if balanced else "as given" if given else "of the standard"
    try:
        with_fan, without = (
            gear_set.standard_sump(hot, fan) - ZERO_CELSIUS for fan in (True, False)
        )
        factor = oil_factor(hot.rated.oil, gear_set.duty.gear.ratio, hot.worm_speed)
    except ValueError as error:
        doubts.append(f"Sump temperature {taken}; the standard's has no value here ({error}).")
        return {"taken": taken}
    if factor != 1:
        doubts.append(
            f"c2 = {factor:.3f} of the standard's sump temperature: the transcription has {2 - factor:.3f}, "
            "its sign is doubtful; the hotter one is taken."
        )
    if gear_set.duty.driver == "wheel":
        doubts.append("The standard's sump temperatures are those of a worm that drives.")
    return {"theta_S_with_fan_C": with_fan, "theta_S_without_fan_C": without, "taken": taken}


_RATES: dict[str, Callable[[RatedWormGear], Safety]] = {
    "S_W": _wear,
    "S_H": _pitting,
    "S_delta": _deflection,
    "S_F": _root,
    "S_T": _temperature,
    "S_M": _material,
}
"""Symbol of a safety -> how it is rated."""

_REQUIRED_KEYS = {
    "S_W": ("wheel_material", "life"),
    "S_H": ("wheel_material", "life"),
    "S_F": ("wheel_material",),
}
"""Symbol of a safety -> keys of `[worm_rating]` without which there is none."""
