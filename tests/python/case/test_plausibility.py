"""What cannot be is refused, what seldom is is told; both by key, and with what is usual."""

import json
import tomllib
from dataclasses import replace

import pytest
from folders import CASES

import pyworm
from pyworm.case.case import case_of
from pyworm.cli.main import main
from pyworm.io.input_error import CaseError
from pyworm.report.page.build import build_report
from pyworm.result.result import open_result
from pyworm.scene.plausibility import overheated

FILES = {
    "zi": "zi_drive",
    "pair": "spur_pair",
    "point": "traction_steel",
    "line": "line_m20_l10",
    "oil": "ball_pag_460",
}
LINE_LOAD = '"182.84 kN/m"'


def case(base, old, new):
    """A shipped case with a passage of its file replaced, wherever it stands."""
    text = (CASES / f"{FILES[base]}.toml").read_text()
    assert old in text
    return case_of(tomllib.loads(text.replace(old, new)), "case", CASES)


@pytest.mark.parametrize(
    ("base", "old", "new", "sentences"),
    [
        # load and what follows from it
        ("line", LINE_LOAD, '"1e-12 N/m"', ['contact.load = "1e-12 N/m": must be a force per le']),
        ("line", LINE_LOAD, '"2e-3 N/m"', ["contact.load: a film of 555 mm is expected between"]),
        (
            "line",
            LINE_LOAD,
            '"30 MN/m"',
            [
                "contact.load: the bodies are pressed",
                "206 GPa, as the softer body",
                "than 10.3 GPa",
            ],
        ),
        ("zi", '"4 kN m"', '"4e7 N m"', ["operation.wheel_torque: the bodies are pressed tog"]),
        # bodies and oil
        (
            "point",
            "210 GPa",
            "210000 GPa",
            ['youngs_modulus = "210000 GPa"', "0.1 MPa and 1500 GPa", 'you mean "210000 MPa"?'],
        ),
        (
            "point",
            "7850 kg/m^3",
            "7.85 kg/m^3",
            ['body_1.density = "7.85 kg/m^3"', 'such as "7850 kg/m^3"', 'you mean "7.85 g/cm^3"?'],
        ),
        ("point", "47 W/(m K)", "42 kW/(m K)", ["body_1.conductivity", 'mean "42 W/(m K)"?']),
        ("point", "450 J/(kg K)", "0.46 J/(kg K)", ["specific_heat", '"0.46 kJ/(kg K)"?']),
        ("point", '"60 degC"', '"2000 degC"', ["inlet_temperature", "-110 degC and 400 degC"]),
        ("oil", '"60 degC"', '"250 degC"', ['oil.temperature = "250 degC": too far from what']),
        ("pair", "0.51 um", "0.51 mm", ["bodies.pinion.roughness", "0.1 nm and 0.1 mm"]),
        # teeth
        (
            "pair",
            '"14 mm"',
            '"30 m"',
            ["drive.face_width", '10 um and 5 m, such as "60 mm"', "30 mm"],
        ),
        ("zi", '"30 um"', '"30 mm"', ["drive.worm.tip_relief", '5 mm, such as "20 um"', "30 um"]),
        # yielding
        (
            "oil",
            '"0.05 um"',
            '"0.05 um"\nhardness = "50 MPa"',
            ["0.807 GPa by", "yields as a whole"],
        ),
        ("zi", 'length = "4 mm"', 'length = "40 mm"', ["tip_relief_length is 40 mm", "18.98 mm"]),
    ],
)
def test_impossible_contacts_are_refused(base, old, new, sentences):
    with pytest.raises(CaseError) as caught:
        case(base, old, new)
    for sentence in sentences:
        assert sentence in str(caught.value)


@pytest.mark.parametrize(
    ("base", "old", "new", "sentences"),
    [
        ("line", LINE_LOAD, '"6 MN/m"', ["contact.load", "10 N/m and 5000 kN/m", '"6 kN/m"?']),
        ("line", LINE_LOAD, '"6 MN/m"', ["contact.load: the bodies", "hard steel", "up to 4 GPa"]),
        ("line", LINE_LOAD, '"1 N/m"', ["contact.load: a film of 1.11 mm is expected", "10 mm"]),
        ("line", '"0.46227 m/s"', '"-1e-8 m/s"', ["contact.load: a film of", "nm", "no fluid"]),
        ("zi", '"4 kN m"', '"600000 N m"', ["operation.wheel_torque", 'mean "600000 N mm"?']),
        ("zi", '"4 kN m"', '"600000 N m"', ["2.73 GPa by Hertz at phase", "bronze", "up to 1 GPa"]),
        ("pair", "0.51 um", "40 um", ["pinion.roughness", "1 nm and 5 um", '"40 uin"?']),
        ("pair", '"14 mm"', '"3 m"', ["drive.face_width", "1 mm and 1.5 m", 'mean "3 mm"?']),
        (
            "oil",
            '"0.05 um"',
            '"0.05 um"\nhardness = "0.6 GPa"',
            ["hardness of 0.6 GPa", "as a whole"],
        ),
        ("point", '"60 degC"', '"353 degC"', ["oil.heat.inlet_temperature", 'you mean "353 K"?']),
        ("point", "210 GPa", "210 MPa", ["body_1.youngs_modulus and bodies.body_2", '"210 GPa"?']),
        ("point", '"2 m/s"', '"2000 m/s"', ["motion.mean_velocity[0]", "at most 300 m/s"]),
    ],
)
def test_unusual_values_give_one_warning(base, old, new, sentences):
    warnings = case(base, old, new).warnings
    told = [warning for warning in warnings if all(of in warning for of in sentences)]
    assert len(told) == 1, warnings
    assert len(warnings) <= 2


