"""The command line: what is printed, what is written, how it ends."""

import json
import sys
from dataclasses import replace
from pathlib import Path
from unittest.mock import Mock

import pytest
from folders import CASES
from synthetic_solution import make_hot_worm
from zi_drives import quickly_described

import pyworm
import pyworm.batch.task
from pyworm.cli.main import main
from pyworm.cli.shared import CONVERGED, FAILED, NOT_CONVERGED
from pyworm.kernel.core import KernelError
from pyworm.result.result import Result, open_result
from pyworm.solver.ending import Ending

CASE = str(CASES / "point_m20_l10.toml")
DRIVE = str(CASES / "zi_sharif_2001.toml")

SCENE_KEYS = {
    "kind",
    "phase",
    "load_N",
    "converged",
    "film_min_m",
    "film_central_m",
    "film_min_at_m",
    "pressure_max_Pa",
    "grid",
    "seconds",
    "convolutions",
    "load_error",
    "mass_error",
}


@pytest.fixture(scope="module")
def solved(tmp_path_factory):
    """A directory with one solved case, and its solution for tests that need none of their own."""
    directory = tmp_path_factory.mktemp("solved")
    assert main(["run", CASE, "--accuracy", "5%", "--out", str(directory)]) == CONVERGED
    return directory, open_result(directory / "result.nc").solutions[0]


@pytest.fixture
def solve_at_once(monkeypatch, solved):
    """Make `run` take the solution at hand and draw one mark; returns how to change the solution."""

    def mark(result, directory, executor=None, key_only=False):
        path = directory / "mark.png"
        path.write_bytes(b"")
        return [path]

    monkeypatch.setattr("pyworm.plots.draw.draw", mark)
    quickly_described(monkeypatch)

    def install(**changes):
        solution = replace(solved[1], **changes)
        monkeypatch.setattr("pyworm.batch.task.solve", lambda scene, plan, *how: solution)

    return install


def test_run_writes_the_result_and_the_pictures(solved):
    directory, solution = solved
    assert solution.converged
    pictures = sorted(path.name for path in directory.glob("*.png"))
    assert pictures == ["regimes.png", "scene_000_film.png"]
    result = open_result(directory / "result.nc")
    assert result.case["contact"]["load"] == pytest.approx(3.6774)
    assert result.provenance["pyworm"] == pyworm.__version__
    assert result.provenance["plans"][0]["accuracy"] == 0.05


def test_a_line_contact_runs_like_a_point_contact(tmp_path, capsys):
    out = tmp_path / "out"
    case = str(CASES / "line_m20_l10.toml")
    assert main(["run", case, "--json", "--out", str(out)]) == CONVERGED
    content = json.loads(capsys.readouterr().out)
    (scene,) = content["scenes"]
    assert set(scene) >= SCENE_KEYS - {"load_N"}
    assert scene["kind"] == "line"
    assert scene["load_per_length_N_m"] == pytest.approx(182.84e3)
    assert scene["film_min_error"] < 0.01
    assert len(scene["film_min_at_m"]) == len(scene["grid"]) == 1
    assert sorted(path.name for path in out.iterdir()) == [
        "regimes.png",
        "result.nc",
        "scene_000_profiles.png",
    ]
    (solution,) = open_result(content["results"]).solutions
    assert solution.figures.film_min.value == scene["film_min_m"]
    assert set(solution.fields.dims) == {"x"}
    assert main(["plot", content["results"]]) == CONVERGED
    capsys.readouterr()
    assert main(["run", case, "--out", str(out)]) == CONVERGED
    said = capsys.readouterr().out
    for words in (
        "Load per length",
        "182.8 kN/m",
        "Hertz contact width",
        "position ",
        "Minimum film thickness",
    ):
        assert words in said
    assert "Dry contact" not in said and "centre line" not in said
    assert main(["check", case]) == CONVERGED
    assert "second-dimension" in capsys.readouterr().out


