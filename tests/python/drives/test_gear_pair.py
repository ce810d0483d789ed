"""The gear pair drive: kinematics, loads, gaps and scenes along the line of action, and its closed forms."""

from dataclasses import replace
from math import cos, hypot, pi, radians, sin, sqrt

import numpy as np
import pytest
from folders import CASES
from hypothesis import given, settings
from hypothesis import strategies as st

import pyworm
from pyworm.cli.main import main
from pyworm.drives.gear_pair.design import LinearRelief
from pyworm.drives.gear_pair.gap import Flank
from pyworm.formulas.film import dowson_higginson, line_groups
from pyworm.formulas.hertz import hertz, hertz_line
from pyworm.io.input_error import CaseError
from pyworm.materials.body import Body
from pyworm.plots.drives.gear_pair import draw_film_and_temperature, draw_line_of_action
from pyworm.result.result import Result, open_result
from pyworm.scene.line import LineScene

SPUR_TEXT = (CASES / "spur_pair.toml").read_text()
STEEL = Body(206e9, 0.3)
"""Steel of which no roughness is known, nor how it takes heat."""


@pytest.fixture(scope="module")
def spur():
    return pyworm.load(CASES / "spur_pair.toml").drive


@pytest.fixture(scope="module")
def increaser():
    return pyworm.load(CASES / "errichello_speed_increaser.toml").drive


@pytest.fixture(scope="module")
def balanced():
    return pyworm.load(CASES / "errichello_optimised_addenda.toml").drive


def loaded(tmp_path, *changes):
    """The spur pair's drive with passages of its case replaced."""
    text = SPUR_TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    path = tmp_path / "case.toml"
    path.write_text(text)
    return pyworm.load(path).drive


# ----------------------------------------------------------------------- kinematics and loads


def test_rigid_bodies_agree_with_the_contacts(increaser):
    """Gears turning in space: equal velocities along the normal, the contacts' own across the line."""
    teeth = increaser.teeth
    pinion, gear = teeth.cylinders
    angle, helix = teeth.pressure_angle, teeth.system.base_helix_angle
    # axes along z, the gear's at x = centre distance; the line of action turned by the pressure angle
    along = np.array([sin(angle), cos(angle), 0.0])
    foot = pinion.base * np.array([cos(angle), -sin(angle), 0.0])
    axial = np.array([0.0, 0.0, 1.0])
    normal = cos(helix) * along + sin(helix) * axial
    line = sin(helix) * along - cos(helix) * axial
    across = np.cross(line, normal)
    for phase in (0.05, 0.4, 0.9):
        contact = increaser.contacts(phase)
        point = foot + contact.pinion_length * along
        centre = np.array([teeth.centre_distance, 0.0, 0.0])
        turns = increaser.pinion_speed * axial, -increaser.gear_speed * axial
        arms = point, point - centre
        velocities = [np.cross(turn, arm) for turn, arm in zip(turns, arms, strict=True)]
        assert hypot(*arms[1][:2]) == pytest.approx(
            hypot(gear.base, contact.gear_length), rel=1e-12
        )
        assert velocities[0] @ normal == pytest.approx(velocities[1] @ normal, rel=1e-12)
        assert velocities[0] @ line == pytest.approx(velocities[1] @ line, rel=1e-12)
        speeds = sorted(abs(velocity @ across) for velocity in velocities)
        told = sorted([float(contact.pinion_velocity), float(contact.gear_velocity)])
        assert speeds == pytest.approx(told, rel=1e-12)


