"""Flanks with an arc in the axial plane, ZC2."""

from math import atan, cos, pi, radians, tan

import numpy as np
import pytest

from pyworm.drives.worm.flanks.axial_arc import axial_arc
from pyworm.drives.worm.flanks.ruled_helicoid import straight_axial
from pyworm.drives.worm.flanks.screw_generator import apart

LEAD, ANGLE, REFERENCE = 8e-3 * pi, radians(20), 20e-3
LEAD_ANGLE = atan(0.2)
THREAD = LEAD, LEAD_ANGLE, ANGLE
ENDS = 14e-3, 26e-3
RADII = np.linspace(16e-3, 24e-3, 9)


def test_the_axial_section_is_a_concave_arc_of_the_pressure_angle():
    flank = axial_arc(*THREAD, REFERENCE, 24e-3, ENDS)
    height = flank.axial_profile(RADII)
    centre = flank.top, 0.0
    np.testing.assert_allclose(np.hypot(RADII - centre[0], height), 24e-3, rtol=1e-14)
    assert (np.diff(height) > 0).all() and (np.diff(height, 2) < 0).all()
    step = 1e-7
    slope = np.diff(flank.axial_profile(REFERENCE + step * np.array([-1, 1]))) / (2 * step)
    assert slope[0] == pytest.approx(tan(ANGLE) / cos(LEAD_ANGLE), rel=1e-8)
    # the normal pressure angle is that of the unit normal's radial part
    assert abs(flank.normal(REFERENCE, 0.0)[0]) == pytest.approx(np.sin(ANGLE), rel=1e-12)


def test_every_helicoid_s_condition_and_derivatives_hold():
    flank = axial_arc(*THREAD, REFERENCE, 24e-3, ENDS)
    point, normal = flank.point(RADII, 0.3), flank.normal(RADII, 0.3)
    identity = point[0] * normal[1] - point[1] * normal[0] + flank.screw * normal[2]
    assert np.abs(identity).max() < 1e-15
    (_, _, low), _, _ = flank.curve(RADII - 1e-6)
    (_, _, at), (_, _, first), (_, _, second) = flank.curve(RADII)
    (_, _, high), _, _ = flank.curve(RADII + 1e-6)
    np.testing.assert_allclose((high - low) / 2e-6, first, rtol=1e-6)
    np.testing.assert_allclose((high - 2 * at + low) / 1e-12, second, rtol=2e-3)


def test_an_arc_that_does_not_rise_all_the_way_is_refused():
    with pytest.raises(ValueError, match="rises from a radius of 12"):
        axial_arc(*THREAD, REFERENCE, 12e-3, ENDS)


def test_an_arc_of_a_large_radius_is_straight_as_za():
    line = straight_axial(*THREAD)
    off = [
        apart(axial_arc(*THREAD, REFERENCE, rho, ENDS), line, REFERENCE, (16e-3, 24e-3))
        for rho in (1, 10)
    ]
    assert off[0] < 1e-5 and off[0] / off[1] == pytest.approx(10, rel=0.01)
