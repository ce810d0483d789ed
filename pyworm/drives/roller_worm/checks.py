"""Checks of the input of a roller drive; each refusal begins with the key that is wrong."""

from math import degrees, pi

import numpy as np

from pyworm.drives.roller_worm.gears import RollerGears
from pyworm.drives.roller_worm.section import WormSection

MAX_END_ANGLE = 80.0
"""Largest wheel angle at which a section may end [deg]."""


CHECKED = (61, 17)
"""Numbers of wheel angles and places along the roller at which undercut is checked."""


def check_gears(gears: RollerGears) -> None:
    """Refuse worm and rollers that do not fit each other, and sections not flank throughout (ValueError)."""
    _check_sizes(gears)
    for section in gears.sections.values():
        check_section(section)


def _check_sizes(gears: RollerGears) -> None:
    worm, rollers, profile = gears.worm, gears.rollers, gears.rollers.profile
    if not 0 < worm.throat_coefficient < 2:
        raise ValueError(
            f"worm.throat_coefficient is {worm.throat_coefficient:g}; the throat must lie between the axes, "
            "from 0 to 2"
        )
    _check_seat(gears)
    if not worm.throat_angle < worm.outer_angle <= np.radians(MAX_END_ANGLE):
        raise ValueError(
            f"worm.outer_angle is {degrees(worm.outer_angle):.4g} deg; it must lie from worm.throat_angle, "
            f"{degrees(worm.throat_angle):.4g} deg, to {MAX_END_ANGLE:g} deg"
        )
    for name in ("addendum", "dedendum"):
        if getattr(worm, name) > profile.length / 2:
            raise ValueError(
                f"worm.{name} is {getattr(worm, name) * 1e3:.4g} mm; it must not be above half the rollers' "
                f"length, {profile.length * 5e2:.4g} mm"
            )
    places = np.linspace(-worm.addendum, worm.dedendum, CHECKED[1])
    apart = 2 * (gears.pitch_radius + np.cos(rollers.tilt) * places) * np.sin(pi / rollers.count)
    tight = int(np.argmin(apart - 2 * profile(places)[0]))
    if not 2 * profile(places)[0][tight] < apart[tight]:
        raise ValueError(
            f"rollers.radius is {profile.radius * 1e3:.4g} mm; {rollers.count} rollers stand only "
            f"{apart[tight] * 1e3:.4g} mm apart at {places[tight] * 1e3:.4g} mm from their middles, which "
            "leaves no thread between them"
        )


def _check_seat(gears: RollerGears) -> None:
    """Refuse rollers that miss the throat, or whose axes do not point to the worm (ValueError)."""
    worm, rollers = gears.worm, gears.rollers
    if abs(rollers.height) > gears.throat_radius * (1 + 1e-9):
        raise ValueError(
            f"rollers.height is {rollers.height * 1e3:.4g} mm; it must not be above the throat's radius, "
            f"{gears.throat_radius * 1e3:.4g} mm, at which the rollers' middles pass the worm"
        )
    if worm.dedendum >= gears.towards:
        raise ValueError(
            f"worm.dedendum is {worm.dedendum * 1e3:.4g} mm; along the rollers' axes, of this tilt and "
            f"height, the worm's axis is nearest at {gears.towards * 1e3:.4g} mm from their middles, before "
            "which the thread must end"
        )
    if worm.arrangement == "double" and rollers.height == 0:
        raise ValueError(
            "rollers.height is 0; two rows of rollers need the height of the driving row over the worm's "
            "axis, the other stands as far below"
        )


def check_section(section: WormSection) -> None:
    """Refuse a section whose flank is undercut, not touched or shorter than a contact line (ValueError)."""
    angles = np.linspace(section.first, section.last, CHECKED[0])
    places = np.linspace(section.lowest, section.highest, CHECKED[1])[:, None]
    contact = section.envelope.contact(places, angles)
    missing, gone = ~np.isfinite(contact.theta), ~(contact.limit > 0)
    for bad, what in ((missing, "is not touched"), (gone, "is undercut")):
        if bad.any():
            where = np.abs(contact.wheel_angle[bad])
            place = contact.place[bad][np.argmin(where)]
            fraction = np.mean(bad)
            raise ValueError(
                f"worm: the {section.name} section's flank {what} by {fraction:.0%} of the bearing "
                f"length, from {degrees(where.min()):.1f} to {degrees(where.max()):.1f} deg of wheel "
                f"angle, first at {place * 1e3:.2f} mm from the rollers' middle; give the rollers other "
                "tilt, height, radius or length, or the worm a larger throat or other angles"
            )
    before, after = section.faces
    ends = section.along(np.array([section.lowest, section.highest]), section.last)
    if not after - before > abs(ends[1] - ends[0]):
        raise ValueError(
            f"worm.outer_angle is {degrees(max(abs(section.first), abs(section.last))):.4g} deg; the section "
            "is then shorter than the rollers, a larger angle is needed"
        )