def test_run_prints_one_json_object_and_nothing_else(tmp_path, capfd, solve_at_once):
    solve_at_once()
    out = tmp_path / "deep" / "out"
    assert main(["run", CASE, "--json", "--out", str(out)]) == CONVERGED
    said = capfd.readouterr()
    content = json.loads(said.out)
    assert said.err == ""
    assert set(content) == {
        "case",
        "scenes",
        "beyond_limits",
        "failed",
        "warnings",
        "results",
        "pictures",
    }
    assert content["case"] == "point_m20_l10"
    assert set(content["scenes"][0]) >= SCENE_KEYS
    written = {str(path) for path in out.iterdir()}
    assert written == {content["results"], *content["pictures"]}
    assert [path.name for path in out.parent.iterdir()] == ["out"]


def test_run_prints_a_table_with_units(tmp_path, capsys, solve_at_once):
    solve_at_once()
    assert main(["run", CASE, "--out", str(tmp_path / "out")]) == CONVERGED
    said = capsys.readouterr().out
    for words in (
        "Minimum film",
        "µm",
        "Convolutions",
        "Relative mass imbalance",
        "result.nc",
        ".png",
    ):
        assert words in said


def test_a_published_figure_stands_beside_the_computed_one(tmp_path, capsys, solve_at_once):
    solve_at_once()
    mourier = str(CASES / "mourier_2006.toml")
    assert main(["run", mourier, "--out", str(tmp_path / "out")]) == CONVERGED
    assert "209.3 nm" in capsys.readouterr().out


def test_temperatures_are_printed_where_heat_was_simulated(tmp_path, capsys, solve_at_once):
    hot = make_hot_worm(0.4, points=(33, 17))
    parts = ("figures", "fields", "inlet_temperature", "profile", "phase")
    solve_at_once(**{part: getattr(hot, part) for part in parts})
    arguments = ["run", DRIVE, "--phase", "0.4", "0.6", "--out", str(tmp_path / "out")]
    assert main(arguments) == CONVERGED
    assert "Friction and temperatures of all contacts" in capsys.readouterr().out
    assert main([*arguments, "--json"]) == CONVERGED
    scene = json.loads(capsys.readouterr().out)["scenes"][0]
    for key in ("temperature_max_C", "temperature_max_error_K"):
        assert list(scene[key]) == ["body_1", "body_2", "film"]
    for key in ("friction_coefficient", "power_loss_W", "shear_rate_max_1_s"):
        assert scene[key] > 0
    for key in ("friction_coefficient_error", "power_loss_error", "shear_rate_max_error"):
        assert 0 < scene[key] < 0.1


def test_a_scene_that_the_kernel_gives_up_does_not_cost_the_others(
    tmp_path, capsys, monkeypatch, solve_at_once
):
    solve_at_once(phase=0.4)
    at_once = pyworm.batch.task.solve

    def half(scene, plan, *how):
        if scene.phase > 0.5:
            raise KernelError(2)
        return at_once(scene, plan, *how)

    monkeypatch.setattr("pyworm.batch.task.solve", half)
    drive = str(CASES / "zi_sharif_2001.toml")
    arguments = ["run", drive, "--phase", "0.4", "0.6", "--json", "--out", str(tmp_path / "out")]
    assert main(arguments) == NOT_CONVERGED
    printed = capsys.readouterr()
    told = json.loads(printed.out)
    assert [scene["phase"] for scene in told["scenes"]] == [0.4]
    reason = "a field holds a value that is not finite"
    assert list(told["failed"].values()) == [reason]
    assert told["stop_reason"] == f"1 of 2 contacts missing: phase 0.60 ({reason})"
    assert told["stop_reason"] in printed.err