def test_surfaces_pass_the_contact_line_against_its_way(spur, increaser):
    """Rotations give the sign along x: the contact line of a driving pinion runs to its tip."""
    for drive in (spur, increaser):
        teeth, angle = drive.teeth, drive.teeth.pressure_angle
        # the pinion's flank faces along the line of action; it turns that way where it drives
        turn = drive.pinion_speed * (1 if drive.driver == "pinion" else -1)
        along, to_tip = (
            np.array([sin(angle), cos(angle), 0.0]),
            np.array([cos(angle), -sin(angle), 0.0]),
        )
        for phase in (0.05, 0.4, 0.9):
            contact = drive.contacts(phase)
            point = teeth.cylinders[0].base * to_tip + contact.pinion_length * along
            centre = np.array([teeth.centre_distance, 0.0, 0.0])
            velocities = (
                np.cross([0.0, 0.0, turn], point),
                np.cross([0.0, 0.0, -turn / teeth.ratio], point - centre),
            )
            scene = drive.scene(phase)
            assert scene.velocities == pytest.approx(
                [velocity @ to_tip for velocity in velocities], rel=1e-12
            )
            assert (scene.entrainment < 0) == (drive.driver == "pinion")


@settings(max_examples=40, deadline=None)
@given(phase=st.floats(0, 1))
def test_curvatures_and_sliding(spur, increaser, phase):
    for drive in (spur, increaser):
        teeth = drive.teeth
        contact = drive.contacts(phase)
        total = teeth.centre_distance * sin(teeth.pressure_angle)
        assert contact.pinion_length + contact.gear_length == pytest.approx(total, rel=1e-12)
        curvature = 1 / contact.pinion_radius + 1 / contact.gear_radius
        assert contact.radius == pytest.approx(1 / curvature, rel=1e-12)
        from_pitch = contact.pinion_length - teeth.pitch_point
        turning = drive.pinion_speed + drive.gear_speed
        assert contact.sliding == pytest.approx(turning * from_pitch, abs=1e-12)
        assert contact.slide_roll_ratio == pytest.approx(contact.sliding / contact.entrainment)


def test_nothing_slides_at_the_pitch_point(spur, increaser, balanced):
    for drive in (spur, increaser, balanced):
        contact = drive.contacts(drive.phase_of(drive.teeth.pitch_point))
        assert abs(contact.sliding) < 1e-12 * contact.entrainment
        assert contact.pinion_velocity == pytest.approx(
            drive.pitch_line_velocity * sin(drive.teeth.pressure_angle), rel=1e-12
        )


def test_torque_power_and_normal_force(spur, increaser):
    for drive in (spur, increaser):
        helix = drive.teeth.system.base_helix_angle
        tangential = drive.normal_force * cos(helix)
        pinion, gear = drive.teeth.cylinders
        carried = drive.load_factor * drive.power
        assert tangential * pinion.base * drive.pinion_speed == pytest.approx(carried, rel=1e-12)
        assert tangential * gear.base * drive.gear_speed == pytest.approx(carried, rel=1e-12)


def test_loads_of_the_report_c14(spur):
    """github.com/cfernandesFEUP/GEARpie, REPORT/C14.txt: force, and pressures where one pair carries all."""
    assert spur.normal_force == pytest.approx(5912.1, rel=2e-5)
    pitch = spur.contacts(spur.phase_of(spur.teeth.pitch_point))
    assert spur.rating(pitch).hertz_pressure == pytest.approx(1347.3e6, rel=1e-4)
    cycle = spur.rating(spur.contacts(spur.cycle_phases()))
    assert cycle.hertz_pressure.max() == pytest.approx(1447.5e6, rel=1e-3)


def test_force_of_the_report_h501(tmp_path):
    """REPORT/H501.txt, 200 N m on the helical pinion: F_bn 6081.0 N, and its tip thickness is above zero."""
    drive = loaded(
        tmp_path,
        ('module = "4.5 mm"', 'module = "3.5 mm"\nhelix_angle = "15 deg"'),
        ("teeth = 16", "teeth = 20"),
        ("teeth = 24", "teeth = 30"),
        ("0.1817", "0.1809"),
        ("0.1715", "0.0891"),
        ('"14 mm"', '"23 mm"'),
    )
    assert drive.normal_force == pytest.approx(6081.0, rel=2e-5)
    shared = drive.contacts(np.array([0.2, 0.5, 0.8]))
    # in the middle of the path the whole face is in contact on one line
    assert shared.line_length[1] == pytest.approx(
        23e-3 / cos(drive.teeth.system.base_helix_angle), rel=1e-12
    )


