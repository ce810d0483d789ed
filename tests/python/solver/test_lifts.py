"""Lifts of transient films."""

import pytest
from test_transient import ball, lived

import pyworm
from pyworm.planning.prediction import predicted
from pyworm.solver.transient.lifts import moving_lift, steady_lift
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.transient import part_at


def both_lifts(contact):
    """Lift by the transient film at present, and by a steady one."""
    plan = pyworm.plan(contact, 0.1, ("isothermal", "squeeze"), ("film",))
    time_grid, now = time_grid_of(contact.past.life, plan), contact.past.seconds
    found = integrate_in_time(time_grid, 0, part_at(time_grid, now).begin, [now])
    moving = moving_lift(time_grid, now, found.rigid_films[now], found.records)
    return moving.distance, steady_lift(time_grid, now).distance


def test_a_contact_without_change_is_lifted_like_a_steady_one():
    moving, steady = both_lifts(lived(lambda back: ball()))
    assert moving == pytest.approx(steady, rel=1e-3)
    solution = pyworm.solve(ball(), pyworm.plan(ball(), 0.1, "isothermal", ("film",)))
    assert steady == pytest.approx(solution.figures.lift, rel=0.1)


def test_oil_of_a_lower_speed_lifts_less():
    """The film, and the lift with it, is that of the speed half a passage ago."""
    transit = predicted(ball()).transit
    moving, steady = both_lifts(lived(lambda back: ball(1 - 0.1 * back / transit)))
    _, then = both_lifts(lived(lambda back: ball(0.95)))
    assert then < moving < steady
