"""Ten tasks of a study without a file, each a function of no more statements than stated here.

Statements are those of the function's body but for `return`, which hands what was found to the test.
"""

import ast
import inspect
import textwrap

import pytest
from folders import ROOT

import pyworm

STATEMENTS = {
    "whole_gear_set": 3,
    "measured_surface": 5,
    "export": 1,
    "formulas": 1,
}
"""Task -> most statements."""

PAO_220 = {"name": "PAO VG 220", "temperature": "60 degC"}


def whole_gear_set():
    """Load sharing, friction and efficiency of a pair of gears over their mesh cycle."""
    gears = pyworm.GearPair(
        centre_distance="91.5 mm",
        module="4.5 mm",
        pressure_angle="20 deg",
        face_width="14 mm",
        pinion={"teeth": 16, "profile_shift": 0.1817},
        gear={"teeth": 24, "profile_shift": 0.1715},
        driver="pinion",
        pinion_speed="1500 rpm",
        power="30 kW",
        oil=PAO_220,
        bodies=("16MnCr5", "16MnCr5"),
    )
    result = pyworm.run(gears, accuracy="50 %", effects=("auto", "-squeeze"), progress=False)
    efficiency = result.mesh_loss.efficiency
    return gears, result, efficiency


def measured_surface(heights):
    """Film between a measured flank and a plane."""
    gap = pyworm.read_gap(heights)
    steel = pyworm.named_body("16MnCr5")
    oil = pyworm.named_oil("PAO VG 220").oil("60 degC")
    scene = pyworm.Scene(
        gap=gap,
        load="60 N",
        motions=(pyworm.RigidMotion("1 m/s", 0), pyworm.RigidMotion("1 m/s", 0)),
        bodies=(steel, steel),
        oil=oil,
    )
    solution = pyworm.solve(scene, accuracy="50 %", effects="isothermal", quantities=("film",))
    return solution


def export(solution, file):
    """Fields for another program."""
    pyworm.write_vtk(solution, file)


def formulas(scene):
    """Films by every published formula, with ranges and deviations."""
    table = pyworm.compare_formulas(scene)
    return table


def statements(task):
    """Number of statements of a task."""
    (function,) = ast.parse(textwrap.dedent(inspect.getsource(task))).body
    return sum(
        isinstance(node, ast.stmt) and not isinstance(node, ast.Return)
        for statement in function.body[1:]
        for node in ast.walk(statement)
    )


@pytest.mark.parametrize("task", STATEMENTS)
def test_a_task_takes_as_few_statements_as_stated(task):
    assert statements(globals()[task]) == STATEMENTS[task]


def test_a_whole_gear_set(tmp_path):
    gears, result, efficiency = whole_gear_set()
    assert result.converged
    assert [solution.phase for solution in result.solutions] == [0.1, 0.3, 0.5, 0.7, 0.9]
    assert 0.98 < efficiency < 1
    kept = pyworm.open_result(result.save(tmp_path / "gears.nc"))
    assert kept.solutions == result.solutions
    assert kept.mesh_loss == result.mesh_loss
    checked = pyworm.check(gears, phases=(0.5,), accuracy="50 %")
    assert checked.contacts[0].scene.load == pytest.approx(result.solutions[2].load)
    assert checked.summary()["drive"] == checked.geometry
    ratings = pyworm.rate(gears)
    assert ratings["films"] in tuple(ratings)
    assert ratings.summary()["not_rated"]


def test_a_measured_surface_its_export_and_formulas(tmp_path):
    solution = measured_surface(ROOT / "cases/gap_example.npz")
    assert solution.converged
    export(solution, tmp_path / "flank.vti")
    assert (tmp_path / "flank.vti").stat().st_size > 10_000
    steel = pyworm.named_body("16MnCr5")
    line = pyworm.LineScene(
        gap=pyworm.Parabola("10 mm"),
        load="100 kN/m",
        velocities=(1.0, 1.0),
        bodies=(steel, steel),
        oil=pyworm.named_oil("PAO VG 220").oil("60 degC"),
    )
    assert {row.formula for row in formulas(line)} > {"Moes", "Dowson-Toyoda"}
