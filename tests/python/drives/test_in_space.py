"""Drives of line contacts in space: what is drawn touches where the contact is and does not overlap."""

from math import cos, sin

import numpy as np
import pytest
from folders import CASES
from matplotlib.path import Path as Outline
from scipy.interpolate import CubicSpline

import pyworm
from pyworm.scene.index import ContactIndex

PHASES = (0.02, 0.3, 0.62, 0.98)


def turned(points, shape, angle):
    """Points turned right-handed about the axis of a shape (Rodrigues)."""
    arm = points - shape.axis_point
    along = (arm @ shape.axis)[..., None] * shape.axis
    across = np.cross(np.broadcast_to(shape.axis, arm.shape), arm)
    return shape.axis_point + along + cos(angle) * (arm - along) + sin(angle) * across


def distance(point, corners):
    """Least distance of a point from the line through corners (n, 2)."""
    start, step = corners[:-1], np.diff(corners, axis=0)
    length = np.maximum((step**2).sum(axis=1), 1e-30)
    part = np.clip(((point - start) * step).sum(axis=1) / length, 0, 1)
    return np.linalg.norm(start + part[:, None] * step - point, axis=1).min()


@pytest.mark.parametrize(
    ("name", "index"),
    [
        ("zi_drive", ContactIndex(phase=0.5)),
        ("spur_pair", ContactIndex(phase=0.5)),
        ("roller_ref", ContactIndex(section="left", phase=0.5)),
    ],
)
def test_a_view_does_not_mirror(name, index):
    view = pyworm.load(CASES / f"{name}.toml").drive.in_space([index]).view
    assert np.linalg.det(view) == pytest.approx(1.0)


@pytest.mark.parametrize("name", ["spur_pair", "errichello_optimised_addenda"])
def test_gears_touch_on_their_line_of_contact_and_nowhere_overlap(name):
    drive = pyworm.load(CASES / f"{name}.toml").drive
    teeth = drive.teeth
    found = drive.in_space([ContactIndex(phase=of) for of in PHASES])
    module = teeth.system.module
    for number in range(len(PHASES)):
        line = found.lines[number]
        assert len(line) > 20
        for row in range(
            2, found.shapes[0].surface.shape[0] - 3
        ):  # sections, without the faces of the gears and the bore
            pinion, gear = (
                [turned(of.surface[row], of, of.turns[number] + copy) for copy in (0, *of.copies)]
                for of in found.shapes
            )
            z = pinion[0][0, 2]
            at = line[np.argmin(np.abs(line[:, 2] - z))]
            if abs(at[2] - z) < 1e-9:  # else this section of helical teeth is out of contact
                # the flanks are drawn by chords, which lie off them by less than this
                assert distance(at[:2], pinion[0][:, :2]) < 0.006 * module
                assert distance(at[:2], gear[0][:, :2]) < 0.006 * module
            # points of one gear's outline lie outside those of the other, but for the chords
            for mine, others in ((pinion, gear), (gear, pinion)):
                points = np.concatenate([of[1:-1, :2] for of in mine])
                for outline in others:
                    inside = Outline(outline[:, :2]).contains_points(points)
                    assert all(
                        distance(of, outline[:, :2]) < 0.006 * module for of in points[inside]
                    )


def angles_on(shape, radius):
    """Polar angles of both flanks of a gear's tooth on a circle [rad]."""
    outline = shape.surface[4, :, :2] - shape.axis_point[:2]
    for half in np.split(outline, 2):
        polar = np.hypot(*half.T)
        rising = np.argsort(polar)[2:]  # two points are of the root
        yield CubicSpline(polar[rising], np.arctan2(half[rising, 1], half[rising, 0]))(radius)


def test_teeth_are_as_thick_as_the_design_says():
    drive = pyworm.load(CASES / "spur_pair.toml").drive
    for shape, size in zip(
        drive.in_space([ContactIndex(phase=0.5)]).shapes, drive.teeth.cylinders, strict=True
    ):
        loaded, other = angles_on(shape, size.pitch)
        thickness = (other - loaded) % (2 * np.pi) * size.pitch
        assert thickness == pytest.approx(size.pitch_thickness, rel=2e-4)


@pytest.mark.parametrize("phase", [0.1, 0.5, 0.9])
@pytest.mark.parametrize("section", ["left", "right"])
def test_worm_and_roller_touch_on_the_line_of_contact(section, phase):
    drive = pyworm.load(CASES / "roller_ref.toml").drive
    found = drive.in_space([ContactIndex(section=section, phase=phase)])
    *flanks, rollers = found.shapes
    (line,) = found.lines
    envelope = drive.sections[section].envelope
    roller = turned(rollers.surface, rollers, rollers.turns[0])
    # axis and radius of the roller that is drawn
    below, above = roller[0].mean(axis=0), roller[-1].mean(axis=0)
    axis = (above - below) / np.linalg.norm(above - below)
    arm = line - below
    off = np.linalg.norm(arm - (arm @ axis)[:, None] * axis, axis=1)
    assert off == pytest.approx(drive.rollers.profile.radius, rel=1e-9)
    rim = roller[1] - below
    assert np.linalg.norm(rim, axis=1) == pytest.approx(drive.rollers.profile.radius, rel=1e-9)
    # the flank of this section, turned, passes through the line; it is drawn by chords of 12 degrees
    flank = flanks[list(drive.sections).index(section)]
    there = turned(flank.surface, flank, flank.turns[0])
    for row, at in ((0, line[0]), (-1, line[-1])):
        radius = np.hypot(at[1] - envelope.worm_centre[1], at[2])
        start, step = there[row][:-1], np.diff(there[row], axis=0)
        part = np.clip(((at - start) * step).sum(axis=1) / (step**2).sum(axis=1), 0, 1)
        off = np.linalg.norm(start + part[:, None] * step - at, axis=1).min()
        assert off < 1.1 * radius * (1 - cos(np.radians(6)))
