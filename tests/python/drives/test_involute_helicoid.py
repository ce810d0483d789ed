"""Closed forms of involute helicoids against the surface itself."""

from math import acos, atan2, cos, degrees, pi, radians, sin, sqrt, tan

import numpy as np
import pytest

from pyworm.drives.worm.flanks import involute_helicoid as closed
from pyworm.drives.worm.flanks.helicoid import Helicoid

THREADS, MODULE, FACTOR, ANGLE = 3, 5e-3, 8.5, radians(22.5)
LEAD, RADIUS = pi * MODULE * THREADS, FACTOR * MODULE / 2
LEAD_ANGLE = atan2(THREADS, FACTOR)
BASE_ANGLE = closed.base_lead_angle(LEAD_ANGLE, ANGLE)
BASE = closed.base_radius(LEAD, BASE_ANGLE)


def on_cylinder(radius):
    """Point of the helicoid over polar angle zero at a radius, and its normal, in the screw's own frame."""
    screw = Helicoid(BASE, LEAD, 0.0)
    across = sqrt(radius**2 - BASE**2)
    theta = -atan2(across, BASE)
    along = across / cos(screw.base_lead_angle)
    return screw.point(theta, along), screw.normals(theta)[0]


def test_the_surface_has_the_pressure_angle_of_its_drawing():
    """Its normal leans out of the cylinder's tangent plane by the normal pressure angle."""
    point, normal = on_cylinder(RADIUS)
    assert point[:2] == pytest.approx([RADIUS, 0.0], abs=1e-15)
    assert abs(normal[0]) == pytest.approx(sin(ANGLE), rel=1e-12)
    # and within the tangent plane by the lead angle
    assert abs(normal[1] / normal[2]) == pytest.approx(tan(LEAD_ANGLE), rel=1e-12)


@pytest.mark.parametrize("radius", [RADIUS - MODULE, RADIUS + MODULE])
def test_pressure_angle_of_any_cylinder(radius):
    _, normal = on_cylinder(radius)
    found = closed.normal_pressure_angle(LEAD, BASE, radius)
    assert sin(found) == pytest.approx(abs(normal[0]), rel=1e-12)


def test_the_pressure_angle_is_zero_on_and_within_the_base_cylinder():
    assert closed.normal_pressure_angle(LEAD, BASE, BASE) == pytest.approx(0, abs=1e-7)
    assert closed.normal_pressure_angle(LEAD, BASE, 0.9 * BASE) == 0


@pytest.mark.parametrize("radius", [RADIUS - MODULE, RADIUS + MODULE])
def test_the_axial_profile_is_the_section_of_the_surface(radius):
    advance = on_cylinder(radius)[0][2] - on_cylinder(RADIUS)[0][2]
    found = closed.axial_profile(radius, BASE, LEAD) - closed.axial_profile(RADIUS, BASE, LEAD)
    assert found == pytest.approx(advance, rel=1e-12)


def test_base_pitch_is_that_of_the_tangent_planes():
    """Turning the screw by a pitch moves each tangent plane along its normal by the base pitch."""
    screw = Helicoid(BASE, LEAD, 0.0)
    moved = screw.base_travel * 2 * pi / THREADS
    assert LEAD * cos(BASE_ANGLE) / THREADS == pytest.approx(moved, rel=1e-12)
    # pi m_n cos(alpha_n), as of any rack
    normal = closed.normal_module(MODULE, LEAD_ANGLE)
    assert moved == pytest.approx(pi * normal * cos(ANGLE), rel=1e-12)


def test_lead_angle_of_a_normal_module():
    normal = closed.normal_module(MODULE, LEAD_ANGLE)
    assert closed.lead_angle_of(THREADS, normal, 2 * RADIUS) == pytest.approx(LEAD_ANGLE, rel=1e-12)
    with pytest.raises(ValueError, match="do not wind about"):
        closed.lead_angle_of(THREADS, normal, 0.9 * THREADS * normal)


def test_the_worm_of_sharif_et_al():
    """Table 1 of the paper: base radius 26.23 mm, lead 86.18 mm, base lead angle 27.61 deg."""
    assert closed.base_radius(86.18e-3, radians(27.61)) == pytest.approx(26.23e-3, rel=3e-4)
    reference = 48.01e-3 - 86.18e-3 / 3 / pi
    angle = closed.normal_pressure_angle(86.18e-3, 26.23e-3, reference)
    lead_angle = atan2(86.18e-3, 2 * pi * reference)
    assert degrees(acos(cos(radians(27.61)) / cos(lead_angle))) == pytest.approx(
        degrees(angle), abs=0.02
    )
    assert np.isfinite(angle)
