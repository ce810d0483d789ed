"""Films that the largest grid allowed cannot bring are refused before any grid is refined."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from circular_contact import circular

import pyworm
from pyworm.cli.shared import warn_of_refusals
from pyworm.planning.expected_work import MAX_FILM_ERROR, expected_work
from pyworm.planning.target import FIGURES
from pyworm.report.console.scenes import plan_table
from pyworm.solver.cost.expected_time import Expectation
from pyworm.solver.error_estimate import Peak, Reading, grid_errors
from pyworm.solver.stop_reason import least_errors, refusal

ORDERS = dict.fromkeys(FIGURES, 2.0)


def reading(film_min, film_central=1.0):
    return Reading(film_min, film_central, 1.0, (0.0, 0.0), {"pressure_max": Peak(1.0, 20.0)})


@pytest.mark.parametrize("films", [(0.5, 0.9), (-3.0, -0.1), (-1.0, 0.01), (0.2, 0.2)])
def test_no_further_grid_leaves_less_than_predicted(films):
    """Whatever film the next grid shows."""
    before = [reading(film) for film in films]
    least = least_errors(before, ORDERS)["film_min"]
    for film in np.geomspace(1e-3, 1e3, 400):
        assert grid_errors([*before, reading(film)], ORDERS)["film_min"] >= least


def test_a_film_that_is_not_positive_yet_leaves_a_third_at_least():
    assert least_errors([reading(-1.0)], ORDERS)["film_min"] == pytest.approx(1 / 3)
    assert least_errors([reading(1.0)], ORDERS)["film_min"] == 0.0


def test_only_the_last_grid_is_refused_for_its_error():
    plan = pyworm.plan(circular(100, 10), 0.05)
    grid = plan.grids[-1]
    readings = [reading(-1.0)]
    last = replace(plan, largest_grid=grid.finer().nodes)
    assert "at least 33 %" in refusal(last, readings, ORDERS, grid.finer()).reason
    assert refusal(plan, readings, ORDERS, grid.finer()) is None
    rough = replace(last, accuracy=0.4)
    assert refusal(rough, readings, ORDERS, grid.finer()) is None


def test_an_accuracy_beyond_reach_costs_no_grid_that_a_worse_one_would_have():
    """What is refused is a film that is not resolved, not one that could be known better."""
    fine, rough = (
        expected_work("point", [[1e4]], 1.0, accuracy, 4e6, full=False) for accuracy in (1e-5, 0.05)
    )
    assert not fine.in_vain
    assert not rough.in_vain
    assert fine.needed == rough.needed
    hard = expected_work("point", [[1e4]], 1e2 * MAX_FILM_ERROR, 0.05, 4e6, full=False)
    assert not hard.in_vain
    assert expected_work("point", [[1e4]], 1e5 * MAX_FILM_ERROR, 0.05, 4e6, full=False).in_vain


def slow():
    """Steel at some micrometres a second."""
    return circular(1e5, 0.3)


def test_a_film_of_nanometres_is_refused_on_its_first_grid():
    scene = slow()
    plan = pyworm.plan(scene, 0.1)
    solution = pyworm.solve(scene, plan)
    assert not solution.converged
    assert "nm that is expected needs some" in solution.stop_reason
    assert solution.stop_reason == plan.refusal
    assert solution.fields.sizes["x"] == plan.grids[-1].shape[0]


def test_what_is_refused_is_expected_to_take_no_longer_than_its_first_grids():
    scene = slow()
    plan = pyworm.plan(scene, 0.1)
    assert plan.work.finest == max(grid.nodes for grid in (*plan.grids, *plan.wider_grids))
    assert plan.work.needed > 2 * plan.largest_grid
    table = plan_table(scene, plan, Expectation(1.0, 100.0))
    assert "Will not converge" in table.column(0)


def test_it_is_told_once_before_anything_is_solved(capsys):
    scene, easy = slow(), circular(20, 10)
    plans = [(scene, pyworm.plan(scene, 0.1)), (easy, pyworm.plan(easy, 0.1))]
    warn_of_refusals([SimpleNamespace(scene=of, plan=plan) for of, plan in [*plans, plans[0]]])
    said = capsys.readouterr().err
    assert said.count("will not reach the requested accuracy") == 1
    assert f"{scene.name}, {scene.name}: " in said
    assert plans[0][1].refusal in said.replace("\n", " ")
