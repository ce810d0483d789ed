"""Rollers by their equation of motion: steady limit, energies, pins, both directions of rotation."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from folders import ROOT

import pyworm
from pyworm.drives.roller_worm import roller_path
from pyworm.drives.roller_worm.profile import RollerProfile
from pyworm.drives.roller_worm.roller_body import GRAVITY, roller_body
from pyworm.drives.roller_worm.roller_path import LEAST_LOAD
from pyworm.drives.roller_worm.roller_rotation import over_a_turn, over_times
from pyworm.drives.roller_worm.spin_up import energies, spin_up
from pyworm.drives.roller_worm.station_history import station_history
from pyworm.drives.roller_worm.wheel_motion import WheelMotion
from pyworm.ratings.motion import rate_motion


@pytest.fixture(scope="module")
def drive():
    return pyworm.load(ROOT / "cases/roller_ref.toml").drive


@pytest.fixture(scope="module", autouse=True)
def _coarse():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(roller_path, "PLACES_PER_PITCH", 8)
        patch.setattr(roller_path, "PLACES_PER_FACE", 8)
        yield


@pytest.fixture(scope="module")
def spun(drive):
    return drive.spun("left")


@pytest.fixture(scope="module")
def turn(drive):
    return drive.rotation("left")


@pytest.mark.parametrize("section", ["left", "right"])
def test_without_inertia_the_moments_balance(drive, section):
    """To 1e-6 as the speed by the balance of moments; the lag goes in proportion to the inertia."""
    smooth = drive.spun("left", rough=False)
    loaded = smooth.paths[section]
    angles = (loaded.driving or loaded.idle).wheel_angles[[30, 34, 40]]
    lags = []
    for share in (1e-1, 1e-2, 1e-7):
        body = replace(smooth.body, inertia=share * smooth.body.inertia)
        roller = replace(smooth, body=body, wheel=WheelMotion(angles[0], drive.turning))
        seconds = (angles - angles[0]) / drive.turning
        found = over_times(roller, seconds[-1], tolerance=1e-8)
        balanced = [drive._turning(section, float(angle)) for angle in angles[1:]]
        lags.append(np.array([found.speed(time) for time in seconds[1:]]) / balanced - 1)
    assert lags[0] / lags[1] == pytest.approx([10, 10], rel=0.1)
    assert np.abs(lags[2]).max() < 1e-6


def test_the_balance_of_rough_surfaces_has_their_asperities_too(drive, spun):
    path = spun.paths["left"].driving
    begin, end = path.wheel_angles[[30, 34]]
    body = replace(spun.body, inertia=1e-7 * spun.body.inertia)
    roller = replace(spun, body=body, wheel=WheelMotion(begin, drive.turning))
    found = over_times(roller, (end - begin) / drive.turning, tolerance=1e-8)
    slices = path.at(end)
    at_rest, there = (spun.shear.at(slices, speed).moment for speed in (0.0, found.speed(1.0)))
    assert abs(there) < 1e-4 * abs(at_rest)


def test_a_slice_without_load_has_the_film_of_the_least_load(spun):
    """At the first touch; it was infinite, with a warning of the interpreter."""
    path = spun.paths["left"].driving
    slices = path.at(path.wheel_angles[34])
    speed = 0.5 * slices.rolling
    one = slices.load == slices.load.max()
    with np.errstate(all="raise"):
        bare, least = (
            spun.shear.film(replace(slices, load=np.where(one, load, slices.load)), speed)
            for load in (0.0, LEAST_LOAD)
        )
    assert np.array_equal(bare, least) and np.all(np.isfinite(bare))


def test_energies_of_a_spin_up_balance(turn):
    """Work of the worm is the sliding loss, the pin's and kinetic energy."""
    for section in ("right", "left"):
        entry = spin_up(turn, section)
        assert entry.energies.residual < 1e-3
        assert entry.energies.kinetic == pytest.approx(entry.energies.shear, rel=1e-3)


def test_energies_balance_to_rounding_of_the_integration(spun):
    roller = replace(spun, body=replace(spun.body, pin_arm=0.004 * 0.01))
    fine = over_times(roller, 0.04, 0.0, tolerance=1e-7)
    whole = energies(fine, 0.0, 0.04)
    assert whole.pin > 0 and whole.kinetic > 0.3
    assert whole.residual < 1e-6


