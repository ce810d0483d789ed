"""The roller enveloping drive from its case file to scenes, closed forms, refusals and pictures."""

import json
from dataclasses import replace
from io import StringIO
from itertools import pairwise
from math import atan, cos, pi, sin
from pathlib import Path

import numpy as np
import pytest
from folders import CASES
from rich.console import Console
from roller_sections import coarse_cycle

import pyworm
from pyworm.case.case import Case
from pyworm.cli.main import main
from pyworm.drives.mesh_loss import ContactLoss
from pyworm.drives.roller_worm.film_formulas import closed_films
from pyworm.formulas.film import dowson_higginson, line_groups
from pyworm.formulas.roller_enveloping import (
    normal_force,
    printed_films,
    printed_minimum,
    printed_normal_force,
    printed_parameters,
)
from pyworm.io.input_error import CaseError
from pyworm.plots.drives.roller_worm import CYCLE_PICTURES
from pyworm.plots.drives.roller_worm_fatigue import draw_roller_fatigue
from pyworm.ratings.rated_case import not_rated, rating_request, ratings
from pyworm.report.console.drives.roller_worm import ends_table
from pyworm.report.console.mesh_cycle import loss_sentence
from pyworm.result.result import Result
from pyworm.result.roller_risk import roller_risk
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.scales import line_scales

REFERENCE = (CASES / "roller_ref.toml").read_text()


@pytest.fixture(scope="module")
def case() -> Case:
    return pyworm.load(CASES / "roller_ref.toml")


@pytest.fixture(scope="module")
def cycle(case):
    return case.drive.cycle_data()


def changed(*changes):
    text = REFERENCE
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    return text


def printed(table):
    console = Console(file=StringIO(), width=80)
    console.print(table)
    return console.file.getvalue()


def refused(tmp_path, text) -> str:
    path = tmp_path / "case.toml"
    path.write_text(text)
    with pytest.raises(CaseError) as error:
        pyworm.load(path)
    return str(error.value)


def test_a_torque_of_the_wheel_is_that_of_the_worm_over_the_ratio(case, tmp_path):
    """By the balance of powers without friction, 35 rollers on one thread."""
    wheel = 35 * 5e3 / (50 * np.pi)
    path = tmp_path / "case.toml"
    path.write_text(changed(('power = "5 kW"', f'wheel_torque = "{wheel} N m"')))
    drive = pyworm.load(path).drive
    assert drive.torque == pytest.approx(case.drive.torque, rel=1e-12)
    assert drive.wheel_torque("left") == pytest.approx(wheel + 110, rel=1e-12)


def test_scenes_come_in_the_order_of_travel(case):
    places = case.places()
    assert [place.section for place in places] == ["right"] * 27 + ["left"] * 27
    for section in ("right", "left"):
        phases = [place.phase for place in places if place.section == section]
        assert all(one <= other for one, other in pairwise(phases))
        assert phases[0] == 0 and phases[-1] == 1
    angles = [case.drive.sections[place.section].wheel_angle(place.phase) for place in places[::3]]
    assert all(one < other for one, other in pairwise(angles))


def test_a_station_is_a_line_contact_with_the_drive_s_figures(case):
    scene = case.scene(section="left", phase=0.5, station=0.5)
    assert isinstance(scene, LineScene)
    # the worm's speed by its radius there
    state = case.drive.state("left", 0.5, [0.5])
    radius = np.hypot(*(state.contact.point[1:, 0] - [0.16, 0.0]))
    assert scene.velocities[0] == pytest.approx(1500 * pi / 30 * radius, rel=0.02)
    assert scene.entrainment == pytest.approx(sum(scene.velocities) / 2)
    # both surfaces as seen in space
    gap, _ = scene.gap(np.array([-1e-5, 0.0, 1e-5]))
    assert np.diff(gap, 2)[0] / 1e-10 == pytest.approx(1 / scene.radius, rel=1e-3)