def test_ohlendorfs_loss_factor(spur):
    """H_V = pi (u+1)/(z1 u) (1 - eps + eps1^2 + eps2^2); REPORT/C14.txt prints 0.1950."""
    drive = replace(spur, load_sharing="uniform")
    teeth = drive.teeth
    pitch = teeth.system.base_pitch
    addendum, dedendum = teeth.end - teeth.pitch_point, teeth.pitch_point - teeth.start
    bracket = 1 - (addendum + dedendum) / pitch + (addendum**2 + dedendum**2) / pitch**2
    ohlendorf = pi * (teeth.ratio + 1) / (teeth.pinion.teeth * teeth.ratio) * bracket
    assert drive.loss_factor == pytest.approx(ohlendorf, rel=1e-5)
    assert drive.loss_factor == pytest.approx(0.1950, abs=6e-5)


@pytest.mark.parametrize("driver", ["pinion", "gear"])
def test_what_friction_takes_is_the_work_of_sliding(spur, driver):
    """Torques by friction and normal load on both gears; their powers differ by friction times sliding."""
    drive = replace(spur, driver=driver)
    friction = 0.07
    contact = drive.contacts(np.array([0.05, 0.3, 0.6, 0.95]))
    load = drive.friction_load_factor(contact, friction)
    # a driver slower than what it drives is dragged along, a faster one held back; the driven one likewise
    held_back = np.sign(contact.sliding) * (1 if driver == "pinion" else -1)
    pinion, gear = drive.teeth.cylinders
    powers = [
        speed * load * (size.base + held_back * friction * length)
        for speed, size, length in (
            (drive.pinion_speed, pinion, contact.pinion_length),
            (drive.gear_speed, gear, contact.gear_length),
        )
    ]
    given_in, got_out = powers if driver == "pinion" else powers[::-1]
    assert given_in == pytest.approx(np.full(4, pinion.base * drive.pinion_speed), rel=1e-12)
    assert given_in - got_out == pytest.approx(load * friction * np.abs(contact.sliding), rel=1e-9)


def test_approach_turns_round_with_the_driver(spur, increaser):
    pitch = spur.phase_of(spur.teeth.pitch_point)
    phases = np.array([0.5, 0.99, 1.01, 1.5]) * pitch
    assert spur.contacts(phases).approach.tolist() == [True, True, False, False]
    turned = replace(spur, driver="gear")
    assert turned.contacts(phases).approach.tolist() == [False, False, True, True]
    # nearly all of a long-addendum pinion's path is recess when it drives, approach when it is driven
    assert increaser.contacts(np.linspace(0, 1, 1001)).approach.mean() > 0.95
    friction = increaser.friction_load_factor(increaser.contacts(np.array([0.01, 0.5])), 0.1)
    assert friction[0] < 1 < friction[1]


# ------------------------------------------------------------------------------------- gaps


@pytest.mark.parametrize("helix", [0.0, 0.2, 0.5])
def test_flanks_are_the_involute_helicoid(helix):
    """Points of the helicoid by roll angle and place along the axis, seen from the contact point."""
    base, length = 34.4e-3, 16.6e-3
    flank = Flank(base, length, helix, form_length=1e-3, tip_length=0.1)
    theta, axial = np.meshgrid(np.linspace(-0.3, 0.4, 15), np.linspace(-8e-3, 8e-3, 9))
    # the section at a place along the axis is the same involute, turned: its radius of curvature changes
    curved = length + base * theta - np.tan(helix) * axial
    x = curved * np.sin(theta) - base * (1 - np.cos(theta))
    forward = curved * np.cos(theta) - base * np.sin(theta) - length
    y = forward * sin(helix) - axial * cos(helix)
    z = forward * cos(helix) + axial * sin(helix)
    height, exists = flank.height(x, y)
    assert np.abs(height - z).max() < 1e-16
    assert np.array_equal(exists, (curved >= 1e-3) & (curved <= 0.1))


