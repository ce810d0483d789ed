"""Variants of the roller drive, cases/rollers: envelopes by a distance that is minimised, limits, mirrors."""

from math import pi

import numpy as np
import pytest
from evidence_data import read
from folders import CASES, ROOT
from roller_sections import CENTRE_DISTANCE, envelope
from scipy.optimize import minimize_scalar

import pyworm
from pyworm.drives.roller_worm.envelope import RollerEnvelope
from pyworm.drives.roller_worm.meridian import Meridian
from pyworm.drives.roller_worm.profile import RollerProfile

VARIANTS = sorted(path.stem for path in (CASES / "rollers").glob("*.toml"))
ANGLES = np.radians([-50.0, -20.0, 7.0, 55.0])
PLACES = np.array([-5e-3, -1e-3, 0.0, 4e-3])[:, None]


@pytest.fixture(scope="module", params=VARIANTS)
def drive(request):
    return pyworm.load(CASES / "rollers" / f"{request.param}.toml").drive


def outside(flank, point, angle):
    """Distance of a point of the worm's frame from the roller at a wheel angle, negative within [m].

    By the meridian alone: the nearest of its points is searched, without normals or derivatives.
    """
    x, y, z = flank.from_worm(point, np.asarray(angle))
    radial = x * np.sin(angle) + y * np.cos(angle) - flank.pitch_radius
    going, up = x * np.cos(angle) - y * np.sin(angle), z - flank.height
    along = radial * np.cos(flank.tilt) + up * np.sin(flank.tilt)
    away = np.hypot(going, up * np.cos(flank.tilt) - radial * np.sin(flank.tilt))

    def squared(place):
        return (place - along) ** 2 + (away - float(flank.profile(np.array(place))[0])) ** 2

    half = flank.profile.length / 2
    low, high = np.clip(along + np.array([-1e-3, 1e-3]), -half, half)
    if low < high:
        place = minimize_scalar(
            squared, bounds=(low, high), method="bounded", options={"xatol": 1e-10}
        ).x
    else:
        place = low
    inside = abs(along) < half and away < float(flank.profile(np.array(along))[0])
    return (-1 if inside else 1) * np.sqrt(squared(place))


def test_the_worm_touches_every_roller_and_is_nowhere_cut(drive):
    """The minimum distance over the family of rollers is zero, and it lies where the contact is computed."""
    for section in drive.sections.values():
        flank = section.envelope
        for fraction, place in ((0.1, section.lowest), (0.5, 1e-3), (0.9, section.highest)):
            angle = float(section.wheel_angle(fraction))
            point = flank.worm_point(np.array(place), np.array(angle))
            nearest = minimize_scalar(
                lambda phi, point=point, flank=flank: outside(flank, point, phi),
                (angle - 3e-3, angle + 1e-3),
                options={"xtol": 1e-7},
            )
            assert nearest.x == pytest.approx(angle, abs=2e-6)
            assert abs(nearest.fun) < 1e-10
            # the same rollers far away, on the other side and in front, stay outside
            passing = np.concatenate(
                [angle + np.linspace(-0.3, -0.01, 12), angle + np.linspace(0.01, 0.3, 12)]
            )
            assert min(outside(flank, point, phi) for phi in passing) > 0


