"""Loss tables: spread of solved points, emulation and its error, check, refusals, files of the command."""

import json
from math import atan, isinf, isnan, pi, radians, tan
from pathlib import Path

import numpy as np
import pytest
from made_up_losses import BALANCE, MadeUpSolving, power_law, stribeck
from refusals import changed, refusal
from zi_drives import coarse_springs

import pyworm
from pyworm.batch import loss_table, operating_points
from pyworm.batch.loss_table import Grid, spread_nodes, table_mesh
from pyworm.batch.operating_points import NotSolvedError, OperatingPoint
from pyworm.cli.main import main
from pyworm.drives.torque_balance import TorqueBalance
from pyworm.drives.worm import dataset, drive
from pyworm.drives.worm.loads import mesh_stiffness
from pyworm.drives.worm.loads.mesh_stiffness import mesh_at_torque
from pyworm.formulas.response_surface import ScatteredSurface

CASES = Path(__file__).parents[3] / "cases"
UNIT = CASES / "worm_drawing.toml"
GRID = Grid((5.0, 20.0, 80.0, 150.0), (50.0, 120.0, 300.0), (313.15, 333.15, 353.15))


@pytest.fixture
def unit(monkeypatch):
    """The catalogue unit, its meshes by closed forms."""
    coarse_springs(monkeypatch)
    monkeypatch.setattr(dataset, "LOADED_PHASES", 11)
    monkeypatch.setattr(drive, "torque_balance", lambda cycle: BALANCE)
    monkeypatch.setattr(loss_table, "_point", lambda case, phases: OperatingPoint(case, ()))
    return pyworm.load(UNIT)


@pytest.mark.parametrize("friction", [0.0, 0.05, 0.1, 0.25])
def test_a_screw_of_square_thread_has_the_efficiencies_of_the_textbook(friction):
    """tan(gamma) / tan(gamma + rho) and tan(gamma - rho) / tan(gamma); it locks from rho = gamma."""
    lead_angle, friction_angle = radians(11.31), atan(friction)
    tangent = tan(lead_angle)
    screw = TorqueBalance(drag=-tangent, rubbing=tangent + 1 / tangent)
    efficiency = float(screw.efficiency(friction))
    assert efficiency == pytest.approx(tangent / tan(lead_angle + friction_angle))
    reverse = tan(lead_angle - friction_angle) / tangent
    assert float(screw.reverse_efficiency(friction)) == pytest.approx(reverse)
    assert screw.friction(efficiency) == pytest.approx(friction, abs=1e-12)


def test_a_mesh_yields_as_springs_in_parallel(monkeypatch, tmp_path):
    """Teeth far softer than their contacts: pairs in mesh times stiffness times lever squared."""
    coarse_springs(monkeypatch)
    monkeypatch.setattr(mesh_stiffness, "PITCH_PHASES", 17)
    path = tmp_path / "soft.toml"
    stiffness = '[drive]\nstiffness = "5 N/um"\n'
    path.write_text(changed(UNIT.read_text(), ("[drive]\n", stiffness), ('"300 Nm"', '"20 Nm"')))
    soft = pyworm.load(path).drive
    found = mesh_at_torque(soft, BALANCE)
    lever = float(soft.arms(np.array([0.5])).wheel_normal[0])
    parallel = soft.mean_teeth_in_contact * 5e6 * lever**2
    assert found.stiffness == pytest.approx(parallel, rel=0.1)
    turns = [soft.shared(float(phase)).turn for phase in (0.3, 0.5, 0.7)]
    assert found.transmission_error == pytest.approx(np.mean(turns), rel=0.1)
    assert 0 < found.transmission_error_range < found.transmission_error


def test_the_balance_of_a_mesh_is_that_of_its_levers(monkeypatch):
    """Drag is tan(gamma) / cos(alpha_n); the wheel locks from a friction of tan(gamma) cos(alpha_n) on."""
    coarse_springs(monkeypatch)
    monkeypatch.setattr(dataset, "LOADED_PHASES", 41)
    balance = pyworm.load(UNIT).drive.mesh_at_torque().balance
    tangent, cosine = 2 / 10, np.cos(radians(20))
    assert -balance.drag == pytest.approx(tangent / cosine, rel=0.05)
    limit = tangent * cosine
    assert balance.reverse_efficiency(0.95 * limit) > 0 > balance.reverse_efficiency(1.05 * limit)


