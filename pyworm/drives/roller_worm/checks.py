"""Checks of the input of a roller drive; each refusal begins with the key that is wrong."""

from math import degrees, pi
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from pyworm.drives.roller_worm.drive import RollerWormDrive

FARTHEST = 80.0
"""Largest wheel angle at which a section may end [deg]."""


def check_drive(drive: "RollerWormDrive") -> None:
    """Refuse sizes that do not fit each other."""
    worm, rollers, profile = drive.worm, drive.rollers, drive.rollers.profile
    if not 0 < worm.throat_coefficient < 2:
        raise ValueError(
            f"worm.throat_coefficient is {worm.throat_coefficient:g}; the throat must lie between the axes, "
            "from 0 to 2"
        )
    if not worm.throat_angle < worm.outer_angle <= np.radians(FARTHEST):
        raise ValueError(
            f"worm.outer_angle is {degrees(worm.outer_angle):.4g} deg; it must lie from worm.throat_angle, "
            f"{degrees(worm.throat_angle):.4g} deg, to {FARTHEST:g} deg"
        )
    for name in ("addendum", "dedendum"):
        if getattr(worm, name) > profile.length / 2:
            raise ValueError(
                f"worm.{name} is {getattr(worm, name) * 1e3:.4g} mm; it must not be above half the rollers' "
                f"length, {profile.length * 5e2:.4g} mm"
            )
    if np.cos(rollers.tilt) * worm.dedendum >= drive.throat_radius:
        raise ValueError(
            f"worm.dedendum is {worm.dedendum * 1e3:.4g} mm; it must stay below the throat's radius, "
            f"{drive.throat_radius * 1e3:.4g} mm"
        )
    thick = 2 * float(np.max(profile(np.array([-worm.addendum, 0.0]))[0]))
    inner = drive.centre_distance - drive.throat_radius - np.cos(rollers.tilt) * worm.addendum
    apart = 2 * inner * np.sin(pi / rollers.count)
    if not thick < apart:
        raise ValueError(
            f"rollers.radius is {profile.radius * 1e3:.4g} mm; {rollers.count} rollers stand only "
            f"{apart * 1e3:.4g} mm apart at the thread's tip, which leaves no thread between them"
        )