def test_the_roller_is_reversed_between_the_sections(turn):
    right, left = spin_up(turn, "right"), spin_up(turn, "left")
    assert right.entry_speed > 0 > right.rolling_speed
    assert left.entry_speed < 0 < left.rolling_speed
    # opposite surfaces entrain nothing; the loaded section is quick, the idling one slow
    assert left.entrainment_min == 0.0
    assert 1e-3 < left.seconds < 3e-3
    assert 0.03 < right.seconds < 0.07
    assert turn.speed(turn.end) == pytest.approx(turn.speed(0.0), rel=1e-4)


def test_the_rating_shows_what_the_rotation_has(drive, turn):
    rating = rate_motion(drive.motion_figures())
    shown = {figure.key: figure.shown(1) for figure in rating.figures}
    left = spin_up(turn, "left")
    assert shown["entry_speed_rad_s"] == f"{left.entry_speed * 30 / pi:.4g} rpm"
    assert shown["spin_up_time_s"] == f"{left.seconds * 1e3:.4g} ms"
    assert shown["sliding_distance_m"] == f"{left.sliding_distance * 1e3:.4g} mm"
    assert rating.summary()["left section, driving"]["spin_up_loss_J"] == left.energies.sliding


def test_a_constant_moment_spins_a_roller_up_as_closed_form(spun):
    """From rest at the limiting stress: omega = M t / I until it rolls."""
    path = spun.paths["right"].idle
    angle = float(path.wheel_angles[40])
    roller = replace(spun, wheel=WheelMotion(angle, spun.wheel.turning))
    moment = spun.shear.at(path.at(angle), 0.0).moment
    short = 2e-4
    found = over_times(roller, short, 0.0, tolerance=1e-8)
    assert found.speed(short) == pytest.approx(moment * short / spun.body.inertia, rel=0.02)


@pytest.mark.long
def test_a_pin_brakes_the_way_back_to_rest_and_holds(spun):
    body = replace(spun.body, pin_arm=1.5e-4, mass=60 * spun.body.mass)
    turned = over_a_turn(replace(spun, body=body))
    _, leaves = turned.passages("left")
    slowing = body.pin_friction(0.0, spun.wheel.turning) / body.inertia
    speed = turned.speed(leaves)
    assert turned.speed(leaves + 0.1) == pytest.approx(speed - slowing * 0.1, rel=1e-3)
    assert turned.speed(turned.end) == turned.speed(0.0) == 0.0
    assert spin_up(turned, "right").entry_speed == 0.0


def test_rollers_that_a_pin_holds_in_mesh_do_not_turn(spun):
    body = replace(spun.body, pin_arm=1.0)
    turned = over_a_turn(replace(spun, body=body), 0.0)
    assert all(turned.speed(time) == 0.0 for time in np.linspace(0, turned.end, 7))
    assert spin_up(turned, "left").energies.kinetic == 0.0


def test_a_roller_is_a_solid_bored_for_its_pin(drive):
    rollers, steel = drive.rollers, drive.bodies[1]
    bored = replace(rollers, pin=replace(rollers.pin, radius=3e-3, friction=0.1))
    found = roller_body(bored, steel, 0.128)
    mass = steel.density * pi * 14e-3 * (6.5e-3**2 - 3e-3**2)
    assert found.mass == pytest.approx(mass)
    assert found.inertia == pytest.approx(mass * (6.5e-3**2 + 3e-3**2) / 2)
    assert found.pin_friction(0.0, 0.0) == pytest.approx(3e-4 * mass * GRAVITY)
    ball = replace(rollers, profile=RollerProfile(5e-3, 10e-3 * (1 - 1e-12), "ball"))
    assert roller_body(ball, steel, 0.1).inertia == pytest.approx(
        2 / 5 * steel.density * 4 / 3 * pi * 5e-3**5, rel=1e-6
    )
    given = roller_body(replace(rollers, inertia=1e-6), steel, 0.1)
    assert given.inertia == 1e-6


