"""Flanks that a disc grinds, ZK and ZC."""

from math import acos, asin, atan, cos, inf, pi, radians, sin, tan

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

from pyworm.drives.worm.flanks.disc_helicoid import Disc, DiscHelicoid
from pyworm.drives.worm.flanks.ruled_helicoid import involute
from pyworm.drives.worm.flanks.screw_generator import apart

ANGLE, MODULE, THREADS, FACTOR = radians(20), 4e-3, 3, 9.0
REFERENCE = FACTOR * MODULE / 2
RADII = REFERENCE - 1.2 * MODULE, REFERENCE + MODULE


def ground(radius=0.2, arc=inf, threads=THREADS, factor=FACTOR):
    """The flank that a disc of a radius at the reference cylinder and of an arc grinds."""
    lead_angle, reference = atan(threads / factor), factor * MODULE / 2
    disc = Disc(radius, pi / 2 * MODULE * cos(lead_angle), ANGLE, arc)
    low, high = reference - 1.4 * MODULE, reference + 1.2 * MODULE
    return DiscHelicoid(disc, reference, MODULE * threads / 2, low, high)


@pytest.mark.parametrize("arc", [inf, 6 * MODULE])
def test_the_disc_touches_where_a_screw_moves_it_along_itself(arc):
    """x n_y - y n_x + p n_z = 0 on the disc, whose normal is that of the flank that is swept."""
    flank = ground(arc=arc)
    way = np.linspace(-4e-3, 4e-3, 9)
    (x, y, z), on_disc = flank.ground(way)
    assert np.abs(x * on_disc[1] - y * on_disc[0] + flank.screw * on_disc[2]).max() < 1e-12
    radius, polar = np.hypot(x, y), np.arctan2(y, x)
    parameter = flank.at_radius(radius)
    swept = flank.point(parameter, polar)
    turned = (
        z - swept[2]
    ) / flank.screw  # a point of the flank is moved into that of the disc by a screw
    assert np.abs(turned).max() < 1e-12
    assert flank.normal(parameter, polar) == pytest.approx(np.stack(on_disc), abs=1e-9)


@pytest.mark.parametrize("arc", [inf, 6 * MODULE])
def test_the_flank_is_what_the_disc_leaves(arc):
    """At a radius of the worm the disc's points, screwed into one axial plane, reach up to the flank."""
    flank = ground(arc=arc)
    lead_angle = atan(THREADS / FACTOR)
    centre = np.array([REFERENCE + flank.disc.radius, 0.0, 0.0])
    along, axis = (
        np.array([0.0, cos(lead_angle), sin(lead_angle)]),
        np.array([0.0, -sin(lead_angle), cos(lead_angle)]),
    )

    def profile(out):
        """Half the width of the disc at a radius beyond the reference one, by the circle's own equation."""
        if arc == inf:
            return flank.disc.width / 2 - out * tan(ANGLE)
        high = -arc * cos(ANGLE) + np.sqrt(arc**2 - (out + arc * sin(ANGLE)) ** 2)
        return flank.disc.width / 2 + high

    def point(out, turn):
        way = -np.cos(turn) * np.array([1.0, 0.0, 0.0]) + np.sin(turn) * along
        return centre + (flank.disc.radius + out) * way + profile(out) * axis

    for radius in (RADII[0], REFERENCE, RADII[1]):

        def height(turn, radius=radius):
            out = brentq(lambda at: np.hypot(*point(at, turn)[:2]) - radius, -8e-3, 8e-3)
            x, y, z = point(out, turn)
            return z - flank.screw * np.arctan2(y, x)

        highest = minimize_scalar(
            lambda turn: -height(turn), bounds=(-0.08, 0.08), options={"xatol": 1e-9}
        )
        assert height(highest.x) == pytest.approx(float(flank.axial_profile(radius)), abs=1e-10)


