"""Expected work of transient solves."""

from dataclasses import replace
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
from test_transient import ball, lived

import pyworm
from pyworm.planning.effects.geometry import as_line
from pyworm.planning.expected_work import STEPS_A_TRANSIT, solves_of_life
from pyworm.planning.prediction import predicted
from pyworm.solver.cost import calibration
from pyworm.solver.cost.expected_motion import FURTHER, motion, time_grid_if_any
from pyworm.solver.cost.expected_time import Expectation, expectation, together
from pyworm.solver.transient import transient as transient_module
from pyworm.solver.transient.time_grid import FORMING
from pyworm.solver.transient.time_integration import integrate_in_time
from pyworm.solver.transient.time_steps import steps_of
from pyworm.solver.transient.transient import WARM_UP, Part, begin_of_one, part_at

LINE, POINT = ("cases/spur_pair.toml", 0.35), ("cases/zi_drive.toml", 0.26)


def moving(case, accuracy, effects=("isothermal", "squeeze")):
    """A contact of a case, its plan and the course of its life."""
    path, phase = case
    scene = pyworm.load(path).scene(phase=phase)
    plan = pyworm.plan(scene, accuracy, effects, ("film",))
    return scene, plan, time_grid_if_any(scene, plan)


def test_the_time_steps_counted_are_those_that_a_solve_takes(monkeypatch):
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 6)
    scene, plan, time_grid = moving(LINE, 0.5)
    at = scene.past.seconds
    part = part_at(time_grid, at)
    (steps,) = motion(scene, plan, time_grid).up_to_present
    solved = integrate_in_time(time_grid, 0, part.begin, [at])
    assert steps.count == len(solved.records)
    assert steps.nodes == steps.coarse == time_grid.grid(at, 0).nodes
    (shared,) = motion(scene, plan, time_grid).shared
    assert shared.count == len(
        integrate_in_time(time_grid, 0, part.begin, [at], time_grid.time_at(part.last)).records
    )


@pytest.mark.parametrize("accuracy", [0.5, 0.05, 0.02])
def test_each_solve_of_a_life_has_twice_the_time_steps_and_four_times_the_nodes(accuracy):
    """A course that is written, whose solves all begin with it."""
    scene, plan, time_grid = moving(POINT, accuracy)
    time_grid = replace(time_grid, life=replace(time_grid.life, kinks=(0.0,)))
    steps, solves = motion(scene, plan, time_grid).up_to_present, solves_of_life(accuracy)
    assert len(steps) == 2 * solves  # as surfaces come together, and of the contact
    of_contact = [
        time_grid.grid_of_contact(time_grid.begin, number).nodes for number in range(solves)
    ]
    counts = [sum(step.count for step in steps if step.nodes == nodes) for nodes in of_contact]
    for coarse, fine in pairwise(zip(of_contact, counts, strict=True)):
        assert fine[0] == pytest.approx(4 * coarse[0], rel=0.1)
        assert fine[1] == pytest.approx(2 * coarse[1], rel=0.1)


def test_most_of_the_way_to_the_first_touch_is_solved_on_the_grid_before():
    _, _, time_grid = moving(POINT, 0.05)
    steps = steps_of(time_grid, 1, 0.0, time_grid.life.touched)
    times, grids = [one.seconds for one in steps], [one.refinement for one in steps]
    assert grids == sorted(grids) and set(grids) == {0, 1}
    most, touched = time_grid.place(times[grids.index(1)]), time_grid.place(time_grid.life.touched)
    assert most == pytest.approx(0.75 * touched, abs=time_grid.step(0))
    alone = {one.seconds for one in steps_of(time_grid, 0, 0.0, time_grid.life.touched)}
    assert alone <= set(times)  # both solves share instants, so that their figures can be compared
    places = [time_grid.place(at) for at in times]
    assert np.diff(places) == pytest.approx([time_grid.step(on) for on in grids[:-1]], rel=1e-6)


def test_a_further_solve_begins_on_the_grid_before():
    scene, plan, time_grid = moving(POINT, 0.05)
    ((_, (before, last)),) = motion(scene, plan, time_grid).further
    (stretch,) = motion(scene, plan, time_grid).stretches
    assert before.nodes == stretch.steps[-1].nodes < last.nodes
    passed = time_grid.transits(scene.past.seconds) - begin_of_one(time_grid, scene.past.seconds)
    assert last.count < passed * (STEPS_A_TRANSIT["point"] << 2)


def test_no_solve_begins_while_surfaces_come_together_but_with_their_life():
    """With oil at rest between surfaces nearly in touch it would begin with too much of it."""
    _, _, time_grid = moving(POINT, 0.05)
    touched, warm_up = time_grid.place(time_grid.life.touched), WARM_UP["point"]
    formed, whole = touched + FORMING, time_grid.transits(time_grid.end)
    for later in (0.5, warm_up, warm_up + FORMING - 0.01):
        assert begin_of_one(time_grid, time_grid.time_at(touched + later)) == 0.0
    remembers_not = next(
        place
        for place in np.arange(formed + warm_up, whole, 0.01)
        if time_grid.place_before(place, warm_up) > formed
    )
    begin = begin_of_one(time_grid, time_grid.time_at(remembers_not))
    assert begin == pytest.approx(time_grid.place_before(remembers_not, warm_up))
    assert begin_of_one(time_grid, time_grid.time_at(remembers_not - 0.02)) == 0.0


