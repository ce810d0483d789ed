"""The gap between worm and real roller, and the velocities over it."""

import numpy as np
import pytest
from roller_sections import section
from scipy.optimize import minimize_scalar

from pyworm.drives.roller_worm.gap import ContactFrame, RollerGap, RollerMotion
from pyworm.drives.roller_worm.motion import line_motion
from pyworm.drives.roller_worm.profile import Crown

CROWN = Crown(0.5, 8e-3)
WHEEL_SPEED = 4.488


def frame(name="left", place=0.0, phase=0.4, crown=None, **options):
    part = section(name, crown=crown, **options)
    contact = part.envelope.contact(np.array(place), np.array(part.wheel_angle(phase)))
    motion = line_motion(part.envelope, contact, WHEEL_SPEED, 900.0)
    return ContactFrame(part, contact, motion.x_axis, motion.y_axis), motion


@pytest.mark.parametrize("name", ["left", "right"])
@pytest.mark.parametrize("options", [{}, {"shape": "cone", "half_angle": 0.1}, {"tilt": 0.3}])
def test_the_gap_is_nowhere_negative_and_zero_along_the_contact_line(name, options):
    seat, _ = frame(name, **options)
    x, y = np.meshgrid(np.linspace(-2e-3, 2e-3, 41), np.linspace(-5e-3, 5e-3, 41))
    gap, covered = RollerGap(seat)(x, y)
    assert covered.all()
    assert gap.min() > -1e-12
    # points of the contact line, seen along the normal
    line = seat.section.envelope.contact(np.linspace(-4e-3, 4e-3, 9), seat.contact.wheel_angle)
    off = line.point - seat.contact.point[:, None]
    touching, _ = RollerGap(seat)(seat.x_axis @ off, seat.y_axis @ off)
    assert np.abs(touching).max() < 1e-12


def test_the_gap_opens_with_the_induced_curvature():
    seat, _ = frame()
    h = 2e-5
    gap, _ = RollerGap(seat)(np.array([-h, 0.0, h]), np.zeros(3))
    assert gap[1] == pytest.approx(0, abs=1e-15)
    assert (gap[0] + gap[2]) / h**2 == pytest.approx(float(seat.contact.curvature), rel=1e-5)


def roller_distance(flank, point, wheel_angle):
    """Distance of points (3, ...) of the drive frame from a roller's profile, and place along its axis [m].

    The distance is taken square to the roller's axis times cos(gamma): exact to first order.
    """
    _, _, axis, middle = flank.axes(wheel_angle)
    arm = point - middle
    place = (arm * axis).sum(axis=0)
    out = np.sqrt(np.maximum((arm * arm).sum(axis=0) - place**2, 0.0))
    radius, gamma = flank.profile(place)
    return (out - radius) * np.cos(gamma), place


def test_heights_lie_on_the_surfaces():
    seat, _ = frame(crown=CROWN)
    flank = seat.section.envelope
    x, y = np.meshgrid(np.linspace(-2e-3, 2e-3, 7), np.linspace(-5.5e-3, 5.5e-3, 7))
    height, place, met = seat.roller_height(x, y)
    assert met.all()
    distance, along = roller_distance(
        flank, seat.lifted(x, y, height), np.broadcast_to(seat.contact.wheel_angle, x.shape)
    )
    assert np.allclose(distance, -CROWN(along), atol=1e-12)
    assert np.allclose(along, place, atol=1e-12)
    height, _, sound = seat.worm_height(x, y)
    assert sound.all()
    # on the flank: some roller position touches the point, and none cuts it away
    for point in seat.lifted(x, y, height).reshape(3, -1).T[::5]:
        fixed = flank.into_worm(point, seat.contact.wheel_angle)
        here = float(seat.contact.wheel_angle)

        def distance(angle, fixed=fixed):
            return float(roller_distance(flank, flank.from_worm(fixed, angle), angle)[0])

        least = minimize_scalar(
            distance, bounds=(here - 0.02, here + 0.02), options={"xatol": 1e-9}
        )
        assert abs(least.fun) < 1e-11


def test_the_crown_opens_the_ends_and_the_ends_are_known():
    plain, _ = frame()
    crowned, _ = frame(crown=CROWN)
    y = np.array([0.0, 3.9e-3, 5.5e-3, 6.5e-3])
    gaps = [RollerGap(seat)(np.zeros(4), y) for seat in (plain, crowned)]
    opened = gaps[1][0] - gaps[0][0]
    assert opened[:2] == pytest.approx([0, 0], abs=1e-11)
    assert opened[2] == pytest.approx(1.5e-3**2 / 2 / 0.5, rel=0.02)
    assert list(gaps[1][1]) == [True, True, True, False]  # the thread ends at 6 mm


def test_velocities_are_those_of_rigid_bodies_at_points_of_the_roller():
    seat, motion = frame("right", place=2e-3)
    flank = seat.section.envelope
    axis = flank.axes(seat.contact.wheel_angle)[2]
    turns = (
        flank.worm_turn * WHEEL_SPEED,
        np.array([0.0, 0.0, -WHEEL_SPEED]) + 900.0 * axis,
    )
    x, y = np.array([1e-3, -0.5e-3]), np.array([2e-3, -4e-3])
    point = seat.lifted(x, y, seat.roller_height(x, y)[0])
    for turn, (u, v) in zip(turns, (motion.worm, motion.roller), strict=True):
        start = u * seat.x_axis + v * seat.y_axis
        field = RollerMotion(seat, start, turn)
        arm = point - seat.contact.point[:, None]
        whole = start[:, None] + np.cross(turn, arm.T).T
        found = field(x, y)
        assert found[0] == pytest.approx(seat.x_axis @ whole, rel=1e-9)
        assert found[1] == pytest.approx(seat.y_axis @ whole, rel=1e-9)
