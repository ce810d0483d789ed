"""Flanks of worm and wheel by their design tables."""

from pyworm.drives.worm.drawing.design import Hob, Worm
from pyworm.drives.worm.flanks.helicoid import Helicoid
from pyworm.drives.worm.flanks.surfaces import WheelSurface, WormSurface
from pyworm.drives.worm.flanks.swept_helicoid import SweptHelicoid
from pyworm.drives.worm.flanks.swept_wheel import SweptWheel
from pyworm.drives.worm.flanks.wheel_envelope import WheelFlank
from pyworm.io.present import present

Seat = tuple[float, float, float]
"""Centre distance [m], turn about X [rad] and shift along the wheel's axis [m]."""


def worm_of(screw: Worm | Hob, size: float, seat: Seat) -> WormSurface:
    """The helicoid of a worm or a hob at its place; `size` is a length such as the reference radius [m]."""
    if screw.generator is None:
        return Helicoid(present(screw.base_radius, "base_radius"), screw.lead, *seat)
    return SweptHelicoid(screw.generator, size, *seat)


def wheel_of(hob: Hob, size: float, ratio: float) -> WheelSurface:
    """The flank that a hob cuts, with threads / teeth as the ratio."""
    cutter = worm_of(hob, size, (hob.centre_distance, hob.swivel, hob.axial_shift))
    return WheelFlank(cutter, ratio) if isinstance(cutter, Helicoid) else SweptWheel(cutter, ratio)
