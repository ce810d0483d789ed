"""Transient films that are thin beside the deformation of their bodies."""

from dataclasses import replace
from math import sqrt
from types import SimpleNamespace

import numpy as np
import pytest
from folders import DATA
from plan_scenes import STEEL, point
from rough_bodies import rough
from test_transient import ball

import pyworm
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Barus, Density
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.plan import first_grids_of
from pyworm.planning.prediction import predicted
from pyworm.scene.life import Life
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import InitialGuess
from pyworm.solver.newton import converge, iterate
from pyworm.solver.point.contact import PointContactSolver
from pyworm.solver.transient import next_film, rated_films
from pyworm.solver.transient.moving_grid import means_about
from pyworm.solver.transient.next_film import _beside, _moved, contact_at, steady_level
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import RateOfChange, integrate_in_time
from pyworm.solver.transient.time_level import time_level_of
from pyworm.solver.transient.time_steps import Step
from pyworm.solver.transient.transient import part_at

OIL = Oil(Barus(0.05, 1.5e-8), Density.incompressible(850.0), FlowLaw("newtonian"), None)


def course_and_scene(name, accuracy=0.05):
    scene = pyworm.load(DATA / name).scene()
    plan = pyworm.plan(scene, accuracy, "auto")
    return time_grid_of(scene.past.life, plan), scene


def test_a_rough_contact_that_has_just_touched_begins_with_the_oils_pressure(monkeypatch):
    """Its asperities would bear 1e25 times the load in a gap that is a little too narrow."""

    def begun(grid, guess):
        residual = 0.5 if guess.oil is None else 1e25
        balance = SimpleNamespace(residual=residual)
        return SimpleNamespace(film=SimpleNamespace(balance=balance), guess=guess)

    onward, latest = (
        InitialGuess(np.full((3, 3), pressure), 1e-6, None, np.full((3, 3), 1e6))
        for pressure in (2e8, 1e8)
    )
    monkeypatch.setattr(next_film, "extrapolated", lambda *how: onward)
    monkeypatch.setattr(next_film, "since_touch", lambda *how: 0.5)
    before, contact = [SimpleNamespace(state=latest)], SimpleNamespace(separation=None)
    time_grid, settling = SimpleNamespace(approach="a touch"), SimpleNamespace(exact=True)
    how = SimpleNamespace(on_grid=begun), None, contact, before, 0.0, settling
    level = next_film._begun_from(time_grid, *how)
    assert level.guess.oil is None and level.guess.pressure is onward.pressure


def test_a_steady_film_keeps_its_thickness_on_a_grid_of_another_length():
    """A line's deflection is relative to its grid's length away: a hundredth of that is 80 films here."""
    time_grid, scene = course_and_scene("unloaded_line.toml")
    first = replace(scene.past.life.at(0.0), past=None)
    film = steady_level(time_grid, Step(0.0, 0))[0].read().film_central
    steady = pyworm.solve(first, pyworm.plan(first, 0.05)).figures.film_central
    assert film == pytest.approx(steady.value, rel=0.03)


def test_a_moved_film_begins_with_its_thickness():
    """On a grid of the same nodes and some more, from whose length away deflections are counted."""
    scene = pyworm.load(DATA / "unloaded_line.toml").scene()
    time_grid = time_grid_of(scene.past.life, pyworm.plan(scene, 0.05, ("isothermal", "squeeze")))
    contact = contact_at(time_grid, 0.0)
    solver = SOLVERS[type(contact)](contact, time_grid.plan)
    level, _ = solver.begin(first_grids_of(contact, time_grid.plan))
    here = level.grid
    grid = replace(here, first=here.first - 40, nodes=here.nodes + 80)
    moved = solver.on_grid(grid, _moved(level, grid))
    # unmoved its datum is 1.4 um off; the pressure beyond the first window counts for 15 nm
    assert moved.read().film_central == pytest.approx(level.read().film_central, abs=50e-9)


def test_a_rough_film_moves_to_a_grid_that_fits_it_badly():
    """From the oil's pressure alone asperities would bear a thousand times the load there."""
    time_grid, _ = course_and_scene("unloaded_line.toml")
    contact, grid = contact_at(time_grid, 0.0), time_grid.grid(0.0, 0)
    solver = SOLVERS[type(contact)](contact, time_grid.plan)
    film = _beside(contact, time_grid, replace(grid, dx=1.08 * grid.dx), solver)
    iterate(film, 1e-5)
    assert film.read().film_central == pytest.approx(17.2e-9, rel=0.03)