def test_stations_of_all_rollers_in_mesh_carry_the_torque(case):
    """Five rollers a pitch of 360/35 deg apart on a path of 55 deg; Gauss' points along lines of 12 mm."""
    points, weights = np.polynomial.legendre.leggauss(3)
    force = 0.0
    for phase in 0.5 + 360 / 35 / 55 * np.arange(-2, 3):
        for point, weight in zip(points, weights, strict=True):
            scene = case.scene(section="left", phase=phase, station=(point + 1) / 2)
            force += weight / 2 * 12e-3 * scene.load
    # lines are up to a few hundredths longer than the rollers' working length
    assert 0.128 * force == pytest.approx(35 * 5000 / (1500 * pi / 30) + 110, rel=0.04)


def test_a_roller_s_past_is_that_of_earlier_phases(case):
    """Half a phase is half of the 55 degrees at 4.488 rad/s; the film rises all along the left section."""
    scene = case.scene(section="left", phase=0.5, station=0.5)
    seconds = 0.01 * np.radians(55) / (1500 * pi / 30 / 35)
    then = scene.past.before(seconds)
    films = case.drive.state("left", 0.49, [0.5]).films
    assert then.phase == pytest.approx(0.49)
    assert line_scales(then).film == pytest.approx(float(films.central[0]), rel=0.05)
    assert line_scales(then).film < line_scales(scene).film
    right = case.scene(section="right", phase=0.5, station=0.5)
    assert line_scales(right.past.before(seconds)).film > line_scales(right).film


def test_without_stations_the_contact_line_is_solved_with_its_ends():
    scene = pyworm.load(CASES / "roller_crowned.toml").scene(section="left", phase=0.5)
    assert isinstance(scene, Scene) and scene.station is None
    gap, covered = scene.gap(np.zeros(3), np.array([0.0, 5e-3, 7e-3]))
    assert gap[0] == pytest.approx(0, abs=1e-15) and gap[1] > 5e-7
    assert list(covered) == [True, True, False]


