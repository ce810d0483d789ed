"""Flanks in space, for pictures, are those that touch."""

import numpy as np
import pytest
from folders import CASES
from worm_drawings import SWIVELLED

import pyworm
from pyworm.drives.worm.drawing.usual_values import completed
from pyworm.drives.worm.flanks.wheel_envelope import turned
from pyworm.drives.worm.patterns.hob_setting import drawn_gears
from pyworm.drives.worm.shapes import in_space

PHASES = (0.2, 0.5, 0.8)


@pytest.fixture(scope="module", params=["ZI", "ZK"])
def gears(request):
    """Involute flanks, which have closed forms, and ground ones, which are points."""
    if request.param == "ZI":
        return pyworm.load(CASES / "zi_drive.toml").drive
    return drawn_gears(completed(SWIVELLED, request.param)[0])


def about(axis, angle, points):
    """Points (..., 3) turned right-handed about an axis, by Rodrigues' formula."""
    along = (points @ axis)[..., None] * axis
    return along + np.cos(angle) * (points - along) + np.sin(angle) * np.cross(axis, points)


def test_contact_points_lie_on_thread_and_flank(gears):
    """Every contact point, turned back, lies between points of both: nearer than these are to each other."""
    for shape, of in zip(in_space(gears, PHASES).shapes, ("thread", "flank"), strict=True):
        points = shape.surface.reshape(-1, 3)
        points = points[np.isfinite(points).all(axis=1)] - shape.axis_point
        angles = (0.0, *shape.copies) if of == "thread" else (0.0,)
        for turn, phase in zip(shape.turns, PHASES, strict=True):
            contact = gears.cycle.contact(phase)
            aim = contact.point - shape.axis_point
            misses = [
                np.linalg.norm(about(shape.axis, turn + copy, points) - aim, axis=1).min()
                for copy in angles
            ]
            assert min(misses) < 3e-3


def test_the_thread_is_the_helicoid_of_every_contact(gears):
    """The section's height at a contact's radius, swept to its angle, is where it lies along the axis."""
    flank, (thread, _) = gears.worm_flank, in_space(gears, PHASES).shapes
    own = np.tensordot(thread.surface - thread.axis_point, flank.axes, 1)
    radius, angle = np.hypot(own[..., 0], own[..., 1]), np.arctan2(own[..., 1], own[..., 0])
    offset = own[..., 2] - flank.screw * angle
    lead = 2 * np.pi * flank.screw
    section = [flank.axial_profile(float(of)) for of in radius[:, 0]]
    anchored = np.mod(offset - np.array(section)[:, None], lead)
    spread = np.abs(np.angle(np.exp(2j * np.pi * (anchored - anchored[0, 0]) / lead)))
    assert spread.max() < 1e-9
    for phase in PHASES:
        contact = gears.cycle.contact(phase)
        at = flank.axes.T @ (contact.point - flank.axis_point)
        met = float(np.hypot(at[0], at[1]))
        height = at[2] - flank.screw * (np.arctan2(at[1], at[0]) - contact.worm_angle)
        off = (height - flank.axial_profile(met) - anchored[0, 0]) / lead * gears.worm.threads
        assert abs(off - round(off)) * lead / gears.worm.threads < 1e-9


def test_the_wheel_turns_with_its_angle(gears):
    _, wheel = in_space(gears, PHASES).shapes
    points = wheel.surface[7, 20]
    for turn, phase in zip(wheel.turns, PHASES, strict=True):
        expected = turned(points, -gears.cycle.contact(phase).wheel_angle)
        assert about(wheel.axis, turn, points) == pytest.approx(expected, abs=1e-12)
