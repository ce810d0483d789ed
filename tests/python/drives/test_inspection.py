"""Inspection sheet: balls and wires touch the flanks themselves, closed forms, published sheets."""

import tomllib
from dataclasses import replace
from math import atan, atan2, cos, degrees, hypot, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
import scipy
from folders import CASES
from worm_drawings import of_profile
from zi_drives import coarse_patterns, coarse_springs, without_allowed_errors

from pyworm.case.case import case_of
from pyworm.drives.gear_pair.gears import (
    Gear,
    InvolutePair,
    ToothSystem,
    inverse_involute,
    involute,
)
from pyworm.drives.gear_pair.inspection import (
    MeasuredGear,
    PairInspection,
    normal_backlash,
    tooth_measures,
)
from pyworm.drives.gear_pair.inspection import (
    backlash_limits as pair_backlash_limits,
)
from pyworm.drives.worm.flanks.ruled_helicoid import RuledHelicoid
from pyworm.drives.worm.inspection import (
    AS_DRAWN,
    Inspection,
    backlash_limits,
    reference_ball,
    seated_ball,
    wheel_chord,
    worm_chord,
)
from pyworm.drives.worm.patterns.hob_setting import drawn_gears
from pyworm.drives.worm.teeth.tooth_form import wheel_thickness, worm_thickness
from pyworm.io.input_error import CaseError

PROFILES = ("ZA", "ZN", "ZI", "ZK", "ZC", "ZC2")

INCH = 25.4e-3


@pytest.fixture(scope="module", params=PROFILES)
def worm(request):
    return drawn_gears(replace(of_profile(request.param, hob_oversize=1.6e-3), hob_swivel=0.004))


def flank_of(gears):
    """The curve that sweeps the worm's flank, for an involute worm its generating line."""
    flank = gears.worm_flank
    if gears.worm.profile != "ZI":
        return flank.generator
    return RuledHelicoid(flank.base_radius, flank.screw / flank.base_radius, flank.screw)


def flank_points(gears, radius, turn):
    """Points of the flank by radius, at turns from the axial plane, (3, radii, turns)."""
    generator = flank_of(gears)
    u = generator.at_radius(np.asarray(radius, float))
    x, y, _ = generator.curve(u)[0]
    return generator.point(u, turn - np.arctan2(y, x))


def ball_in_space(gears, ball):
    """Centre of a ball in the middle of the space at polar angle zero, (3,)."""
    reference = gears.reference_radius
    at_reference = flank_points(gears, reference, 0.0)[2]
    space = gears.worm.axial_pitch - worm_thickness(gears, reference)
    return np.array([ball.centre_radius, 0.0, float(at_reference) - space / 2])


def nearest(distance, gears):
    """Least of a distance over the flank, with radius and turn where it is."""
    radii = np.linspace(gears.worm_tooth.start_radius, gears.worm.tip_radius, 41)[:, None]
    turns = np.linspace(-0.4, 0.4, 81)
    grid = distance(flank_points(gears, radii, turns))
    row, column = np.unravel_index(np.argmin(grid), grid.shape)
    found = scipy.optimize.minimize(
        lambda q: float(distance(flank_points(gears, q[0], q[1]))) * 1e3,
        [radii[row, 0], turns[column]],
        method="Nelder-Mead",
        options={"xatol": 1e-11, "fatol": 1e-12},
    )
    return found.fun * 1e-3, found.x


def test_the_ball_touches_the_flank_and_is_nowhere_in_it(worm):
    ball = seated_ball(worm, 6.8e-3)
    centre = ball_in_space(worm, ball)
    apart, (radius, _) = nearest(
        lambda point: np.linalg.norm(np.moveaxis(point, 0, -1) - centre, axis=-1), worm
    )
    assert apart == pytest.approx(ball.diameter / 2, abs=1e-10)
    assert radius == pytest.approx(ball.contact_radius, abs=1e-7)
    assert ball.over == pytest.approx(2 * centre[0] + 6.8e-3)


