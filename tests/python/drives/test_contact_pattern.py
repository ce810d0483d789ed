"""The contact pattern without load, as a marking compound shows it."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest
from zi_drives import HOB, changed, conjugate, sharif

from pyworm.drives.zi_worm.contact_pattern import both_patterns, contact_pattern
from pyworm.drives.zi_worm.dataset import pattern_data
from pyworm.drives.zi_worm.design import Assembly
from pyworm.plots.drives.zi_worm_pattern import draw_pattern
from pyworm.result.result import Result


@pytest.fixture(scope="module")
def drive():
    return sharif()


@pytest.fixture(scope="module")
def pattern(drive):
    return contact_pattern(drive)


def middle(pattern):
    """Middle of the marked part along the face."""
    return float(pattern.face[pattern.marked()].mean())


def test_a_wheel_that_its_worm_cuts_is_marked_all_over():
    """Its ease-off is zero but for the steps of the phases."""
    separation = conjugate().patterns[0].separation
    known = np.isfinite(separation)
    assert known.mean() > 0.8
    assert np.mean(separation[known] < 0.5e-6) > 0.85


def test_the_path_of_contact_is_marked_and_the_ends_of_the_face_are_not(drive, pattern):
    for phase in (0.1, 0.5, 0.9):
        contact = drive.contact(phase)
        face, radius = contact.point[1], np.hypot(*contact.point[[0, 2]])
        off = np.hypot(pattern.face - face, pattern.radius - radius)
        assert pattern.separation[np.unravel_index(np.argmin(off), off.shape)] < 4e-6
    first, last = pattern.along_face()
    assert -25e-3 < first < last < 28e-3
    assert np.nanmin(pattern.separation[:, [0, -1]]) > 15e-6
    assert pattern.fraction(2e-6) < pattern.fraction() < pattern.fraction(30e-6) < 1


def test_the_separation_is_that_of_a_place_followed_by_hand(drive, pattern):
    """The wheel's own surface over the tangent plane of each instant, another way to the same place."""
    row, column = 8, 12
    face, radius = pattern.face[row, column], pattern.radius[row, column]
    least = np.inf
    for phase in np.linspace(-0.1, 1.1, 49):
        contact = drive.cycle.contact(phase)
        x, y = np.meshgrid(np.linspace(-0.03, 0.03, 121), np.linspace(-0.012, 0.012, 61))
        gap, covered = drive.gap(contact)(x, y)
        there = drive.flank_place(contact, x, y)
        off = np.hypot(there[0] - face, there[1] - radius)
        nearest = np.unravel_index(np.argmin(np.where(covered, off, np.inf)), off.shape)
        if off[nearest] < 0.5e-3:
            least = min(least, gap[nearest])
    assert pattern.separation[row, column] == pytest.approx(least, rel=0.1)


def test_errors_of_the_assembly_move_the_pattern_as_they_move_the_contact(drive, pattern):
    tilted = replace(drive, assembly=Assembly(shaft_angle=radians(-0.05)))
    moved = tilted.contact(0.5).point[1] - drive.contact(0.5).point[1]
    shifted = middle(contact_pattern(tilted)) - middle(pattern)
    assert moved > 2e-3 and shifted == pytest.approx(moved, rel=0.6)


def test_the_other_flank_is_the_mirror_image_but_for_shifts():
    centred = sharif(hob=changed(HOB, axial_shift=0.0))
    own, other = centred.patterns
    np.testing.assert_array_equal(own.separation, other.separation[:, ::-1])
    np.testing.assert_array_equal(own.face, -other.face[:, ::-1])
    # a worm too far to the leaving side of one flank is too far to the entering side of the other
    shifted = both_patterns(replace(centred, assembly=Assembly(axial_shift=0.1e-3)))
    moves = [
        middle(after) - middle(before) for after, before in zip(shifted, (own, other), strict=True)
    ]
    assert moves[0] > 1e-3 and moves[1] > 1e-3


def test_the_picture_names_the_sides_of_the_flank(pattern):
    cycle = pattern_data((pattern, pattern))
    cycle.attrs |= {"driver": "worm", "drive": "zi-worm"}
    figure = draw_pattern(Result("drive", {}, (), cycle, {}))
    said = [[text.get_text() for text in axes.texts] for axes in figure.axes]
    for words in said:
        assert {"tip", "root", "leaving side", "entering side"} <= set(words)
    places = [
        {text.get_text(): text.get_position()[0] for text in axes.texts}["leaving side"]
        for axes in figure.axes
    ]
    assert places[0] > 0.9 and places[1] < 0.1
    assert "marked" in figure.axes[0].get_title()
    assert draw_pattern(Result("drive", {}, (), cycle.drop_vars("marking_separation"), {})) is None
