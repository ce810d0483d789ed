"""Public objects at the prompt: one short line with quantities and their units."""

import inspect
from html import escape
from importlib.resources import files
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr
from contacts import ball, roller
from lives import life_dataset
from synthetic_solution import make_result, make_solution

import pyworm
from pyworm.batch.duty import BlockFigures
from pyworm.result.calibration import FittedValue

EXCEPTIONS = ("CaseError", "KernelError", "NoAdjointError", "UnusualWarning")


def built():
    """An object of each public class, and what its line has to have in it."""
    steel, oil = pyworm.Body.from_name("16MnCr5"), pyworm.named_oil("PAO VG 220")
    solution = make_solution()
    table = xr.Dataset({"converged": ("scene", [1, 0])})
    square = np.linspace(-1e-3, 1e-3, 9)
    heights = (square[:, None] ** 2 + square[None, :] ** 2) / 0.02
    checked, formulas = pyworm.check("cases/line_m20_l10.toml"), pyworm.compare_formulas(roller())
    wear = SimpleNamespace(
        steps=[SimpleNamespace(hours=100.0, depth_max_m=1e-6)],
        hours_allowed=900.0,
        depth_allowed=1e-5,
    )
    return {
        "BestDesign": (
            pyworm.BestDesign("b", "b", "worm", (), (), (), (), (), 48, 0, ""),
            "BestDesign of worm",
        ),
        "Calibration": (
            pyworm.Calibration(
                "rig",
                "films.csv",
                (FittedValue("z", ("oil.viscosity.z",), "", 0.22, 0.005, 0.012, 0.35, 0.07, 1.7),),
                (),
                ((1.0,),),
                (),
                0.0,
                1,
                0.0,
            ),
            "Calibration of rig: z 0.22 +- 0.005, measurements 0",
        ),
        "CaseRatings": (pyworm.rate("cases/spur_pair.toml"), "Ratings of spur_pair"),
        "CaseSetup": (pyworm.CaseSetup({}, hob_life=({},)), "required pattern none, proposed no"),
        "CaseWear": (pyworm.CaseWear("worm", wear, 1e-5, ""), "Wear of worm: hours 100"),
        "CaseDuty": (made_duty(), "closed forms, no contact solved: blocks 1, duration 1 h"),
        "CheckedCase": (checked, "contacts 1, expected time"),
        "FormulaComparison": (formulas, "Film thickness of roller by formula"),
        "FormulaFilm": (formulas.rows[0], "µm"),
        "PlannedContact": (checked.contacts[0], "simulated compressibility"),
        "Barus": (pyworm.Barus(0.04, 2e-8), "eta0 40 mPa s, alpha 20 1/GPa"),
        "Body": (steel, "youngs_modulus 210 GPa, poisson_ratio 0.3, density 7850 kg/m³"),
        "Branch": (pyworm.Branch(0.5, 1.0, 0.4), "fraction 0.5, ratio 1, exponent 0.4"),
        "Coating": (pyworm.Coating("3 um", "250 GPa", 0.2), "thickness 3 µm"),
        "FatigueStrength": (pyworm.FatigueStrength("500 MPa", "300 MPa"), "bending_limit 500 MPa"),
        "Case": (pyworm.load("cases/point_m20_l10.toml"), "contacts 1, accuracy 1 %"),
        "Comparison": (pyworm.compare(solution, solution), "µm"),
        "Density": (pyworm.Density(870.0, 6e-10, 1.7e-9), "rho0 870 kg/m³"),
        "Estimate": (pyworm.Estimate(3.0, 0.1), "3 ± 10 %"),
        "Figures": (solution.figures, "film_min 0."),
        "FlowLaw": (pyworm.FlowLaw(law="eyring", stress=5e6), "stress 5 MPa, law eyring"),
        "FormulaFilms": (pyworm.film_of(ball()), "1 contact: central 0."),
        "LineScene": (roller(), "load"),
        "NamedOil": (oil, "at 40 °C 218.1 mm²/s"),
        "Oil": (oil.oil("60 degC"), "alpha 13.476 1/GPa, law Roelands"),
        "OilHeat": (oil.oil("60 degC").heat, "inlet_temperature 60 °C"),
        "OilLayer": (
            pyworm.OilLayer((-1e-3, 0.0, 1e-3), (0.0, 1e-6, 0.0)),
            "across -1 mm to 1 mm (3 values)",
        ),
        "Parabola": (pyworm.Parabola(0.01), "radius 10 mm"),
        "Paraboloid": (pyworm.Paraboloid(0.01, 0.02), "radius_x 10 mm, radius_y 20 mm"),
        "Plan": (pyworm.plan(ball(), 0.1), "accuracy 10 %"),
        "Result": (make_result(), "contacts"),
        "RigidMotion": (pyworm.RigidMotion(1.1, 0.0), "u 1.1 m/s, v 0 m/s"),
        "Roelands": (pyworm.Roelands(0.076, 0.4), "eta0 0.076 Pa s, z 0.4"),
        "SampledGap": (pyworm.SampledGap(square, square, heights), "9 x 9 heights"),
        "Roughness": (pyworm.Roughness("0.4 um", lay="30 deg"), "rms 0.4 µm, lay 30 °"),
        "Scene": (ball(), "load"),
        "Sensitivities": (
            pyworm.sensitivities(roller(), accuracy=0.1, effects="isothermal", inputs=["load"]),
            "film_min load -0.",
        ),
        "Sensitivity": (pyworm.Sensitivity(0.7, 0.1), "value 0.7"),
        "Solution": (solution, "status accurate, film_min 0."),
        "SweepResult": (
            pyworm.SweepResult("loads", "Loads", [["load"]], table, {}),
            "loads: scenes 2, converged 1, varied load",
        ),
        "TabulatedDensity": (
            pyworm.TabulatedDensity.of(lambda p, t: 870.0 * (1 + 5e-10 * p), "40 degC"),
            "870 kg/m³ at 40 °C",
        ),
        "TabulatedViscosity": (
            pyworm.TabulatedViscosity.of(lambda p, t: 0.1 * np.exp(2e-8 * p), "40 degC"),
            "0.1 Pa s at 40 °C",
        ),
        "TransientResult": (make_transient(), "status accurate, times 3 to 8 ms, film_min 0.5 "),
    }