def test_points_spread_from_the_middle_to_the_corners():
    nodes = spread_nodes(GRID, 9)
    assert nodes[0] == (1, 1, 1)
    assert {node for node in nodes[1:] if all(number in (0, 2, 3) for number in node)} == {
        *nodes[1:]
    }
    assert len({*spread_nodes(GRID, 100)}) == 36
    further = spread_nodes(GRID, 5, nodes)
    assert len(further) == 5 and not {*further} & {*nodes}
    assert spread_nodes(Grid((10.0,), (100.0,), (333.0,)), 3) == [(0, 0, 0)]


def test_a_power_law_is_interpolated_exactly():
    nodes = GRID.nodes
    values = np.array(
        [power_law(GRID.speeds[i], GRID.torques[j], GRID.temperatures[k]) for i, j, k in nodes]
    )
    chosen = [nodes.index(node) for node in spread_nodes(GRID, 14)]
    places = GRID.places(nodes)
    surface = ScatteredSurface(places[chosen], values[chosen])
    assert surface.at(places) == pytest.approx(values, rel=1e-9)
    errors = surface.errors()
    assert np.nanmax(np.abs(errors)) < 1e-9
    corners = np.all((places[chosen] == 0) | (places[chosen] == 1), axis=1)
    assert np.array_equal(np.isnan(errors), corners)


def test_no_error_is_known_of_too_few_points():
    surface = ScatteredSurface(np.array([[0.0], [1.0]]), np.array([1.0, 2.0]))
    assert all(map(isnan, surface.errors()))
    assert isinf(loss_table._stated_error(surface, False))
    assert loss_table._stated_error(surface, True) == 0.0
    one = ScatteredSurface(np.zeros((1, 0)), np.array([0.02]))
    assert one.at(np.zeros((3, 0))) == pytest.approx([0.02] * 3)


def test_a_table_has_the_losses_of_its_points(unit):
    solving = MadeUpSolving()
    table, checked = loss_table.loss_table(unit, GRID, solving, 12, [0.3, 0.5, 0.7], checks=10)
    assert solving.solved == 22 and table.solved.sum() == 12
    assert table.emulation_error < 1e-9 and table.solution_error == pytest.approx(0.02)
    assert len(checked.deviations) == 10 and max(map(abs, checked.deviations)) < 1e-9
    friction = power_law(20.0, 300.0, 353.15)
    assert table.friction[1, 2, 2] == pytest.approx(friction)
    assert table.efficiency[1, 2, 2] == pytest.approx(BALANCE.efficiency(friction))
    # power in = power out over the efficiency
    power = table.worm_torque * table.speeds[:, None, None]
    out = table.torques[None, :, None] * table.speeds[:, None, None] / table.ratio
    out = np.broadcast_to(out, power.shape)
    assert power * table.efficiency == pytest.approx(out)
    lost = table.friction_torque * table.speeds[:, None, None]
    assert lost == pytest.approx(power - out)


def test_ten_solved_points_lie_within_the_stated_error(unit):
    """A transition of friction that is no power law: the error by leaving out covers what is emulated."""
    grid = Grid(tuple(np.geomspace(5, 150, 7)), (50.0, 300.0), (313.15, 333.15, 353.15))
    table, checked = loss_table.loss_table(
        unit, grid, MadeUpSolving(stribeck), 20, [0.5], checks=10
    )
    assert 1e-3 < table.emulation_error < 0.5
    assert checked.within == 10
    assert checked.summary()["deviation_max"] <= table.emulation_error
    assert (table.efficiency_error[table.solved] == 0).all()
    assert (table.efficiency_error[~table.solved] > 0).all()


def test_bearings_seals_and_churning_are_those_of_the_housing(monkeypatch, tmp_path):
    coarse_springs(monkeypatch)
    monkeypatch.setattr(dataset, "LOADED_PHASES", 11)
    path = tmp_path / "cooled.toml"
    path.write_text(
        UNIT.read_text()
        + '\n[cooling]\nconductance = "10 W/K"\nambient_temperature = "20 degC"\nother_loss = "80 W"\n'
    )
    grid = Grid((20.0, 80.0), (300.0,), (333.15,))
    table, _ = loss_table.loss_table(pyworm.load(path), grid, MadeUpSolving(), 2, [0.5])
    assert table.other_torque[:, 0, 0] == pytest.approx([4.0, 1.0])
    assert table.emulation_error == 0.0