def test_flanks_touch_all_along_the_contact_line(increaser):
    gap = increaser.gap(0.4)
    y = np.linspace(-0.08, 0.08, 41)
    opening, _ = gap(np.zeros(41), y)
    assert np.abs(opening).max() < 1e-18
    contact, helix = increaser.contacts(0.4), increaser.teeth.system.base_helix_angle
    # across it, relative curvature changes along the line as both radii do
    x = 1e-5
    opening, covered = gap(np.full(3, x), np.array([-0.03, 0.0, 0.03]))
    rises = np.array([-0.03, 0.0, 0.03]) * sin(helix)
    first, second = contact.pinion_length + rises, contact.gear_length - rises
    expected = x**2 / 2 * cos(helix) * (1 / first + 1 / second)
    assert opening == pytest.approx(expected, rel=2e-3)
    assert covered[1]


def test_teeth_end_at_tips_and_faces(spur):
    drive = replace(spur, lead_crowning=20e-6, contact="point")
    phase = 0.97
    gap, contact = drive.gap(phase), drive.contacts(phase)
    half = drive.teeth.face_width / 2
    assert gap(np.zeros(2), np.array([0.999, 1.001]) * half)[1].tolist() == [True, False]
    assert gap(np.zeros(1), np.array([half]))[0] == pytest.approx(20e-6, rel=1e-12)
    # the pinion's tip is near, at the roll angle where its involute ends
    pinion = drive.teeth.cylinders[0]
    turn = (pinion.tip_length - contact.pinion_length) / pinion.base
    edge = pinion.tip_length * sin(turn) - pinion.base * (1 - cos(turn))
    assert gap(edge * np.array([0.999, 1.001]), np.zeros(2))[1].tolist() == [True, False]


def test_the_gap_far_off_is_finite_and_open(increaser, spur):
    for drive in (increaser, spur):
        for phase in (0.0, 0.5, 1.0):
            x, y = np.meshgrid(np.linspace(-0.1, 0.1, 41), np.linspace(-0.3, 0.3, 41))
            opening, _ = drive.gap(phase)(x, y)
            assert np.isfinite(opening).all()
            assert opening.min() > -1e-18


def test_tip_relief_grows_from_where_it_begins(spur):
    relief = LinearRelief(20e-6, 3e-3)
    drive = replace(spur, tip_relief=(relief, LinearRelief()))
    phase = 0.8
    x = np.linspace(-2e-3, 2e-3, 401)
    plain, _ = spur.gap(phase)(x, 0 * x)
    relieved, _ = drive.gap(phase)(x, 0 * x)
    contact, pinion = spur.contacts(phase), spur.teeth.cylinders[0]
    # radius of curvature of the pinion's flank at x, by its involute
    turn = np.linspace(-0.2, 0.2, 4001)
    rolled = contact.pinion_length + pinion.base * turn
    place = rolled * np.sin(turn) - pinion.base * (1 - np.cos(turn))
    curved = np.interp(x, place, rolled)
    taken = 20e-6 * np.maximum(curved - (pinion.tip_length - 3e-3), 0) / 3e-3
    at_contact = np.interp(0.0, x, taken)
    assert relieved - plain == pytest.approx(taken - at_contact, abs=1e-10)
    assert taken.max() > 5e-6


# ----------------------------------------------------------------------------------- scenes


