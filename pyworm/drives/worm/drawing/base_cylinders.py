"""A ZI worm gear given by the base cylinders of worm and hob, as papers have it, in place of a module."""

from collections.abc import Mapping
from typing import Any

from pyworm.drives.worm.drawing.design import Design, Hand, Hob, ParabolicRelief, Wheel, Worm
from pyworm.drives.worm.drawing.drawing import key_of
from pyworm.drives.worm.flanks.worm_profiles import Profile

OF_HOB = tuple(
    f"hob_{name}"
    for name in (
        *("tip_diameter", "root_diameter", "base_diameter"),
        *("axial_pitch", "lead", "base_lead_angle"),
    )
)
"""Numbers of a hob that follow from a module where one is given."""

_WANTED = (
    *("centre_distance", "face_width"),
    *("worm_tip_diameter", "worm_root_diameter", "worm_base_diameter"),
    *("worm_axial_pitch", "worm_lead", "worm_base_lead_angle"),
    *("wheel_outside_diameter", "wheel_throat_diameter"),
    *(*OF_HOB, "hob_centre_distance", "hob_swivel", "hob_axial_shift"),
)
"""Numbers that all have to be given."""

_OF_MODULE = (
    *("diameter_factor", "pressure_angle", "profile_shift", "backlash"),
    *("worm_thickness", "worm_reference_diameter", "worm_lead_angle"),
    *("worm_disc_diameter", "worm_arc_radius"),
    *("wheel_root_diameter", "wheel_reference_diameter", "wheel_groove_radius"),
    *("hob_oversize", "hob_reference_diameter"),
)
"""Numbers of a drawing with a module that these gears do not have."""


def base_cylinder_design(profile: Profile, given: Mapping[str, Any], hand: Hand) -> Design:
    """Worm, wheel and hob of their base cylinders.

    Parameters
    ----------
    profile : str
        Form of the flanks, which is ZI.
    given : mapping
        Numbers by the names of `Drawing`, and those of `OF_HOB`; those that are left out None.
    hand : str
        Hand of the threads.

    Raises
    ------
    ValueError
        A number is missing, or is of a drawing with a module; the sentence begins with its key.
    """
    _check(profile, given)
    return Design(
        worm=Worm(
            threads=given["threads"],
            tip_radius=given["worm_tip_diameter"] / 2,
            root_radius=given["worm_root_diameter"] / 2,
            base_radius=given["worm_base_diameter"] / 2,
            axial_pitch=given["worm_axial_pitch"],
            lead=given["worm_lead"],
            base_lead_angle=given["worm_base_lead_angle"],
            tip_relief=_relief(given, "worm"),
            fillet_radius=given["worm_fillet_radius"] or 0.0,
        ),
        wheel=Wheel(
            teeth=given["teeth"],
            face_width=given["face_width"],
            tip_radius=given["wheel_outside_diameter"] / 2,
            throat_radius=given["wheel_throat_diameter"] / 2,
            tip_relief=_relief(given, "wheel"),
            fillet_radius=given["wheel_fillet_radius"] or 0.0,
        ),
        hob=Hob(
            tip_radius=given["hob_tip_diameter"] / 2,
            root_radius=given["hob_root_diameter"] / 2,
            base_radius=given["hob_base_diameter"] / 2,
            lead=given["hob_lead"],
            axial_pitch=given["hob_axial_pitch"],
            base_lead_angle=given["hob_base_lead_angle"],
            centre_distance=given["hob_centre_distance"],
            swivel=given["hob_swivel"],
            axial_shift=given["hob_axial_shift"],
        ),
        centre_distance=given["centre_distance"],
        hand=hand,
    )


def check_no_cylinder_of_the_hob(given: Mapping[str, Any]) -> None:
    """Refuse numbers of the hob that follow from a module; ValueError, whose sentence begins with the key."""
    for name in OF_HOB:
        if given.get(name) is not None:
            raise ValueError(
                f"{key_of(name)} means nothing beside module, of which the hob follows by hob.oversize and "
                "wheel.root_diameter; leave it out, or give the base cylinders of worm and hob and no module"
            )


def _check(profile: Profile, given: Mapping[str, Any]) -> None:
    """Refuse numbers that are not those of base cylinders; as `base_cylinder_design`."""
    if given["worm_base_diameter"] is given["hob_base_diameter"] is None:
        raise ValueError(
            "module is missing (axial, m); or give the base cylinders of worm and hob, "
            f"{', '.join(map(key_of, _WANTED))}"
        )
    if profile != "ZI":
        raise ValueError(
            f'profile is "{profile}"; without module the flanks are those of base cylinders, profile "ZI"'
        )
    for name in _OF_MODULE:
        if given[name] is not None:
            raise ValueError(
                f"{key_of(name)} means nothing without module, where the flanks are those of base cylinders"
            )
    for name in _WANTED:
        if given[name] is None:
            raise ValueError(
                f"{key_of(name)} is missing; without module the flanks are those of base cylinders, which "
                "ask for it"
            )


def _relief(given: Mapping[str, Any], part: str) -> ParabolicRelief:
    """Tip relief of worm or wheel; none where it is not given."""
    amount, length = (given[f"{part}_tip_relief{end}"] or 0.0 for end in ("", "_length"))
    return ParabolicRelief(amount, length)
