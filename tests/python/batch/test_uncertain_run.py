"""Uncertainty of results by inputs: moved one by one, put together as the GUM says."""

from types import SimpleNamespace

import numpy as np
import pytest
from folders import ROOT

import pyworm
from pyworm.batch.operating_points import Computed, NotSolvedError, Solving
from pyworm.batch.task import Task
from pyworm.batch.uncertain_run import moved_points, require_uncertain, uncertainty_of
from pyworm.case.uncertain_inputs import UncertainInputs
from pyworm.cli.main import main
from pyworm.io.uncertain import Uncertain
from pyworm.result.input_uncertainty import by_inputs

RIG = (ROOT / "cases/film_rig.toml").read_text()


@pytest.fixture
def rig(tmp_path):
    """The rig with an uncertain load and an uncertain viscosity."""
    text = RIG.replace('"20 N"', '"20 N +- 10 %"').replace('"0.227 Pa s"', '"0.227 Pa s +- 5 %"')
    (tmp_path / "rig.toml").write_text(text)
    return tmp_path / "rig.toml"


def test_independent_inputs_add_by_squares_and_correlated_ones_linearly():
    values = {"a": Uncertain(1.0, 0.1, ""), "b": Uncertain(1.0, 0.1, "")}
    assert by_inputs(UncertainInputs(values), (3.0, 4.0)) == pytest.approx(5.0)
    together = UncertainInputs(values, {("b", "a"): 1.0})
    assert by_inputs(together, (3.0, 4.0)) == pytest.approx(7.0)
    against = UncertainInputs(values, {("a", "b"): -1.0})
    assert by_inputs(against, (3.0, 4.0)) == pytest.approx(1.0)


def test_half_the_difference_of_moved_solves_is_the_change(rig, monkeypatch):
    """A model that is a power law of the moved inputs stands for the solves."""
    case = pyworm.load(rig)
    tasks = [Task(case, place, 0.05, ("auto",), ("film",)) for place in case.places()]

    def film(point):
        return point.case.tables.oil.viscosity.eta0**0.67 * point.case.tables.contact.load**-0.07

    monkeypatch.setattr(
        Solving,
        "results",
        lambda self, points: [{"film_min": Computed(film(point), 0.0)} for point in points],
    )
    summary = {"film_min_m": 3e-7, "film_min_error": 0.02, "film_min_model_error": 0.04}
    result = SimpleNamespace(
        sound=SimpleNamespace(solutions=[SimpleNamespace(summary=lambda: summary)])
    )
    points = moved_points(tasks)
    assert [point.case.tables.contact.load for point in points] == [18.0, 22.0, 20.0, 20.0]
    (found,) = uncertainty_of(result, tasks, points, Solving(rig.parent, 0.05, ("auto",))).results
    eta, load = 0.227, 20.0
    by_hand = (
        eta**0.67 * ((1.1 * load) ** -0.07 - (0.9 * load) ** -0.07) / 2,
        load**-0.07 * ((1.05 * eta) ** 0.67 - (0.95 * eta) ** 0.67) / 2,
    )
    assert found.changes == pytest.approx(by_hand)
    assert found.inputs == pytest.approx(np.hypot(*by_hand))
    # numerical and model uncertainties hold in 19 of 20 cases: half of each is a standard one
    assert (found.numerical, found.model) == pytest.approx((3e-9, 6e-9))
    assert found.combined == pytest.approx(np.hypot(found.inputs, np.hypot(3e-9, 6e-9)))


def test_a_run_prints_draws_and_keeps_the_uncertainty(rig, tmp_path, capsys):
    out = tmp_path / "out"
    words = ["run", str(rig), "--inputs-uncertain", "--accuracy", "20%", "--out", str(out)]
    assert main([*words, "--effects", "isothermal"]) == 0
    printed = capsys.readouterr().out
    assert "Uncertainty by inputs" in printed and "oil.viscosity.eta0" in printed
    assert (out / "input_uncertainty.png").exists()
    found = pyworm.open_result(out / "result.nc").input_uncertainty
    central = next(each for each in found.results if each.name == "film_central")
    by_load, by_viscosity = central.changes
    print(found)
    # films go with the viscosity by a power of about 0.7, and hardly with the load
    assert by_viscosity / central.value == pytest.approx(0.05 * 0.7, rel=0.15)
    assert abs(by_load / central.value) < 0.02
    assert found.summary()["results"]["film_central"]["combined"] == central.combined


def test_without_the_option_best_estimates_are_used_and_named(rig, tmp_path, capsys):
    words = ["run", str(rig), "--accuracy", "20%", "--effects", "isothermal"]
    assert main([*words, "--pictures", "none", "--out", str(tmp_path / "out")]) == 0
    assert "best estimates are used of contact.load, oil.viscosity.eta0" in capsys.readouterr().err
    assert pyworm.open_result(tmp_path / "out/result.nc").input_uncertainty is None


def test_moved_contacts_without_a_solution_cost_no_result(rig, tmp_path, capsys, monkeypatch):
    def unsolved(self, points):
        raise NotSolvedError("no film")

    monkeypatch.setattr(Solving, "results", unsolved)
    words = ["run", str(rig), "--inputs-uncertain", "--accuracy", "20%", "--out", str(tmp_path)]
    assert main([*words, "--effects", "isothermal", "--pictures", "none"]) == 0
    assert "no uncertainty by inputs: no film" in capsys.readouterr().err


def test_exact_inputs_and_impossible_moves_are_refused(tmp_path):
    with pytest.raises(pyworm.CaseError, match="no input is written with its uncertainty"):
        require_uncertain(pyworm.load(ROOT / "cases/film_rig.toml"))
    (tmp_path / "rig.toml").write_text(RIG.replace('"20 N"', '"20 N +- 30 N"'))
    case = pyworm.load(tmp_path / "rig.toml")
    with pytest.raises(pyworm.CaseError, match=r"contact\.load moved by its standard uncertainty"):
        moved_points([Task(case, case.places()[0], 0.05)])