def test_surfaces_meet_without_approach_along_the_normal(drive):
    """n . v = 0 by differences of positions, and the worm's own normal by differences of its points."""
    step = 1e-6
    for section in drive.sections.values():
        flank, angle = section.envelope, section.wheel_angle(np.array([0.05, 0.6]))
        place = np.array([section.lowest, section.middle, section.highest])[:, None]
        contact = flank.contact(place, angle)
        fixed = flank.into_worm(contact.point, contact.wheel_angle)
        worm = flank.from_worm(fixed, contact.wheel_angle + step)
        worm = (worm - flank.from_worm(fixed, contact.wheel_angle - step)) / (2 * step)
        x, y, _ = contact.point
        wheel = np.array([y, -x, np.zeros_like(x)])
        assert np.abs(((worm - wheel) * contact.normal).sum(axis=0)).max() < 1e-8 * CENTRE_DISTANCE
        sides = flank.worm_point(place + step, angle) - flank.worm_point(place - step, angle)
        onward = flank.worm_point(place, angle + step) - flank.worm_point(place, angle - step)
        normal = np.cross(sides, onward, axis=0)
        normal /= np.linalg.norm(normal, axis=0)
        seen = flank.into_worm(contact.point + contact.normal, contact.wheel_angle) - fixed
        assert np.abs((normal * seen).sum(axis=0)) == pytest.approx(1, abs=1e-8)


def same(one, other, tolerance):
    """Contacts of two flanks agree; lengths are compared over a millimetre, curvatures relatively."""
    one, other = (flank.contact(PLACES, ANGLES) for flank in (one, other))
    assert np.abs(one.point - other.point).max() < tolerance * 1e-3
    assert np.abs(one.curvature / other.curvature - 1).max() < tolerance
    assert np.abs(one.normal - other.normal).max() < tolerance


def revolved(radius, **meridian):
    """The reference flank of a roller with a meridian of its own."""
    profile = RollerProfile(radius, 14e-3, "revolved", meridian=Meridian(**meridian))
    return envelope(radius=radius, profile=profile)


@pytest.mark.parametrize(
    ("meridian", "options", "tolerance"),
    [
        ({"formula": "0 * s"}, {}, 1e-12),
        ({"formula": "0.15 * s"}, {"shape": "cone", "half_angle": np.arctan(0.15)}, 1e-12),
        ({"formula": "sqrt(radius^2 - s^2) - radius"}, {"shape": "ball", "radius": 8e-3}, 1e-12),
        (
            {"formula": "(radius*radius - s*s)^0.5 - radius"},
            {"shape": "ball", "radius": 8e-3},
            1e-12,
        ),
    ],
)
def test_a_profile_in_closed_form_is_the_shape_that_it_describes(meridian, options, tolerance):
    same(revolved(options.get("radius", 6.5e-3), **meridian), envelope(**options), tolerance)


def test_points_on_a_line_are_a_cylinder_and_points_on_a_circle_come_to_a_ball():
    line = np.linspace(-7e-3, 7e-3, 5)
    same(revolved(6.5e-3, places=tuple(line), rises=(0.0,) * 5), envelope(), 1e-12)
    errors = []
    for count in (21, 41):
        places = np.linspace(-7e-3, 7e-3, count)
        rises = np.sqrt(64e-6 - places**2) - 8e-3
        points = revolved(8e-3, places=tuple(places), rises=tuple(rises))
        radius = points.profile(PLACES)[0]
        errors.append(np.abs(radius - np.sqrt(64e-6 - PLACES**2)).max())
    # a cubic spline: half the distance, a sixteenth of the error
    assert errors[1] < 2e-8 and 8 < errors[0] / errors[1] < 40


def test_a_formula_has_the_derivatives_of_its_function():
    place, radius, length = np.linspace(-6e-3, 6e-3, 7), 6.5e-3, 14e-3
    formula = Meridian(
        "1e-5*cosh(s/0.004) - 2e-6*sin(300*s)/exp(s) + log(1 + s/length)^2*1e-4 - -s^3"
    )
    rise, slope, bend = formula(place, radius, length)
    h = 1e-6

    def exact(s):
        wave = 1e-5 * np.cosh(s / 0.004) - 2e-6 * np.sin(300 * s) / np.exp(s)
        return wave + np.log(1 + s / length) ** 2 * 1e-4 + s**3

    assert rise == pytest.approx(exact(place), rel=1e-13)
    assert slope == pytest.approx(
        (exact(place + h) - exact(place - h)) / (2 * h), rel=1e-6, abs=1e-9
    )
    assert bend == pytest.approx(
        (exact(place + h) - 2 * exact(place) + exact(place - h)) / h**2, rel=2e-4
    )
    # beyond its ends a roller goes straight on
    beyond = formula(np.array([9e-3]), radius, length)
    end = formula(np.array([7e-3]), radius, length)
    assert beyond[0] == pytest.approx(end[0] + 2e-3 * end[1], rel=1e-12) and beyond[2] == 0