def test_other_gears_and_oils_of_one_temperature_are_refused(monkeypatch):
    coarse_springs(monkeypatch)
    with pytest.raises(pyworm.CaseError, match="a table is made of a worm drive"):
        table_mesh(pyworm.load(CASES / "spur_pair.toml"), False)
    one_tooth = pyworm.load(CASES / "zi_sharif_2001.toml")
    with pytest.raises(pyworm.CaseError, match=r"no teeth share; give a torque in \[operation\]"):
        table_mesh(one_tooth, False)
    own_oil = pyworm.load(CASES / "zi_drive.toml")
    assert table_mesh(own_oil, False).torque == 4000
    with pytest.raises(pyworm.CaseError, match="--temperatures needs an oil by name"):
        table_mesh(own_oil, True)


def words(tmp_path, *more):
    values = ("--speeds", "200 rpm", "700 rpm", "1500 rpm", "--torques", "50 N m", "300 N m")
    return ["table", str(UNIT), *values, "--out", str(tmp_path / "out"), *more]


def test_the_command_writes_all_files_and_says_their_errors(unit, tmp_path, capsys, monkeypatch):
    made_up = MadeUpSolving(stribeck)
    monkeypatch.setattr(
        operating_points.Solving, "results", lambda self, points: made_up.results(points)
    )
    monkeypatch.setenv("CC", "no-such-compiler")
    assert main(words(tmp_path, "--points", "5", "--check", "1", "--json", "--phase", "0.5")) == 0
    said = capsys.readouterr()
    assert "has its C source only: there is no C compiler no-such-compiler" in said.err
    found = json.loads(said.out)
    assert len(found["points"]) == 6 and found["check"]["points"] == 1
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        *("loss_table.csv", "worm_drawing.mo", "worm_drawing_mujoco.xml"),
        *("worm_drawing.urdf", "worm_drawing.fmu"),
    }
    rows = (tmp_path / "out/loss_table.csv").read_text().splitlines()
    assert len(rows) == 7 and rows[0].startswith(
        "worm_speed_rpm,wheel_torque_N_m,oil_temperature_C"
    )
    speed = 200 * pi / 30
    expected = BALANCE.efficiency(stribeck(speed, 50.0, 333.15))
    assert float(rows[1].split(",")[3]) == pytest.approx(expected, rel=1e-6)


def test_a_check_that_fails_is_an_exit_code(unit, tmp_path, capsys, monkeypatch):
    made_up = MadeUpSolving(stribeck)
    monkeypatch.setattr(
        operating_points.Solving, "results", lambda self, points: made_up.results(points)
    )
    monkeypatch.setattr(loss_table, "_stated_error", lambda surface, all_solved: 1e-9)
    monkeypatch.setenv("CC", "no-such-compiler")
    assert main(words(tmp_path, "--points", "5", "--check", "1")) == 3
    said = capsys.readouterr()
    assert "0 of 1 further points within the error of 1e-07 %" in said.out
    assert "0 of 1 further points" in said.err


def test_wrong_options_and_unsolved_points_are_said(unit, tmp_path, capsys, monkeypatch):
    falling = ["table", str(UNIT), "--speeds", "500 rpm", "200 rpm"]
    assert "--speeds 500 rpm 200 rpm: must rise" in refusal(falling, tmp_path, capsys)
    unknown = ["table", str(UNIT), "--torques", "500 rpm"]
    assert "--torques 500 rpm: must be a torque" in refusal(unknown, tmp_path, capsys)
    assert "--points -1: must be" in refusal(words(tmp_path, "--points", "-1"), tmp_path, capsys)

    def fail(self, points):
        raise NotSolvedError("phase 0.5 did not converge: no reason")

    monkeypatch.setattr(operating_points.Solving, "results", fail)
    assert main(words(tmp_path)) == 3
    assert "phase 0.5 did not converge" in capsys.readouterr().err


@pytest.mark.parametrize("count", [1, 2, 3, 5])
def test_few_places_in_a_plane_have_a_surface(count):
    places = np.array([[0, 0, 0], [1, 1, 1], [0, 0, 1], [1, 1, 0], [0.5, 0.5, 0.5]])[:count]
    surface = ScatteredSurface(places.astype(float), np.linspace(0.02, 0.03, count))
    assert surface.at(places.astype(float)) == pytest.approx(surface.responses)
    assert np.isfinite(surface.at(np.array([[0.3, 0.9, 0.2]]))).all()
