"""Forces of the mesh on both shafts and their bearings: balances, published examples, equivalent loads."""

import tomllib
from math import atan, cos, pi, radians, sin, tan

import numpy as np
import pytest
from folders import CASES

import pyworm
from pyworm.case.case import case_of
from pyworm.drives.forces import ShaftForce, Supports
from pyworm.formulas.bearing_life import basic_life
from pyworm.formulas.bearing_load import LoadFactors, equivalent_load, load_factors
from pyworm.io.input_error import CaseError
from pyworm.ratings.rated_case import not_rated, rating_request, ratings

WORM = (CASES / "worm_drawing.toml").read_text()
WORM = WORM.replace("[operation]", '[operation]\nsharing = "equal"')  # no springs are needed
SHAFTS = """
    [drive.shaft]
    bearing_span = "180 mm"
    bearing_offset = "10 mm"
    [drive.wheel_shaft]
    bearing_span = "100 mm"
    """
BEARINGS = """
    [bearings.locating]
    elements = "ball"
    dynamic_rating = "60 kN"
    static_rating = "50 kN"
    shaft = "worm"
    side = "thrust"
    locating = true
    [bearings.floating]
    elements = "roller"
    dynamic_rating = "60 kN"
    shaft = "wheel"
    side = "opposite"
    """


def case_with(*tables: str, text: str = WORM):
    return case_of(tomllib.loads("\n".join((text, *tables))), "loaded", CASES)


@pytest.fixture(scope="module")
def drives():
    helical = (CASES / "spur_pair.toml").read_text()
    changes = {
        'module = "4.5 mm"': 'module = "3.5 mm"\nhelix_angle = "15 deg"',
        "teeth = 16\nprofile_shift = 0.1817": "teeth = 20\nprofile_shift = 0.1809",
        "teeth = 24\nprofile_shift = 0.1715": "teeth = 30\nprofile_shift = 0.0891",
        'face_width = "14 mm"': 'face_width = "23 mm"',
    }
    for spur, changed in changes.items():
        assert spur in helical
        helical = helical.replace(spur, changed)
    return {
        "worm": case_with(SHAFTS).drive,
        "gear-pair": case_of(tomllib.loads(helical), "helical", CASES).drive,
        "roller-worm": pyworm.load(CASES / "roller_ref.toml").drive,
    }


KINDS = ("worm", "gear-pair", "roller-worm")


@pytest.mark.parametrize("kind", KINDS)
def test_forces_on_both_shafts_are_opposite(drives, kind):
    """Crossed shafts exchange tangential and axial parts of the same force; radial ones are equal."""
    first, second = drives[kind].mesh_forces().shafts
    parts = [np.sort(np.abs([f.tangential, f.axial, f.radial])) for f in (first, second)]
    np.testing.assert_allclose(*parts, rtol=1e-12)
    assert first.radial == second.radial < 0  # the shafts are pushed apart


@pytest.mark.parametrize("kind", KINDS)
def test_bearings_balance_forces_and_torques_of_the_mesh(drives, kind):
    """Both bearings' forces, from moments about each, against the equations of a rigid body."""
    for force in drives[kind].mesh_forces().shafts:
        supports = Supports(0.2, 0.015)
        at = np.array([-0.1 + 0.015, 0.1 + 0.015])
        moment = np.array(force.moment)
        # unknown radial and tangential reactions: force and moment balance of the free body
        equations = np.array(
            [[1, 1, 0, 0], [0, 0, 1, 1], [0, 0, -at[0], -at[1]], [at[0], at[1], 0, 0]]
        )
        known = -np.array([force.radial, force.tangential, moment[0], moment[1]])
        radial = np.linalg.solve(equations, known)
        loads = force.bearings(supports)
        expected = np.hypot(radial[:2], radial[2:])
        assert loads["opposite"].radial == pytest.approx(expected[0], rel=1e-12)
        assert loads["thrust"].radial == pytest.approx(expected[1], rel=1e-12)
        assert loads["thrust"].thrust == pytest.approx(max(force.axial, 0))