def test_the_command_prints_section_and_phase_of_every_scene(tmp_path, capsys, monkeypatch):
    coarse_cycle(monkeypatch)
    path = CASES / "roller_ref.toml"
    options = ["--phase", "0", "1", "--station", "0.5", "--json", "--out", str(tmp_path / "out")]
    assert main(["run", str(path), *options]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [(one["section"], one["phase"]) for one in told["scenes"]] == [
        ("right", 0.0),
        ("right", 1.0),
        ("left", 0.0),
        ("left", 1.0),
    ]
    films = [one["film_min_m"] for one in told["scenes"]]
    assert films[0] > films[1] and films[3] > films[2]  # falls, then rises
    drawn = {Path(name).stem for name in told["pictures"]}
    assert set(CYCLE_PICTURES) - drawn == {"mesh_cycle_fatigue"}  # without fatigue limits


def test_the_source_s_trends_where_its_formulas_have_them(cycle):
    film = cycle["printed_film_min"].min("station")
    assert (film.sel(section="right").diff("phase") < 0).mean() > 0.9
    assert (film.sel(section="left").diff("phase") > 0).mean() > 0.8
    left = film.sel(section="left")
    assert 1.9 < float(left[-1] / left[0]) < 2.7  # the source has 2.5


def test_films_of_the_cycle_are_the_formulas(case, cycle):
    at = cycle.sel(section="left").isel(phase=10, station=4)
    speed = float(at["worm_velocity"] + at["roller_velocity"]) / 2
    groups = line_groups(
        float(at["contact_radius"]), float(at["load_per_length"]), 225.6e9, speed, 0.08, 2.2e-8
    )
    assert float(at["formula_film_min"]) == pytest.approx(
        dowson_higginson(groups).minimum, rel=1e-3
    )
    composite = np.hypot(0.4e-6, 0.2e-6)
    warm = float(at["formula_film_min"] * at["heated_share"])
    assert float(at["specific_film"]) == pytest.approx(warm / composite, rel=1e-9)
    assert float(at["elasticity_parameter"]) == pytest.approx(np.sqrt(2) * groups.moes_m, rel=1e-3)
    viscous = np.sqrt(2) * groups.moes_m**1.5 * groups.moes_l
    assert float(at["viscosity_parameter"]) == pytest.approx(viscous, rel=1e-3)


def test_closed_forms_go_without_roughness(case):
    drive = case.drive
    state = drive.state("left", 0.5, [0.2, 0.8])
    given = state.contact.curvature, state.load, state.motion
    smooth = tuple(replace(body, roughness=None) for body in drive.bodies)
    bare = closed_films(*given, smooth, drive.oil)
    assert np.isnan(bare.specific_film).all()
    assert bare.minimum == pytest.approx(state.films.minimum, rel=0)
    unloaded = closed_films(given[0], 0 * given[1], given[2], drive.bodies, drive.oil)
    assert np.isnan(unloaded.specific_film).all()


def test_the_table_of_a_cycle_without_roughness_has_no_lambda(cycle):
    said = printed(ends_table(cycle))
    assert "Specific film thickness lambda" in said and "mixed" in said
    assert "…" not in said
    bare = printed(ends_table(cycle.assign(specific_film=np.nan * cycle["specific_film"])))
    assert "Minimum film" in bare
    assert "lambda" not in bare and "mixed" not in bare and "Lubrication  " not in bare


def test_both_sections_carry_what_the_torques_ask(case, cycle):
    """Loads of all rollers on the arm of their middles; the normals lean by the lead angle at most."""
    lead = atan(128 / (35 * 32))
    for section, torque in (("left", 35 * 5000 / (1500 * pi / 30) + 110), ("right", 110)):
        shared = case.drive.shared(section, float(case.drive.sections[section].wheel_angle(0.5)))
        assert torque < shared.forces.sum() * 0.128 < torque / cos(lead)


def test_the_source_s_formulas_are_as_printed():
    given = 6.1e-3, 1e5, 225.6e9, 2.5, 0.08, 2.2e-8
    groups = line_groups(*given)
    right = dowson_higginson(groups).minimum
    assert printed_minimum(*given) == pytest.approx(0.75 * right, rel=1e-9)
    films = printed_films(*given)
    assert films.rigid_isoviscous == pytest.approx(4.9 * 0.2 * 6.1e-3 / 1e5)
    assert films.rigid_piezoviscous == pytest.approx(
        1.66 * 0.2**0.67 * 2.2e-8**0.53 * 6.1e-3**0.67 * 1e5**-0.11
    )
    assert films.elastic_isoviscous == pytest.approx(
        3.01 * 0.2**0.8 * 6.1e-3**0.8 * 225.6e9**-0.08 * 1e5**-0.04
    )
    g_v, g_e = printed_parameters(*given)
    assert np.sqrt(g_v) == pytest.approx(np.sqrt(2) * groups.moes_m**1.5 * groups.moes_l)
    assert np.sqrt(g_e) == pytest.approx(np.sqrt(2) * groups.moes_m)


def test_normal_forces_with_cosine_and_sine():
    lead = atan(128 / (35 * 32))
    assert printed_normal_force(31.83, 0.064, 0.0, lead) == pytest.approx(1001, abs=1)
    right = normal_force(31.83, 0.064, 0.0, lead)
    # the wheel's torque on its arm, where the thread leans by the lead angle
    assert right * cos(lead) == pytest.approx(35 * 31.83 / 0.128, rel=1e-6)
    assert normal_force(31.83, 0.064, 0.3, lead, 0.05) < right / (cos(0.3) * sin(lead)) * sin(lead)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('tilt = "0 deg"', 'tilt = "75 deg"', "drive.worm: the right section's flank is undercut"),
        (
            'tilt = "0 deg"',
            'tilt = "90 deg"',
            "drive.worm.dedendum is 6 mm; along the rollers' axes",
        ),
        (
            'tilt = "0 deg"',
            'height = "-33 mm"',
            "drive.rollers.height is -33 mm; it must not be above",
        ),
        ('throat_angle = "5 deg"', "", "give a throat_angle above zero to a divided worm"),
        ('throat_angle = "5 deg"', 'arrangement = "double"', "drive.rollers.height is 0; two rows"),
        ('throat_angle = "5 deg"', 'arrangement = "triple"', "drive.worm.arrangement"),
        ('radius = "6.5 mm"', 'radius = "11 mm"', "leaves no thread between them"),
        ('outer_angle = "60 deg"', 'outer_angle = "4 deg"', "drive.worm.outer_angle is 4 deg"),
        ('outer_angle = "60 deg"', 'outer_angle = "5.3 deg"', "a larger angle is needed"),
        ('addendum = "6 mm"', 'addendum = "8 mm"', "drive.worm.addendum is 8 mm"),
        ("throat_coefficient = 0.4", "throat_coefficient = 2.5", "drive.worm.throat_coefficient"),
        ('power = "5 kW"', "", "give one of power, worm_torque, wheel_torque"),
        (
            'power = "5 kW"',
            'power = "5 kW"\nwheel_torque = "1 kN m"',
            "wheel_torque, not power and wheel_torque",
        ),
        ('rolling = "free"', 'rolling = "fast"', "operation.rolling"),
        ("stations = [0.1, 0.5, 0.9]", "", "drive.rollers.crown is missing"),
        ("stations = [0.1", "stations = [1.1", "operation.stations[0] = 1.1: must be at most 1"),
        (
            'effects = "isothermal"',
            'effects = "most"',
            'effects = "most": most is none of auto, all',
        ),
        ('length = "14 mm"', 'length = "14 mm"\nshape = "cone"', "give a half_angle"),
        ('preload = "110 N m"', 'preload = "0 N m"', 'operation: sections has "right", the idling'),
        ('preload = "110 N m"', 'preload = "-1 N m"', "operation.preload"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(tmp_path, old, new, sentence):
    assert sentence in refused(tmp_path, changed((old, new)))


def losses(section, phases, **others):
    """Contacts that each lose 2 W, of a friction of 0.02 under 100 N."""
    return [
        ContactLoss(phase, 100.0, 0.02, 2.0, 0.01, section=section, **others) for phase in phases
    ]


def test_the_loss_is_that_of_all_rollers_in_mesh(case):
    """A section has 55 of 360 degrees, and 35 rollers stand round the wheel."""
    phases = 0.1, 0.5, 0.9
    both = losses("right", phases) + losses("left", phases)
    loss = case.drive.mesh_loss(both)
    assert loss.loss == pytest.approx(2 * 2.0 * 55 / 360 * 35)
    assert loss.power == pytest.approx(5e3) and loss.friction == pytest.approx(0.02)
    assert loss.efficiency == pytest.approx(1 - loss.loss / 5e3)
    assert case.drive.mesh_loss(both[:3]) is None and case.drive.mesh_loss(both[:-1]) is None
    # where the idling section is not braced it neither carries nor loses anything
    loose = replace(case.drive, preload=0.0)
    assert loose.mesh_loss(both[3:]).loss == pytest.approx(loss.loss / 2)
    line = loose.state("left", 0.5, [0.5]).length
    along = [one for at in (0.1, 0.5, 0.9) for one in losses("left", [0.5], station=at)]
    spread = loose.mesh_loss(losses("left", [0.0, 1.0]) + along)
    assert spread.loss == pytest.approx(55 / 360 * 35 * 2.0 * (1 + line) / 2, rel=1e-3)
    assert "efficiency" in loss_sentence(spread).lower()


def test_a_section_without_preload_touches_without_load(case):
    loose = replace(case.drive, preload=0.0)
    state = loose.state("right", 0.5, [0.5])
    assert state.force == 0 and np.isnan(state.films.minimum).all()
    assert loose.shared("left", 0.5).forces.max() > 1e3


def test_films_of_a_drive_that_no_standard_covers_are_rated(case):
    asked = rating_request(case)
    built = ratings(asked)
    assert [one.key for one in built] == [
        *("films", "forces", "element_bearing", "roller_rotation"),
    ]
    assert any("no standard that is known here covers" in one for one in not_rated(asked, built))


def test_free_rollers_need_a_flow_law(tmp_path):
    start = REFERENCE.index("[oil.shear]")
    text = REFERENCE[:start] + REFERENCE[REFERENCE.index("[oil.heat]") :]
    assert "[oil.shear] is missing" in refused(tmp_path, text)
    path = tmp_path / "case.toml"
    path.write_text(text.replace('rolling = "free"', 'rolling = "locked"'))
    scene = pyworm.load(path).scene(section="left", phase=0.5, station=0.5)
    assert abs(scene.velocities[1]) < 0.02 * scene.velocities[0]


@pytest.mark.parametrize(
    ("place", "sentence"),
    [
        ({"section": "middle"}, "section middle: choose one of right, left"),
        ({"station": 1.5}, "station 1.5: must lie between 0 and 1"),
        ({"phase": -1}, "phase -1: must lie between 0 and 1"),
    ],
)
def test_places_outside_the_mesh_are_refused(case, place, sentence):
    with pytest.raises(CaseError, match=sentence):
        case.scene(**place)


def test_a_drive_without_sections_takes_none():
    with pytest.raises(
        CaseError, match="section left: the gear set of zi_sharif_2001 has no sections"
    ):
        pyworm.load(CASES / "zi_sharif_2001.toml").scene(section="left")


def test_the_map_of_fatigue_of_thread_and_rollers(case, cycle):
    """Each contact at its section, phase and place; a body without limits and contacts unsolved stay out."""

    line = case.scene(section="left", phase=0.5, station=0.5)
    one = pyworm.solve(line, accuracy=0.2, effects="isothermal")

    def solved(section, phase, station, ratio, risk):
        zero = 0 * one.fields["pressure"]
        fields = one.fields.assign(
            fatigue_ratio_body_2=zero + ratio, fatigue_risk_body_2=zero + risk
        )
        return replace(one, section=section, phase=phase, station=station, fields=fields)

    contacts = [solved("left", phase, 0.5, 0.3 + phase, 1e-3) for phase in (0.0, 0.5, 1.0)]
    contacts.append(solved("right", 0.5, 0.1, 0.2, 0.0))
    result = Result("roller_ref", case.resolved, tuple(contacts), cycle, {})
    field = roller_risk(result)
    ratio = field["fatigue_ratio_body_2"]
    assert "fatigue_ratio_body_1" not in field
    assert ratio.sel(section="left", station=0.5).values == pytest.approx([0.3, 0.8, 1.3])
    assert float(ratio.sel(section="right", phase=0.5, station=0.1)) == pytest.approx(0.2)
    assert int(np.isfinite(ratio).sum()) == 4
    rollers = field["pitting_probability"].isel(body=1)
    one_contact = rollers.sel(section="left", phase=0.5, station=0.5)
    assert float(one_contact) == pytest.approx(1 - np.exp(-1e-9 * 1e7 ** (10 / 9)), rel=1e-6)
    assert float(rollers.sel(section="right", phase=0.5, station=0.1)) == 0
    middle = cycle["wheel_angle"].sel(section="left").interp(phase=0.5)
    assert float(field["wheel_angle"].sel(section="left", phase=0.5)) == pytest.approx(
        float(middle)
    )
    figure = draw_roller_fatigue(result)
    titles = [axes.get_title() for axes in figure.axes[:2]]
    assert titles == ["right section, maximum 0.2", "left section, maximum 1.3"]
    one_place = replace(result, solutions=tuple(contacts[:3]))
    right, left = draw_roller_fatigue(one_place).axes[:2]
    assert right.get_title() == "right section, not solved"
    assert left.get_ylim() == (0, 1)
    assert any("pitting" in axes.get_ylabel() for axes in figure.axes)
    assert roller_risk(replace(result, solutions=tuple(contacts[:2]))) is None


def test_pictures_and_table_of_the_cycle(case, cycle):
    result = Result("roller_ref", case.resolved, (), cycle, {})
    assert CYCLE_PICTURES["mesh_cycle_fatigue"].draw(result) is None
    for name in CYCLE_PICTURES.keys() - {"mesh_cycle_fatigue"}:
        assert CYCLE_PICTURES[name].draw(result).axes
    table = ends_table(cycle)
    assert table.head[1:] == ("right\nentry", "right\nexit", "left\nentry", "left\nexit")
    (row,) = (row for row in table.rows if row[0] == "Minimum film thickness / µm")
    films = [float(cell) for cell in row[1:]]
    assert films[0] > films[1] and films[3] > films[2]
