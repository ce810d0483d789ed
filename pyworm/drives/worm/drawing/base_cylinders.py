"""A ZI worm gear given by the base cylinders of worm and hob, as papers have it, in place of a module."""

from collections.abc import Mapping
from typing import Any

from pyworm.drives.worm.drawing.design import Design, Hand, Hob, ParabolicRelief, Wheel, Worm
from pyworm.drives.worm.drawing.drawing import key_of
from pyworm.drives.worm.flanks.worm_profiles import Profile

_SCREW = (
    *("tip_diameter", "root_diameter", "base_diameter"),
    *("axial_pitch", "lead", "base_lead_angle"),
)
"""Numbers of worm and hob."""

OF_HOB = tuple(f"hob_{name}" for name in _SCREW)
"""Numbers of a hob that follow from a module where one is given."""

_REQUIRED_NUMBERS = (
    *("threads", "teeth", "centre_distance", "face_width"),
    *(*(f"worm_{name}" for name in _SCREW), "wheel_outside_diameter", "wheel_throat_diameter"),
    *(*OF_HOB, "hob_centre_distance", "hob_swivel", "hob_axial_shift"),
)
"""Numbers that all have to be given."""

_ALLOWED = tuple(
    f"{part}_{name}"
    for part in ("worm", "wheel")
    for name in ("fillet_radius", "tip_relief", "tip_relief_length")
)
"""Numbers that may be given; all others are of a drawing with a module."""


def base_cylinder_design(profile: Profile, given: Mapping[str, Any], hand: Hand) -> Design:
    """Worm, wheel and hob of their base cylinders by `Drawing`'s and `OF_HOB`'s numbers, None if not given.

    ValueError, which begins with a key, if one is missing, or is of a drawing with a module.
    """
    _check(profile, given)
    return Design(
        worm=Worm(threads=given["threads"], **_screw(given, "worm"), **_ends(given, "worm")),
        wheel=Wheel(
            teeth=given["teeth"],
            face_width=given["face_width"],
            tip_radius=given["wheel_outside_diameter"] / 2,
            throat_radius=given["wheel_throat_diameter"] / 2,
            **_ends(given, "wheel"),
        ),
        hob=Hob(
            centre_distance=given["hob_centre_distance"],
            swivel=given["hob_swivel"],
            axial_shift=given["hob_axial_shift"],
            **_screw(given, "hob"),
        ),
        centre_distance=given["centre_distance"],
        hand=hand,
    )


def _screw(given: Mapping[str, Any], part: str) -> dict[str, Any]:
    """Numbers of worm or hob by the names of their design tables, which have radii."""
    return {
        name.replace("diameter", "radius"): given[f"{part}_{name}"]
        / (2 if "diameter" in name else 1)
        for name in _SCREW
    }


def _ends(given: Mapping[str, Any], part: str) -> dict[str, Any]:
    """Fillet and tip relief of worm or wheel; none where they are not given."""
    fillet, amount, length = (
        given[f"{part}_{name}"] or 0.0
        for name in ("fillet_radius", "tip_relief", "tip_relief_length")
    )
    return {"fillet_radius": fillet, "tip_relief": ParabolicRelief(amount, length)}


def check_no_cylinder_of_the_hob(given: Mapping[str, Any]) -> None:
    """Refuse numbers of the hob that follow from a module; ValueError, whose sentence begins with the key."""
    for name in OF_HOB:
        if given.get(name) is not None:
            raise ValueError(
                f"{key_of(name)} has no effect with module, of which the hob follows by hob.oversize and "
                "wheel.root_diameter; leave it out, or give the base cylinders of worm and hob and no module"
            )


def _check(profile: Profile, given: Mapping[str, Any]) -> None:
    """Refuse numbers that are not those of base cylinders; as `base_cylinder_design`."""
    if given["worm_base_diameter"] is given["hob_base_diameter"] is None:
        raise ValueError(
            "module is missing (axial, m); or give the base cylinders of worm and hob, "
            f"{', '.join(map(key_of, _REQUIRED_NUMBERS[2:]))}"
        )
    if profile != "ZI":
        raise ValueError(
            f'profile is "{profile}"; without module the flanks are those of base cylinders, profile "ZI"'
        )
    for name in sorted(given.keys() - {*_REQUIRED_NUMBERS, *_ALLOWED}):
        if given[name] is not None:
            raise ValueError(
                f"{key_of(name)} has no effect without module, where the flanks are those of base cylinders"
            )
    for name in _REQUIRED_NUMBERS:
        if given[name] is None:
            raise ValueError(
                f"{key_of(name)} is missing; without module the flanks are those of base cylinders, which "
                "ask for it"
            )