@pytest.mark.parametrize("seat", ["rim", "ring", "disc"])
def test_on_a_large_wheel_rim_ring_and_disc_are_one_rack(seat):
    """Its offset of a helicoid has 1/R (1 + R^2 kappa^2) / (1 - R^2 kappa^2), kappa = p/(p^2 + r^2)."""
    pitch, throat, radius, rollers = 0.023, 0.032, 6.5e-3, 10**6
    wheel = rollers * pitch / (2 * pi)
    distance, tilt, height = {
        "rim": (wheel + throat, 0.0, 0.0),
        "ring": (wheel - throat, pi, 0.0),
        "disc": (wheel, pi / 2, -throat),
    }[seat]
    profile = RollerProfile(radius, 14e-3)
    flank = RollerEnvelope(profile, rollers, distance, wheel, tilt, height, "driving", -1)
    p = pitch / (2 * pi)
    for place in (-5e-3, 0.0, 5e-3):
        kappa = radius * p / (p**2 + (throat - place) ** 2)
        exact = (1 + kappa**2) / (1 - kappa**2) / radius
        assert flank.contact(place, 0.0).curvature == pytest.approx(exact, rel=1e-6)


def test_rows_of_a_double_worm_are_turned_into_each_other():
    drive = pyworm.load(CASES / "rollers" / "double.toml").drive
    left, right = drive.sections["left"].envelope, drive.sections["right"].envelope
    one, other = left.contact(PLACES, ANGLES), right.contact(PLACES, -ANGLES)
    assert np.abs(one.curvature / other.curvature - 1).max() < 1e-12
    turned = one.point * np.array([-1.0, 1.0, -1.0])[:, None, None]
    assert np.abs(turned - other.point).max() < 1e-15


def test_rollers_pass_the_throat_whatever_their_seat(drive):
    middle = drive.sections["left"].envelope.axes(np.array(0.0))[3]
    off = middle - np.array([0.0, drive.centre_distance, 0.0])
    assert np.hypot(off[1], off[2]) == pytest.approx(drive.throat_radius, rel=1e-12)
    assert drive.axis_distance(0.0) == pytest.approx(drive.throat_radius, rel=1e-12)


FORMULA = 'formula = "sqrt(0.06^2 - s^2) - 0.06" # m'


@pytest.mark.parametrize(
    ("key", "sentence"),
    [
        ('formula = "s +"', "is no formula"),
        ('formula = "open(s)"', "a formula has numbers"),
        ('formula = "s ^ s"', "a formula has numbers"),
        ('formula = "r * s"', "a formula has numbers"),
        (f'formula = "{"s+" * 150}s"', "at most 200 characters"),
        ('formula = "s - radius"', "no smooth curve of positive radius"),
        ('formula = "sqrt(0.004^2 - s^2)"', "no smooth curve of positive radius"),
        ("", "give either formula or places and rises"),
        ('places = ["-7 mm", "0 mm", "7 mm"]\nrises = ["0 mm", "0 mm", "0 mm"]', "4 points or more"),
        ('places = ["-7 mm", "0 mm", "7 mm"]\nrises = ["0 mm"]', "need as many rises"),
        ('places = ["-7 mm", "1 mm", "0 mm", "7 mm"]\nrises = ["0 mm", "0 mm", "0 mm", "0 mm"]', "must rise"),
        ('places = ["-5 mm", "0 mm", "1 mm", "7 mm"]\nrises = ["0 mm", "0 mm", "0 mm", "0 mm"]', "both ends"),
    ],
)  # fmt: skip
def test_a_meridian_that_is_none_is_refused(tmp_path, key, sentence):
    text = (CASES / "rollers" / "barrel.toml").read_text(encoding="utf-8")
    assert FORMULA in text
    file = tmp_path / "case.toml"
    file.write_text(text.replace(FORMULA, key), encoding="utf-8")
    with pytest.raises(pyworm.CaseError, match=sentence):
        pyworm.load(file)


