"""Running-in programmes: what ends a stage, smoother flanks, the own load with and without them."""

import csv
import json
import tomllib
from dataclasses import replace
from itertools import pairwise

import pytest
from folders import CASES

from pyworm.batch import running_in as batch
from pyworm.batch.running_in import running_in, state_summary
from pyworm.case.case import case_of
from pyworm.cli.main import main
from pyworm.formulas.wear_law import truncated_roughness
from pyworm.io.input_error import CaseError
from pyworm.report.running_in import words

ROUGH = (CASES / "errichello_speed_increaser.toml").read_text().replace('"20 uin"', '"33 uin"')

COOLING = """
[cooling]
ambient_temperature = "25 degC"
other_loss = "300 W"

[cooling.housing]
length = "1000 mm"
width = "500 mm"
height = "700 mm"
"""

STAGE = """
[[running_in.stages]]
torque = "{} kN m"
speed = "375 rpm"
duration = "{} h"
"""

PROGRAMME = (
    '\n[running_in]\nservice = "3 h"\n'
    + STAGE.format(15, 40)
    + 'oil_temperature = "50 degC"\n'
    + STAGE.format(22, 40)
    + "asperity_load_ratio = 0.83\n"
    + STAGE.format(22, 2)
)


def gears(text=ROUGH + COOLING + PROGRAMME):
    return case_of(tomllib.loads(text), "increaser", CASES)


@pytest.fixture(scope="module")
def found():
    return running_in(gears())


def test_each_stage_ends_by_its_criterion(found):
    assert found.programme.ended_by == (
        "oil temperature",
        "asperity load ratio",
        "duration",
        "duration",
    )
    warm, run_in, fixed, _ = map(found.programme.of_stage, found.programme.stages)
    assert warm[-1].oil >= 323.15 > warm[-2].oil
    assert run_in[-1].asperity_load_fraction <= 0.83 < run_in[-2].asperity_load_fraction
    assert fixed[-1].time - fixed[0].time == pytest.approx(7200)
    assert fixed[0].time == run_in[-1].time


def test_flanks_are_smoothed_by_what_is_worn_off_their_summits(found):
    states = found.programme.states
    for before, after in pairwise(states):
        for body in (0, 1):
            assert after.roughness[body] <= before.roughness[body]
            assert after.wear[body] >= before.wear[body]
    # the deepest place loses more than the mean that cuts the roughness
    cut = 33 * 25.4e-9
    for number in (0, 1):
        last = states[-1]
        assert truncated_roughness(cut, last.wear[number]) < last.roughness[number] < cut


def test_new_flanks_under_their_own_load_are_hotter_than_in_a_programme(found):
    (own,) = found.none.stages
    stages = found.programme.stages
    assert found.none.ended_by == ("duration",) and own == stages[-1]
    rough, smooth = (sequence.of_stage(own)[-1] for sequence in (found.none, found.programme))
    assert rough.roughness[0] > smooth.roughness[0]
    half = max(state.contact for state in found.programme.of_stage(stages[2]))
    assert max(state.contact for state in found.programme.of_stage(own)) > half
    assert found.scuffing_temperature == pytest.approx(487.6, abs=0.1)
    assert json.dumps(found.summary())
    assert state_summary(found.none.states[0])["oil_temperature_C"] == pytest.approx(25)


def test_the_command_compares_both(tmp_path, capsys, monkeypatch, found):
    monkeypatch.setattr(batch, "running_in", lambda case: found)
    path, out = tmp_path / "unit.toml", tmp_path / "out"
    path.write_text(ROUGH + COOLING + PROGRAMME)
    assert main(["duty", str(path), "--running-in", "--out", str(out)]) == 0
    text = capsys.readouterr().out
    assert "None: contacts stay below the scuffing temperature of 214 °C." in text
    with (out / "running_in.csv").open() as file:
        sequences = {row["sequence"] for row in csv.DictReader(file)}
    assert sequences == {"programme", "none"}
    assert (out / "running_in.png").stat().st_size > 10_000
    cooler = replace(found, scuffing_temperature=340.0)
    assert "reach the scuffing temperature of 67 °C after" in " ".join(words(cooler))


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (ROUGH + COOLING, r"has no \[running_in\]"),
        (ROUGH + COOLING + "\n[running_in]\n", r"stages is missing"),
        (ROUGH + PROGRAMME, r"\[running_in\] asks for \[cooling\]"),
        (ROUGH.replace('roughness = "33 uin"', "") + COOLING + PROGRAMME, "needs a roughness"),
    ],
)
def test_programmes_that_cannot_be_are_refused(text, reason):
    with pytest.raises(CaseError, match=reason):
        running_in(gears(text))