def test_torques_and_powers_of_a_worm_drive_balance(drives):
    """T_2 as given; T_1 without friction by the ratio, with it as the shared load has it."""
    drive = drives["worm"].with_rigid_shaft
    for driver in ("worm", "wheel"):
        worm, wheel = drive.mesh_forces(0.0, driver).shafts
        assert abs(wheel.torque) == pytest.approx(300, rel=1e-12)
        assert abs(worm.torque) == pytest.approx(300 * 2 / 41, rel=1e-6)
    middle = drive.arms(np.array([0.5]))
    worm = drive.mesh_forces(0.03).shafts[0]
    assert -worm.torque == pytest.approx(
        300 * float((middle.of("worm", 0.03) / middle.of("wheel", 0.03))[0]), rel=1e-12
    )
    driven, driving = (
        abs(drive.mesh_forces(0.03, by).shafts[0].torque) for by in ("wheel", "worm")
    )
    assert driven < 300 * 2 / 41 < driving


def test_the_bent_shaft_has_the_same_bearing_forces(drives):
    drive = drives["worm"]
    loads = drive.mesh_forces().on("worm").bearings(drive.supports["worm"])
    bent = drive.shaft_deflection
    assert bent.reactions == pytest.approx(
        (loads["opposite"].radial, loads["thrust"].radial), rel=1e-12
    )
    assert bent.force[2] == pytest.approx(loads["thrust"].thrust)


def test_the_worm_gear_of_mott():
    """R. L. Mott, Machine Elements in Mechanical Design, 4th ed., p. 480: 962, 265 and 352 lb on the gear.

    Three threads, 52 teeth of diametral pitch 6, D_W 2.000 in, 20 deg in the axial section, T 4168 lb in,
    mu 0.022. The book's forces act at the pitch point, these in mid-mesh, where the pressure angle differs.
    """
    inch, pound = 25.4e-3, 4.4482216
    changes = {
        'profile = "ZI"': 'profile = "ZA"',
        'centre_distance = "100 mm"': f'centre_distance = "{(2 + 52 / 6) / 2 * 25.4} mm"',
        "threads = 2": "threads = 3",
        "teeth = 41": "teeth = 52",
        'module = "4 mm"': f'module = "{25.4 / 6} mm"',
        "diameter_factor = 10": "diameter_factor = 12",
        '"300 Nm"': f'"{4168 * pound * inch} N m"\nfriction = 0.022',
    }
    text = WORM
    for drawn, book in changes.items():
        assert drawn in text
        text = text.replace(drawn, book)
    wheel = case_with(text=text).drive.mesh_forces().on("wheel")
    assert abs(wheel.torque) == pytest.approx(4168 * pound * inch)
    forces = np.abs([wheel.tangential, wheel.axial, wheel.radial]) / pound
    assert forces == pytest.approx([962, 265, 352], rel=0.03)
    # and at the pitch point by the book's formulas, to its rounding
    lead, friction = atan(0.25), 0.022
    normal = atan(tan(radians(20)) * cos(lead))
    held = cos(normal) * cos(lead) - friction * sin(lead)
    axial = 962 * (cos(normal) * sin(lead) + friction * cos(lead)) / held
    assert [axial, 962 * sin(normal) / held] == pytest.approx([265, 352], abs=0.7)


def test_helical_gears_as_in_the_report_h501_of_gearpie(drives):
    """github.com/cfernandesFEUP/GEARpie, REPORT/H501.txt: 5464.5, 2220.6 and 1479.0 N at 200 N m."""
    pinion, gear = drives["gear-pair"].mesh_forces().shafts
    forces = np.abs([pinion.tangential, pinion.radial, pinion.axial])
    assert forces == pytest.approx([5464.5, 2220.6, 1479.0], abs=0.1)
    assert abs(gear.torque) == pytest.approx(300, rel=1e-5)
    other = drives["gear-pair"].mesh_forces(driver="gear").shafts[0]
    assert other == pinion.reversed and other.axial < 0


def test_the_roller_drive_balances_its_power(drives):
    """By the meshing equation the worm's torque is the wheel's over the ratio, roller by roller."""
    worm, wheel = drives["roller-worm"].mesh_forces().shafts
    assert abs(worm.torque) == pytest.approx(5000 / (1500 * pi / 30), rel=1e-9)
    assert abs(wheel.torque) == pytest.approx(35 * abs(worm.torque), rel=1e-9)
    with pytest.raises(ValueError, match='"wheel": must be one of "worm"'):
        drives["roller-worm"].mesh_forces(driver="wheel")