def test_two_further_solves_are_expected_of_a_coarse_request_and_none_beyond_the_third():
    scene, plan, time_grid = moving(POINT, 0.2)
    assert solves_of_life(plan.accuracy) == 1
    further = motion(scene, plan, time_grid).further
    assert tuple(chance for chance, _ in further) == FURTHER
    second, third = (steps[-1].nodes for _, steps in further)
    assert third == pytest.approx(4 * second, rel=0.1)


@pytest.mark.parametrize(("most", "built"), [(1e12, True), (1.0, False)])
def test_a_fourth_solve_is_made_where_it_is_affordable(monkeypatch, most, built):
    monkeypatch.setitem(transient_module.MOST_WORK, 3, most)
    scene, plan, time_grid = moving(POINT, 0.02)
    assert solves_of_life(plan.accuracy) == 3
    further = motion(scene, plan, time_grid).further
    assert bool(further) == built
    if built:
        fourth = time_grid.grid_of_contact(time_grid.begin, 3)
        ((_, steps),) = further
        assert steps[-1].nodes == pytest.approx(fourth.nodes, rel=0.1)
    assert transient_module.begin_of_further(time_grid, scene.past.seconds, 4) is None


def test_a_further_solve_is_made_up_to_its_work_which_limited_rates_multiply(monkeypatch):
    scene, plan, time_grid = moving(LINE, 0.5)
    rates = transient_module.rates_at_present(scene, plan)
    (only,), seconds = rates.found, scene.past.seconds
    begin = transient_module.begin_of_further(time_grid, seconds, 1)
    assert begin is not None
    work = sum(
        time_grid.grid(step.seconds, 1).nodes for step in steps_of(time_grid, 1, begin, seconds)
    )
    for share, limited, built in ((1.1, False, True), (1.1, True, False), (0.9, False, False)):
        monkeypatch.setattr(transient_module, "MOST_WORK", {1: share * work})
        before = replace(rates, found=(replace(only, limited=limited),))
        further = transient_module.finer(scene, plan, before)
        assert further.finest is not built and len(further.found) == 1 + built


@pytest.mark.parametrize(
    ("most", "least", "built"), [(10.0, 0.0, True), (0.5, 0.0, False), (0.5, 1e9, True)]
)
def test_a_further_solve_is_given_up_where_its_films_take_too_many_newton_steps(
    monkeypatch, most, least, built
):
    """Unless that is little work all the same."""
    scene, plan, _ = moving(LINE, 0.5)
    rates = transient_module.rates_at_present(scene, plan)
    monkeypatch.setattr(transient_module, "MOST_NEWTON_STEPS", most)
    monkeypatch.setattr(transient_module, "LEAST_WORK", least)
    further = transient_module.finer(scene, plan, rates)
    assert further.finest is not built and len(further.found) == 1 + built


def test_a_further_solve_is_made_where_those_before_leave_too_much_error(monkeypatch):
    """Two steps a transit, of which two solves leave more than their part of 4 %, and the third does not."""
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 2)
    transit = predicted(as_line(ball())).transit
    scene = lived(lambda back: as_line(ball(1 + 0.8 * np.sin(5 - back / transit))))
    plan = pyworm.plan(scene, 0.04, ("isothermal", "squeeze"), ("film",))
    rates = transient_module.rates_at_present(scene, plan)
    further = transient_module.finer(scene, plan, rates)
    coarse, fine = (
        transient_module.transient(plan.simplified(scene), plan, of) for of in (rates, further)
    )
    assert coarse.coarse and fine.flaw is None
    assert pyworm.solve(scene, plan, rates=rates).converged


def test_a_steady_film_has_none():
    scene, plan, _ = moving(POINT, 0.05, "isothermal")
    assert motion(scene, plan) is None


def test_contacts_of_one_part_of_a_life_pay_for_it_once():
    first, second = Part(0.0, 0.0, 5.0), Part(3.0, 5.0, 9.0)
    of = [
        Expectation(1.0 + past, 1.0, past, 7.0, part) for past, part in ((4.0, first), (6.0, first))
    ]
    assert together(of, ["life"] * 2) == 2 * 1.0 + 7.0
    assert together(of, ["one", "another"]) == 2 * 1.0 + 4.0 + 6.0
    of.append(Expectation(3.0, 1.0, 2.0, 5.0, second))
    assert together(of, ["life"] * 3) == 3 * 1.0 + 7.0 + 5.0
    lone = [Expectation(1.0 + 4.0, 1.0, 4.0, 7.0, None)] * 2
    assert together(lone, ["life"] * 2) == 2 * (1.0 + 4.0)


def test_heat_that_others_of_its_life_call_for_is_expected_of_a_contact_that_is_cold_itself():
    scene, cold, _ = moving(POINT, 0.05)
    path, phase = POINT
    whole = pyworm.plan(pyworm.load(path).scene(phase=phase), 0.05)
    heated, alone = (time_grid_if_any(scene, plan) for plan in (whole, cold))
    assert heated.plan.model.heated and not cold.model.heated
    past = [expectation(scene, cold, time_grid).past for time_grid in (alone, heated)]
    assert past[1] > 2 * past[0]


def test_the_shortest_of_several_times_counts(monkeypatch):
    """A machine that is busy makes some of them longer, and what is left beside the nodes meaningless."""
    clock = iter([0, 3, 9, 10, 11, 15, 20, 22, 24])
    monkeypatch.setattr(calibration, "process_time", lambda: next(clock))
    monkeypatch.setattr(calibration, "steps_to_convergence", lambda level, planned: 2)
    solver = SimpleNamespace(on_grid=lambda grid, guess: None)
    level = SimpleNamespace(grid=None, state=lambda: None)
    assert calibration._shortest(solver, level, None) == (1, 1.0)