@pytest.fixture(scope="module")
def teeth():
    """Rough teeth that roll over each other: time grid, a step, the film before it and the one found."""
    drive = pyworm.load(DATA / "worm_unit_a100.toml").drive
    scene = replace(drive.scene(0.5), past=drive.life.past(0.5))
    plan = pyworm.plan(scene, 0.2, ("isothermal", "squeeze", "roughness"))
    time_grid, step = time_grid_of(scene.past.life, plan), Step(scene.past.seconds, 0)
    first = time_grid.time_at(time_grid.place(step.seconds) - time_grid.step(0))
    before = [time_level_of(steady_level(time_grid, Step(first, 0))[0], first)]
    found, _ = next_film._onward(time_grid, step, before, [], False, 0)
    return time_grid, step, before, found.read().film_min


def overloaded(guess):
    """A guess from which no film is found."""
    return replace(guess, pressure=5 * guess.pressure)


@pytest.fixture
def lost(monkeypatch):
    """Films that the ones before do not lead to, and the steady films that are sought instead."""

    def begun_from(time_grid, solver, grid, contact, before, seconds, settling):
        return solver.on_grid(grid, overloaded(before[0].state))

    sought = []
    monkeypatch.setattr(next_film, "_begun_from", begun_from)
    monkeypatch.setattr(next_film, "_beside", lambda *how: sought.append(how) or _beside(*how))
    return sought


def test_a_rough_film_that_is_lost_begins_with_the_dry_contact(teeth, lost):
    """Within a whole step already, and comes to the same."""
    time_grid, step, before, found = teeth
    level, _ = next_film._onward(time_grid, step, before, [], False, 0)
    assert level.read().film_min == pytest.approx(found, rel=5e-3)
    assert not lost


def test_where_the_dry_contact_leads_to_no_film_the_last_halves_begin_with_a_steady_one(
    teeth, lost, monkeypatch
):
    time_grid, step, before, found = teeth
    guesses = [overloaded(before[0].state)]
    monkeypatch.setattr(PointContactSolver, "dry_guesses", lambda solver, level: guesses)
    with pytest.raises(next_film.NoFilmError):
        next_film._onward(time_grid, step, before, [], False, next_film.MOST_HALVINGS - 1)
    assert not lost
    level, _ = next_film._onward(time_grid, step, before, [], False, next_film.MOST_HALVINGS)
    assert level.read().film_min == pytest.approx(found, rel=5e-3)
    assert len(lost) == 1


def test_a_rough_film_with_a_rate_that_is_lost_begins_with_the_dry_contact(monkeypatch):
    """The steady film, from which it is sought first, may be far from it."""
    scene = rough(ball(), 0.3e-6)
    plan = pyworm.plan(scene, 0.2, ("isothermal", "roughness"))
    level, _ = SOLVERS[type(scene)](scene, plan).begin(plan.grids)
    converge(level, plan.tolerance, plan.target, 0.01)
    reading_of, lost = rated_films._reading_of, []

    def given_up_once(plan, level):
        if not lost:
            lost.append(level)
            level.film.start(5 * level.film.pressure, level.film.rigid_film)
            return level.read()
        return reading_of(plan, level)

    monkeypatch.setattr(rated_films, "_reading_of", given_up_once)
    rate = RateOfChange(level.grid, np.zeros(level.grid.shape))
    found, reading = rated_films._film_with(scene, plan, level, rate)
    assert lost[0].diverged() and not found.diverged()
    assert reading.figures["film_min"] == pytest.approx(level.read().film_min, rel=2e-3)


def test_a_line_has_a_film_up_to_the_end_of_its_history():
    time_grid, scene = course_and_scene("unloaded_line.toml")
    found = integrate_in_time(time_grid, 0, 0.0, [scene.past.seconds])
    assert found.failure is None
    films = [one.figures["film_central"] for one in found.records]
    # the film of the heavy load is carried through, and a thicker one follows
    assert films[0] == pytest.approx(17.3e-9, rel=0.03)
    assert min(films) > 0.97 * films[0]