def test_a_mirrored_set_that_turns_the_other_way_is_the_same(drive, turn):
    """Loads, velocities, films and rotation, of both sections, to rounding."""
    mirrored = replace(drive, worm=replace(drive.worm, hand="left"), driving="right")
    for section, other in (("left", "right"), ("right", "left")):
        for phase in (0.0, 0.3, 1.0):
            here = drive.state(section, phase, [0.1, 0.8])
            there = mirrored.state(other, 1 - phase, [0.1, 0.8])
            for found, wanted in (
                (there.load, here.load),
                (there.motion.worm[0], here.motion.worm[0]),
                (there.motion.roller[0], here.motion.roller[0]),
                (np.abs(there.motion.worm[1]), np.abs(here.motion.worm[1])),
                (there.films.minimum, here.films.minimum),
                (np.abs(there.motion.roller_speed), np.abs(here.motion.roller_speed)),
            ):
                assert found == pytest.approx(wanted, rel=1e-7)
    other_way = mirrored.rotation("left")
    for time in (0.01, 0.2, 0.26, 0.28):
        assert abs(other_way.speed(time)) == pytest.approx(abs(turn.speed(time)), rel=1e-4)


def test_the_section_that_drives_changes_with_the_direction(drive):
    back = replace(drive, driving="right")
    torque = drive.ratio * drive.torque
    assert back.wheel_torque("right") == drive.preload + torque
    assert back.wheel_torque("left") == drive.preload
    assert back.turning == -drive.turning


@pytest.mark.long
def test_a_reversing_wheel_turns_its_rollers_back(drive):
    """A roller in the driving section, whose torque passes to the other section as the wheel reverses."""
    begin = float(np.radians(30))
    wheel = WheelMotion(begin, drive.turning, (0.0, 0.02), (1.0, -1.0), (1.0, -1.0))
    assert wheel.wheel_angle(0.02) == pytest.approx(begin)
    assert wheel.passages([wheel.wheel_angle(0.005)], 0.02) == pytest.approx(
        [0.0, 0.005, 0.01, 0.015, 0.02]
    )
    roller = drive.spun("left", wheel)
    found = over_times(roller, 0.02)
    first, last = (dict(roller.slices(time))["left"] for time in (0.0, 0.02))
    assert first.force > 8 * last.force > 0
    assert found.speed(0.02) < 0 < found.speed(0.0)
    # the light load of the backlash turns it with a lag, by the closed form of limiting friction
    assert abs(found.speed(0.02)) < abs(last.rolling)


@pytest.mark.long
def test_a_station_has_what_its_transient_film_needs(drive, turn):
    """As the scene of a roller that turns so; the closed form's own friction leaves the rotation as it is."""
    begin, _ = turn.passages("left")
    window = begin + 0.5e-3, begin + 1.5e-3
    history = station_history(turn, "left", 0.5, window)
    dynamic = replace(drive, rolling="dynamic")
    part = dynamic.sections["left"]
    scene = dynamic.scene("left", float(part.phase(history.wheel_angles[-1])), 0.5)
    assert history.load[-1] == pytest.approx(scene.load, rel=0.03)
    assert history.radius[-1] == pytest.approx(scene.radius, rel=1e-3)
    assert history.entrainment[-1] == pytest.approx(scene.entrainment, rel=0.02)
    assert history.sliding[0] > history.sliding[-1] > 0
    lost = history.friction * history.load * history.sliding
    friction = history.friction_of(history.times, lost, history.load)
    known = np.isfinite(friction)
    assert known.any() and friction[known] == pytest.approx(history.friction[known])
    same = history.factor("left", history.times, friction)
    half = history.factor("left", history.times, friction / 2)
    angle, speed = history.wheel_angles[20], history.speeds[20]
    assert (same("left", angle, speed), half("left", angle, speed)) == pytest.approx((1.0, 0.5))
    assert half("right", angle, speed) == half("left", angle + 1, speed) == 1.0
    whole = turn.spun.shear_at(window[0], turn.speed(window[0])).moment
    halved = replace(turn.spun, factor=half).shear_at(window[0], turn.speed(window[0])).moment
    assert halved == pytest.approx(whole / 2, rel=1e-6)


def test_a_station_that_the_roller_does_not_touch_is_refused(turn):
    with pytest.raises(ValueError, match="the left section carries no load"):
        station_history(turn, "left", 0.5, (0.0, 1e-3))