def test_a_wire_lies_where_the_ball_does(worm):
    """A straight wire square to radius and normal touches the flank where the ball does, and nowhere else."""
    ball = seated_ball(worm, None)
    centre = ball_in_space(worm, ball)
    _, (radius, turn) = nearest(
        lambda point: np.linalg.norm(np.moveaxis(point, 0, -1) - centre, axis=-1), worm
    )
    along = np.cross([1.0, 0.0, 0.0], flank_points(worm, radius, turn) - centre)
    along /= np.linalg.norm(along)

    def from_wire(point):
        return np.linalg.norm(np.cross(np.moveaxis(point, 0, -1) - centre, along), axis=-1)

    assert nearest(from_wire, worm)[0] == pytest.approx(ball.diameter / 2, abs=1e-10)


def test_the_ball_of_the_reference_cylinder_touches_there(worm):
    ball = seated_ball(worm, reference_ball(worm))
    assert ball.contact_radius == pytest.approx(worm.reference_radius, abs=1e-12)
    assert seated_ball(worm, None).diameter == pytest.approx(reference_ball(worm), rel=8e-3)
    assert seated_ball(worm, 5e-3) is None and seated_ball(worm, 12e-3) is None


def test_involute_worms_follow_the_formula_of_helical_gears():
    """inv alpha_K = s_t/d + inv alpha_t + D/(d_b cos beta_b) - pi/z with beta = 90 deg - gamma."""
    gears = drawn_gears(replace(of_profile("ZI", hob_oversize=1.6e-3), hob_swivel=0.004))
    threads, diameter, ball = 2, 2 * gears.reference_radius, 6.8e-3
    helix = pi / 2 - atan(0.2)
    transverse = atan(tan(radians(20)) / cos(helix))
    base, tilt = diameter * cos(transverse), cos(gears.worm.base_lead_angle - pi / 2)
    thickness = worm_thickness(gears, diameter / 2) / tan(atan(0.2))
    value = thickness / diameter + involute(transverse) + ball / (base * tilt) - pi / threads
    over = base / cos(inverse_involute(value)) + ball
    assert seated_ball(gears, ball).over == pytest.approx(over, abs=1e-12)


def test_the_worm_s_chord_is_that_of_the_caliper_formula(worm):
    """s_n within 0.1 um, and h_a + s_n^2 sin^2(gamma)/(4 d), the formulas of AGMA and DIN 3975."""
    chord, lead_angle = worm_chord(worm), atan(0.2)
    normal = worm_thickness(worm, worm.reference_radius) * cos(lead_angle)
    assert chord.thickness == pytest.approx(normal, abs=1e-7)
    height = normal**2 * sin(lead_angle) ** 2 / (8 * worm.reference_radius)
    addendum = worm.worm.tip_radius - worm.reference_radius
    assert chord.height == pytest.approx(addendum + height, abs=1e-7)


def test_the_wheel_s_chord_is_near_that_of_its_normal_thickness(worm):
    chord, lead_angle = wheel_chord(worm), atan(0.2)
    reference, thickness = worm.wheel_reference_radius, wheel_thickness(worm)
    assert chord.thickness == pytest.approx(thickness * cos(lead_angle), rel=5e-3)
    across = chord.thickness * cos(lead_angle) / 2
    height = worm.wheel.throat_radius - sqrt(reference**2 - across**2)
    assert chord.height == pytest.approx(height, abs=1e-9)


def test_tolerances_widen_the_backlash():
    """Thin worm and wheel by their deviations, a longer centre distance by 2 tan(alpha_x) of it."""
    gears = drawn_gears(replace(of_profile("ZI", hob_oversize=1.6e-3), hob_swivel=0.004))
    thin = Inspection(worm_thickness=(-0.08e-3, -0.04e-3), wheel_thickness=(-0.05e-3, 0.0))
    nominal = gears.wheel.backlash
    assert backlash_limits(gears, thin) == pytest.approx((nominal + 0.04e-3, nominal + 0.13e-3))
    apart = backlash_limits(gears, Inspection(centre_distance=(-0.02e-3, 0.02e-3)))
    spread = 2 * 0.04e-3 * tan(radians(20)) / cos(atan(0.2))
    assert apart[1] - apart[0] == pytest.approx(spread, rel=0.1)
    assert backlash_limits(gears, AS_DRAWN) is None
    unknown = replace(gears, wheel=replace(gears.wheel, backlash=None))
    assert backlash_limits(unknown, thin) is None