@pytest.mark.parametrize("form", [["--json"], []], ids=["json", "tables"])
def test_a_run_without_any_solution_reports_why(tmp_path, capsys, monkeypatch, form):
    def never(scene, plan, *how):
        raise KernelError(2)

    monkeypatch.setattr("pyworm.batch.task.solve", never)
    arguments = ["run", DRIVE, "--phase", "0.4", "0.6", *form, "--out", str(tmp_path / "out")]
    assert main(arguments) == FAILED
    printed = capsys.readouterr()
    reason = "a field holds a value that is not finite"
    assert reason in printed.err
    if form:
        told = json.loads(printed.out)
        assert told["stop_reason"] == reason and told["scenes"] == []
        assert list(told["failed"].values()) == [reason] * 2


@pytest.mark.parametrize("form", [["--json"], []], ids=["json", "tables"])
def test_a_run_whose_every_contact_did_not_converge_reports_why(
    tmp_path, capsys, solve_at_once, form
):
    solve_at_once(
        converged=False, ending=Ending.LARGEST_GRID, stop_reason="grids as fine as allowed"
    )
    arguments = ["run", CASE, *form, "--out", str(tmp_path / "out")]
    assert main([*arguments, "--pictures", "none"]) == NOT_CONVERGED
    printed = capsys.readouterr()
    reason = "1 of 1 contacts missing: point_m20_l10 (grids as fine as allowed)"
    assert reason in printed.err
    assert not form or json.loads(printed.out)["stop_reason"] == reason


def test_pictures_of_an_earlier_run_do_not_stay(tmp_path, capsys, solve_at_once):
    solve_at_once()
    out = tmp_path / "out"
    out.mkdir()
    (out / "scene_007_film.png").write_text("old")
    (out / "my_own.png").write_text("mine")
    assert main(["run", CASE, "--out", str(out)]) == CONVERGED
    assert not (out / "scene_007_film.png").exists()
    assert (out / "my_own.png").exists()


@pytest.mark.parametrize(("asked", "key_only"), [((), True), (("--pictures", "all"), False)])
def test_run_draws_key_pictures_unless_asked_for_all(
    tmp_path, capsys, solve_at_once, monkeypatch, asked, key_only
):
    solve_at_once()
    drawing = Mock(return_value=[])
    monkeypatch.setattr("pyworm.plots.draw.draw", drawing)
    assert main(["run", CASE, "--out", str(tmp_path), *asked]) == CONVERGED
    assert drawing.call_args.kwargs["key_only"] == key_only
    assert ("--pictures all" in capsys.readouterr().out) == key_only


def test_run_draws_nothing_where_none_is_asked_for(tmp_path, solve_at_once):
    solve_at_once()
    assert main(["run", CASE, "--out", str(tmp_path), "--pictures", "none"]) == CONVERGED
    assert [path.name for path in tmp_path.iterdir()] == ["result.nc"]


def test_not_converged_is_written_and_marked(tmp_path, capsys, solve_at_once):
    solve_at_once(
        converged=False, ending=Ending.LARGEST_GRID, stop_reason="grids as fine as allowed"
    )
    assert main(["run", CASE, "--out", str(tmp_path / "out")]) == NOT_CONVERGED
    assert "did not converge: grids as fine as allowed" in capsys.readouterr().out
    assert not open_result(tmp_path / "out" / "result.nc").solutions[0].converged


def test_not_a_number_is_null_in_json(tmp_path, capsys, solve_at_once, solved):
    figures = replace(solved[1].figures, mass_error=float("nan"))
    solve_at_once(converged=False, figures=figures)
    assert main(["run", CASE, "--json", "--out", str(tmp_path / "out")]) == NOT_CONVERGED
    assert json.loads(capsys.readouterr().out)["scenes"][0]["mass_error"] is None


