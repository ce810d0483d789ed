"""A contact whose error bars are wider than asked for is used, and said to be less accurate."""

from dataclasses import replace

import pytest
from circular_contact import circular
from swept_cycle import PHASES, cycle_result

import pyworm
from pyworm.result.headline import opening
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.solver.ending import LESS_ACCURATE, Ending
from pyworm.solver.solve import solve


@pytest.fixture(scope="module")
def coarse():
    """A film on grids too small for the accuracy asked for."""
    scene = circular(20, 10)
    plan = pyworm.plan(scene, accuracy=1e-4)
    return solve(scene, replace(plan, largest_grid=plan.grids[-1].finer().finer().nodes))


def test_a_film_with_wider_bars_than_asked_for_has_converged_but_is_less_accurate(coarse):
    assert coarse.converged and not coarse.accurate
    assert coarse.stop_reason.startswith(LESS_ACCURATE)
    assert "the largest grid allowed leaves an error" in coarse.stop_reason
    assert coarse.figures.film_min.error > 1e-4
    summary = coarse.summary()
    assert (summary["converged"], summary["accurate"]) == (True, False)


def wider(solution):
    """The solution with a bar of the loss of a fifth, for 5 % asked."""
    loss = replace(solution.figures.power_loss, grid=0.2)
    stop = Ending.WIDER_BARS.stop(
        error="20.0%", reason="the transient solve leaves an error of 20.0%"
    )
    figures = replace(solution.figures, power_loss=loss)
    return replace(solution, figures=figures, ending=stop.ending, stop_reason=stop.reason)


def test_a_mesh_cycle_is_not_lost_for_a_phase_with_wider_bars():
    result = cycle_result(PHASES)
    first, *others = result.solutions
    torn = replace(result, solutions=(wider(first), *others))
    cycle, before = drive_cycle(torn), drive_cycle(result)
    assert cycle.phases == before.phases
    assert not cycle.missing
    assert cycle.loss.power == before.loss.power
    assert cycle.loss.scene_error > 1.5 * before.loss.scene_error
    assert f"Less accurate than requested: {first.name}." in opening(torn.solutions, "")
    assert torn.stop_reason is None
    assert torn.shortfall.startswith(f"{first.name}: {LESS_ACCURATE}")
    assert result.shortfall is None
