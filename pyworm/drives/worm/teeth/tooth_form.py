"""Thickness of threads and teeth up to their tips.

A tooth's other flank is the first one turned by half a turn about the line of centres, so that the place
along the face changes its sign.
"""

from collections.abc import Iterator
from math import pi

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.flanks.thread_section import thread_thickness
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.tooth import wheel_radius
from pyworm.drives.worm.teeth.tooth_outline import flank_places

FACE_PLACES = 21
"""Places along the face at which the wheel tooth's thickness is found; an odd number has the middle."""

REACHED = 1e-5
"""Distance from a boundary at which the flank has reached it [m]."""


def worm_thickness(gears: WormGears, radius: float) -> float:
    """Axial thickness of the thread on a cylinder [m]; as usual half the pitch on the reference one."""
    known = gears.worm.thickness
    there = pi / 2 * gears.module if known is None else known
    return thread_thickness(gears.worm_flank, radius, gears.reference_radius, there)


def wheel_thickness(gears: WormGears) -> float:
    """Thickness of the wheel's tooth on its reference circle in the mid-plane [m].

    There it rolls with the worm's cylinder of the radius that is left of the centre distance: both
    thicknesses and the backlash fill the pitch.
    """
    cylinder = gears.centre_distance - gears.wheel_reference_radius
    taken = worm_thickness(gears, cylinder) + (gears.wheel.backlash or 0.0)
    return pi * gears.module - taken


def wheel_tip_thickness(gears: WormGears) -> tuple[Array, Array]:
    """Thickness of the wheel's teeth at their tip over places along the face [m].

    It is negative where the flanks meet below the tip, not a number where the flank does not reach it.
    """
    half = gears.wheel.face_width / 2
    along = np.linspace(-half, half, FACE_PLACES)
    reference = gears.wheel_reference_radius
    target = np.stack([np.append(gears.wheel_tooth.tip(along), reference), np.append(along, 0.0)])
    q = flank_places(gears.wheel_flank, gears.within, target)
    point, normal = gears.wheel_flank.point(*q), gears.wheel_flank.normal(*q)
    angle = np.arctan2(point[2], -point[0])
    outwards = np.sign(normal[0] * np.sin(angle) + normal[2] * np.cos(angle))
    off = np.abs(np.stack([wheel_radius(point), point[1]]) - target).max(axis=0)
    angle = np.where(off < 1e-6, angle, np.nan)
    grown = outwards[:-1] * (angle[:-1] + angle[:-1][::-1] - 2 * angle[-1])
    return along, target[0, :-1] * (wheel_thickness(gears) / reference + grown)


def flank_start(gears: WormGears) -> float:
    """Radius in the mid-plane from which the wheel's tooth has its flank [m]; a fillet is below it."""
    target = np.array([[float(gears.wheel_tooth.root(np.zeros(1))[0])], [0.0]])
    q = flank_places(gears.wheel_flank, gears.within, target, gears.wheel_tooth.hob_form_radius)
    return float(wheel_radius(gears.wheel_flank.cut_point(*q))[0])


def undercut(gears: WormGears) -> float:
    """How far the hob's flank reaches beyond the edge of its envelope [m]; zero without undercut."""
    cut = gears.wheel_flank.cut_point(*gears.rim)
    margins = np.stack(list(gears.wheel_tooth.margins(cut).values())).min(axis=0)
    beyond = gears.wheel_tooth.hob_form_radius - gears.wheel_flank.hob.radius(cut)
    ended = (margins > REACHED) & (beyond > REACHED)
    return float(np.max(beyond, where=ended, initial=0.0))


def tooth_form_warnings(gears: WormGears) -> tuple[str, ...]:
    """A sentence each for an undercut and a pointed thread, a pointed and an undercut tooth."""
    said = list(_thread_undercut(gears))
    tip = worm_thickness(gears, gears.worm.tip_radius)
    if tip <= 0:
        said.append(
            "worm: its threads are pointed below their tip, where their flanks would be "
            f"{-tip * 1e3:.3g} mm past each other; a smaller tip or a smaller pressure angle is needed"
        )
    along, thickness = wheel_tip_thickness(gears)
    known = np.isfinite(thickness)
    if known.any() and np.nanmin(thickness) <= 0:
        least = int(np.nanargmin(thickness))
        said.append(
            f"wheel: its teeth are pointed below their tip {abs(along[least]) * 1e3:.1f} mm from the middle "
            f"of the face, where their flanks would be {-thickness[least] * 1e3:.3g} mm past each other; a "
            "smaller outside diameter or face width is needed"
        )
    reach = undercut(gears)
    if reach > 0:
        said.append(
            f"wheel: it is undercut, the hob's flank reaches up to {reach * 1e3:.2g} mm below the end of its "
            "flanks, which are shorter than drawn; more teeth, a larger profile_shift or a larger pressure "
            "angle is needed"
        )
    return tuple(said)


def _thread_undercut(gears: WormGears) -> Iterator[str]:
    """The sentence about a thread whose flank ends above where the tip of the wheel reaches."""
    start = gears.worm_flank.start_radius
    reached = gears.axes_distance - gears.wheel.throat_radius
    if start > max(reached, gears.worm.root_radius):
        yield (
            f"worm: it is undercut, its flank begins on a diameter of {2e3 * start:.4g} mm, and the tip of "
            f"the wheel reaches to {2e3 * reached:.4g} mm; fewer threads, a larger diameter_factor or a "
            "larger pressure angle is needed"
        )