def test_a_result_that_could_not_be_written_leaves_what_was_solved(
    tmp_path, capsys, monkeypatch, solve_at_once
):
    save = Result.save

    def full(result, path):
        if path.name == "result.nc":
            raise OSError("No space left on device")
        return save(result, path)

    solve_at_once()
    monkeypatch.setattr(Result, "save", full)
    out = tmp_path / "out"
    two = ["run", "cases/traction_steel.toml", "--slide-roll-ratio", "0.5", "2", "--out", str(out)]
    assert main(two) == FAILED
    assert "No space left on device" in capsys.readouterr().err
    assert [path.parent.name for path in out.rglob("*.*")] == ["scenes", "scenes"]
    monkeypatch.setattr(Result, "save", save)
    monkeypatch.setattr("pyworm.batch.task.solve", None)
    assert main(two) == CONVERGED
    assert "2 of 2 contacts were solved before" in capsys.readouterr().err
    assert (out / "result.nc").is_file()


def test_a_kernel_that_gives_up_is_reported_in_one_sentence(tmp_path, capsys, monkeypatch):
    def give_up(scene, plan, *how):
        raise KernelError(6)

    monkeypatch.setattr("pyworm.batch.task.solve", give_up)
    assert main(["run", CASE, "--out", str(tmp_path / "out")]) == FAILED
    assert capsys.readouterr().err == "pyworm: point_m20_l10: there is not enough memory\n"
    assert list(tmp_path.iterdir()) == []


def test_plot_draws_the_pictures_again(tmp_path, capsys, solved):
    directory, _ = solved
    result = str(directory / "result.nc")
    assert (
        main(["plot", result, "--pictures", "all", "--out", str(tmp_path / "again")]) == CONVERGED
    )
    printed = capsys.readouterr().out.split()
    drawn = {Path(name).name for name in printed}
    assert drawn > {path.name for path in directory.glob("*.png")}
    assert "scene_000_pressure.png" in drawn
    assert all(Path(name).is_file() for name in printed)


def test_check_shows_the_plan_and_solves_nothing(tmp_path, capsys, monkeypatch):
    quickly_described(monkeypatch)
    monkeypatch.chdir(tmp_path)
    assert main(["check", DRIVE]) == CONVERGED
    said = capsys.readouterr().out
    for words in (
        "Mesh phase 0.5",
        "Maximum Hertz pressure",
        "elastic-deflection",
        "film-heating",
    ):
        assert words in said
    assert list(tmp_path.iterdir()) == []


def test_check_prints_one_json_object(capsys, monkeypatch):
    quickly_described(monkeypatch)
    assert main(["check", DRIVE, "--phase", "0.25", "0.75", "--json"]) == CONVERGED
    content = json.loads(capsys.readouterr().out)
    of_run = {"expected_seconds", "expected_seconds_of_search"}
    of_case = {"assumptions", "beyond_limits", "case", "drive", "resolved", "scenes", "warnings"}
    assert set(content) == of_case | of_run | {"forces"}
    assert [scene["phase"] for scene in content["scenes"]] == [0.25, 0.75]
    assert content["resolved"]["oil"]["shear"]["limit"] == pytest.approx(100e6)
    effect = content["scenes"][0]["effects"][0]
    assert set(effect) == {"name", "on", "indicator", "influence", "reason"}


def test_doctor_finds_nothing_wrong_here(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code = main(["doctor"])
    lines = capsys.readouterr().out.splitlines()
    assert code == CONVERGED, lines
    assert all(" ok " in line for line in lines)
    assert any("fftw-3" in line for line in lines)
    assert list(tmp_path.iterdir()) == []


def test_doctor_says_what_to_do_about_a_missing_kernel(capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyworm.kernel.core", None)
    assert main(["doctor"]) == FAILED
    said = capsys.readouterr().out
    assert "kernel        NO  not built" in said
    assert "make install" in said


def test_version(capsys):
    with pytest.raises(SystemExit) as end:
        main(["--version"])
    assert end.value.code == CONVERGED
    assert capsys.readouterr().out == f"pyworm {pyworm.__version__}\n"


def test_the_package_offers_its_functions_and_not_its_modules():
    assert callable(pyworm.solve)
    assert callable(pyworm.plan)
    assert callable(pyworm.load)
    with pytest.raises(AttributeError, match=r"attribute solv$"):
        _ = pyworm.solv
