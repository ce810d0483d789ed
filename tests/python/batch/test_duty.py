"""Duty of gear units: blocks, temperatures that repeat, energy, damages, files and refusals."""

import csv
import json
import tomllib

import numpy as np
import pytest
from folders import CASES
from refusals import changed

import pyworm
from pyworm.batch import duty_run
from pyworm.batch.duty import duty_model
from pyworm.batch.operating_points import NotSolvedError
from pyworm.case.case import case_of
from pyworm.case.duty import read_blocks
from pyworm.cli.main import main
from pyworm.drives.mesh_loss import ContactLoss
from pyworm.formulas.unit_factors import RPM
from pyworm.io.input_error import CaseError
from pyworm.report.duty import words

UNIT = """
[cooling]
ambient_temperature = "20 degC"
other_loss = "300 W"

[cooling.housing]
length = "1000 mm"
width = "500 mm"
height = "700 mm"

[bearings.pinion]
shaft = "pinion"
side = "thrust"
elements = "roller"
dynamic_rating = "500 kN"

[drive.pinion_shaft]
bearing_span = "400 mm"
"""

BLOCKS = """
[duty]
{start}
[[duty.blocks]]
name = "half"
torque = "20 kN m"
speed = "375 rpm"
duration = "6 h"

[[duty.blocks]]
name = "full"
torque = "40 kN m"
speed = "375 rpm"
duration = "1 h"
ambient = "30 degC"

[[duty.blocks]]
torque = "0 N m"
speed = "0 rpm"
duration = "5 h"
"""

TEXT = (CASES / "errichello_speed_increaser.toml").read_text()


PERIODIC = BLOCKS.format(start="")


def gears(duty=PERIODIC, *changes, directory=CASES):
    return case_of(tomllib.loads(changed(TEXT + UNIT, *changes) + duty), "increaser", directory)


@pytest.fixture(scope="module")
def found():
    return pyworm.duty(gears())


def test_a_repeated_duty_comes_back_and_gives_off_what_it_loses(found):
    history, cycle = found.model.history, found.model.cycle
    for node in found.model.base.network().capacities:
        first, last = history.temperatures[node][[0, -1]]
        assert last == pytest.approx(first, abs=2e-3), node
    assert found.imbalance < 1e-6
    assert found.energy_lost == pytest.approx(sum(block.energy_lost for block in found.blocks))
    # power through the mesh less that of the tooth and bearing losses over all blocks
    losses = [block.tooth_loss + 300 for block in found.blocks[:2]]
    hours = [block.duration for block in cycle.blocks[:2]]
    assert found.energy_lost == pytest.approx(np.dot(losses, hours), rel=2e-3)
    assert history.temperatures["ambient"][150] == pytest.approx(303.15)


def test_a_long_block_ends_in_the_steady_state_of_its_load():
    long = BLOCKS.format(start='start = "cold"').replace('"6 h"', '"600 h"')
    model = duty_model(gears(long))
    state = model.loads[model.cycle.blocks[0].load]
    steady = state.unit.network(fit=model.base.fit, ambient=293.15).steady()
    assert abs(steady.imbalance) < 1e-6
    end = model.times_of_block - 1
    for node, value in steady.temperatures.items():
        assert model.history.temperatures[node][end] == pytest.approx(value, abs=0.01), node
    assert model.history.temperatures["oil"][0] == 293.15


def test_losses_follow_the_temperature_and_the_hottest_block_wears_and_damages_most(found):
    half, full, rest = found.blocks
    state = found.model.loads[found.model.cycle.blocks[0].load]
    cold, hot = (state.friction.at(kelvin).loss for kelvin in (293.15, 353.15))
    # thinner oil carries less of the load: rough teeth rub more, by H_V mu P
    assert hot.loss > cold.loss
    assert hot.loss == pytest.approx(hot.power * state.drive.loss_factor * hot.friction)
    assert full.oil_max > half.oil_max > rest.temperatures["oil"]
    assert rest.damage is None and rest.energy_lost == 0
    assert found.decisive == {"bearing pinion": "full", "energy": "half"}
    # ISO 281 of rollers: twice the load, 2^(10/3) of the damage in an hour
    ratio = full.damage["bearing pinion"] / (half.damage["bearing pinion"] / 6)
    assert ratio == pytest.approx(2 ** (10 / 3), rel=1e-6)
    assert full.wear["pinion"] > half.wear["pinion"] / 6 > 0
    assert found.lives_h["bearing pinion"] == pytest.approx(12 / found.damage["bearing pinion"])
    assert any("pitting" in sentence for sentence in found.not_rated)


