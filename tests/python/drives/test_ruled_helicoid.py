"""Flanks of ZA, ZN and ZI worms as one family."""

from math import atan, cos, pi, radians, sin, tan

import numpy as np
import pytest

from pyworm.drives.worm.flanks.helicoid import Helicoid
from pyworm.drives.worm.flanks.ruled_helicoid import (
    blade_angle,
    involute,
    straight_axial,
    straight_normal,
)
from pyworm.drives.worm.flanks.screw_generator import apart

ANGLE, MODULE, THREADS, FACTOR = radians(20), 4e-3, 3, 9.0
LEAD, LEAD_ANGLE, REFERENCE = pi * MODULE * THREADS, atan(THREADS / FACTOR), FACTOR * MODULE / 2
NORMAL_MODULE = MODULE * cos(LEAD_ANGLE)
SPACE = REFERENCE - pi * NORMAL_MODULE / 4 / tan(ANGLE)
FLANKS = {
    "ZA": straight_axial(LEAD, LEAD_ANGLE, ANGLE),
    "ZN": straight_normal(LEAD, LEAD_ANGLE, ANGLE, SPACE),
    "ZI": involute(LEAD, LEAD_ANGLE, ANGLE),
}
TURN, ACROSS = np.meshgrid(np.linspace(-2, 3, 7), np.linspace(12e-3, 24e-3, 9))


@pytest.mark.parametrize("name", FLANKS)
def test_a_screw_carries_the_flank_into_itself(name):
    """x n_y - y n_x + p n_z = 0 of every helicoid."""
    flank = FLANKS[name]
    (x, y, _), (nx, ny, nz) = flank.point(ACROSS, TURN), flank.normal(ACROSS, TURN)
    assert np.abs(x * ny - y * nx + flank.screw * nz).max() < 1e-12


@pytest.mark.parametrize("name", FLANKS)
def test_normals_are_across_both_directions_of_the_surface(name):
    flank, step = FLANKS[name], 1e-6
    normal = flank.normal(ACROSS, TURN)
    for ahead, behind in (
        (flank.point(ACROSS, TURN + step), flank.point(ACROSS, TURN - step)),
        (flank.point(ACROSS + step, TURN), flank.point(ACROSS - step, TURN)),
    ):
        along = (ahead - behind) / np.linalg.norm(ahead - behind, axis=0)
        assert np.abs(np.sum(along * normal, axis=0)).max() < 1e-8


def test_the_involute_one_is_the_closed_form_to_a_nanometre():
    """The developable of the base helix: its points, found by turn and distance, lie on the other surface."""
    flank = FLANKS["ZI"]
    closed = Helicoid(flank.offset, LEAD, 0.0)
    point = flank.point(ACROSS, TURN)
    other = closed.point(TURN, ACROSS / cos(closed.base_lead_angle))
    assert np.abs(point - other).max() < 1e-9


@pytest.mark.parametrize("name", FLANKS)
def test_the_axial_profile_is_the_section_of_the_surface(name):
    flank = FLANKS[name]
    radius = np.linspace(14e-3, 22e-3, 9)
    across = np.sqrt(radius**2 - flank.offset**2)
    turn = -np.arctan2(across, flank.offset)
    point = flank.point(across, turn)
    assert point[0] == pytest.approx(radius, rel=1e-12)
    assert np.abs(point[1]).max() < 1e-15
    assert point[2] == pytest.approx(flank.axial_profile(radius), rel=1e-12)


def test_the_line_of_a_normal_profile_lies_in_the_plane_normal_to_the_thread():
    """The plane holds the radius through the middle of the space, and is across the reference helix there."""
    flank = FLANKS["ZN"]
    apex = np.array([SPACE, 0.0, 0.0])
    thread = np.array([0.0, cos(LEAD_ANGLE), sin(LEAD_ANGLE)])
    across = np.sqrt(SPACE**2 - flank.offset**2)
    turn = -np.arctan2(across, flank.offset)
    line = flank.point(np.linspace(0, 30e-3, 5), np.full(5, turn))
    line[2] -= flank.point(across, turn)[2]  # the apex at height zero
    off = thread @ (line - apex[:, None])
    assert np.abs(off).max() < 1e-15
    # and makes the pressure angle with that radius
    direction = line[:, -1] - line[:, 0]
    assert abs(direction[0]) / np.linalg.norm(direction) == pytest.approx(cos(ANGLE), rel=1e-12)


def test_an_axial_profile_is_straight():
    radius = np.linspace(14e-3, 22e-3, 9)
    height = FLANKS["ZA"].axial_profile(radius)
    assert np.abs(np.diff(height, 2)).max() < 1e-15


@pytest.mark.parametrize("name", ["ZA", "ZN"])
def test_the_forms_agree_as_the_lead_angle_falls(name):
    """With its square."""

    def off(factor):
        lead, angle, reference = pi * MODULE, atan(1 / factor), factor * MODULE / 2
        normal = MODULE * cos(angle)
        other = {
            "ZA": straight_axial(lead, angle, ANGLE),
            "ZN": straight_normal(lead, angle, ANGLE, reference - pi * normal / 4 / tan(ANGLE)),
        }[name]
        radii = reference - 1.2 * MODULE, reference + MODULE
        return apart(involute(lead, angle, ANGLE), other, reference, radii)

    fall = np.log(off(20.0) / off(80.0)) / np.log(4)
    assert 1.7 < fall < 3.5
    assert off(80.0) < 1e-6 < off(8.0)


def test_a_blade_angle_is_that_of_the_line_in_the_plane_normal_to_the_thread():
    """The line from the apex to a point of it, by its parts along the radius and across the thread."""
    for angle, lead_angle in ((ANGLE, LEAD_ANGLE), (radians(14.5), radians(35))):
        apex = 0.8 * REFERENCE
        flank = straight_normal(LEAD, lead_angle, angle, apex)
        line = np.array([0.0, 1.0, flank.slope])
        nearest = np.array([flank.offset, 0.0, 0.0])
        # the blade lies in the plane through a radius; the line meets that radius at the apex
        meets = nearest + line * np.sqrt(apex**2 - flank.offset**2)
        radial = meets * [1, 1, 0] / apex
        around = np.cross([0.0, 0.0, 1.0], radial)
        across = -sin(lead_angle) * around + cos(lead_angle) * np.array([0.0, 0.0, 1.0])
        along = cos(lead_angle) * around + sin(lead_angle) * np.array([0.0, 0.0, 1.0])
        assert abs(line @ along) < 1e-12
        assert abs(line @ across) / (line @ radial) == pytest.approx(tan(angle), rel=1e-12)
        assert blade_angle(flank, lead_angle) == pytest.approx(angle, rel=1e-12)