def test_a_large_cone_grinds_an_involute_helicoid():
    """In the limit a plane moves in a screw, whose envelope that is; what is left falls with the radius."""
    lead = pi * MODULE * THREADS
    plane = involute(lead, atan(THREADS / FACTOR), ANGLE)
    off = [apart(ground(radius), plane, REFERENCE, RADII) for radius in (1.0, 10.0, 100.0, 1e5)]
    assert np.array(off[:3]) * [1, 10, 100] == pytest.approx(off[2] * 100, rel=0.05)
    assert off[3] < 1e-9


def test_a_cone_agrees_with_the_involute_as_the_lead_angle_falls():
    """With its square."""

    def off(factor):
        plane = involute(pi * MODULE, atan(1 / factor), ANGLE)
        reference = factor * MODULE / 2
        radii = reference - 1.2 * MODULE, reference + MODULE
        return apart(ground(0.2, threads=1, factor=factor), plane, reference, radii)

    fall = np.log(off(20.0) / off(80.0)) / np.log(4)
    assert 1.7 < fall < 3.5
    assert off(80.0) < 1e-6 < off(6.0)


def test_an_arc_makes_the_thread_hollow():
    """Of a small lead angle its axial profile bends as the arc does, away from the thread at larger z."""
    flank = ground(arc=6 * MODULE, threads=1, factor=60.0)
    _, (_, _, slope), (_, _, bend) = flank.curve(np.array(30 * MODULE))
    assert bend / (1 + slope**2) ** 1.5 == pytest.approx(-1 / (6 * MODULE), rel=0.01)
    assert abs(ground(threads=1, factor=60.0).curve(np.array(30 * MODULE))[2][2]) < 0.05


def test_a_disc_too_hollow_for_its_thread_is_refused():
    with pytest.raises(ValueError, match=r"a disc of 400 mm leaves no flank from 36 to 45\.6 mm"):
        ground(arc=MODULE)


def test_a_flank_begins_at_its_edge_of_regression():
    """In the limit of a plane that is the base cylinder of the involute, which is known in closed form.

    Its slope changes from there as (r - r_0)^(1/2); a smaller disc leaves more of the flank.
    """
    threads = 5
    lead_angle = atan(threads / FACTOR)
    base_angle = acos(cos(lead_angle) * cos(ANGLE))
    base_radius = MODULE * threads / 2 / tan(base_angle)
    flanks = [ground(radius, threads=threads) for radius in (0.1, 0.25, 1.0, 1e5)]
    edges = np.array([flank.edge for flank in flanks])
    assert np.all(np.diff(edges) > 0) and edges[-1] == pytest.approx(base_radius, rel=1e-6)
    plane = involute(pi * MODULE * threads, lead_angle, ANGLE)
    radii = base_radius + 1e-5, REFERENCE + MODULE
    assert apart(flanks[-1], plane, REFERENCE, radii) < 1e-9
    for flank in flanks:
        assert flank.undercut and flank.edge > flank.inner_radius
        _, (by_u, _, rise), _ = flank.curve(
            flank.at_radius(flank.edge + 1e-5 * np.array([1, 4, 16]))
        )
        assert np.divide(*np.diff(rise / by_u)[::-1]) == pytest.approx(2, rel=0.1)


def test_an_edge_below_the_root_takes_nothing_of_the_flank():
    """Radii are searched to below the root, where the edge may lie."""
    flank = ground(0.25, threads=4, factor=9.34)
    assert flank.inner_radius < flank.start_radius < (9.34 / 2 - 1.2) * MODULE


@pytest.mark.parametrize("oversize", np.linspace(0.0, 0.25, 6))
def test_the_profile_is_followed_along_one_branch(oversize):
    """A hollow disc's envelope turns beyond the tip; the pressure angle falls outwards all the way."""
    reference = 61e-3 * (1 + oversize)
    lead_angle = asin(5 * 11.6e-3 * cos(radians(25.5)) / 2 / reference)
    disc = Disc(0.25, 16.5e-3, radians(23), 70e-3)
    screw = reference * tan(lead_angle)
    flank = DiscHelicoid(disc, reference, screw, reference - 17.5e-3, reference + 18.6e-3)
    angles = [flank.pressure_angle(at) for at in np.linspace(*flank.bounds, 25)]
    assert np.all(np.diff(angles) < 0)