def made_duty():
    """An hour of a unit without damage."""
    block = BlockFigures("hour", 0.0, 3600.0, 10.0, 100.0, {}, 350.0, 7.2e6)
    history = SimpleNamespace(dissipated=[7.2e6])
    cycle = SimpleNamespace(duration=3600.0)
    model = SimpleNamespace(history=history, cycle=cycle, loads={}, tabulated=False)
    return pyworm.CaseDuty("unit", model, (block,))


def make_transient():
    """A contact at three times."""
    phases = np.linspace(0.2, 0.4, 3)
    solution = make_solution().changed(
        life=life_dataset(phases, np.full(3, 1.0), np.full(3, 9.0), np.array([1e-6, 5e-7, 1e-6]))
    )
    return pyworm.TransientResult(pyworm.Result("ball", {}, (solution,), None, {}))


def test_every_public_object_shows_itself_in_a_line():
    objects = built()
    classes = {name for name in pyworm.__all__ if inspect.isclass(getattr(pyworm, name))}
    assert objects.keys() == classes - set(EXCEPTIONS)
    for name, (one, words) in objects.items():
        line = repr(one)
        print(line)
        assert type(one) is getattr(pyworm, name)
        assert line.startswith("<") and line.endswith(">") and len(line) <= 160, line
        assert "\n" not in line and "array(" not in line and "np.float64" not in line, line
        assert words in line, line


@pytest.mark.parametrize("count", [1, 3])
def test_films_by_the_formula_are_shown_from_the_thinnest_to_the_thickest(count):
    load = np.linspace(1e-3, 50.0, count)
    films = pyworm.film(
        (0.01, 0.01), load, 226e9, (1.0, 0.0), pyworm.named_oil("PAO VG 220").oil(333)
    )
    line = repr(films)
    assert (" to " in line) is (count > 1)
    assert f"of {count} contact" in line and "outside the box of the atlas 1" in line


def test_type_checkers_read_the_types_of_the_package():
    assert files("pyworm").joinpath("py.typed").is_file()


def test_objects_are_tables_in_notebooks():
    solution = make_solution()
    study = pyworm.SweepResult(
        "loads", "<b>", [["load"]], xr.Dataset({"converged": ("scene", [1])}), {}
    )
    drives = [pyworm.load(f"cases/{name}.toml").drive for name in ("spur_pair", "roller_ref")]
    oil = pyworm.named_oil("PAO VG 220").oil("60 degC")
    for one in (solution, make_result(), ball(), oil, pyworm.plan(ball(), 0.1), study, *drives):
        page = one._repr_html_()
        heading, rows = one.shown()
        assert page.startswith("<table>") and page.count("<tr>") == len(rows) > 1
        assert escape(heading) in page and "<b>" not in page
        assert len(repr(one)) <= 160


def test_completion_lists_what_a_solution_has():
    solution = make_solution()
    names = dir(solution)
    assert {"figures", "fields", "history", "plot", "converged", "summary", "save"} <= set(names)
    assert {"film", "pressure"} <= set(dir(solution.plot))
    assert {"film_min", "film_central", "friction_coefficient"} <= set(dir(solution.figures))
    for name in (name for name in names if not name.startswith("_")):
        getattr(solution, name)