@pytest.mark.parametrize("path", sorted(CASES.glob("*.toml")), ids=lambda path: path.stem)
def test_cases_of_the_literature_give_no_warning(path):
    if "drive" in (tables := tomllib.loads(path.read_text())) or "contact" in tables:
        assert pyworm.load(path).warnings == ()


def test_contacts_at_other_places_are_checked_too():
    """A load that is too much at a slide-roll ratio that the file does not list is refused there."""
    built = case("point", '"41.33 N"', '"41.33 N"')
    heavy = built.tables.contact.model_copy(update={"load": 1e6})
    built = replace(built, tables=built.tables.model_copy(update={"contact": heavy}))
    with pytest.raises(CaseError, match=r"contact.load: .* at slide roll ratio 0.3; nothing with"):
        built.scene(slide_roll_ratio=0.3)


UNUSUAL = ("450 J/(kg K)", "90 J/(kg K)")
SAID = (
    'bodies.body_1.specific_heat and bodies.body_2.specific_heat = "90 J/(kg K)": unusual, a specific '
    "heat lies between 100 J/(kg K) and 5000 J/(kg K) as a rule"
)


@pytest.mark.usefixtures("undrawn")
def test_warnings_go_to_standard_error_json_result_and_report(tmp_path, capsys):
    text = (CASES / "traction_steel.toml").read_text()
    (tmp_path / "case.toml").write_text(text.replace(*UNUSUAL))
    case_file, ratio = str(tmp_path / "case.toml"), ("--slide-roll-ratio", "0")
    assert main(["check", case_file, "--json", *ratio]) == 0
    said = capsys.readouterr()
    assert said.err == f"pyworm: warning: {SAID}\n"
    assert json.loads(said.out)["warnings"] == [SAID]
    out = tmp_path / "out"
    how = ("--accuracy", "30%", "--effects", "isothermal", "--json", *ratio)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pyworm.plots.draw.draw", lambda *given, **options: [])
        assert main(["run", case_file, *how, "--out", str(out)]) == 0
    said = capsys.readouterr()
    assert said.err.startswith(f"pyworm: warning: {SAID}\n")
    assert json.loads(said.out)["warnings"] == [SAID]
    result = open_result(out / "result.nc")
    assert result.provenance["warnings"] == [SAID]
    assert SAID in build_report(result).warnings


def test_ratings_give_the_same_warnings(tmp_path, capsys):
    text = (CASES / "oil_zi.toml").read_text()
    assert '"0.3 um"' in text
    (tmp_path / "case.toml").write_text(text.replace('"0.3 um"', '"9 um"'))
    assert main(["rate", str(tmp_path / "case.toml"), "--json"]) == 0
    said = capsys.readouterr()
    (warning,) = json.loads(said.out)["warnings"]
    assert warning.startswith(
        'worm_gear.worm_roughness = "9 um": unusual, a root mean square height'
    )
    assert said.err == f"pyworm: warning: {warning}\n"


def test_a_film_hotter_than_oils_withstand_gives_a_warning():
    films = [
        {"name": name, "temperature_max_C": {"film": celsius}}
        for name, celsius in (("phase 0.1", 310.0), ("phase 0.5", 431.0), ("phase 0.9", 120.0))
    ]
    (told,) = overheated([{"name": "isothermal"}, *films])
    assert told.startswith("phase 0.5: the film reaches 431 degC; oils break from 300 degC on")
    assert overheated(films[2:]) == overheated([{"name": "isothermal"}]) == ()


def test_a_run_warns_of_a_film_that_is_too_hot(tmp_path, capsys):
    """After the solve, where it is known."""
    out = ("--json", "--accuracy", "30%", "--slide-roll-ratio", "3", "--out", str(tmp_path / "out"))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pyworm.plots.draw.draw", lambda *given, **options: [])
        patch.setattr("pyworm.scene.plausibility.HOTTEST_FILM", 61.0)
        assert main(["run", str(CASES / "traction_steel.toml"), *out]) == 0
    said = capsys.readouterr()
    (warning,) = json.loads(said.out)["warnings"]
    assert "the film reaches" in warning and f"pyworm: warning: {warning}\n" in said.err