def test_line_scenes_by_hand(spur):
    """At the pitch point of the FZG C gears: radius 8.385 mm, 422.3 kN/m, 2.192 m/s."""
    teeth = spur.teeth
    phase = spur.phase_of(teeth.pitch_point)
    scene = spur.scene(phase)
    assert isinstance(scene, LineScene)
    sine = sin(teeth.pressure_angle)
    radius = 36.6e-3 * 54.9e-3 / 91.5e-3 * sine
    assert scene.radius == pytest.approx(radius, rel=1e-9)
    assert scene.load == pytest.approx(200 / (36e-3 * cos(radians(20))) / 14e-3, rel=1e-5)
    assert scene.velocities == pytest.approx((-157.08 * 36.6e-3 * sine,) * 2, rel=1e-5)
    opening, covered = scene.gap(np.array([-1e-4, 0.0, 1e-4]))
    assert opening == pytest.approx([1e-8 / 2 / radius, 0, 1e-8 / 2 / radius], rel=1e-2)
    assert covered.all()
    contact = hertz_line(scene.radius, scene.load, scene.reduced_modulus)
    by_hand = sqrt(scene.load * scene.reduced_modulus / (2 * pi * scene.radius))
    assert contact.pressure_max == pytest.approx(by_hand, rel=1e-12)


def test_point_scenes_have_the_crowned_face(spur):
    drive = replace(spur, contact="point", lead_crowning=40e-6, power=8e3)
    scene = drive.scene(0.5)
    contact = drive.contacts(0.5)
    assert scene.radii == pytest.approx((float(contact.radius), 14e-3**2 / (8 * 40e-6)))
    assert scene.load == pytest.approx(float(drive.normal_force * contact.load_share))
    assert scene.load == pytest.approx(float(contact.unit_load) * 14e-3, rel=1e-12)
    x = np.zeros(1)
    assert scene.entrainment(x, x)[0] == pytest.approx([-float(contact.entrainment)])
    y = np.array([3e-3])
    assert scene.gap(x, y)[0] == pytest.approx(y**2 / 2 / scene.radii[1], rel=1e-9)


def test_helical_surfaces_move_as_their_radii_grow(increaser):
    drive = replace(increaser, contact="point", lead_crowning=30e-6, load_sharing="uniform")
    scene, helix = drive.scene(0.4), drive.teeth.system.base_helix_angle
    contact = drive.contacts(0.4)
    y = np.array([0.02])
    (u1, v1), (u2, v2) = (motion(0 * y, y) for motion in scene.motions)
    assert u1 == pytest.approx(drive.pinion_speed * (contact.pinion_length + y * sin(helix)))
    assert u2 == pytest.approx(drive.gear_speed * (contact.gear_length - y * sin(helix)))
    assert v1 == v2 == pytest.approx([0.0])
    assert scene.load == pytest.approx(
        float(contact.unit_load * contact.line_length), rel=1e-12
    )  # the same load all along


def test_a_crowned_pair_is_hertzs_ellipse(spur):
    """The dry contact of the real gap against the closed form of its radii; the film beside the line's."""
    drive = replace(spur, contact="point", lead_crowning=40e-6, power=8e3)
    scene = drive.scene(0.5)
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.05, "isothermal"))
    assert solution.converged
    ellipse = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    dry = solution.figures.dry
    assert dry.pressure_max == pytest.approx(ellipse.pressure_max, rel=0.005)
    assert dry.length == pytest.approx(2 * ellipse.semi_axis_y, rel=0.01)
    # a line contact of the same largest pressure
    line = replace(drive, contact="line").scene(0.5)
    load = 2 * pi * line.radius * ellipse.pressure_max**2 / line.reduced_modulus
    line = replace(line, load=load)
    middle = pyworm.solve(line, pyworm.plan(line, 0.02, "isothermal"))
    assert solution.figures.film_central.value == pytest.approx(
        middle.figures.film_central.value, rel=0.03
    )


def test_phases_outside_the_mesh_are_refused(spur):
    with pytest.raises(ValueError, match=r"phase is 1\.1; a tooth pair touches from phase 0 to"):
        spur.scene(1.1)


# ------------------------------------------------------------------- closed forms and simulation


