"""The hob's swivel where a drawing does not give it."""

from dataclasses import replace
from functools import lru_cache
from math import degrees

from pyworm.drives.worm.drawing.design import AS_DESIGNED, Assembly
from pyworm.drives.worm.drawing.drawing import Drawing
from pyworm.drives.worm.flanks.contact_curve import HobError
from pyworm.drives.worm.flanks.worm_profiles import CONCAVE_PROFILES
from pyworm.drives.worm.teeth.checks import check_gears
from pyworm.drives.worm.teeth.gears import WormGears

FRACTIONS = (1.0, 0.95, 0.9, 0.85, 0.8, 0.7)
"""Swivels that are tried, over the one by which hob and worm have the same normal in the pitch point.

At larger lead angles that one leaves so little crowning that the worm would cut in at an end of the face.
"""

LEAST_CONCAVE_SHIFT = 0.4
"""Profile shift of ZC worms below which it is the likely cause where worm and wheel do not fit."""


@lru_cache(maxsize=4)
def with_swivel(drawing: Drawing) -> tuple[Drawing, str]:
    """A drawing with the first swivel without interference of worm and wheel, and that in words.

    ValueError if none of those tried leaves a wheel that the worm meshes with.
    """
    refusal: ValueError | None = None
    depth: float | None = None
    for fraction in FRACTIONS:
        swivel = fraction * drawing.normal_swivel
        tried = replace(drawing, hob_swivel=swivel)
        try:
            found = drawn_gears(tried).interference
        except ValueError as error:
            refusal = refusal or error
            continue
        if found is None:
            angle = "the difference of the lead angles of worm and hob"
            part = "" if fraction == 1.0 else f"{fraction:g} of "
            why = "" if fraction == 1.0 else ", with all of which the worm would cut into the wheel"
            return tried, f"hob.swivel = {degrees(swivel):.4g} deg, {part}{angle}{why}"
        depth = found.depth if depth is None else min(depth, found.depth)
    if depth is None:
        # any other refusal is of a size of the drawing
        of_hob = isinstance(refusal, HobError)
        if (
            of_hob
            and drawing.profile in CONCAVE_PROFILES
            and drawing.profile_shift < LEAST_CONCAVE_SHIFT
        ):
            raise ValueError(
                f"profile_shift is {drawing.profile_shift:.3g}, with which a concave worm and its wheel "
                f'interfere or do not touch; profile "{drawing.profile}" has 0.5 to 1 as a rule, so that '
                "the pitch line is near the worm's tip; another centre_distance or number of teeth gives it"
            )
        raise refusal or ValueError("hob.swivel is not given, and none fits")
    last, first = (degrees(fraction * drawing.normal_swivel) for fraction in (FRACTIONS[-1], 1.0))
    raise ValueError(
        f"hob.swivel is not given, and none from {last:.4g} to {first:.4g} deg fits: the worm would cut "
        f"{depth * 1e6:.1f} um or more into the wheel; a larger hob.oversize or a smaller face_width is "
        "needed"
    )


def drawn_gears(drawing: Drawing, assembly: Assembly = AS_DESIGNED) -> WormGears:
    """Worm and wheel of a drawing, as cut and assembled; ValueError if they do not mesh."""
    gears = WormGears(
        worm=drawing.worm,
        wheel=drawing.wheel,
        hob=drawing.hob,
        centre_distance=drawing.centre_distance,
        assembly=assembly,
    )
    check_gears(gears)
    return gears
