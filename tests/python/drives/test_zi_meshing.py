"""The wheel flank is the hob's envelope, and the tooth contact meshes."""

import numpy as np
import pytest
from zi_drives import DEGREE, HOB, MM, changed, conjugate, sharif

from pyworm.drives.worm.drawing.design import Assembly
from pyworm.drives.worm.flanks.helicoid import Helicoid
from pyworm.drives.worm.sensitivity import sensitivity_data
from pyworm.report.console.drives.worm import sensitivity_table


def test_helicoid_is_the_involute_of_its_base_cylinder():
    worm = Helicoid(26.23 * MM, 86.18 * MM, 0.3)
    theta, along, angle = np.array(-0.7), np.linspace(0.005, 0.05, 7), 0.4
    x, y, z = worm.point(theta, along, angle) - worm.axis_point[:, None]
    radius, polar = np.hypot(x, y), np.arctan2(y, x)
    pressure = np.arccos(worm.base_radius / radius)
    involute = np.tan(pressure) - pressure
    np.testing.assert_allclose(z, worm.screw * (polar - angle + involute), rtol=0, atol=1e-16)
    np.testing.assert_allclose(
        worm.radius(worm.point(theta, along, angle)), radius, rtol=1e-14, atol=0
    )


def test_helicoid_normal_is_square_to_the_surface():
    screw = Helicoid(26.48 * MM, 85.97 * MM, 0.3, swivel=0.1, axial_shift=2e-3)
    theta, along, h = 0.3, 0.03, 1e-5
    normal = screw.normals(theta)[0]
    for step in ((h, 0), (0, h)):
        ahead = screw.point(theta + step[0], along + step[1])
        behind = screw.point(theta - step[0], along - step[1])
        assert abs(normal @ (ahead - behind)) / (2 * h) < 1e-11
    assert np.linalg.norm(normal) == pytest.approx(1, abs=1e-15)


def test_wheel_flank_solves_the_meshing_equation_to_rounding():
    flank = sharif().wheel_flank
    theta, roll = np.meshgrid(np.linspace(-1.3, -0.5, 23), np.linspace(-0.05, 0.15, 23))
    point = flank.cut_point(theta, roll)
    normal = flank.hob.normals(theta)[0]
    hob_axis = flank.hob.axes[:, 2]
    hob_velocity = np.cross(hob_axis, np.moveaxis(point, 0, -1) - flank.hob.axis_point)
    wheel_velocity = np.cross([0.0, -flank.ratio, 0.0], np.moveaxis(point, 0, -1))
    slip = np.sum(np.moveaxis(normal, 0, -1) * (hob_velocity - wheel_velocity), axis=-1)
    assert np.max(np.abs(slip)) < 1e-15
    # and the point lies on the hob as it then stands
    own = flank.hob.axes.T @ (point.reshape(3, -1) - flank.hob.axis_point[:, None])
    radius, polar = np.hypot(own[0], own[1]), np.arctan2(own[1], own[0])
    pressure = np.arccos(flank.hob.base_radius / radius)
    angle = (roll / flank.ratio).ravel()
    miss = own[2] - flank.hob.screw * (polar - angle + np.tan(pressure) - pressure)
    assert np.max(np.abs(miss)) < 1e-15


def test_wheel_flank_is_tangent_to_its_normal():
    flank, h = sharif().wheel_flank, 1e-5
    normal = flank.normal(-0.9, 0.04, wheel_angle=0.03)
    for step in ((h, 0), (0, h)):
        ahead = flank.point(-0.9 + step[0], 0.04 + step[1], wheel_angle=0.03)
        behind = flank.point(-0.9 - step[0], 0.04 - step[1], wheel_angle=0.03)
        assert abs(normal @ (ahead - behind)) / (2 * h) < 1e-10