def test_simulated_least_films_follow_dowson_and_higginson(spur, increaser):
    """Isothermal Newtonian films: 2 to 8 % below the formula all along the line of action."""
    for drive in (spur, increaser):
        for phase in (0.1, 0.3, 0.5, 0.7, 0.9):
            scene = drive.scene(phase)
            solution = pyworm.solve(scene, pyworm.plan(scene, 0.01, "isothermal"))
            assert solution.converged
            formula = float(drive.rating(drive.contacts(phase)).film_min)
            assert 0.92 < solution.figures.film_min.value / formula < 0.98


def test_simulated_surfaces_are_as_hot_as_blok_has_it_with_their_friction(increaser):
    """Between smooth surfaces the film's heat goes to both bodies as Blok shares it: within 5 %."""
    for phase in (0.35, 0.6, 0.87):
        scene = increaser.scene(phase)
        solution = pyworm.solve(scene, pyworm.plan(scene, 0.02, ("all", "-roughness", "-squeeze")))
        assert solution.converged
        flash = float(increaser.rating(increaser.contacts(phase)).flash_temperature)
        flash *= solution.figures.friction_coefficient.value
        flash /= increaser.surfaces.friction_coefficient
        for figure in ("temperature_max_body_1", "temperature_max_body_2"):
            rise = getattr(solution.figures, figure).value - solution.inlet_temperature
            assert rise == pytest.approx(flash, rel=0.05)


def test_the_rating_by_hand(spur):
    contact = spur.contacts(0.35)
    rating = spur.rating(contact)
    groups = line_groups(
        contact.radius,
        contact.unit_load,
        spur.reduced_modulus,
        contact.entrainment,
        spur.oil.viscosity.eta0,
        spur.oil.viscosity.alpha,
    )
    film = float(dowson_higginson(groups).minimum)
    assert rating.film_min == pytest.approx(film, rel=1e-12)
    assert rating.specific_film == pytest.approx(film / hypot(0.51e-6, 0.40e-6), rel=1e-12)
    # Blok with equal steel bodies: the square roots of the velocities
    speeds = sqrt(contact.pinion_velocity), sqrt(contact.gear_velocity)
    half_width = sqrt(8 * contact.unit_load * contact.radius / (pi * spur.reduced_modulus))
    taken_up = sqrt(46 * 7830 * 465)
    flash = 0.80 * 0.05 * contact.unit_load * abs(speeds[0] - speeds[1])
    flash /= taken_up * sqrt(half_width)
    assert rating.flash_temperature == pytest.approx(flash, rel=1e-12)
    assert rating.contact_temperature == pytest.approx(333.15 + flash, rel=1e-12)


def test_a_case_without_surfaces_or_heat_has_films_only(spur):
    phases = np.array([0.3, 0.6])
    bare = replace(spur, surfaces=None)
    assert "closed_form_flash_temperature" not in bare.cycle_data()
    smooth = replace(spur, bodies=tuple(replace(body, roughness=None) for body in spur.bodies))
    assert smooth.rating(smooth.contacts(phases)).specific_film is None
    assert "closed_form_specific_film" not in smooth.cycle_data()
    cold = replace(spur, oil=replace(spur.oil, heat=None))
    rating = cold.rating(cold.contacts(phases))
    assert rating.specific_film is not None
    assert rating.flash_temperature is None


def worst(drive):
    """Least film [microinch], largest contact temperature [degF] and their phases."""
    phases = drive.cycle_phases()
    rating = drive.rating(drive.contacts(phases))
    thin, hot = rating.film_min.argmin(), rating.contact_temperature.argmax()
    fahrenheit = rating.contact_temperature[hot] * 1.8 - 459.67
    return rating.film_min[thin] / 25.4e-9, phases[thin], fahrenheit, phases[hot], rating


