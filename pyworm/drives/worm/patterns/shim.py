"""The shim under the wheel's bearing that brings a pattern moved by errors of assembly back to its place.

Moving the wheel along its axis is what a fitter can do. It is the opposite shift of the worm. The contact
point at mid-mesh moves nearly as the marked part does, so that its way by the shift is the first slope of the
secant method for the middle of the marked part.
"""

from dataclasses import replace

from pyworm.drives.answers import Shim
from pyworm.drives.worm.drawing.design import AS_DESIGNED
from pyworm.drives.worm.patterns.contact_pattern import ContactPattern, both_flanks, contact_pattern
from pyworm.drives.worm.patterns.hob_for_pattern import TOLERANCES, mark_of
from pyworm.drives.worm.teeth.gears import WormGears

DIFFERENCE = 0.02e-3
"""Shift of the wheel for the first slope [m]."""

MAX_SHIFT_STEP = 0.5e-3
"""Longest step of a shift [m]."""

MOST_STEPS = 10


def found_shim(
    gears: WormGears, patterns: tuple[ContactPattern, ContactPattern], wanted: float | None = None
) -> Shim:
    """The shim for a wanted middle of the mark along the face [m], or None: that without errors.

    `patterns` are those without load of the flank that the worm drives and of the other one.
    """

    def middle(pattern: ContactPattern) -> float:
        return mark_of(pattern).face

    def at(shift: float) -> float | None:
        try:
            return middle(contact_pattern(shimmed(gears, shift), gears.flank_grid))
        except ValueError:  # worm and wheel do not touch
            return None

    before = middle(patterns[0])
    if wanted is None:
        wanted = middle(contact_pattern(replace(gears, assembly=AS_DESIGNED), gears.flank_grid))
    shift, face, slope = 0.0, before, _slope(replace(gears, assembly=AS_DESIGNED))
    for _ in range(MOST_STEPS):
        if abs(face - wanted) <= TOLERANCES["face"]:
            break
        step = max(-MAX_SHIFT_STEP, min(MAX_SHIFT_STEP, (wanted - face) / slope))
        tried = at(shift + step)
        if tried is None:
            break
        slope = (tried - face) / step or slope
        shift, face = shift + step, tried
    return Shim(
        shift=shift,
        wanted=wanted,
        before=before,
        after=face,
        other_before=middle(patterns[1]),
        other_after=middle(both_flanks(shimmed(gears, shift), contact_pattern, gears)[1]),
        reached=abs(face - wanted) <= TOLERANCES["face"],
    )


def shimmed(gears: WormGears, shift: float) -> WormGears:
    """The gears with the wheel shifted along its axis [m]."""
    assembly = gears.assembly
    return replace(gears, assembly=replace(assembly, axial_shift=assembly.axial_shift - shift))


def _slope(gears: WormGears) -> float:
    """Way of the contact at mid-mesh along the face by the wheel's shift, of aligned flanks."""
    ends = [shimmed(gears, side * DIFFERENCE).cycle.contact(0.5).point[1] for side in (-1, 1)]
    return float(ends[1] - ends[0]) / (2 * DIFFERENCE)
