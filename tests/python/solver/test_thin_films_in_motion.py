"""Transient films that are thin beside the deformation of their bodies."""

from dataclasses import replace
from pathlib import Path

import pytest

import pyworm
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.newton import lead, settle
from pyworm.solver.transient.course import course_of
from pyworm.solver.transient.march import _beside, contact_at, march, steady_level
from pyworm.solver.transient.time_steps import Step
from pyworm.solver.transient.transient import part_at

DATA = Path(__file__).parents[2] / "data"


def course_and_scene(name, accuracy=0.05):
    scene = pyworm.load(DATA / name).scene()
    plan = pyworm.plan(scene, accuracy, "auto")
    return course_of(scene.past.life, plan), scene


def test_a_steady_film_keeps_its_thickness_on_a_grid_of_another_length():
    """A line's deflection is relative to its grid's length away: a hundredth of that is 80 films here."""
    course, scene = course_and_scene("unloaded_line.toml")
    first = replace(scene.past.life.at(0.0), past=None)
    film = steady_level(course, Step(0.0, 0))[0].read().film_central
    steady = pyworm.solve(first, pyworm.plan(first, 0.05)).figures.film_central
    assert film == pytest.approx(steady.value, rel=0.03)


def test_a_rough_film_moves_to_a_grid_that_fits_it_badly():
    """From the oil's pressure alone asperities would bear a thousand times the load there."""
    course, _ = course_and_scene("unloaded_line.toml")
    contact, grid = contact_at(course, 0.0), course.grid(0.0, 0)
    solver = SOLVERS[type(contact)](contact, course.plan)
    film = _beside(contact, course, replace(grid, dx=1.08 * grid.dx), solver)
    lead(film, 1e-5)
    assert film.read().film_central == pytest.approx(17.2e-9, rel=0.03)


def test_a_line_has_a_film_up_to_the_end_of_its_history():
    course, scene = course_and_scene("unloaded_line.toml")
    found = march(course, 0, 0.0, [scene.past.seconds])
    assert found.lost is None
    films = [one.figures["film_central"] for one in found.moments]
    # the film of the heavy load is carried through, and a thicker one follows
    assert films[0] == pytest.approx(17.3e-9, rel=0.03)
    assert min(films) > 0.97 * films[0]


def test_grids_do_not_move_as_fast_as_the_oil_when_a_blow_is_over():
    course, scene = course_and_scene("struck_ellipse.toml")
    transit = 1 / (course.transits(scene.past.seconds) / scene.past.seconds)
    for kink in scene.past.life.kinks:
        assert abs(course.mesh(kink).growth_x) * transit < 0.2


def test_solves_of_a_struck_contact_agree_in_its_minimum_film_thickness():
    course, scene = course_and_scene("struck_ellipse.toml")
    at, plan = scene.past.seconds, pyworm.plan(scene, 0.05, "auto")
    begin = part_at(course, at).begin
    simple = plan.simplified(scene)
    level, _ = SOLVERS[type(scene)](simple, plan).begin(plan.grids)
    films = []
    for refinement in (0, 1):
        rate = march(course, refinement, begin, [at]).rates[at]
        level = SOLVERS[type(scene)](simple, plan, rate).with_rate(level)
        films.append(settle(level, plan.tolerance, plan.aim, 0.001).reading.film_min)
    assert films[0] == pytest.approx(films[1], rel=0.03)