def pair(teeth, module, shift=0.0, helix=0.0, addendum=1.0, width=50e-3):
    """Two equal gears with 20 deg, without backlash."""
    gear = Gear(teeth, shift, addendum)
    equal = InvolutePair(ToothSystem(module, radians(20), radians(helix)), gear, gear, 1.0, width)
    return replace(equal, centre_distance=equal.tight_centre_distance)


def test_chords_of_the_sheet_of_sdp_si():
    """Elements of Metric Gear Technology, SDP/SI, page T-81, tables 10-1 and 10-3; heights less h_a."""
    spur = tooth_measures(pair(12, 10e-3, 0.3), 0, MeasuredGear())
    assert 1e3 * spur.thickness == pytest.approx(17.8918, abs=5e-5)
    assert 1e3 * spur.chordal_thickness == pytest.approx(17.8256, abs=5e-5)
    sized = pair(12, 10e-3, 0.3)
    addendum = sized.cylinders[0].tip - sized.cylinders[0].reference
    assert 1e3 * (spur.chordal_height - addendum) == pytest.approx(13.6657 - 13.0, abs=5e-5)
    helical = pair(16, 5e-3, 0.2, 25)
    found = tooth_measures(helical, 0, MeasuredGear())
    assert 1e3 * found.thickness == pytest.approx(8.5819, abs=5e-5)
    assert 1e3 * found.chordal_thickness == pytest.approx(8.5728, abs=5e-5)
    addendum = helical.cylinders[0].tip - helical.cylinders[0].reference
    # the table bends the normal section to a circle by the virtual number of teeth
    assert 1e3 * (found.chordal_height - addendum) == pytest.approx(6.1712 - 6.0, abs=5e-4)


def test_pins_as_gearcutter_has_them():
    """127 teeth of DP 12, 20 deg, helix 10.5 deg, pins of 0.144 in: 10.967749 in.

    Quoted as the AGMA and GearCutter reference in a public report on measurement over pins.
    """
    found = tooth_measures(pair(127, INCH / 12, helix=10.5), 0, MeasuredGear(0.144 * INCH))
    assert found.thickness / INCH == pytest.approx(0.1309, abs=1e-6)
    assert found.over_pins / INCH == pytest.approx(10.967749, abs=1e-6)
    assert found.over_balls < found.over_pins


def test_the_worm_gear_of_a_sheet_by_din_3975():
    """A workshop's sheet, "Worm gear pairs - axial module, as per DIN 3975:1975" (scribd.com 424562372)."""
    text = (CASES / "worm_drawing.toml").read_text()
    sheet = {
        'centre_distance = "100 mm"': 'centre_distance = "67 mm"',
        "teeth = 41": "teeth = 30",
        'module = "4 mm"': 'module = "3.028287687 mm"',
        "diameter_factor = 10": "diameter_factor = 14.529663149",
    }
    for drawn, written in sheet.items():
        assert drawn in text
        text = text.replace(drawn, written)
    with pytest.MonkeyPatch.context() as patch:
        coarse_patterns(patch)
        coarse_springs(patch)
        without_allowed_errors(patch)
        found = case_of(tomllib.loads(text), "sheet", CASES).drive.geometry_table()
    lengths = {
        "lead_m": 19.0272927009,
        "axial_pitch_m": 9.5136463504,
        "normal_module_m": 3.0,
        "worm_reference_diameter_m": 44.0,
        "worm_tip_diameter_m": 50.0565753844,
        "worm_root_diameter_m": 36.7321095616,
        "wheel_reference_diameter_m": 90.84863061,
    }
    for key, millimetres in lengths.items():
        assert 1e3 * found[key] == pytest.approx(millimetres, abs=1e-6)
    assert found["lead_angle_deg"] == pytest.approx(7.837479761, abs=1e-8)
    assert found["profile_shift"] == pytest.approx(-0.14012, abs=5e-6)
    assert 0 < found["face_coverage"] <= 1


