"""Verdicts on a worm gear rated by the standards: self-locking, failures, ratings left out."""

from math import atan, degrees

from pyworm.case.ratings import WormRatingTable
from pyworm.drives.duty import WormDuty
from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_rating import WormRating

NEVER_RATED = (
    "Tooth root strength: no formulas of the standards are known here.",
    "Scuffing: the closed forms are those of steel on steel, a worm gear has a bronze wheel.",
)
"""What no case can ask of a worm gear."""

NO_WEAR = (
    "polyglycol asks for worm_rating.structure_factor (W_S), of PAO no constants are known here"
)
"""Why wear is not rated where its life is given: mineral oil needs nothing more."""


def locking(gear: WormGear, rated: WormRating) -> str:
    """Whether the wheel can drive the worm, running and from rest: lead angle against friction angle."""
    lead = degrees(gear.lead_angle)
    running, at_rest = (degrees(atan(mu)) for mu in (rated.friction, rated.static_friction))
    if rated.self_locking_margin > 1:
        verdict = "Self-locking, running and at rest: the wheel cannot drive the worm"
    elif rated.static_locking_margin > 1:
        verdict = (
            "Self-locking at rest only: the wheel cannot start the worm, but drives it once it runs or is "
            "shaken loose, so that it is no brake"
        )
    else:
        verdict = (
            "Not self-locking, neither running nor at rest: the wheel can start and drive the worm"
        )
    return (
        f"{verdict}. Lead angle {lead:.1f}°; friction angle {running:.1f}° running, {at_rest:.1f}° at rest "
        "(of tin bronze; aluminium bronze and cast iron rub more)."
    )


def failures(duty: WormDuty, rated: WormRating) -> tuple[str, ...]:
    """Why a worm gear fails its rating; empty where every safety that is rated is above 1."""
    failed, gear = [], duty.gear
    depth, thickness = rated.wear_depth, gear.tooth_thickness
    if depth is not None and depth >= thickness:
        failed.append(
            f"Wear of {depth * 1e3:.3g} mm in its life would take the whole tooth, which is "
            f"{thickness * 1e3:.3g} mm thick."
        )
    elif depth is not None and depth > gear.wear_limit:
        failed.append(
            f"Wear of {depth * 1e3:.3g} mm in its life is more than {gear.wear_limit * 1e3:.3g} mm, what the "
            "standard allows (0.3 m_x cos gamma)."
        )
    if rated.pitting_safety is not None and rated.pitting_safety < 1:
        failed.append(f"Safety against pitting of {rated.pitting_safety:.3g} is below 1.")
    if rated.temperature_safety is not None and rated.temperature_safety < 1:
        failed.append(f"Safety of temperature of {rated.temperature_safety:.3g} is below 1.")
    if duty.deflection_safety is not None and duty.deflection_safety < 1:
        failed.append(
            f"Safety of deflection of {duty.deflection_safety:.3g} is below 1: the worm's shaft bends "
            f"{duty.deflection * 1e6:.3g} µm."
        )
    return tuple(failed)


def left_unrated(table: WormRatingTable, duty: WormDuty, rated: WormRating) -> tuple[str, ...]:
    """Ratings of a worm gear that are left out, each with the missing data."""
    missing = {
        key: f"worm_rating.{key} is missing"
        for key in ("life", "wheel_material", "temperature_limit")
        if getattr(table, key) is None
    }
    left = []
    if rated.pitting_safety is None:
        reasons = [missing[key] for key in ("wheel_material", "life") if key in missing]
        left.append(f"Pitting: {', '.join(reasons)}.")
    if rated.wear_depth is None:
        left.append(f"Wear: {missing.get('life', NO_WEAR)}.")
    if rated.temperature_safety is None:
        left.append(f"Temperature: {missing['temperature_limit']}.")
    if duty.deflection is None:
        left.append("Deflection of the worm's shaft: no [drive.shaft] gives its bearings.")
    return (*left, *NEVER_RATED)
