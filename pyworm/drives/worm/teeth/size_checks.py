"""Checks whether sizes of worm, wheel and hob are what they are called: no radii, no numbers exchanged.

Each refusal begins with the key of a case file that is wrong, of which radii here are halves; the sizes are
compared with those that every worm gear has.
"""

from math import pi

from pyworm.drives.worm.flanks.contact_curve import HobError
from pyworm.drives.worm.teeth.gears import WormGears

TALLEST = 4.0
"""Largest height of a thread or a tooth over the axial module; usual ones have 2.2."""

MIN_TOOTH_HEIGHT = 1.8
"""Least height of a usual one over the axial module."""


def check_sizes(gears: WormGears) -> None:
    """Refuse sizes that belong to another key, or to none (ValueError)."""
    _check_counts(gears)
    _check_threads(gears)
    _check_wheel(gears)


def _check_counts(gears: WormGears) -> None:
    """Refuse a worm of as many threads as its wheel has teeth."""
    threads, teeth = gears.worm.threads, gears.wheel.teeth
    if threads >= teeth:
        raise ValueError(
            f"threads is {threads} with {teeth} teeth; a worm has fewer threads than its wheel has teeth, "
            f"swapped? threads = {teeth}, teeth = {threads}"
        )


def _check_threads(gears: WormGears) -> None:
    """Refuse diameters of the threads of worm or hob, and a hob smaller than the worm."""
    module = gears.worm.axial_pitch / pi
    tallest = TALLEST * module
    for name, screw in (("worm", gears.worm), ("hob", gears.hob)):
        tip, root = screw.tip_radius, screw.root_radius
        key = f"{name}.tip_diameter"
        if tip <= root:
            if MIN_TOOTH_HEIGHT * module < tip - root / 2 < tallest:
                raise ValueError(_twice(f"{name}.root_diameter", root, "above tip_diameter"))
            if MIN_TOOTH_HEIGHT * module < 2 * tip - root < tallest:
                raise ValueError(_half(key, tip, f"below root_diameter, {_mm(2 * root)}"))
            continue  # refused with both
        if tip - root > tallest and root < tip / 2 < root + tallest:
            high = f"{_mm(tip - root)} from root to tip, and threads are up to {_mm(tallest)} high"
            raise ValueError(_twice(key, tip, high))
    if gears.hob.tip_radius < gears.worm.tip_radius:
        raise HobError(
            f"hob.tip_diameter is {_mm(2 * gears.hob.tip_radius)}, smaller than that of the worm, "
            f"{_mm(2 * gears.worm.tip_radius)}: the worm's tip would touch the root that the hob leaves"
        )


def _check_wheel(gears: WormGears) -> None:
    """Refuse a throat that is not about the worm, a tip far above it, and a face wider than the worm."""
    worm, wheel, distance = gears.worm, gears.wheel, gears.centre_distance
    if worm.tip_radius <= worm.root_radius:
        return  # refused with both
    tallest = TALLEST * worm.axial_pitch / pi
    low, high = distance - worm.tip_radius, distance - worm.root_radius
    throat = wheel.throat_radius
    about = f"at a centre distance of {_mm(distance)} it lies between {_mm(2 * low)} and {_mm(2 * high)}"
    if low < throat / 2 < high:
        raise ValueError(_twice("wheel.throat_diameter", throat, about))
    if low < 2 * throat < high:
        raise ValueError(_half("wheel.throat_diameter", throat, about))
    if throat <= worm.tip_radius < low:
        raise ValueError(
            f"wheel.throat_diameter is {_mm(2 * throat)}: {about}; is it that of the throat's groove? the "
            "wheel's own in its throat is required"
        )
    tip, over = wheel.tip_radius, f"throat_diameter is {_mm(2 * throat)}"
    if throat < tip / 2 < throat + tallest:
        raise ValueError(_twice("wheel.outside_diameter", tip, over))
    if throat < 2 * tip < throat + tallest:
        raise ValueError(_half("wheel.outside_diameter", tip, over))
    if wheel.face_width > 2 * worm.tip_radius:
        raise ValueError(
            f"face_width is {_mm(wheel.face_width)}; a wheel is not wider than its worm, "
            f"{_mm(2 * worm.tip_radius)}"
        )


def _twice(key: str, radius: float, why: str) -> str:
    """The refusal of a diameter that is twice as large as a fitting one."""
    return f"{key} is {_mm(2 * radius)}: {why}; did you mean {_mm(radius)}?"


def _half(key: str, radius: float, why: str) -> str:
    """The refusal of a radius in the place of a diameter."""
    size = 2 * radius
    return f"{key} is {_mm(size)}: {why}; is it a radius? a diameter is required, {_mm(2 * size)}"


def _mm(value: float) -> str:
    return f"{value * 1e3:.2f} mm"
