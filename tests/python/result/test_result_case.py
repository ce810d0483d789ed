"""A result knows its case: rated, reported or drawn with one that has changed, it says what differs."""

import json
from pathlib import Path

import pytest
from folders import CASES
from refusals import changed, refusal
from synthetic_solution import make_hot_worm, make_mesh_cycle

import pyworm
from pyworm.case.case import case_of
from pyworm.cli.main import main
from pyworm.io.toml import read_toml
from pyworm.result.result import Result
from pyworm.result.result_case import as_solved, differences

TEXT = (CASES / "zi_sharif_2001.toml").read_text()


@pytest.fixture
def kept(tmp_path, monkeypatch):
    """A result beside its case file, in an empty directory."""
    monkeypatch.chdir(tmp_path)
    Path("case.toml").write_text(TEXT)
    case = pyworm.load("case.toml")
    solutions = tuple(make_hot_worm(phase) for phase in (0.25, 0.75))
    return Result(case.name, case.resolved, solutions, make_mesh_cycle(), {}).save("result.nc")


COMMANDS = (
    ["rate", "case.toml", "--result", "result.nc"],
    ["report", "result.nc", "--case", "case.toml"],
    ["plot", "result.nc", "--case", "case.toml"],
)

CHANGES = {
    '"14 kN"': ('"15 kN"', "operation.load is 15 kN, was 14 kN"),
    'worm_speed = "1500 rpm"': (
        'worm_speed = "1450 rpm"',
        "operation.worm_speed is 1450 rpm, was 1500 rpm",
    ),
    'eta0 = "0.227 Pa s"': (
        'eta0 = "0.22 Pa s"',
        "oil.viscosity.eta0 is 0.22 Pa s, was 0.227 Pa s",
    ),
    'roughness = "0.3 um"': ('roughness = "0.4 um"', "bodies.worm.roughness is 0.4 µm, was 0.3 µm"),
}


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command[0])
def test_a_changed_case_is_refused_with_what_differs(kept, tmp_path, capsys, command):
    for old, (new, said) in CHANGES.items():
        Path("case.toml").write_text(changed(TEXT, (old, new)))
        error = refusal(command, tmp_path, capsys)
        assert said in error and "--anyway" in error
    Path("case.toml").write_text(changed(TEXT, *((old, new) for old, (new, _) in CHANGES.items())))
    error = refusal(command, tmp_path, capsys)
    assert all(said in error for _, said in CHANGES.values())


@pytest.mark.usefixtures("plain")
@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command[0])
def test_a_renamed_copy_is_taken(kept, capsys, command):
    """So is one of another title, accuracy or list of phases: none decides a contact."""
    renamed = changed(TEXT, ("Three-start", "My"), ('accuracy = "1 %"', 'accuracy = "3 %"'))
    Path("case.toml").unlink()
    Path("copy.toml").write_text(changed(renamed, ("[0.1, 0.3, 0.5, 0.7, 0.9]", "[0.25, 0.75]")))
    assert main([one.replace("case.toml", "copy.toml") for one in command]) == 0
    assert capsys.readouterr().err == ""


@pytest.mark.usefixtures("plain")
@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command[0])
def test_a_changed_case_is_taken_anyway_with_a_warning(kept, capsys, command):
    Path("case.toml").write_text(changed(TEXT, ('"14 kN"', '"15 kN"')))
    assert main([*command, "--anyway"]) == 0
    err = capsys.readouterr().err
    told = Path("report.html").read_text() if command[0] == "report" else err
    assert "operation.load is 15 kN, was 14 kN" in told


@pytest.mark.usefixtures("plain")
def test_a_report_takes_the_ratings_of_the_case(kept, capsys):
    """What is only rated may change: the life that is wanted, say."""
    Path("case.toml").write_text(changed(TEXT, ('"25000 h"', '"20000 h"')))
    assert main(["report", "result.nc", "--case", "case.toml"]) == 0
    page = Path("report.html").read_text()
    assert main(["rate", "case.toml", "--result", "result.nc", "--json"]) == 0
    out = capsys.readouterr().out
    rated = json.loads(out[out.index("{") :])["ratings"][0]["safeties"]["S_H"]["value"]
    assert f"{rated:.4g}" in page


def test_what_a_run_found_is_no_difference():
    """Friction and lifts that the case leaves open, and the result's case holds, are taken from there."""
    data = read_toml(CASES / "zi_drive.toml")
    case = case_of(data, "drive", CASES)
    found = {"operation": {"friction": 0.009, "lifts": ((0.1, 2e-6), (0.9, 1e-6))}}
    result = Result("drive", case.with_found(found).resolved, (), None, {})
    assert differences(case, result) == ()
    solved = as_solved(case, result).tables.operation
    assert (solved.friction, solved.lifts) == (0.009, found["operation"]["lifts"])
    data["operation"]["friction"] = 0.02
    given = case_of(data, "drive", CASES)
    assert differences(given, result) == ("operation.friction is 0.02, was 0.009",)