def test_solved_loads_correct_the_losses(monkeypatch, found):
    """Contacts that lose 1.5 times the closed forms' friction warm the oil more."""

    class Solved:
        converged, stop_reason = True, ""

        def __init__(self, scene, plan):
            self.scene = scene
            self.figures = type("Figures", (), {"film_min": type("Film", (), {"value": 1e-7})})

    case, before = found.model.case, found

    def losses(solutions):
        state = before.model.loads[before.model.cycle.blocks[0].load]
        temperature = before.blocks[0].temperatures
        mean = (temperature["pinion"] + temperature["gear"]) / 2
        friction = 1.5 * state.friction.at(mean).loss.friction
        return [ContactLoss(one.scene.phase, 1.0, friction, 1.0, 0.02) for one in solutions]

    monkeypatch.setattr(duty_run, "solve", Solved)
    monkeypatch.setattr(duty_run, "plan", lambda *given: None)
    monkeypatch.setattr(duty_run, "contact_losses", losses)
    after = pyworm.duty(case, solve_loads=1)
    (confirmed,) = after.confirmed
    assert confirmed.block == "half"
    assert confirmed.deviation == pytest.approx(1 / 1.5 - 1, rel=0.02)
    assert after.blocks[0].oil_max > before.blocks[0].oil_max + 1
    Solved.converged = False
    with pytest.raises(NotSolvedError, match=r"half, phase 0\.06 did not converge"):
        pyworm.duty(case, solve_loads=1)


def test_the_command_writes_tables_and_a_picture(tmp_path, capsys):
    """Teeth lose 500 W by a table, whatever their temperature."""
    path, out, table = tmp_path / "unit.toml", tmp_path / "out", tmp_path / "table.csv"
    (tmp_path / "day.csv").write_text(
        "torque_N_m,speed_rpm,time_s,ambient_C\n20000,375,3600,10\n0,0,1800,10\n"
    )
    path.write_text(TEXT + UNIT + '\n[duty]\nfile = "day.csv"\nstart = "cold"\n')
    table.write_text(
        "worm_speed_rpm,wheel_torque_N_m,oil_temperature_C,friction_torque_N_m\n"
        f"375,20000,60,{500 / (375 / RPM)}\n"
    )
    assert main(["duty", str(path), "--out", str(out), "--table", str(table)]) == 0
    text = capsys.readouterr().out
    assert "block 1 (100 %)" in text and "Heat balance" in text and "in a year" not in text
    with (out / "blocks.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["name"] for row in rows] == ["block 1", "block 2"]
    assert float(rows[0]["energy_lost_J"]) == pytest.approx(800 * 3600, rel=1e-5)
    with (out / "temperatures.csv").open() as file:
        last = list(csv.DictReader(file))[-1]
    assert float(last["energy_lost_J"]) == pytest.approx(800 * 3600, rel=1e-5)
    assert (out / "duty.png").stat().st_size > 10_000


def test_all_of_it_is_an_object_for_json(found):
    held = json.loads(json.dumps(found.summary()))
    assert held["imbalance"] < 1e-6 and held["periodic"]
    assert held["energy_lost_J_per_year"] == pytest.approx(held["energy_lost_J"] * 730)
    assert held["blocks"][0]["duration_h"] == 6
    assert held["blocks"][2]["film_min_m"] is None
    assert len(held["time_h"]) == len(held["oil_temperature_C"])
    assert "of the pinion" in " ".join(words(found)) and "in a year" in " ".join(words(found))


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ("torque,speed\n", "its first line is torque, speed"),
        ("torque_N_m,speed_rpm,time_s\n", "no block with a speed"),
        ("torque_N_m,speed_rpm,time_s\n1,a,3\n", "line 2 is 1,a,3; 3 numbers"),
        ("torque_N_m,speed_rpm,time_s\n0,10,3\n", "torque above 0 where"),
        ("torque_N_m,speed_rpm,time_s\n" + "1,1,1\n" * 2001, "more than 2000 blocks"),
    ],
)
def test_files_that_are_no_duty_are_refused(tmp_path, content, reason):
    file = tmp_path / "duty.csv"
    file.write_text(content)
    with pytest.raises(ValueError, match=reason):
        read_blocks(file)


@pytest.mark.parametrize(
    ("duty", "changes", "reason"),
    [
        ("", (), r"has no \[duty\]"),
        ('[duty]\nfile = "none.csv"\n', (), "none.csv.*no such file"),
        ("[duty]\n", (), "give either blocks or file"),
        (
            '[duty]\n[[duty.blocks]]\ntorque = "0 N m"\nspeed = "0 rpm"\nduration = "1 h"\n',
            (),
            "none of them has a speed",
        ),
        (
            '[duty]\n[[duty.blocks]]\ntorque = "0 N m"\nspeed = "1 rpm"\nduration = "1 h"\n',
            (),
            "torque must be above 0",
        ),
    ],
)
def test_duties_that_cannot_be_are_refused(duty, changes, reason):
    with pytest.raises(CaseError, match=reason):
        pyworm.duty(gears(duty, *changes))


def test_a_unit_without_sizes_or_cooling_is_refused():
    block = BLOCKS.format(start="")
    conductance = UNIT.split("[cooling.housing]")[0] + 'conductance = "80 W/K"\n'
    with pytest.raises(CaseError, match=r"need \[cooling.housing\]"):
        pyworm.duty(case_of(tomllib.loads(TEXT + conductance + block), "unit", CASES))
    with pytest.raises(CaseError, match=r"\[duty\] asks for \[cooling\]"):
        case_of(tomllib.loads(TEXT + block), "unit", CASES)
    with pytest.raises(CaseError, match="solve_loads = -1"):
        pyworm.duty(gears(), solve_loads=-1)
    with pytest.raises(CaseError, match=r"none\.csv: no such file"):
        pyworm.duty(gears(), table="none.csv")
