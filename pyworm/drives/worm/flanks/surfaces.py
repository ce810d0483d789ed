"""Flanks of worm and wheel, involutes in closed form and all others as points, and how they touch."""

from pyworm.drives.worm.flanks.contact_curve import ContactCurve
from pyworm.drives.worm.flanks.contact_path import ContactPath
from pyworm.drives.worm.flanks.helicoid import Helicoid
from pyworm.drives.worm.flanks.line_of_action import lines_of_action
from pyworm.drives.worm.flanks.swept_helicoid import SweptHelicoid
from pyworm.drives.worm.flanks.swept_wheel import SweptWheel
from pyworm.drives.worm.flanks.wheel_envelope import WheelFlank

WormSurface = Helicoid | SweptHelicoid
"""Flank of a worm or a hob."""

WheelSurface = WheelFlank | SweptWheel
"""Flank of a wheel."""


def contact_paths(
    worm: WormSurface, flank: WheelSurface, threads: int, reference_radii: tuple[float, float]
) -> tuple[ContactPath, ...]:
    """Paths along which worm and wheel touch, by threads and reference radii of worm and hob [m]."""
    if isinstance(worm, Helicoid) and isinstance(flank, WheelFlank):
        return lines_of_action(worm, flank)
    if isinstance(worm, SweptHelicoid) and isinstance(flank, SweptWheel):
        return (ContactCurve(worm, flank, threads, reference_radii),)
    raise TypeError("worm and hob have flanks of one profile")
