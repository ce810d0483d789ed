"""The contact pattern without load and under it, as a marking compound shows it, and its shim."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest
from zi_drives import HOB, changed, coarse_patterns, conjugate, sharif

from pyworm.drives.worm.dataset import pattern_data
from pyworm.drives.worm.drawing.design import Assembly
from pyworm.drives.worm.loads.tooth_compliance import PlacedGap
from pyworm.drives.worm.patterns import loaded_pattern as loaded
from pyworm.drives.worm.patterns.contact_pattern import both_flanks, contact_pattern
from pyworm.drives.worm.patterns.loaded_pattern import deflection, loaded_pattern
from pyworm.drives.worm.patterns.shim import found_shim
from pyworm.drives.worm.teeth.gap import surface_points
from pyworm.formulas.hertz import hertz
from pyworm.materials.body import reduced_modulus
from pyworm.plots.drives.worm_pattern import draw_pattern
from pyworm.result.result import Result


@pytest.fixture(scope="module")
def drive():
    return sharif()


@pytest.fixture(scope="module")
def pattern(drive):
    return drive.driven_pattern


def middle(pattern):
    """Middle of the marked part along the face."""
    return float(pattern.face[pattern.marked()].mean())


def test_a_wheel_that_its_worm_cuts_is_marked_all_over():
    """Its ease-off is zero but for the steps of the phases."""
    separation = conjugate().patterns[0].separation
    known = np.isfinite(separation)
    assert known.mean() > 0.8
    assert np.mean(separation[known] < 0.5e-6) > 0.85


def test_a_contact_alone_has_no_patterns_of_whole_flanks(drive):
    around = drive.cycle_around_contact()
    assert "varied_load" in around.attrs
    assert "marking_separation" not in around


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


def test_places_on_the_thread_are_where_the_wheel_touches_it(drive):
    """By the wheel's flank and the worm's axis, 304.8 mm off and along z."""
    x, y = np.meshgrid(np.linspace(-4e-3, 4e-3, 5), np.linspace(-0.4e-3, 0.4e-3, 3))
    for phase in (0.2, 0.8):
        contact = drive.contact(phase)
        on_wheel = surface_points(contact, x, y, contact.wheel_height.solve(x, y)[0])
        axial, radius = drive.thread_place(contact, x, y)
        assert np.ptp(axial) > 0.5e-3 and np.ptp(radius) > 0.5e-3
        assert axial == pytest.approx(on_wheel[2], abs=20e-6)
        assert radius == pytest.approx(np.hypot(on_wheel[0] + 0.3048, on_wheel[1]), abs=20e-6)


def test_errors_of_the_assembly_move_the_pattern_as_they_move_the_contact(drive, pattern):
    tilted = replace(drive, assembly=Assembly(shaft_angle=radians(-0.05)))
    moved = tilted.contact(0.5).point[1] - drive.contact(0.5).point[1]
    shifted = middle(tilted.driven_pattern) - middle(pattern)
    assert moved > 2e-3 and shifted == pytest.approx(moved, rel=0.6)


def test_the_other_flank_is_the_mirror_image_but_for_shifts(coarse):
    centred = sharif(hob=changed(HOB, axial_shift=0.0))
    own, other = centred.patterns
    np.testing.assert_array_equal(own.separation, other.separation[:, ::-1])
    np.testing.assert_array_equal(own.face, -other.face[:, ::-1])
    # a worm too far to the leaving side of one flank is too far to the entering side of the other
    shifted = both_flanks(replace(centred, assembly=Assembly(axial_shift=0.1e-3)), contact_pattern)
    moves = [
        middle(after) - middle(before) for after, before in zip(shifted, (own, other), strict=True)
    ]
    assert moves[0] > 1e-3 and moves[1] > 1e-3


def test_the_picture_names_the_sides_of_the_flank(pattern):
    cycle = pattern_data((pattern, pattern), (pattern, pattern))
    cycle.attrs |= {"driver": "worm", "drive": "worm"}
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


def test_the_deflection_in_and_beyond_a_window_is_that_of_hertz():
    """Johnson, Contact Mechanics, equations 3.41a and 3.42a; with E' = 2 E*."""
    radius, peak, modulus = 1e-3, 1e9, 2e11
    x = np.linspace(-1.5e-3, 1.5e-3, 97)
    off = np.hypot(*np.meshgrid(x, x, indexing="ij"))
    pressure = peak * np.sqrt(np.maximum(1 - (off / radius) ** 2, 0))
    placed = PlacedGap(x, x, np.zeros(off.shape), np.ones(off.shape, bool))
    r = np.array([0.3e-3, 0.8e-3, 1.2e-3, 1.8e-3, 4e-3])
    found = deflection(placed, pressure, modulus, 0.6 * r, 0.8 * r)
    a_r = np.minimum(radius / r, 1.0)
    beyond = (2 * radius**2 - r**2) * np.arcsin(a_r) + r**2 * a_r * np.sqrt(1 - a_r**2)
    expected = peak / (modulus * radius) * beyond
    np.testing.assert_allclose(found, expected, rtol=0.01)


