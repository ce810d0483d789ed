"""Fillets of worm and wheel where a drawing does not give them: as large as usual, or as what fits.

Full roundings, of which two fill the space at the worm's root or the tip of the hob's thread, are found on
the flanks themselves, which differ from straight ones at large lead angles and of concave worms.
"""

from collections.abc import Callable
from math import cos, pi

import scipy

from pyworm.drives.worm.drawing.designed_flanks import worm_of
from pyworm.drives.worm.drawing.drawing import Drawing
from pyworm.drives.worm.flanks.surfaces import WormSurface
from pyworm.drives.worm.flanks.thread_section import axial_angle, form_radius, thread_thickness

USUAL = 0.2
"""Usual radius over the axial module: its height, 0.2 (1 - sin alpha) modules, is within the clearance."""

ROOM = 0.8
"""Usual radius over that of a full rounding, at most."""


def fitting_fillets(drawing: Drawing) -> tuple[float, float]:
    """Radii [m] of the worm's fillet and of the hob's rounded tip edge; zero where nothing fits.

    ValueError if the drawing has no flanks (`Drawing.worm`, `Drawing.hob`).
    """
    worm, hob, size = drawing.worm, drawing.hob, drawing.reference_diameter / 2
    thread, cutter = (
        worm_of(screw, size, (drawing.centre_distance, 0.0, 0.0)) for screw in (worm, hob)
    )
    hob_size = size + drawing.hob_oversize / 2
    thickness = thread_thickness(thread, hob_size, size, drawing.worm_thickness) + drawing.backlash
    thickness *= hob.axial_pitch / worm.axial_pitch

    def space(radius: float) -> float:
        return pi * drawing.module - thread_thickness(thread, radius, size, drawing.worm_thickness)

    def tip(radius: float) -> float:
        return thread_thickness(cutter, radius, hob_size, thickness)

    return (
        _fitting(drawing.module, thread, worm.root_radius, worm.tip_radius, space),
        _fitting(drawing.module, cutter, hob.tip_radius, hob.root_radius, tip),
    )


def _fitting(
    module: float,
    flank: WormSurface,
    end: float,
    other_end: float,
    room_of: Callable[[float], float],
) -> float:
    """Radius [m] of which two fit, with some room, between two flanks at an end of a thread."""

    def left(fillet: float) -> float:
        try:
            radius = form_radius(flank, end, fillet, other_end)
        except ValueError:  # it would take all of the flank
            return -module
        return room_of(radius) - 2 * fillet * cos(axial_angle(flank, radius))

    most = USUAL * module / ROOM
    if left(most) >= 0:
        return USUAL * module
    if left(0.0) <= 0:
        return 0.0
    return ROOM * float(scipy.optimize.brentq(left, 0.0, most, xtol=1e-12))
