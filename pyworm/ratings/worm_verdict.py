"""Verdicts on a worm gear rated by the standards: self-locking, and failures."""

from math import atan, degrees

from pyworm.drives.duty import WormDuty
from pyworm.formulas.worm_gear import WormGear
from pyworm.formulas.worm_rating import WormRating
from pyworm.ratings.rating import Safety

NEVER_RATED = (
    "Scuffing: ISO/TS 14521 and DIN 3996 have no rating; that of ISO/TS 6336-20 is of steel on steel, a "
    "worm gear has a bronze wheel.",
    "Micropitting: ISO/TS 14521 and DIN 3996 have no rating of it; that of ISO/TS 6336-22 is of hard steel.",
)
"""What no case can ask of a worm gear."""


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


def failures(duty: WormDuty, made: tuple[Safety, ...], worn: float | None) -> tuple[str, ...]:
    """Why a worm gear fails its rating; empty where every safety that is rated is sufficient.

    S_delta counts where the case gives the bearings of the worm's shaft.
    """
    failed, gear = [], duty.gear
    if worn is not None and worn >= gear.tooth_thickness:
        failed.append(
            f"Wear of {worn * 1e3:.3g} mm in its life would take the whole tooth, which is "
            f"{gear.tooth_thickness * 1e3:.3g} mm thick."
        )
    elif worn is not None and worn > gear.wear_limit:
        failed.append(
            f"Wear of {worn * 1e3:.3g} mm in its life is more than {gear.wear_limit * 1e3:.3g} mm, what the "
            "standard allows (0.3 m_x cos gamma)."
        )
    # bearings that are assumed decide nothing
    decides = [of for of in made if of.symbol != "S_delta" or duty.deflection is not None]
    failed += [
        f"{of.symbol} = {of.value:.3g} against {of.label} is below {of.minimum:g}."
        for of in decides
        if of.value is not None and of.value < of.minimum
    ]
    return tuple(failed)
