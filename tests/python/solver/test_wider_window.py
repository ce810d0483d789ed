"""The film of a narrow window as the initial guess in a wider one, and what the narrow one cuts off."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from contacts import ball
from folders import CASES

import pyworm
from pyworm.planning.grid import Grid
from pyworm.solver import grid_sequence
from pyworm.solver.level import InitialGuess
from pyworm.solver.newton import iterate
from pyworm.solver.point.contact import PointContactSolver
from pyworm.solver.point.level import guess_around

TRACTION = CASES / "traction_steel.toml"


def test_the_film_of_a_grid_that_the_wider_one_does_not_hold_is_taken_where_both_are():
    """Where teeth end, a window grown outward may end before the narrow one."""

    def level(grid, pressure):
        guess = InitialGuess(np.full(grid.shape, pressure), pressure, None)
        return SimpleNamespace(grid=grid, state=lambda: guess)

    narrow = level(Grid(-3.0, -2.0, 1.0, 1.0, 7, 6), 2.0)
    wide = level(Grid(-6.0, -6.0, 1.0, 1.0, 13, 9), 1.0)
    guess = guess_around(narrow, wide)
    assert guess.rigid_film == 2.0
    np.testing.assert_array_equal(guess.pressure[3:10, 4:9], 2.0)
    assert (guess.pressure == 1.0).sum() == 13 * 9 - 7 * 5


def test_oil_around_a_narrow_window_is_as_warm_as_at_its_outline():
    def level(grid, rise):
        guess = InitialGuess(np.zeros(grid.shape), 1.0, rise)
        return SimpleNamespace(grid=grid, state=lambda: guess)

    narrow, wide = Grid(0.0, 0.0, 1.0, 1.0, 3, 4), Grid(-2.0, -1.0, 1.0, 1.0, 8, 6)
    known = np.arange(24.0).reshape(3, 4, 2)
    rise = guess_around(level(narrow, known), level(wide, None)).rise
    np.testing.assert_array_equal(rise[2:5, 1:5], known)
    np.testing.assert_array_equal(rise, np.pad(known, ((2, 3), (1, 1), (0, 0)), mode="edge"))


def test_friction_that_a_window_cuts_off_is_that_of_the_contact_beyond_it():
    scene = pyworm.load(TRACTION).scene(slide_roll_ratio=0.5)
    plan = pyworm.plan(scene, 0.3, ("isothermal", "shear-thinning"))
    solver = PointContactSolver(plan.simplified(scene), plan)
    wide, _ = solver.begin(plan.grids)
    iterate(wide, plan.tolerance)
    assert not wide.contact_is_cut()

    grid = wide.grid
    half = replace(grid, nx=round(-grid.west / grid.dx) + 1)  # up to the middle of the contact
    west = SimpleNamespace(contact_is_cut=lambda: True, grid=half)
    cut = solver.cut_off(west, wide)
    inside = np.zeros(grid.shape, dtype=bool)
    inside[: half.nx] = True
    whole, rest = wide.read().figures, wide.rubbed(inside)
    assert cut.keys() == rest.keys() == {"friction_coefficient", "power_loss"}
    for name, part in cut.items():
        assert 0.3 < part < 0.7
        assert part + rest[name] / whole[name] == pytest.approx(1.0)

    assert solver.cut_off(wide, wide) == {}
    assert solver.cut_off(west, west) == {}


def test_windows_of_different_films_are_compared_on_the_next_grid(monkeypatch):
    """The loss is of no target here, but the film of an outline under pressure loses far more."""
    scene, compared = ball(), []
    plan = pyworm.plan(scene, 0.1, effects=("isothermal", "shear-thinning"), quantities=("film",))
    usual = pyworm.solve(scene, plan)
    limits = grid_sequence.in_wider_window

    def found(here, wider, *rest):
        compared.append(here)
        strange = replace(
            here, further=here.further | {"power_loss": 200 * here.further["power_loss"]}
        )
        return limits(strange if len(compared) == 1 else here, wider, *rest)

    monkeypatch.setattr(grid_sequence, "in_wider_window", found)
    again = pyworm.solve(scene, plan)
    assert len(compared) == 2
    assert again.converged and again.figures.power_loss.agrees_with(usual.figures.power_loss)
