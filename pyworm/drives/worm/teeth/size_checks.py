"""Checks whether sizes of a design table are what their keys say: diameters for radii, numbers exchanged.

Each refusal begins with the key that is wrong; the sizes are compared with those that every worm gear has.
"""

from math import pi

from pyworm.drives.worm.teeth.gears import WormGears

TALLEST = 4.0
"""Largest height of a thread or a tooth over the axial module; usual ones have 2.2."""

LOWEST = 1.8
"""Least height of a usual one over the axial module."""


def check_sizes(gears: WormGears) -> None:
    """Refuse sizes that belong to another key, or to none.

    Raises
    ------
    ValueError
        If one is such.
    """
    _check_counts(gears)
    _check_threads(gears)
    _check_wheel(gears)


def _check_counts(gears: WormGears) -> None:
    """Refuse a worm of as many threads as its wheel has teeth."""
    threads, teeth = gears.worm.threads, gears.wheel.teeth
    if threads >= teeth:
        raise ValueError(
            f"worm.threads is {threads} and wheel.teeth {teeth}; a worm has fewer threads than its wheel "
            f"has teeth, swapped? worm.threads = {teeth}, wheel.teeth = {threads}"
        )


def _check_threads(gears: WormGears) -> None:
    """Refuse diameters of the threads of worm or hob, and a hob smaller than the worm."""
    module = gears.worm.axial_pitch / pi
    tallest = TALLEST * module
    for name, screw in (("worm", gears.worm), ("hob", gears.hob)):
        tip, root = screw.tip_radius, screw.root_radius
        if tip <= root:
            if LOWEST * module < tip - root / 2 < tallest:
                raise ValueError(_a_diameter(f"{name}.root_radius", root, "above tip_radius"))
            continue  # refused with both
        if tip - root > tallest and root < tip / 2 < root + tallest:
            high = f"{_mm(tip - root)} above root_radius, and threads are up to {_mm(tallest)} high"
            raise ValueError(_a_diameter(f"{name}.tip_radius", tip, high))
    if gears.hob.tip_radius < gears.worm.tip_radius:
        raise ValueError(
            f"hob.tip_radius is {_mm(gears.hob.tip_radius)}, smaller than that of the worm, "
            f"{_mm(gears.worm.tip_radius)}: the worm's tip would touch the root that the hob leaves"
        )


def _check_wheel(gears: WormGears) -> None:
    """Refuse a throat that is not about the worm, a tip far above it, and a face wider than the worm."""
    worm, wheel, distance = gears.worm, gears.wheel, gears.centre_distance
    if worm.tip_radius <= worm.root_radius:
        return  # refused with both
    tallest = TALLEST * worm.axial_pitch / pi
    low, high = distance - worm.tip_radius, distance - worm.root_radius
    throat = wheel.throat_radius
    about = (
        f"at a centre distance of {_mm(distance)} the worm lies between {_mm(low)} and {_mm(high)}"
    )
    if low < throat / 2 < high:
        raise ValueError(_a_diameter("wheel.throat_radius", throat, about))
    if throat <= worm.tip_radius < low:
        raise ValueError(
            f"wheel.throat_radius is {_mm(throat)}: {about}; is it the radius of the throat's groove? the "
            "radius of the wheel in its throat is wanted"
        )
    if throat < wheel.tip_radius / 2 < throat + tallest:
        raise ValueError(
            _a_diameter("wheel.tip_radius", wheel.tip_radius, f"throat_radius is {_mm(throat)}")
        )
    if wheel.face_width > 2 * worm.tip_radius:
        raise ValueError(
            f"wheel.face_width is {_mm(wheel.face_width)}; a wheel is not wider than its worm, "
            f"{_mm(2 * worm.tip_radius)}"
        )


def _a_diameter(key: str, value: float, why: str) -> str:
    """The refusal of a diameter in the place of a radius."""
    return f"{key} is {_mm(value)}: {why}; is it a diameter? a radius is wanted, {_mm(value / 2)}"


def _mm(value: float) -> str:
    return f"{value * 1e3:.2f} mm"