def touching(pair, centre, ball):
    """Distance of a ball's centre in a space's middle from an involute helicoid of the pinion."""
    system, size, gear = pair.system, pair.cylinders[0], pair.pinion
    half = (pi / 2 + 2 * gear.profile_shift * tan(system.pressure_angle)) / gear.teeth
    half += involute(system.transverse_pressure_angle)

    def apart(q):
        roll, along = q
        polar = (
            half
            - (roll - atan(roll))
            - pi / gear.teeth
            + along * tan(system.base_helix_angle) / size.base
        )
        radius = size.base * hypot(1, roll)
        return hypot(radius * cos(polar) - centre, radius * sin(polar), along) * 1e3

    found = scipy.optimize.minimize(
        apart, [0.5, 0.0], method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-12}
    )
    return found.fun * 1e-3 - ball / 2


@pytest.mark.parametrize(("teeth", "helix"), [(20, 0), (21, 0), (20, 15), (21, 30)])
def test_balls_of_gears_touch_the_involute_helicoid(teeth, helix):
    gears = pair(teeth, 3.5e-3, 0.18, helix)
    found = tooth_measures(gears, 0, MeasuredGear(6e-3))
    odd = cos(pi / (2 * teeth)) if teeth % 2 else 1.0
    centre = (found.over_balls - 6e-3) / (2 * odd)
    assert touching(gears, centre, 6e-3) == pytest.approx(0, abs=1e-10)
    touch = tooth_measures(gears, 0, MeasuredGear()).ball_diameter
    assert 1.5 < touch / 3.5e-3 < 2.2


@pytest.mark.parametrize("helix", [0, 15])
def test_spans_are_base_pitches_and_a_base_thickness(helix):
    """W_k = (k - 1) p_bn + s_bn, two involutes apart along a common normal."""
    gears = pair(24, 4.5e-3, 0.17, helix)
    found = tooth_measures(gears, 0, MeasuredGear())
    system, size = gears.system, gears.cylinders[0]
    half = (pi / 2 + 2 * 0.17 * tan(system.pressure_angle)) / 24
    base = 2 * size.base * (half + involute(system.transverse_pressure_angle))
    normal = cos(system.base_helix_angle)
    span = (found.span_teeth - 1) * system.base_pitch * normal + base * normal
    assert found.span == pytest.approx(span, rel=1e-12)
    touched = hypot(size.base, found.span * normal / 2)
    assert size.root < touched < size.tip
    one_less = tooth_measures(gears, 0, MeasuredGear(span_teeth=found.span_teeth - 1))
    assert found.span - one_less.span == pytest.approx(system.base_pitch * normal)
    narrow = replace(gears, face_width=5e-3)
    assert (tooth_measures(narrow, 0, MeasuredGear()).span is None) == (helix > 0)
    assert tooth_measures(gears, 0, MeasuredGear(2e-3)).over_balls is None


def test_backlash_of_gears_by_thickness_and_centre_distance():
    """j_bn = -(A_1 + A_2) cos(alpha_n) of thicknesses, 2 da sin(alpha_wt) cos(beta_b) of the distance."""
    gears = pair(24, 4.5e-3, 0.1, 15)
    thin = MeasuredGear(thickness=(-0.1e-3, -0.04e-3))
    limits = pair_backlash_limits(gears, PairInspection(thin, thin))
    to_normal = cos(gears.pressure_angle) * cos(gears.system.base_helix_angle)
    assert [limit * to_normal for limit in limits] == pytest.approx(
        [0.08e-3 * cos(radians(20)), 0.2e-3 * cos(radians(20))], rel=1e-9
    )
    apart = pair_backlash_limits(gears, PairInspection(centre_distance=(0.0, 0.03e-3)))
    wider = replace(gears, centre_distance=gears.centre_distance + 0.03e-3)
    normal = 2 * 0.03e-3 * sin(gears.pressure_angle) * cos(gears.system.base_helix_angle)
    assert apart[0] == pytest.approx(0, abs=1e-15)
    assert normal_backlash(wider) == pytest.approx(normal, rel=1e-3)
    assert pair_backlash_limits(gears, PairInspection()) is None


