"""Worm, wheel and hob of a drive as solids, assembled in contact at mid-mesh.

Both gears lie in the drive frame as designed, without errors of the assembly and without load, the hob where
it cuts the wheel as that stands. A left-hand drive is the mirror image of a right-hand one at the plane
square to the worm's axis: the worm still turns positively, and its threads leave to the same side.
"""

from functools import partial

from pyworm.drives.worm.drawing.design import Hand
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.thread_solid import hob_solid, worm_solid
from pyworm.drives.worm.wheel_solid import wheel_solid
from pyworm.io.solid import Solid, accurate


def as_designed(gears: WormGears) -> WormGears:
    """Gears without errors of the assembly and without the load of a drive."""
    return WormGears(
        worm=gears.worm, wheel=gears.wheel, hob=gears.hob, centre_distance=gears.centre_distance
    )


def solids(gears: WormGears, hand: Hand) -> dict[str, Solid]:
    """Worm, wheel and hob by name; ValueError where a tooth has no such solid."""
    gears = as_designed(gears)
    middle = gears.cycle.contact(0.5)
    found = {
        "worm": accurate(partial(worm_solid, gears, middle.worm_angle)),
        "wheel": accurate(partial(wheel_solid, gears, middle.wheel_angle)),
        "hob": accurate(partial(hob_solid, gears, middle.wheel_angle / gears.ratio)),
    }
    if hand == "left":
        return {name: solid.mirrored() for name, solid in found.items()}
    return found
