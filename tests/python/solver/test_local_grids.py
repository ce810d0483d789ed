"""The minimum film thickness of starved contacts on finer grids about its places."""

from pathlib import Path

import numpy as np
import pytest
from contacts import ball
from draws import starved

import pyworm
from pyworm.case.case import case_of
from pyworm.solver.point import local_grids
from pyworm.solver.point.contact import PointContactSolver
from pyworm.solver.point.local_grids import resolved


def begun(number, seed=20260, effects=("isothermal", "starvation")):
    """A solver of a starved scene with its film on the first grid of the figures."""
    scene = case_of(starved(number, seed).tables, "starved", Path()).scene()
    plan = pyworm.plan(scene, 0.05, effects)
    solver = PointContactSolver(plan.simplified(scene), plan)
    level, _ = solver.begin(plan.grids)
    return solver, plan, level, solver.converged(level, plan, 0.05).reading


@pytest.fixture(scope="module")
def ellipse():
    """One with an inlet layer of 0.24 flooded films."""
    return begun(22, 82001)


def test_a_coarse_grid_has_the_minimum_of_one_four_times_as_fine(ellipse):
    """On the whole grid itself it is half of that."""
    solver, plan, level, coarse = ellipse
    fine = level
    for _ in range(2):
        fine, _ = solver.refined(fine)
        found = solver.converged(fine, plan, 0.05).reading
    assert level.read().film_min < 0.6 * found.film_min
    off = abs(coarse.film_min / found.film_min - 1)
    assert off < coarse.left["film_min"] + found.left["film_min"] < 0.12
    assert found.left["film_min"] < 0.05
    assert coarse.figures.keys() == found.figures.keys()


def test_the_minimum_is_not_above_the_film_at_the_contact_point():
    """A layer of 0.14 flooded films keeps its thickness through the contact, and its outline no dip."""
    *_, level, reading = begun(72)
    assert level.read().film_min < 0.7 * reading.film_central
    assert reading.film_min == reading.film_central == level.read().film_central


def test_thicker_layers_need_no_finer_grids():
    """One of two flooded films, whose meniscus stands before the dry contact."""
    *_, level, reading = begun(4, 99400)
    assert level.film.fed and reading.left == {}
    assert reading.film_min == level.read().film_min


def test_a_finer_grid_begins_with_the_film_around_it(ellipse):
    """Under the pressure of all nodes beyond it: shifted by a twentieth, alike up to its outline."""
    solver, plan, level, _ = ellipse
    begins = []

    def seen(whole, grid, deflection, guess):
        finer = solver._within(whole, grid, deflection, guess)
        begins.append((finer, finer.film.thickness().copy()))
        return finer

    resolved(level, level.read(), seen, plan.tolerance)
    finer, film = begins[0]
    window = level.grid.window_of(finer.grid)
    shift = film[::2, ::2] / level.film.thickness()[window] - 1
    borne = level.film.pressure[window] > 0
    least, middle, most = np.quantile(shift[borne], (0.1, 0.5, 0.9))
    assert abs(middle) < 0.06 and most - least < 0.01
    outline = np.ones(borne.shape, dtype=bool)
    outline[1:-1, 1:-1] = False
    assert (borne & outline).sum() > 20
    assert np.abs(shift[borne & outline] - middle).max() < 0.04


def test_a_film_that_is_not_found_on_a_finer_grid_leaves_the_reading(ellipse, monkeypatch):
    solver, plan, level, _ = ellipse
    on_grid = level.read()
    assert resolved(level, on_grid, solver._within, 0.0) is on_grid
    monkeypatch.setattr(local_grids, "MOST_GRIDS", 0)
    assert resolved(level, on_grid, solver._within, plan.tolerance) is on_grid


def test_where_the_finest_film_is_not_found_the_last_one_counts_with_its_change(ellipse):
    solver, _, level, settled = ellipse
    finest = []

    def once(whole, grid, deflection, guess):
        finer = solver._within(whole, grid, deflection, guess)
        if grid.dx < 0.4 * level.grid.dx:
            finer.film.place(2 * finer.film.pressure, -finer.film.rigid_film)
            finest.append(finer)
        return finer

    reading = resolved(level, level.read(), once, 1e-4)
    assert finest and reading.left["film_min"] > 0.03 + settled.left["film_min"]
    assert level.read().film_min < reading.film_min < settled.film_min


def test_temperatures_on_finer_grids_are_those_of_the_whole_one():
    """They are held while the film is found: a step without it changes them."""
    scene = ball()
    plan = pyworm.plan(scene, 0.1, "all")
    solver = PointContactSolver(scene, plan)
    level, _ = solver.begin(plan.grids)
    finer = solver.on_grid(level.grid, level.state())
    rise = finer.film.rise()
    assert rise.max() > 1.0
    finer.film.start(0.99 * finer.film.pressure, finer.film.rigid_film)
    finer.film.hold_rise()
    finer.film.step(0.1)
    assert np.array_equal(finer.film.rise(), rise) and finer.film.balance.warming == 0.0
    free = solver.on_grid(level.grid, level.state())
    free.film.start(0.99 * free.film.pressure, free.film.rigid_film)
    free.film.step(0.1)
    assert not np.array_equal(free.film.rise(), rise)