def test_only_a_revolved_roller_has_a_meridian(tmp_path):
    file = tmp_path / "case.toml"
    text = (CASES / "rollers" / "barrel.toml").read_text(encoding="utf-8")
    file.write_text(text.replace('shape = "revolved"', 'shape = "cylinder"'), encoding="utf-8")
    with pytest.raises(pyworm.CaseError, match="give a meridian to a roller of the shape"):
        pyworm.load(file)


def test_a_case_of_an_internal_worm_is_solved():
    scene = pyworm.load(CASES / "rollers" / "internal.toml").scene(
        section="left", phase=0.5, station=0.5
    )
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.1, "isothermal"))
    assert solution.converged
    assert solution.figures.film_min.value == pytest.approx(0.93e-6, rel=0.1)


def test_the_page_has_the_numbers_of_the_variants():
    data = read("roller_variants")
    rows = {row[0].split(":")[0]: dict(zip(data.columns, row, strict=True)) for row in data.rows}
    page = (ROOT / "docs" / "theory" / "roller-worm.md").read_text(encoding="utf-8")

    def number(case, column):
        return float(rows[case][column].split(" to ")[-1])

    slid, mesh = "sliding along the line / m/s", "loss of the films, simulated, and of pins / W"
    along = "loss of sliding along the rollers, closed form / W"
    face, double = (number(case, along) / 1e3 for case in ("face", "double"))
    assert f"losses of {face:.1f} and {double:.2f} kW" in page
    assert f"at {number('face', slid):.0f} m/s" in page
    assert f"offset rows at {number('double', slid):.0f} m/s" in page
    saved = 1 - number("cone", mesh) / number("cone, thicker at the outer end", mesh)
    assert "lose a third less" in page and saved == pytest.approx(1 / 3, abs=0.05)
    assert all(row["contacts converged"] == "18 of 18" for row in rows.values())


def test_the_page_has_the_verdicts_on_the_source_s_films():
    data = read("roller_verdicts")
    rows = [dict(zip(data.columns, row, strict=True)) for row in data.rows]
    films = [row for row in rows if row["cell"].split(", ")[-1][:2] in ("R ", "k ")]
    trends = [
        row for row in rows if row["cell"].endswith("trend") and row["table"] == "roller radius"
    ]
    given = sum("its formula gives it" in row["verdict"] for row in films)
    page = (ROOT / "docs" / "evidence" / "validation.md").read_text(encoding="utf-8")
    assert f"its formula gives {given} of {len(films)} films within 25 %" in page
    assert "no trend in R" in page
    assert len(trends) == 4 and all("against its formula" in row["verdict"] for row in trends)
    turned = [
        float(row["rollers turn / um"]) / float(row["minimum once / um"]) - 1 for row in films
    ]
    assert f"rolling (+{100 * np.mean(turned):.0f} %)" in page
    hot = "solved, with heat and roughness / um"
    heated = [float(row[hot]) / float(row["solved, isothermal / um"]) - 1 for row in films]
    assert f"heat (to −{-100 * min(heated):.0f} %)" in page


@pytest.mark.long
@pytest.mark.parametrize("name", VARIANTS)
def test_every_variant_runs_to_a_converged_result(name):
    result = pyworm.run(pyworm.load(CASES / "rollers" / f"{name}.toml"))
    assert all(solution.converged for solution in result.solutions)
    assert len(result.solutions) == 18
    assert 0.85 < result.mesh_loss.efficiency < 1
