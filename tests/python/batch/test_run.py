"""Commands on a case from Python: what they give is what the command line prints, or a one-line refusal."""

import json
from types import SimpleNamespace

import pytest
from folders import ROOT
from synthetic_solution import make_worm_solution

import pyworm
from pyworm.batch import case_run
from pyworm.cli.main import main

CASE = ROOT / "cases/point_m20_l10.toml"

WORM = {
    "profile": "ZI",
    "centre_distance": "100 mm",
    "threads": 2,
    "teeth": 41,
    "module": "4 mm",
    "diameter_factor": 9,
    "hob": {"swivel": "0.3 deg"},
    "worm_speed": "1500 rpm",
    "wheel_torque": "500 N m",
    "sharing": "equal",
    "oil": {"name": "PAG VG 220", "temperature": "80 degC"},
    "bodies": ("16MnCr5", "CuSn12Ni2-C-GZ"),
    "phases": (0.5,),
}


def test_a_run_is_that_of_the_command(tmp_path, capsys):
    words = "--accuracy", "50%", "--effects", "isothermal", "--pictures", "none", "--json"
    assert main(["run", str(CASE), "--out", str(tmp_path), *words]) == 0
    printed = json.loads(capsys.readouterr().out)
    result = pyworm.run(CASE, accuracy="50 %", effects="isothermal", progress=False)
    (solution,), (scene,) = result.solutions, printed["scenes"]
    assert solution.figures.film_min.value == scene["film_min_m"]
    assert result.cycle is None and result.mesh_loss is None


def test_a_check_is_that_of_the_command(capsys):
    assert main(["check", str(CASE), "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    checked = pyworm.check(CASE)
    assert printed["case"] == checked.summary()["case"] == "point_m20_l10"
    assert printed["scenes"][0].keys() == checked.summary()["scenes"][0].keys()
    assert printed["scenes"][0]["load_N"] == checked.contacts[0].scene.load
    assert checked.geometry == {} and checked.assumptions == ()


def test_a_contact_that_cannot_be_planned_is_refused():
    assert pyworm.check(CASE).contacts[0].plan.asked is None
    with pytest.raises(pyworm.CaseError, match=r"effects = film-heating: .*\[oil.heat\]"):
        pyworm.check(CASE, effects="film-heating")


@pytest.mark.parametrize(
    ("call", "given", "sentence"),
    [
        (pyworm.load, {"source": 3}, "case = 3: must be the path of a case file, its tables"),
        (pyworm.check, {"case": CASE, "phases": 0.5}, r"phases = 0.5: must be several values"),
        (pyworm.check, {"case": CASE, "phases": ("a",)}, r"phases\[0\] = 'a': must be a number"),
        (pyworm.check, {"case": CASE, "sections": (1,)}, r"sections\[0\] = 1: must be a text"),
        (pyworm.run, {"case": CASE, "fields": "half"}, 'fields = "half": must be one of "rounded"'),
        (pyworm.run, {"case": CASE, "processes": 1.5}, "processes = 1.5: must be a whole number"),
        (pyworm.run, {"case": CASE, "scheduler": 3}, "scheduler = 3: must be a text"),
        (pyworm.sweep, {"make": max, "load": 3}, "load = 3: must be several values"),
        (pyworm.sweep, {"make": max, "together": 3}, "together = 3: must be values by name"),
        (pyworm.transient, {"scene": 3, "times": (0, 1)}, "scene is a int: must be a Scene or a"),
    ],
)
def test_wrong_types_are_refused_by_name(call, given, sentence):
    with pytest.raises(ValueError, match=sentence):
        call(**given, **({"progress": False} if call in (pyworm.run, pyworm.sweep) else {}))


@pytest.mark.parametrize(("name", "command"), [("oil_zi", "rate"), ("point_m20_l10", "check")])
def test_an_example_names_the_command_that_shows_it(name, command, tmp_path, capsys):
    assert main(["example", name, "--out", str(tmp_path)]) == 0
    assert f"Next: pyworm {command} {tmp_path / name}.toml" in capsys.readouterr().out.replace(
        "\n", ""
    )


def test_what_has_nothing_to_be_rated_or_set_up_is_refused():
    case = pyworm.load(CASE)
    with pytest.raises(pyworm.CaseError, match="only drives of kind"):
        pyworm.rate(case)
    with pytest.raises(TypeError, match="phase is none of the arguments: accuracy, effects, quan"):
        pyworm.check(case, phase=0.5)
    with pytest.raises(pyworm.CaseError, match="point_m20_l10: has no hob that could be set up"):
        pyworm.setup(case)
    with pytest.raises(pyworm.CaseError, match="point_m20_l10: has no wheel that a shim could"):
        pyworm.shim(case)
    with pytest.raises(pyworm.CaseError, match="point_m20_l10: wear is simulated of worm drives"):
        pyworm.wear(case, 100)
    with pytest.raises(pyworm.CaseError, match="size = 120 %: must lie between 0 and 100 %"):
        pyworm.setup(case, size="120 %")


@pytest.mark.filterwarnings("ignore::pyworm.UnusualWarning")
def test_wear_needs_a_roughness():
    gears = pyworm.WormDrive(**WORM)
    with pytest.raises(pyworm.CaseError, match=r"^worm: bodies\.worm\.roughness"):
        pyworm.wear(gears, 100, progress=False)
    with pytest.raises(pyworm.CaseError, match="hours = 0: must be above zero"):
        pyworm.wear(gears, 0)
    with pytest.raises(pyworm.CaseError, match="give one of coefficient, energy and calibrate"):
        pyworm.wear(gears, 1, energy=1e14, calibrate=True)


@pytest.mark.parametrize(("count", "kept"), [(1, "around one"), (2, "whole")])
def test_a_contact_alone_keeps_what_belongs_to_it_of_the_mesh_cycle(count, kept):
    drive = SimpleNamespace(cycle_data=lambda: "whole", cycle_around_contact=lambda: "around one")
    case = SimpleNamespace(name="drive", drive=drive, resolved={}, warnings=())
    solution = make_worm_solution()
    tasks = [SimpleNamespace(key=str(n), scene=SimpleNamespace(name=str(n))) for n in range(count)]
    found = {task.key: (solution, {}) for task in tasks}
    assert case_run._result(case, tasks, found, {}, None).mesh_cycle == kept
