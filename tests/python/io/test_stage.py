"""Long work says what it does, once; short work says nothing."""

from time import sleep

import pytest
from folders import CASES

from pyworm.cli.main import main
from pyworm.io.stage import long_stages_said, stage
from pyworm.solver.cost import calibration

PATIENCE = 0.06


@pytest.fixture(autouse=True)
def impatient(monkeypatch, unhurried):
    monkeypatch.setattr("pyworm.io.stage.PATIENCE", PATIENCE)


def test_a_long_stage_is_said_once_and_of_nested_ones_the_innermost(capsys):
    with long_stages_said(), stage("reading"), stage("counting teeth"):
        sleep(5 * PATIENCE)
    assert capsys.readouterr().err == "pyworm: still counting teeth\n"


def test_the_outer_stage_is_said_after_the_inner_one_has_ended(capsys):
    with long_stages_said(), stage("reading"):
        with stage("counting teeth"):
            pass
        sleep(5 * PATIENCE)
    assert capsys.readouterr().err == "pyworm: still reading\n"


def test_short_stages_and_work_without_a_name_say_nothing(capsys):
    with long_stages_said():
        with stage("counting teeth"):
            pass
        sleep(5 * PATIENCE)
    with stage("counting teeth"):  # of the library, which prints nothing
        sleep(3 * PATIENCE)
    assert capsys.readouterr().err == ""


def test_a_failure_ends_its_stage(capsys):
    with pytest.raises(ZeroDivisionError), long_stages_said(), stage("counting teeth"):
        _ = 1 / 0
    with long_stages_said():
        sleep(5 * PATIENCE)
    assert capsys.readouterr().err == ""


def test_the_first_check_on_a_machine_says_that_it_measures_its_speed(
    monkeypatch, tmp_path, capsys
):
    measured = calibration.calibration()

    def slow():
        sleep(6 * PATIENCE)
        return measured

    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(calibration, "calibrate", slow)
    assert main(["check", str(CASES / "line_m20_l10.toml")]) == 0
    said = capsys.readouterr().err
    assert f"pyworm: still measuring the speed of this machine, to be kept in {tmp_path}" in said