def test_grids_do_not_move_as_fast_as_the_oil_when_a_blow_is_over():
    time_grid, scene = course_and_scene("struck_ellipse.toml")
    transit = 1 / (time_grid.transits(scene.past.seconds) / scene.past.seconds)
    for kink in scene.past.life.kinks:
        assert abs(time_grid.mesh(kink).growth_x) * transit < 0.2


@pytest.mark.long
def test_solves_of_a_struck_contact_agree_in_its_minimum_film_thickness():
    time_grid, scene = course_and_scene("struck_ellipse.toml")
    at, plan = scene.past.seconds, pyworm.plan(scene, 0.05, "auto")
    begin = part_at(time_grid, at).begin
    simple = plan.simplified(scene)
    level, _ = SOLVERS[type(scene)](simple, plan).begin(plan.grids)
    films = []
    for refinement in (0, 1):
        rate = integrate_in_time(time_grid, refinement, begin, [at]).rates[at]
        level = SOLVERS[type(scene)](simple, plan, rate).with_rate(level)
        films.append(converge(level, plan.tolerance, plan.target, 0.001).reading.film_min)
    assert films[0] == pytest.approx(films[1], rel=0.03)


def test_the_grid_holds_a_contact_that_grows_longer_in_cells():
    """Its breadth, by which the spacing goes, falls faster than its length."""

    def contact_at(seconds):
        fall = np.exp(-3 * seconds)
        speeds = (1.0, 0.0), (0.5, 0.0)
        radii = 2.0, 0.2 * fall
        return point("runs off", radii, 5000 * sqrt(fall), speeds, (STEEL, STEEL), OIL)

    life = Life(1.0, contact_at, lambda seconds: 0.0)
    time_grid = time_grid_of(life, pyworm.plan(contact_at(0.0), 0.05, "isothermal", ("film",)))
    for seconds in np.linspace(0.0, 1.0, 9):
        grid, prediction = time_grid.grid(seconds, 0), predicted(contact_at(seconds))
        # the spacing follows that of the windows within a per cent
        assert min(-grid.x[0], grid.x[-1]) > 1.19 * prediction.half_width
        assert min(-grid.y[0], grid.y[-1]) > 1.19 * prediction.half_length


def test_oil_stores_no_heat_beyond_the_grid_on_which_its_rate_is_known():
    """Gaps are wide there: the rates of its edge heated the wider domain of a worm gear by 2800 K."""
    grid, wider = Grid(-1.0, -1.0, 0.5, 0.5, 5, 5), Grid(-2.0, -1.5, 0.5, 0.5, 9, 7)
    ones = np.ones(grid.shape)
    rate = RateOfChange(grid, 0 * ones, np.zeros((5, 5, 2)), np.ones((5, 5, 3)), ones)
    stored = rate.stored(wider)
    inner = np.zeros(wider.shape)
    inner[2:7, 1:6] = 1.0
    assert stored.pressing == pytest.approx(inner)
    assert stored.warming == pytest.approx(np.repeat(inner[..., np.newaxis], 3, axis=-1))


def test_a_rate_keeps_its_sum_on_a_grid_far_coarser_than_its_features():
    fine, coarse = LineGrid(0.01, -200, 401), LineGrid(0.16, -13, 27)
    dent = np.exp(-(((fine.x - 0.08) / 0.03) ** 2))
    means = means_about(fine, dent, coarse)
    assert means.sum() * coarse.dx == pytest.approx(0.03 * np.sqrt(np.pi), rel=1e-6)
    # half of it lies to each side of the face at 0.08
    assert means[13] == pytest.approx(means[14], rel=1e-6)


def test_a_rate_over_two_directions_keeps_its_sum_and_goes_on_beyond_its_grid():
    fine, coarse = Grid(-2.0, -1.0, 0.02, 0.01, 201, 201), Grid(-4.0, -2.0, 0.4, 0.25, 21, 17)
    x, y = fine.mesh()
    means = means_about(fine, np.exp(-((x / 0.1) ** 2) - ((y - 0.3) / 0.05) ** 2), coarse)
    assert means.sum() * 0.4 * 0.25 == pytest.approx(0.1 * 0.05 * np.pi, rel=1e-6)
    assert means_about(fine, 1.0 + 0.0 * x, coarse) == pytest.approx(1.0)
