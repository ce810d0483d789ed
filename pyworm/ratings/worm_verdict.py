"""Verdicts on a worm gear rated by the standards: self-locking, and failures."""

from math import atan, degrees

from pyworm.drives.duty import WormDuty
from pyworm.formulas.ranges import apart
from pyworm.formulas.unit_factors import RPM
from pyworm.formulas.unknown import Unknown, attempt, or_none
from pyworm.ratings.rating import Safety
from pyworm.ratings.worm_loads import RatedLoad, RatedWormGear

NEVER_RATED = (
    "Scuffing: ISO/TS 14521 and DIN 3996 have no rating of it, and that of ISO/TS 6336-20 is of steel gears.",
    "Micropitting: ISO/TS 14521 and DIN 3996 have no rating of it; that of ISO/TS 6336-22 is of hard steel.",
)
"""What no case can ask of a worm gear."""

CANNOT_DRIVE = "cannot drive"
"""In place of an efficiency with the wheel driving where that is not possible."""

NO_BRAKE = (
    "Friction is no brake: it falls with speed, running-in and vibration. A load that must be held needs a "
    "brake."
)


def locking(gear_set: RatedWormGear) -> str:
    """Whether the wheel can drive the gearbox, running and from rest; ValueError where that is not known.

    By all losses of the gearbox under the load that locks least.
    """
    loads = gear_set.loads
    at_rest = max(loads, key=lambda load: load.rated.static_gearbox_efficiency_back)
    locks_at_rest = at_rest.rated.static_gearbox_efficiency_back <= 0
    back = [_efficiency_back(load) for load in loads]
    sure = [efficiency for efficiency in back if not isinstance(efficiency, Unknown)]
    running = max(sure) <= 0 if len(sure) == len(back) else None
    return f"{_verdict(running, locks_at_rest)}. {_why(loads, back)} {NO_BRAKE}"


def _efficiency_back(load: RatedLoad) -> float | Unknown:
    return attempt(lambda: load.rated.gearbox_efficiency_back)


def _verdict(running: bool | None, at_rest: bool) -> str:
    """What locks, in a clause; `running` is None where that is not known."""
    if running is None:
        if at_rest:
            return "Self-locking at rest: the wheel cannot start the gearbox; running is not rated"
        return "Not self-locking at rest: the wheel can start the gearbox; running is not rated"
    if running and at_rest:
        return (
            "Self-locking, running and at rest: the wheel can neither start nor drive the gearbox"
        )
    if at_rest:
        return (
            "Self-locking at rest only: the wheel cannot start the gearbox, but drives it once it runs or is "
            "shaken loose"
        )
    if running:
        return (
            "Self-locking at this speed only: the wheel can start the gearbox, and drives it at a lower "
            "speed, where oil and bearings resist less"
        )
    return (
        "Not self-locking, neither running nor at rest: the wheel can start and drive the gearbox"
    )


def _why(loads: tuple[RatedLoad, ...], back: list[float | Unknown]) -> str:
    """Teeth alone and the whole gearbox, under the load that locks least, in sentences."""
    sure = [
        (efficiency, load)
        for efficiency, load in zip(back, loads, strict=True)
        if not isinstance(efficiency, Unknown)
    ]
    efficiency, load = max(sure, key=lambda pair: pair[0]) if sure else (None, loads[0])
    rated = load.rated
    rest = rated.static_backward_efficiency
    lasting = rest - rated.static_gearbox_efficiency_back
    parts = [_passing("at rest", "torque", rest, "bearings and seals", lasting)]
    angles = [f"{degrees(atan(rated.static_friction)):.1f}° at rest"]
    if efficiency is not None:
        teeth = rated.backward_efficiency
        others = "bearings, seals and churning"
        parts.insert(0, _passing("running", "power", teeth, others, teeth - efficiency))
        angles.insert(0, f"{degrees(atan(rated.friction)):.1f}° running")
    return (
        f"Lead angle {degrees(rated.gear.lead_angle):.1f}°, friction angle {', '.join(angles)}. At "
        f"{load.torque:.4g} N m and {load.worm_speed * RPM:.4g} rpm, {'; '.join(parts)}."
    )


def _passing(when: str, what: str, teeth: float, others: str, taken: float) -> str:
    """How much of what the wheel gives passes the teeth, and what the other losses take of it."""
    through = f"{100 * teeth:.3g} %" if teeth > 0 else "nothing"
    return f"{when}, {through} of the wheel's {what} passes the teeth, and {others} take {100 * taken:.3g} %"


def failures(gear_set: RatedWormGear, rated: tuple[Safety, ...]) -> tuple[str, ...]:
    """Why a worm gear fails its rating; empty where every safety that is rated is sufficient.

    S_delta counts where the case gives the bearings of the worm's shaft.
    """
    failed, duty, gear = [], gear_set.duty, gear_set.duty.gear
    worn = or_none(attempt(lambda: gear_set.total_wear))
    if worn is not None and worn >= gear.tooth_thickness:
        failed.append(
            f"Wear of {worn * 1e3:.3g} mm in its life would take the whole tooth, which is "
            f"{gear.tooth_thickness * 1e3:.3g} mm thick."
        )
    elif worn is not None and worn > gear.wear_limit:
        failed.append(
            f"Wear of {apart(worn * 1e3, gear.wear_limit * 1e3, 3)} mm in its life is more than "
            f"{gear.wear_limit * 1e3:.3g} mm, what the standard allows (0.3 m_x cos gamma)."
        )
    # bearings that are assumed decide nothing
    decides = [
        safety for safety in rated if safety.symbol != "S_delta" or duty.deflection is not None
    ]
    failed += [safety.failure for safety in decides if safety.failure]
    return (*failed, *_cannot_run(duty, gear_set.loads))


def _cannot_run(duty: WormDuty, loads: tuple[RatedLoad, ...]) -> tuple[str, ...]:
    if duty.driver == "worm":
        return ()
    held = [load for load in loads if (or_none(_efficiency_back(load)) or 1.0) <= 0]
    return tuple(
        f"The wheel is to drive (operation.driver) and cannot: at {load.torque:.4g} N m and "
        f"{load.worm_speed * RPM:.4g} rpm the gearbox loses {load.rated.loss:.4g} W, more than the "
        f"{load.rated.output:.4g} W of the wheel; the worm has to add the rest."
        for load in held
    )