@pytest.mark.parametrize(
    ("case", "inspection", "right"),
    [
        (
            "worm_drawing",
            'worm_thickness = ["0 mm", "-0.1 mm"]',
            "drive.inspection.worm_thickness is [0, -0.1] mm",
        ),
        (
            "spur_pair",
            'centre_distance = ["1 mm", "0 mm"]',
            "drive.inspection.centre_distance is [1, 0] mm",
        ),
        (
            "spur_pair",
            'pinion.thickness = ["1 mm", "0 mm"]',
            "drive.inspection.pinion.thickness is [1, 0] mm",
        ),
        ("spur_pair", "pinion.span_teeth = 0", "drive.inspection.pinion.span_teeth"),
    ],
)
def test_deviations_in_the_wrong_order_are_refused(case, inspection, right):
    text = (CASES / f"{case}.toml").read_text()
    with pytest.raises(CaseError, match="inspection") as refused:
        case_of(tomllib.loads(f"{text}\n[drive.inspection]\n{inspection}\n"), case, CASES)
    assert right in str(refused.value)


def test_the_sheet_takes_what_the_drawing_gives():
    text = (CASES / "spur_pair.toml").read_text()
    given = """
        [drive.inspection]
        centre_distance = ["-0.02 mm", "0.02 mm"]
        [drive.inspection.pinion]
        ball_diameter = "8 mm"
        span_teeth = 2
        thickness = ["-0.12 mm", "-0.08 mm"]
        """
    found = case_of(tomllib.loads(text + given), "spur", CASES).drive.geometry_table()
    assert found["pinion_ball_diameter_m"] == 8e-3 and found["pinion_span_teeth"] == 2
    assert found["least_backlash_m"] < 0.08e-3 < 0.12e-3 < found["largest_backlash_m"]
    # FZG C gears, github.com/cfernandesFEUP/GEARpie, REPORT/C14.txt
    radii = {
        "root": (31.193, 49.147),
        "reference": (36.0, 54.0),
        "pitch": (36.6, 54.9),
        "tip": (41.228, 59.182),
    }
    for name, both in radii.items():
        for gear, radius in zip(("pinion", "gear"), both, strict=True):
            assert 5e2 * found[f"{gear}_{name}_diameter_m"] == pytest.approx(radius, abs=5e-4)
    assert found["transverse_contact_ratio"] == pytest.approx(1.44, abs=5e-3)
    assert "pinion_lead_m" not in found and found["face_coverage"] == 1


def test_a_crowned_contact_covers_part_of_the_face():
    text = (CASES / "spur_pair.toml").read_text()
    point = 'kind = "gear-pair"\ncontact = "point"\nlead_crowning = "20 um"'
    drive = case_of(tomllib.loads(text.replace('kind = "gear-pair"', point)), "spur", CASES).drive
    semi_axis = 0.7 * 14e-3 / 2  # of the dry contact, by the report's 5.9 kN at the pitch point
    assert drive.geometry_table()["face_coverage"] * 7e-3 == pytest.approx(semi_axis, rel=0.5)


def test_roller_worms_have_a_sheet(roller):
    found = roller.geometry_table()
    assert found["worm_throat_diameter_m"] == pytest.approx(64e-3)  # 0.4 of 160 mm
    assert found["contact_ratio"] == pytest.approx(55 / 360 * 35)
    assert found["lead_angle_deg"] == pytest.approx(degrees(atan2(128 / 35, 32)))
    assert set(roller.sheet) <= set(found)


@pytest.fixture
def roller():
    text = (CASES / "roller_ref.toml").read_text()
    return case_of(tomllib.loads(text), "roller", CASES).drive