def test_errichellos_speed_increaser(increaser):
    """Lubrication of gears, part 3: 2.1 microinch near the LPSTC, 439 degF near the HPSTC, 400 ft/min."""
    film, thin, hottest, hot, rating = worst(increaser)
    assert increaser.pitch_line_velocity / 0.3048 * 60 == pytest.approx(400, rel=0.01)
    assert increaser.teeth.ratio == pytest.approx(375 / 55, rel=0.005)
    assert film == pytest.approx(2.1, rel=0.15)  # 2.37: the assumed geometry does not reach lower
    assert thin == pytest.approx(increaser.phase_of(increaser.teeth.lowest_single), abs=1e-6)
    assert hottest - 230 == pytest.approx(439 - 230, rel=0.06)
    assert hot == pytest.approx(increaser.phase_of(increaser.teeth.highest_single), abs=1e-6)
    assert hottest > 418  # above the mean scuffing temperature, as printed
    assert rating.specific_film.min() == pytest.approx(film / hypot(20, 20), rel=1e-9)


def test_errichellos_addenda_for_the_least_flash_temperature(balanced, increaser):
    """2.7 microinch and 302 degF: teeth of full depth, shifted to the least flash temperature."""
    film, _, hottest, _, _ = worst(balanced)
    assert film == pytest.approx(2.7, rel=0.03)
    assert hottest - 230 == pytest.approx(302 - 230, rel=0.08)
    # no other shift has a lower one
    total = balanced.teeth.pinion.profile_shift + balanced.teeth.gear.profile_shift
    for shift in (0.18, 0.30):
        pinion = replace(balanced.teeth.pinion, profile_shift=shift)
        gear = replace(balanced.teeth.gear, profile_shift=total - shift)
        other = replace(balanced, teeth=replace(balanced.teeth, pinion=pinion, gear=gear))
        assert worst(other)[2] > hottest


# --------------------------------------------------------------------------------- bad input


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('driver = "pinion"', 'driver = "both"', 'operation.driver = "both": must be "pinion" or'),
        ('power = "31.416 kW"', 'power = "31 N"', "must be a power with its unit"),
        ("teeth = 16", "teeth = 16.5", "drive.pinion.teeth = 16.5: must be a whole number"),
        ("teeth = 16", "teeth = 26", "drive.pinion.teeth is 26; the pinion is the gear with fewer"),
        ("0.1817", "-0.5", "drive.pinion.profile_shift is -0.5; 16 teeth are undercut below"),
        ('"91.5 mm"', '"90.9 mm"', "drive.centre_distance is 90.9 mm; teeth of profile shifts"),
        ('"14 mm"', '"14 mm"\ncontact = "point"', "drive.lead_crowning is missing; contact ="),
        ('"14 mm"', '"14 mm"\nhelix_angle = "-3 deg"', "must be an angle zero or more"),
        ('"14 mm"', '"14 mm"\nload_sharing = "even"', 'must be "ramp", "uniform" or "elastic"'),
        (
            "0.1817",
            '0.1817\ntip_relief = "20 um"',
            "drive.pinion.tip_relief_length is 0 mm; it must lie between 0 and the length of the path",
        ),
        ("[0.2,", "[1.2,", "operation.phases[0] = 1.2: must be at most 1"),
        ("friction_coefficient = 0.05", "", "surfaces.friction_coefficient is missing"),
    ],
)
def test_one_sentence_for_bad_input(tmp_path, old, new, sentence):
    with pytest.raises(CaseError) as refusal:
        loaded(tmp_path, (old, new))
    assert sentence in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_a_scuffing_temperature_needs_heat(tmp_path):
    text = SPUR_TEXT[: SPUR_TEXT.index("[oil.heat]")].replace(
        "friction_coefficient = 0.05",
        'friction_coefficient = 0.05\nscuffing_temperature = "200 degC"',
    )
    path = tmp_path / "case.toml"
    path.write_text(text)
    with pytest.raises(CaseError, match="scuffing_temperature has no effect without"):
        pyworm.load(path)


# ------------------------------------------------------------------------------- from end to end


