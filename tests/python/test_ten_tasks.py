"""Ten tasks of a study without a file, each a function of no more statements than stated here.

Statements are those of the function's body but for `return`, which hands what was found to the test.
"""

import ast
import inspect
import textwrap
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import pytest
from contacts import ball
from folders import ROOT

import pyworm

STATEMENTS = {
    "whole_gear_set": 3,
    "measured_surface": 5,
    "export": 1,
    "formulas": 1,
    "stribeck_curve": 6,
    "start_and_stop": 4,
    "starved_contact": 5,
    "own_oil": 3,
    "parallel_sweep": 1,
    "sensitivity": 2,
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
    steel = pyworm.Body.from_name("16MnCr5")
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


def contact(load):
    """What the sweeps vary."""
    return ball(load=load)


def stribeck_curve(accuracy):
    """Friction over speed, from mixed to full film."""
    steel = pyworm.Body.from_name("16MnCr5", roughness="0.1 um")
    oil = pyworm.named_oil("mineral VG 100").oil("80 degC")
    gap = pyworm.Paraboloid("10 mm", "10 mm")

    def rubbing(speed):
        pair = pyworm.RigidMotion(1.1 * speed, 0), pyworm.RigidMotion(0.9 * speed, 0)
        return pyworm.Scene(gap=gap, load="20 N", motions=pair, bodies=(steel, steel), oil=oil)

    curve = pyworm.sweep(rubbing, speed=(0.05, 3.0), accuracy=accuracy, progress=False).dataset
    return curve.friction_coefficient


def start_and_stop(accuracy):
    """A ball that starts and stops."""
    oil = pyworm.named_oil("PAO VG 220").oil("60 degC")
    steel = pyworm.Body.from_name("16MnCr5")
    scene = pyworm.Scene(
        gap=pyworm.Paraboloid("10 mm", "10 mm"),
        load="30 N",
        motions=(pyworm.RigidMotion("1.1 m/s", 0), pyworm.RigidMotion("0.9 m/s", 0)),
        bodies=(steel, steel),
        oil=oil,
    )
    run = pyworm.transient(
        scene,
        times=[0, "1 ms", "2 ms"],
        speed=["0.3 m/s", "1 m/s", 0],
        accuracy=accuracy,
        effects="isothermal",
    )
    return run.dataset


def starved_contact(accuracy):
    """A contact under little oil."""
    oil = pyworm.named_oil("PAO VG 220").oil("60 degC")
    scarce = replace(oil, supply="0.15 um")
    steel = pyworm.Body.from_name("16MnCr5")
    scene = pyworm.Scene(
        gap=pyworm.Paraboloid("10 mm", "10 mm"),
        load="30 N",
        motions=(pyworm.RigidMotion("1.1 m/s", 0), pyworm.RigidMotion("0.9 m/s", 0)),
        bodies=(steel, steel),
        oil=scarce,
    )
    solution = pyworm.solve(scene, accuracy=accuracy, quantities=("film",))
    return solution


def own_oil(accuracy):
    """Film of an oil by its data sheet."""
    oil = pyworm.NamedOil.from_datasheet(nu40="220 mm^2/s", nu100="26 mm^2/s", base="PAO")
    scene = pyworm.Scene(
        gap=pyworm.Paraboloid("10 mm", "10 mm"),
        load="30 N",
        motions=(pyworm.RigidMotion("1.1 m/s", 0), pyworm.RigidMotion("0.9 m/s", 0)),
        bodies=(pyworm.Body.from_name("16MnCr5"),) * 2,
        oil=oil.oil("60 degC"),
    )
    solution = pyworm.solve(scene, accuracy=accuracy, effects="isothermal")
    return solution


def parallel_sweep(accuracy):
    """Two loads by two processes."""
    study = pyworm.sweep(
        contact,
        load=("20 N", "40 N"),
        processes=2,
        accuracy=accuracy,
        effects="isothermal",
        progress=False,
    )
    return study


def sensitivity(accuracy):
    """Exponent of the load in the film thickness."""
    films = pyworm.sweep(
        contact, load=(29, 31), accuracy=accuracy, effects="isothermal", progress=False
    ).dataset.film_min
    exponent = (films.differentiate("load") * films["load"] / films).mean()
    return exponent


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
    steel = pyworm.Body.from_name("16MnCr5")
    line = pyworm.LineScene(
        gap=pyworm.Parabola("10 mm"),
        load="100 kN/m",
        velocities=(1.0, 1.0),
        bodies=(steel, steel),
        oil=pyworm.named_oil("PAO VG 220").oil("60 degC"),
    )
    assert {row.formula for row in formulas(line)} > {"Moes", "Dowson-Toyoda"}


def test_a_stribeck_curve_falls_from_mixed_to_full_film():
    mixed, full = stribeck_curve(0.5).values
    assert mixed > 2 * full > 0


def test_a_film_outlives_a_stop():
    films = start_and_stop(0.3).film_min
    assert films[0] < films.max() and films[-1] > 0.3 * films.max()


def test_a_starved_film_is_thinner_than_its_supply():
    solution = starved_contact(0.3)
    assert solution.figures.supply is not None
    assert float(solution.figures.film_central) < 0.15e-6


def test_an_oil_of_a_data_sheet_makes_a_film():
    assert float(own_oil(0.3).figures.film_central) == pytest.approx(0.285e-6, rel=0.1)


def test_a_sweep_runs_in_several_processes(monkeypatch):
    """Those of `test_study.py` are real; here one thread stands for them."""
    monkeypatch.setattr("pyworm.batch.workers.WorkerPool", lambda count: ThreadPoolExecutor(1))
    assert parallel_sweep(0.3).converged.all()


def test_film_falls_a_little_with_the_load():
    assert -0.4 < float(sensitivity(0.3)) < -0.05
