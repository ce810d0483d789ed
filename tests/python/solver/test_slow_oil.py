"""Lives of a contact that are hardly longer than the passage of oil through it."""

from math import inf

import pytest
from plan_scenes import STEEL, mineral, point

import pyworm
from pyworm.planning.prediction import predicted
from pyworm.scene.life import Life
from pyworm.solver.transient.time_grid import LEAST_PASSAGES, LEAST_TRANSITS, time_grid_of
from pyworm.solver.transient.time_steps import STRETCH, restart_place
from pyworm.solver.transient.transient import WARM_UP, begin_of_one

BALL = point("ball", (0.02, 0.02), 50.0, ((1.0, 0.0),) * 2, (STEEL, STEEL), mineral(0.09, 2e-8))


def time_grid_for(passages):
    """That of a ball whose life lasts some passages of oil, and which does not change."""
    duration = passages * predicted(BALL).transit
    plan = pyworm.plan(BALL, 0.05, ("isothermal", "squeeze"), ("film",))
    return time_grid_of(Life(duration, lambda seconds: BALL), plan)


def test_passages_of_oil_are_counted_beside_transits():
    """A life of two counts four transits, half a passage each; one of eight has as many."""
    short, long = time_grid_for(2.0), time_grid_for(8.0)
    assert short.transits(short.end) == pytest.approx(LEAST_TRANSITS)
    assert short.passages_of_transit(0.5 * short.end) == pytest.approx(0.5)
    assert short.place_before(3.0, 1.0) == pytest.approx(1.0)
    assert short.place_before(3.0, 1.6) == -inf
    assert long.transits(long.end) == pytest.approx(8.0)
    assert long.passages_of_transit(0.5 * long.end) == pytest.approx(1.0)
    assert long.place_before(7.0, 2.0) == pytest.approx(5.0)
    assert time_grid_for(0.01).passages_of_transit(0.0) == LEAST_PASSAGES


def test_solves_begin_as_many_passages_of_oil_before_a_film_as_it_remembers():
    """From a steady film `WARM_UP` before it, from films of the solve before `STRETCH` of them."""
    for passages in (3.0, 8.0):
        time_grid = time_grid_for(passages)
        transit = time_grid.transits(time_grid.end) / passages  # of oil, in those of the grid
        at = 0.95 * time_grid.end
        place = time_grid.place(at)
        assert begin_of_one(time_grid, at) == pytest.approx(place - WARM_UP["point"] * transit)
        assert restart_place(time_grid, at, 1) == pytest.approx(place - STRETCH * transit)
    short = time_grid_for(1.5)
    assert begin_of_one(short, short.end) == 0.0
    assert restart_place(short, short.end, 1) is None
