"""Threads of the worm and teeth of the wheel in space, for pictures.

The thread is swept from its section with a plane through the axis: its height there, of any profile, and the
screw. A contact point, which lies on it, says where on the axis it stands.
"""

from collections.abc import Sequence
from math import pi

import numpy as np

from pyworm.drives.answers import Shape, Space
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.teeth.gears import WormGears

HEIGHTS = 7
"""Points from the root of the thread to its tip."""

ANGLES = 48
"""Points in a turn of the thread."""

THREAD_TURNS = 1.5
"""Length of the worm shown, in turns of a thread."""

TEETH = 3
"""Teeth of the wheel on each side of the one in contact."""

DRAWN_PARTS = (
    "Colours: pressure of this contact, seen through the worm. Drawn are only the flanks that drive and are "
    "driven."
)


def in_space(gears: WormGears, phases: Sequence[float]) -> Space:
    """The thread that drives and the flank of the wheel that it drives, turned to phases."""
    contacts = [gears.cycle.contact(phase) for phase in phases]
    worm = Shape(
        1,
        gears.worm_flank.axis_point,
        gears.worm_flank.axes[:, 2],
        thread(gears),
        np.array([contact.worm_angle for contact in contacts]),
        tuple(2 * pi * np.arange(1, gears.worm.threads) / gears.worm.threads),
    )
    wheel = _wheel(gears, np.array([contact.wheel_angle for contact in contacts]))
    # the worm, which lies at negative x, comes above the wheel; a left-handed triad would mirror its threads
    view = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
    return Space((worm, wheel), view, 0.5 * gears.centre_distance, DRAWN_PARTS)


def thread(gears: WormGears) -> Array:
    """Points of the driving flank at worm angle zero, (heights, angles, 3) [m]."""
    flank, tooth = gears.worm_flank, gears.worm_tooth
    radius = np.linspace(tooth.start_radius, tooth.tip_radius, HEIGHTS)
    section = np.array([flank.axial_profile(r) for r in radius])
    middle = gears.cycle.contact(0.5)
    local = flank.axes.T @ (middle.point - flank.axis_point)
    met = float(np.hypot(local[0], local[1]))
    # turning the screw takes its advance off the height, so this is the height at angle zero, in the section
    turn = float(np.arctan2(local[1], local[0]))
    height = (
        section - flank.axial_profile(met) + local[2] - flank.screw * (turn - middle.worm_angle)
    )
    centre = -height[HEIGHTS // 2] / flank.screw  # whole turns off are the same thread
    reach = pi * THREAD_TURNS
    angle = centre + np.linspace(-reach, reach, round(ANGLES * THREAD_TURNS) + 1)
    section_points = np.stack(
        [
            radius[:, None] * np.cos(angle),
            radius[:, None] * np.sin(angle),
            height[:, None] + flank.screw * angle,
        ]
    )
    return np.moveaxis(
        flank.axis_point[:, None, None] + np.tensordot(flank.axes, section_points, 1), 0, -1
    )


def _wheel(gears: WormGears, angles: Array) -> Shape:
    grid, flank = gears.flank_grid, gears.wheel_flank
    points = np.where(grid.found, flank.point(*grid.q), np.nan)
    around = (
        2
        * pi
        * np.array([tooth for tooth in range(-TEETH, TEETH + 1) if tooth])
        / gears.wheel.teeth
    )
    return Shape(
        2,
        np.zeros(3),
        np.array([0.0, 1.0, 0.0]),
        np.moveaxis(points.reshape(3, *grid.face.shape), 0, -1),
        -angles,
        tuple(around),
        grid.face,
        grid.radius,
    )