def test_the_other_rotation_pushes_to_the_other_bearing():
    force = ShaftForce("worm", -1.0, -2.0, 3.0, (0.1, 0.2, -0.3))
    there, back = (f.bearings(Supports(1.0)) for f in (force, force.reversed))
    assert there["thrust"].radial == back["opposite"].radial
    # whichever of both locates takes the thrust
    assert {bearing.thrust for loads in (there, back) for bearing in loads.values()} == {3}
    assert force.reversed.reversed == force
    with pytest.raises(ValueError, match="bearing_offset is 500 mm; it must be less than half"):
        Supports(1.0, 0.5)


def test_equivalent_load_and_life_of_jindal():
    """U. C. Jindal, Machine Design, example 18-2: 1250 and 625 N with X 0.56, Y 1.2, C 5590 N: 57.3 Mrev."""
    load = equivalent_load(1250.0, 625.0, LoadFactors(0.4, 0.56, 1.2))
    assert basic_life(5590.0, load, "ball") == pytest.approx(57.3e6, rel=1e-3)
    assert equivalent_load(1250.0, 0.4 * 1250.0, LoadFactors(0.4, 0.56, 1.2)) == 1250.0


@pytest.mark.parametrize(
    ("elements", "angle", "thrust"),
    [("ball", 0, share) for share in (0.014, 0.05, 0.084, 0.2, 0.42, 0.56)]
    + [("ball", angle, 1) for angle in (20, 25, 30, 35, 40, 45)]
    + [("roller", angle, 1) for angle in (10, 14, 25)],
)
def test_the_equivalent_load_has_no_step(elements, angle, thrust):
    """X + e Y is 1 where the thrust begins to count."""
    factors = load_factors(elements, radians(angle), thrust, 1.0)
    assert factors.radial + factors.limit * factors.thrust == pytest.approx(1, abs=0.02)
    assert factors.limit > 0 and factors.thrust >= 0.5


@pytest.mark.parametrize(
    ("arguments", "right"),
    [
        (("roller", 0.0, 1.0, None), "take no thrust"),
        (("ball", 0.0, 1.0, None), "static_rating is missing"),
        (("ball", 0.1, 1.0, 1.0), "must lie between 20 and 45 deg"),
        (("roller", 1.0, 1.0, None), "must lie between 5 and 45 deg"),
    ],
)
def test_bearings_that_take_no_thrust_are_refused(arguments, right):
    with pytest.raises(ValueError, match=right):
        load_factors(*arguments)


@pytest.fixture(scope="module")
def rated():
    request = rating_request(case_with(SHAFTS, BEARINGS))
    return request, {rating.key: rating for rating in ratings(request)}


def test_bearings_take_their_load_from_the_shaft(rated):
    request, found = rated
    forces = found["forces"]
    assert forces.columns == ("standard",)
    values = {figure.key: figure.values[0] for figure in forces.figures}
    radial, thrust = values["worm_thrust_bearing_radial_N"], values["worm_bearing_thrust_N"]
    assert thrust == pytest.approx(values["worm_drives_worm_axial_N"])
    locating = {figure.key: figure.values[0] for figure in found["bearing locating"].figures}
    factors = load_factors("ball", 0.0, thrust, 50e3)
    load = equivalent_load(radial, thrust, factors)
    assert locating["equivalent_load_N"] == pytest.approx(load)
    assert locating["basic_life_rev"] == pytest.approx(basic_life(60e3, load, "ball"))
    hours = locating["basic_life_rev"] / 1500 / 60
    assert locating["basic_life_h"] == pytest.approx(hours)
    floating = {figure.key: figure.values[0] for figure in found["bearing floating"].figures}
    assert floating["equivalent_load_N"] == values["wheel_opposite_bearing_radial_N"]
    assert "with the friction of the standard" in found["bearing locating"].words[0]
    # at starting friction is larger, so the driving worm needs more and the driven one gets less
    for driver, more in (("worm", 1), ("wheel", -1)):
        running, starting = (
            values[f"{driver}_drives_{state}worm_torque_N_m"] for state in ("", "starting_")
        )
        assert more * (starting - running) > 0
    assert not [line for line in not_rated(request, tuple(found.values())) if "Forces" in line]


