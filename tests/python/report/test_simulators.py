"""Loss tables for other simulators: the unit stepped by FMPy, Modelica, MuJoCo and URDF."""

import re
import shutil
from xml.etree import ElementTree
from zipfile import ZipFile

import numpy as np
import pytest
from made_up_losses import RATIO, made_up_table
from scipy.interpolate import RegularGridInterpolator

from pyworm.report.fmu import NoCompilerError, compiled, identifier, write_fmu
from pyworm.report.simulators import joint_friction, modelica, modelica_rows, mujoco, urdf

fmpy = pytest.importorskip("fmpy")

TABLE = made_up_table()
QUANTITIES = (
    "efficiency",
    "reverse_efficiency",
    "transmission_error",
    "mesh_stiffness",
    "output_torque",
)


@pytest.fixture(scope="module")
def unit(tmp_path_factory):
    """The unit of the table, with its library."""
    if shutil.which("cc") is None:
        pytest.skip("there is no C compiler")
    path = tmp_path_factory.mktemp("fmu") / "unit_100.fmu"
    assert write_fmu(TABLE, path) is None
    return path


def stepped(unit, points):
    """Outputs of the unit at the ends of steps whose inputs are speeds, worm torques and temperatures."""
    points = [*points, points[-1]]
    names = ("time", "speed", "torque", "temperature")
    kinds = [(name, np.float64) for name in names]
    times = np.arange(len(points), dtype=float)
    inputs = np.array([(time, *point) for time, point in zip(times, points, strict=True)], kinds)
    outputs = [*QUANTITIES, "friction_torque", "locked", "outside"]
    found = fmpy.simulate_fmu(
        str(unit),
        stop_time=times[-1],
        step_size=1.0,
        output_interval=1.0,
        input=inputs,
        output=outputs,
        validate=True,
    )
    return found[1:]


def interpolated(quantity):
    """A quantity between the points of the table by SciPy."""
    grid = TABLE.speeds, TABLE.torques, TABLE.temperatures
    return RegularGridInterpolator(grid, np.broadcast_to(quantity, TABLE.efficiency.shape))


def test_the_unit_has_the_numbers_of_the_table(unit):
    """At all points and between them, each with the worm's torque for a torque of the wheel."""
    between = [(30.0, 120.0, 320.0), (149.0, 299.0, 353.0)]
    points = [
        *((w, m, t) for w in TABLE.speeds for m in TABLE.torques for t in TABLE.temperatures),
        *between,
    ]
    efficiency, other = interpolated(TABLE.efficiency), interpolated(TABLE.other_torque)
    asked = [(w, m / (RATIO * efficiency((w, m, t))) + other((w, m, t)), t) for w, m, t in points]
    found = stepped(unit, [(w, float(m), t) for w, m, t in asked])
    expected = {
        "efficiency": efficiency(points),
        "reverse_efficiency": interpolated(TABLE.reverse_efficiency)(points),
        "transmission_error": interpolated(TABLE.transmission_error[None, :, None])(points),
        "mesh_stiffness": interpolated(TABLE.stiffness[None, :, None])(points),
        "output_torque": [m for _, m, _ in points],
    }
    for name, values in expected.items():
        assert found[name] == pytest.approx(values, rel=1e-9), name
    locked = interpolated(TABLE.reverse_efficiency)(points) <= 0
    assert list(found["locked"]) == list(locked) and locked.any() and not locked.all()
    lost = [
        float(torque) - m / RATIO for (_, torque, _), (_, m, _) in zip(asked, points, strict=True)
    ]
    assert found["friction_torque"] == pytest.approx(lost, rel=1e-9)


def test_beyond_the_table_its_end_holds(unit):
    found = stepped(unit, [(500.0, 5.0, 333.0), (-40.0, -5.0, 333.0), (0.0, 0.0, 273.15)])
    assert found["outside"].tolist() == [True, False, True]
    assert found["output_torque"][1] < 0 < found["output_torque"][0]
    assert found["output_torque"][2] == 0


def test_a_load_that_drives_makes_no_energy(unit):
    """Torque against the speed: the wheel gives what the worm takes and all losses, none if it locks."""
    fast = (float(TABLE.speeds[-1]), -10.0, float(TABLE.temperatures[0]))
    slow = (float(TABLE.speeds[0]), -10.0, float(TABLE.temperatures[0]))
    found = stepped(unit, [fast, slow])
    assert not found["locked"][0] and found["locked"][1]
    given = -found["output_torque"] / RATIO
    assert given[0] > 10.0
    assert found["friction_torque"][0] == pytest.approx(given[0] - 10.0)
    assert given[1] == 0.0