def test_run_solves_the_line_of_action_and_draws_it(tmp_path, capsys):
    case = str(CASES / "errichello_speed_increaser.toml")
    how = "--effects", "auto,-squeeze", "--phase", "0.13", "0.6", "0.87"
    assert main(["run", case, "--out", str(tmp_path), *how]) == 0
    said = capsys.readouterr().out
    assert "2.1 uin" in said
    result = open_result(tmp_path / "result.nc")
    assert [solution.summary()["phase"] for solution in result.solutions] == [0.13, 0.6, 0.87]
    assert result.mesh_cycle.attrs["drive"] == "gear-pair"
    assert result.mesh_cycle.attrs["friction_coefficient"] == 0.1
    assert float(result.mesh_cycle["closed_form_film_min"].min()) == pytest.approx(
        6.02e-8, rel=0.01
    )
    for name in ("film_and_temperature.png", "line_of_action.png"):
        assert (tmp_path / name).stat().st_size > 10_000


# ---------------------------------------------------------------------------------- pictures


@pytest.fixture(scope="module")
def solved(increaser):
    scenes = [increaser.scene(phase) for phase in (0.87, 0.13)]
    # full steady films, as the formulas have them
    effects = ("auto", "-roughness", "-squeeze")
    solutions = tuple(pyworm.solve(scene, pyworm.plan(scene, 0.05, effects)) for scene in scenes)
    return Result("increaser", {}, solutions, increaser.cycle_data(), {})


def curve(axes, label):
    """The data of a line or of an error bar by the beginning of its label."""
    handles, labels = axes.get_legend_handles_labels()
    (handle,) = [one for one, text in zip(handles, labels, strict=True) if text.startswith(label)]
    line = handle[0] if hasattr(handle, "lines") else handle
    return line.get_xdata(), line.get_ydata()


def test_simulated_points_stand_at_their_roll_angles(solved, increaser):
    film, temperature = draw_film_and_temperature(solved).axes
    roll, least = curve(film, "minimum film thickness, simulated")
    contacts = increaser.contacts(np.array([0.13, 0.87]))  # in the order of the tooth
    assert roll == pytest.approx(np.degrees(contacts.roll_angle), rel=1e-12)
    values = [one.figures.film_min.value * 1e6 for one in reversed(solved.solutions)]
    assert least == pytest.approx(values)
    _, blok = curve(temperature, "Blok, simulated friction")
    _, hottest = curve(temperature, "simulated surface")
    assert blok == pytest.approx(hottest, abs=1.0)
    _, contact = curve(temperature, "Blok, friction 0.1")
    assert contact.max() == pytest.approx((429 - 32) / 1.8, abs=0.5)
    _, scuffing = curve(temperature, "mean scuffing temperature")
    assert scuffing[0] == pytest.approx((418 - 32) / 1.8, abs=0.1)


def test_the_line_of_action_shows_loads_and_sliding(solved, increaser):
    load, pressure, velocity, sliding = draw_line_of_action(solved).axes
    _, unit_load = curve(load, "without friction")
    assert unit_load.max() == pytest.approx(
        increaser.normal_force / increaser.teeth.shortest_line / 1e3
    )
    _, rubbed = curve(load, "with friction 0.1")
    assert rubbed.max() > unit_load.max()
    assert pressure.get_ylabel().endswith("MPa")
    roll, pinion = curve(velocity, "pinion")
    _, gear = curve(velocity, "gear")
    pitch = np.degrees(increaser.teeth.pitch_point / increaser.teeth.cylinders[0].base)
    assert np.interp(pitch, roll, pinion - gear) == pytest.approx(0, abs=1e-9)
    _, specific = curve(sliding, "gear")
    assert specific[-1] == pytest.approx(1 - pinion[-1] / gear[-1], rel=1e-9)


def test_a_pair_without_surfaces_has_films_alone(spur):
    bare = replace(spur, surfaces=None, bodies=(STEEL, STEEL))
    result = Result("bare", {}, (), bare.cycle_data(), {})
    (film,) = draw_film_and_temperature(result).axes
    assert film.get_ylabel() == "film thickness $h$ / µm"
    assert len(draw_line_of_action(result).axes) == 4
