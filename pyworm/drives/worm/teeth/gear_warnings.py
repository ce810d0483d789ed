"""Warnings of gears that mesh, but are unusual or mesh badly: a sentence each that begins with the key."""

from pyworm.drives.worm.teeth.fillet_checks import fillet_warnings
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.tooth_form import tooth_form_warnings

PITCH_WARNED = 5e-6
"""Difference of normal base pitches [m] that gives a warning; tables of four digits leave up to 3 um."""

USUAL_SHIFT = 1.0
"""Profile shift beyond which a drawing gives a warning."""


def gear_warnings(gears: WormGears) -> tuple[str, ...]:
    """Warnings, a sentence each: base pitch, profile shift, contact ratio, pointed teeth, fillets."""
    return (
        *_pitch_warnings(gears),
        *_shift_warnings(gears),
        *_ratio_warnings(gears),
        *(() if gears.edge_contact is None else (gears.edge_contact.warning,)),
        *tooth_form_warnings(gears),
        *fillet_warnings(gears),
    )


def _shift_warnings(gears: WormGears) -> tuple[str, ...]:
    if abs(gears.profile_shift) <= USUAL_SHIFT or gears.worm.reference_radius is None:
        return ()
    return (
        f"centre_distance is {gears.centre_distance * 1e3:.5g} mm, which asks for a profile shift of "
        f"{gears.profile_shift:.3g}; up to {USUAL_SHIFT:g} in either direction is usual",
    )


def _ratio_warnings(gears: WormGears) -> tuple[str, ...]:
    if gears.pitch <= 1:
        return ()
    return (
        f"wheel: its contact ratio is {1 / gears.pitch:.2f}, below 1: a pair of teeth parts before the "
        "next one meets; another place of the contact (drive.hob, drive.assembly), taller teeth or "
        "more of them are needed",
    )


def _pitch_warnings(gears: WormGears) -> tuple[str, ...]:
    worm, hob = gears.base_pitches
    apart = hob - worm
    if abs(apart) <= PITCH_WARNED or gears.worm.generator is not None:
        return ()
    return (
        f"hob.lead and hob.base_diameter give a normal base pitch of {hob * 1e3:.4f} mm, "
        f"{abs(apart) * 1e6:.1f} um {'more' if apart > 0 else 'less'} than the worm's "
        f"{worm * 1e3:.4f} mm: each tooth pair meets that far off its neighbours and carries most of the "
        "load at one end of its mesh; equal base pitches, lead x cos(base_lead_angle), share it evenly",
    )