def test_a_given_load_is_taken_and_said(rated):
    typed = BEARINGS.replace('shaft = "worm"', 'load = "5 kN"\n    shaft = "worm"')
    found = {rating.key: rating for rating in ratings(rating_request(case_with(SHAFTS, typed)))}
    locating = found["bearing locating"]
    assert locating.figures[0].values == (5e3,)
    assert locating.words[0] == (
        "The load of 5000 N is given and is taken, not that of the worm shaft."
    )


def test_factors_of_a_catalogue_are_taken():
    given = BEARINGS.replace(
        'static_rating = "50 kN"', "thrust_limit = 0.3\nradial_factor = 0.5\nthrust_factor = 1.0"
    )
    found = {rating.key: rating for rating in ratings(rating_request(case_with(SHAFTS, given)))}
    values = {figure.key: figure.values[0] for figure in found["forces"].figures}
    load = 0.5 * values["worm_thrust_bearing_radial_N"] + values["worm_bearing_thrust_N"]
    assert found["bearing locating"].figures[0].values[0] == pytest.approx(load)
    thrust = BEARINGS.replace('side = "thrust"', 'side = "thrust"\ndirection = "thrust"')
    found = {rating.key: rating for rating in ratings(rating_request(case_with(SHAFTS, thrust)))}
    assert found["bearing locating"].figures[0].values[0] == values["worm_bearing_thrust_N"]


def test_a_locating_bearing_takes_the_thrust_on_either_side():
    other = BEARINGS.replace('side = "thrust"', 'side = "opposite"')
    found = {rating.key: rating for rating in ratings(rating_request(case_with(SHAFTS, other)))}
    values = {figure.key: figure.values[0] for figure in found["forces"].figures}
    radial, thrust = values["worm_opposite_bearing_radial_N"], values["worm_bearing_thrust_N"]
    load = equivalent_load(radial, thrust, load_factors("ball", 0.0, thrust, 50e3))
    assert found["bearing locating"].figures[0].values[0] == pytest.approx(load)
    assert load > thrust


def test_a_locked_worm_is_said():
    text = WORM.replace("threads = 2", "threads = 1").replace("teeth = 41", "teeth = 40")
    text = text.replace('centre_distance = "100 mm"', 'centre_distance = "98 mm"')
    found = {rating.key: rating for rating in ratings(rating_request(case_with(text=text)))}
    values = {figure.key: figure.values[0] for figure in found["forces"].figures}
    assert values["wheel_drives_starting_worm_torque_N_m"] < 0
    assert any("cannot drive it" in words for words in found["forces"].words)


@pytest.mark.parametrize(
    ("change", "right"),
    [
        (('shaft = "worm"', ""), "bearings.locating"),
        (('side = "thrust"', ""), "give shaft and side together"),
        (
            ("locating = true", "thrust_limit = 0.3"),
            "thrust_limit, radial_factor and thrust_factor",
        ),
    ],
)
def test_half_of_a_bearing_is_refused(change, right):
    with pytest.raises(CaseError) as refused:
        case_with(SHAFTS, BEARINGS.replace(*change, 1))
    assert right in str(refused.value)


def test_shafts_that_are_not_there_are_not_rated():
    other = BEARINGS.replace('shaft = "wheel"', 'shaft = "pinion"')
    request = rating_request(case_with(other))
    sentences = not_rated(request, ratings(request))
    assert any("the distance of the worm shaft's bearings" in line for line in sentences)
    assert any('"pinion": must be one of "worm", "wheel"' in line for line in sentences)


def test_bearings_without_a_drive_have_no_shaft():
    from pyworm.ratings.rated_case import load_rating_request

    with pytest.raises(
        CaseError, match=r"bearings.locating.shaft has no effect without a \[drive\]"
    ):
        load_rating_request({"title": "a", "source": "b", **tomllib.loads(BEARINGS)})


def test_gears_and_check_show_forces():
    from pyworm.batch.check import check

    case = pyworm.load(CASES / "spur_pair.toml")
    found = {rating.key: rating for rating in ratings(rating_request(case))}
    assert found["forces"].columns == ("computed",) and len(found["forces"].figures) == 8
    summary = check(case, phases=[0.5]).summary()
    assert [forces["driver"] for forces in summary["forces"]] == ["pinion", "gear"]
    assert summary["forces"][0]["pinion"]["tangential_N"] == pytest.approx(-5464.5, abs=0.1)
    assert summary["drive"]["pinion_over_balls_m"] > summary["drive"]["pinion_tip_diameter_m"]