@pytest.fixture
def coarse(monkeypatch):
    """Fewer places and phases."""
    coarse_patterns(monkeypatch)


def test_a_load_widens_the_pattern_by_what_the_flanks_yield(coarse, monkeypatch):
    monkeypatch.setattr(loaded, "PHASES", np.linspace(0, 1, 15))
    bare = sharif().driven_pattern
    light, heavy = (
        loaded_pattern(of, of.flank_grid)
        for of in (sharif(tooth_load=1.0), sharif(tooth_load=14e3))
    )
    assert bare.fraction() < heavy.fraction() < bare.fraction(50e-6)
    # hardly loaded it is the pattern without load, but for the pitch error that sets a pair back there
    near = bare.separation < 30e-6
    near[[0, 1, -2, -1]] = False  # reached beyond the mesh cycle, where a given load is not borne
    np.testing.assert_allclose(light.separation[near], bare.separation[near], atol=6e-6)
    reached = np.isfinite(light.separation) & (light.separation < 1e-3)
    approach = light.separation[reached] - heavy.separation[reached]
    assert np.all(approach > -1e-7)
    # far from the contact the flanks come nearer by what they yield there, some 20 um under 14 kN
    far = light.separation[reached] > 60e-6
    assert 5e-6 < approach[far].min() and approach[far].max() < 40e-6
    # beside it they yield, too: what is nearer than they approach does not all touch
    of = sharif()
    dry = hertz(*of.contact(0.5).radii, of.tooth_load, reduced_modulus(*of.bodies))
    beside = (light.separation > 0.75 * dry.approach) & (light.separation < dry.approach)
    assert np.mean(heavy.separation[beside] > 0.5e-6) > 0.7


def test_a_shim_takes_a_shift_of_the_worm_back(drive, coarse):
    shifted = sharif(assembly=Assembly(axial_shift=0.1e-3))
    shim = found_shim(shifted, shifted.patterns)
    assert shim.reached and shim.before > shim.wanted + 1e-3
    assert shim.shift == pytest.approx(0.1e-3, abs=0.01e-3)
    assert shim.other_before - shim.other_after > 1e-3


def test_a_loaded_contact_beside_all_teeth_closes_no_gap(monkeypatch):
    """No tooth is where the dry contact is sought: its flanks do not approach, the pattern stays empty."""
    monkeypatch.setattr(loaded, "PHASES", np.linspace(0.2, 0.8, 3))
    monkeypatch.setattr(loaded, "placed_gap", lambda *given: None)
    drive = sharif(tooth_load=14e3)
    assert np.isnan(loaded_pattern(drive, drive.flank_grid).separation).all()