def test_the_description_is_valid(unit):
    description = fmpy.read_model_description(str(unit), validate=True)
    assert description.fmiVersion == "3.0" and description.modelName == "unit_100"
    with ZipFile(unit) as content:
        names = content.namelist()
        source = content.read("sources/unit_100.c").decode()
    assert "sources/buildDescription.xml" in names
    assert any(name.startswith("binaries/") for name in names)
    assert "@" not in source and description.instantiationToken in source


def test_without_a_compiler_the_source_stays(tmp_path, monkeypatch):
    monkeypatch.setenv("CC", "false")
    path = tmp_path / "unit.fmu"
    assert write_fmu(TABLE, path) == "false failed: without a message"
    with ZipFile(path) as content:
        assert not any(name.startswith("binaries/") for name in content.namelist())
    monkeypatch.setattr("pyworm.report.fmu.sys.platform", "plan9")
    with pytest.raises(NoCompilerError, match="libraries for plan9"):
        compiled("")
    monkeypatch.undo()
    monkeypatch.setattr("pyworm.report.fmu.COMPILE_SECONDS", 0.1)
    monkeypatch.setenv("CC", "sleep 5")
    monkeypatch.setattr("pyworm.report.fmu.COMPILER_FLAGS", ())
    with pytest.raises(NoCompilerError):
        compiled("")


def test_names_become_identifiers():
    assert [identifier(name) for name in ("zi_drive", "100 mm", "ü-1")] == [
        "zi_drive",
        "gear_100_mm",
        "gear___1",
    ]


def test_modelica_has_the_columns_of_its_loss_table():
    rows = modelica_rows(TABLE, 1, 0)
    assert rows[0, 0] == 0 and rows[0, 1:] == pytest.approx(rows[1, 1:])
    assert rows[1:, 0] == pytest.approx(TABLE.speeds)
    assert rows[1:, 1] == pytest.approx(TABLE.efficiency[:, 1, 0])
    assert rows[1, 2] == 1e-6 < rows[3, 2]
    other = np.array([0.3, 0.4, 0.6])
    assert rows[1:, 3] == pytest.approx(rows[1:, 1] * other)
    assert rows[3, 4] == pytest.approx(0.6 / rows[3, 2])
    text = modelica(TABLE)
    tables = re.findall(r"lossTable=\[(.*?)\]", text, re.DOTALL)
    assert len(tables) == 4 and text.count("LossyGear(") == 4
    read = np.array([[float(value) for value in row.split(",")] for row in tables[2].split(";")])
    assert read == pytest.approx(rows, rel=1e-8)
    assert "package unit_100 \"A unit of '100 mm': flange_a is the worm\"" in text


def test_an_efficiency_of_zero_is_not_divided_by():
    table = made_up_table(lambda *at: 1 / 5.3 + 0 * sum(at))
    assert (modelica_rows(table, 0, 0)[:, 2] >= 1e-6).all()


def test_a_lossy_gear_of_the_rows_has_the_torques_of_the_table():
    """Flange torques a and b by the library's balance: tau_b = -i (tau_a - loss), both ways of the power."""
    speed, eta_1, eta_2, tau_1, tau_2 = modelica_rows(TABLE, 1, 1)[3]
    other = TABLE.other_torque[2, 1, 1]
    worm = 10.0
    # worm driving: loss = (1 - eta_mf1) tau_a + tau_bf1
    driven = worm - ((1 - eta_1) * worm + tau_1)
    assert driven == pytest.approx(eta_1 * (worm - other))
    # wheel driving, the worm held by -worm: loss = (1 - 1/eta_mf2) tau_a + tau_bf2
    pushing = -worm - ((1 - 1 / eta_2) * -worm + tau_2)
    assert -pushing == pytest.approx((worm + other) / eta_2)
    assert speed > 0


def test_joints_have_the_friction_of_the_table():
    found = joint_friction(TABLE)
    lost = (TABLE.friction_torque + TABLE.other_torque)[:, 1, 1] * RATIO
    fitted = found.dry + found.damping * TABLE.speeds / RATIO
    assert np.abs(fitted - lost).max() == pytest.approx(found.deviation)
    assert found.dry >= 0 and found.damping >= 0 and found.locked
    model, robot = ElementTree.fromstring(mujoco(TABLE)), ElementTree.fromstring(urdf(TABLE))
    joint, motor = model.find(".//joint"), model.find(".//motor")
    assert float(joint.get("frictionloss")) == pytest.approx(found.dry, rel=1e-8)
    assert float(joint.get("damping")) == pytest.approx(found.damping, rel=1e-8)
    assert float(motor.get("gear")) == RATIO
    dynamics = robot.find("./joint/dynamics")
    assert float(dynamics.get("friction")) == pytest.approx(found.dry, rel=1e-8)
    assert float(robot.find("./transmission/actuator/mechanicalReduction").text) == RATIO
    assert "the wheel cannot drive the worm here" in urdf(TABLE)