def test_shifting_the_hob_along_its_own_axis_only_turns_the_wheel():
    # a helicoid shifted along its axis by d is the one turned by -d / screw: the angle at which the
    # hob passes differs, the family of surfaces and so its envelope do not
    hob = sharif().wheel_flank.hob
    turn = 0.1
    moved = hob.point(-0.9, 0.03, 0.0) - hob.axes[:, 2] * hob.screw * turn
    np.testing.assert_allclose(moved, hob.point(-0.9, 0.03, turn), rtol=0, atol=1e-16)


def test_contact_lies_on_both_flanks_with_one_normal():
    drive = sharif()
    for contact in drive.mesh_cycle(5):
        line = drive.cycle.path.line
        x, y, z = contact.point - drive.worm_flank.axis_point
        pressure = np.arccos(drive.worm.base_radius / np.hypot(x, y))
        polar = np.arctan2(y, x)
        worm_z = drive.worm_flank.screw * (polar - contact.worm_angle + np.tan(pressure) - pressure)
        assert abs(worm_z - z) < 1e-14
        roll = line.lag + contact.wheel_angle
        on_wheel = drive.wheel_flank.point(line.hob_theta, roll, wheel_angle=contact.wheel_angle)
        np.testing.assert_allclose(on_wheel, contact.point, rtol=0, atol=1e-13)
        wheel_normal = drive.wheel_flank.normal(
            line.hob_theta, roll, wheel_angle=contact.wheel_angle
        )
        np.testing.assert_allclose(wheel_normal, -contact.normal, rtol=0, atol=1e-13)


def test_cycle_begins_and_ends_on_a_tooth_boundary():
    drive = sharif()
    cycle = drive.mesh_cycle()
    assert len(cycle) >= 20
    smallest = []
    for contact in cycle:
        margins = {
            **drive.worm_tooth.margins(contact.point),
            **drive.wheel_tooth.margins(contact.point),
        }
        smallest.append(min(margins.values()))
    assert abs(smallest[0]) < 1e-12 and abs(smallest[-1]) < 1e-12
    assert min(smallest[1:-1]) > 1e-4
    assert drive.cycle.begin_boundary == "wheel throat"
    assert drive.cycle.end_boundary == "worm tip"
    # the worm turns forward through the cycle, by the way of the contact over its base travel
    assert np.all(np.diff([contact.worm_angle for contact in cycle]) > 0)
    way = np.linalg.norm(cycle[-1].point - cycle[0].point)
    screw = 86.18 * MM / (2 * np.pi)
    base_travel = screw * np.cos(np.arctan(screw / (26.23 * MM)))
    assert drive.cycle.worm_rotation == pytest.approx(way / base_travel, rel=1e-9)


def test_transmission_error_of_matching_base_pitches_is_constant():
    errors = [contact.transmission_error for contact in conjugate().mesh_cycle()]
    assert np.ptp(errors) < 1e-12
    # matching pitches are enough: oversize and swivel do not matter
    drive = sharif()
    worm_travel = drive.worm_flank.base_travel
    hob_radius = np.sqrt(1 / (1 / worm_travel**2 - (2 * np.pi / HOB.lead) ** 2))
    matched = sharif(hob=changed(HOB, base_radius=float(hob_radius)))
    errors = [contact.transmission_error for contact in matched.mesh_cycle()]
    assert np.ptp(errors) < 1e-12


def test_transmission_error_follows_the_base_pitch_difference():
    drive = sharif()
    first, last = drive.contact(0), drive.contact(1)
    expected = (drive.worm_flank.base_travel / drive.wheel_flank.hob.base_travel - 1) * drive.ratio
    got = (last.transmission_error - first.transmission_error) / (
        last.worm_angle - first.worm_angle
    )
    assert got == pytest.approx(expected, rel=1e-8)


def test_worm_cut_wheel_touches_along_a_line():
    drive = conjugate()
    contact = drive.contact(0.5)
    assert contact.radii[0] == np.inf
    assert 0 < contact.radii[1] < 1
    theta = drive.cycle.path.line.hob_theta + np.linspace(-0.35, 0.35, 51)
    roll = drive.cycle.path.line.lag + contact.wheel_angle
    line = (
        drive.wheel_flank.point(theta, roll, wheel_angle=contact.wheel_angle)
        - contact.point[:, None]
    )
    x, y = contact.x_axis @ line, contact.y_axis @ line
    assert np.ptp(x) > 0.02
    gap, _ = drive.gap(contact)(x, y)
    assert np.max(np.abs(gap)) < 1e-9
    # the same line on an oversize hob opens
    opened, _ = sharif().scene(0.5).gap(x, y)
    assert np.max(opened) > 1e-5


def test_calibrated_set_up_gives_the_published_radii():
    contact = sharif().contact(0.5)
    # Sharif et al. (2001), section 6: 3.046 m and 95.4 mm
    assert contact.radii[0] == pytest.approx(3.046, rel=0.005)
    assert contact.radii[1] == pytest.approx(0.0954, rel=0.005)


def test_a_shifted_worm_meets_the_flank_of_a_hob_shifted_the_other_way():
    """The hob's shift moves the whole flank along its axis, so only the difference of both counts."""
    shift = 0.1 * MM
    moved = sharif(assembly=Assembly(axial_shift=shift)).cycle.path.line
    recut = sharif(hob=changed(HOB, axial_shift=HOB.axial_shift - shift)).cycle.path.line
    np.testing.assert_allclose(moved.direction, recut.direction, rtol=0, atol=1e-12)
    np.testing.assert_allclose(
        moved.foot, recut.foot + _foot_of_shift(recut.direction, shift), rtol=0, atol=1e-12
    )


def _foot_of_shift(direction, shift):
    """How the foot of a line moves if the line is shifted along Y: square to the line."""
    along = np.array([0.0, shift, 0.0])
    return along - (along @ direction) * direction


ERRORS = Assembly(centre_distance=0.1 * MM, axial_shift=-0.05 * MM, shaft_angle=0.1 * DEGREE)


@pytest.mark.parametrize("phase", (0.1, 0.5, 0.9))
def test_misaligned_teeth_touch_and_mesh(phase):
    drive = sharif(assembly=ERRORS)
    contact = drive.contact(phase)
    assert np.linalg.norm(contact.point - sharif().contact(phase).point) > 0.5 * MM
    x, y = np.meshgrid(np.linspace(-0.025, 0.025, 65), np.linspace(-0.012, 0.012, 65))
    assert drive.gap(contact)(x, y)[0].min() > -1e-15
    worm, wheel = (motion.velocity(0.0, 0.0) for motion in drive.motions(contact))
    assert abs(worm[2]) < 1e-12 and abs(wheel[2]) < 1e-12
    # the worm turns about its own, tilted, axis
    axis = np.array([0.0, -np.sin(ERRORS.shaft_angle), np.cos(ERRORS.shaft_angle)])
    centre = np.array([-304.9 * MM, -0.05 * MM, 0.0])
    velocity = drive.speed * np.cross(axis, contact.point - centre) - contact.velocity
    np.testing.assert_allclose(worm, contact.axes @ velocity, rtol=0, atol=1e-12)


def test_sensitivities_are_those_of_drives_built_with_the_errors():
    drive = sharif()
    data = sensitivity_data(drive)
    at = data.sel(error="assembly.axial_shift", side=1)
    error = float(at["error_size"])
    other = sharif(assembly=Assembly(axial_shift=error)).contact(0.5)
    assert float(at["varied_radius_long"]) == other.radii[0]
    assert float(at["varied_contact_face"]) == pytest.approx(other.point[1], abs=2 * MM)
    # Hertz's pressure on the real gap within what its edges and higher orders do
    assert float(at["varied_dry_pressure_max"]) == pytest.approx(530e6, rel=0.05)
    middle = data.sel(side=0)
    assert np.ptp(middle["varied_contact_face"].values) == 0
    table = sensitivity_table(data)
    assert sum(map(bool, table.rows)) == 9
