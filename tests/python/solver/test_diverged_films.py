"""What the solver does with films that diverge; the kernel is made to lose what contacts at hand keep."""

from dataclasses import replace
from importlib import import_module

import numpy as np
import pytest
from contacts import INLET, ball, roller

import pyworm
from pyworm.kernel.core import NOT_CONVERGED, KernelError
from pyworm.kernel.film import Balance, Film
from pyworm.planning import error_budget
from pyworm.solver import arrival_uncertainty, grid_sequence
from pyworm.solver.contact import MAX_STRESS_FACTOR, ContactSolver
from pyworm.solver.ending import Ending
from pyworm.solver.grid_sequence import GridSequence
from pyworm.solver.line.contact import LineContactSolver
from pyworm.solver.newton import iterate
from pyworm.solver.point.contact import PointContactSolver
from pyworm.solver.window_limit import in_wider_window

ACCURACY = 0.2

DRY_CONTACT = import_module("pyworm.kernel.dry_contact")


@pytest.fixture
def diverging(monkeypatch):
    """Makes Newton's iteration diverge at once on the films for which a condition holds; counts them."""
    lost = []

    def make(condition):
        step = Film.step

        def diverged(film, forcing):
            if not condition(film):
                return step(film, forcing)
            lost.append(film)
            waves = 1 + 0.9 * np.cos(np.pi * np.arange(film.pressure.shape[0]))
            film.pressure = np.asfortranarray((film.pressure.T * waves).T)
            film.balance = Balance(1e3, 0.0)
            raise KernelError(NOT_CONVERGED)

        monkeypatch.setattr(Film, "step", diverged)
        return lost

    return make


def on_grid(shape, number):
    """Whether a film is that of the grid of this number among those of a shape, from 1."""
    films = []

    def is_it(film):
        if film.pressure.shape == shape and film not in films:
            films.append(film)
        return film in films[number - 1 : number]

    return is_it


def agree(one, other):
    """Whether the films of two solutions agree within their error bars."""
    return all(
        getattr(one.figures, name).agrees_with(getattr(other.figures, name))
        for name in ("film_min", "film_central")
    )


def settled(*levels):
    """Central films of levels, each settled first."""
    for level in levels:
        iterate(level, 1e-6, 1e-5)
    return [level.read().film_central for level in levels]


def finer(grid, times):
    for _ in range(times):
        grid = grid.finer()
    return grid


def test_a_film_that_is_lost_on_its_first_grid_begins_again_on_the_next(diverging):
    scene = ball()
    plan = pyworm.plan(scene, ACCURACY, "isothermal")
    usual = pyworm.solve(scene, plan)
    shapes = [grid.shape for grid in plan.grids]
    lost = diverging(on_grid(shapes[-1], shapes.count(shapes[-1])))
    solution = pyworm.solve(scene, plan)
    assert lost and solution.converged, solution.stop_reason
    assert agree(solution, usual)


def test_a_film_that_the_interpolated_one_leads_nowhere_begins_anew(diverging, monkeypatch):
    scene = ball()
    plan = pyworm.plan(scene, 0.004, "isothermal", ("film",))
    usual = pyworm.solve(scene, plan)
    next_one = finer(plan.grids[-1], 1).shape
    assert usual.fields["film"].shape == next_one[::-1]
    anew, begun = PointContactSolver.begun_again, []

    def counted(solver, level):
        begun.append(level.grid.shape)
        return anew(solver, level)

    monkeypatch.setattr(PointContactSolver, "begun_again", counted)
    lost = diverging(on_grid(next_one, 1))
    solution = pyworm.solve(scene, plan)
    assert lost and solution.converged, solution.stop_reason
    assert begun[0] == plan.grids[-1].shape
    assert agree(solution, usual)


def test_no_film_in_the_wider_window_is_no_error_bar(diverging):
    """Two finer grids are tried; a window error that nothing shows is infinite."""
    scene = roller()
    plan = pyworm.plan(scene, ACCURACY, "isothermal")
    wider = {finer(plan.wider_grids[-1], times).shape for times in range(3)}
    narrow = {finer(plan.grids[-1], times).shape for times in range(3)}
    assert not wider & narrow
    diverging(lambda film: film.pressure.shape in wider)
    solution = pyworm.solve(scene, plan)
    assert not solution.converged
    assert solution.ending is Ending.NO_WIDER_FILM
    assert solution.figures.film_min.error == np.inf
    assert solution.fields["film"].shape == finer(plan.grids[-1], 2).shape


def test_a_wider_window_that_is_lost_from_the_narrower_film_is_solved_for_itself(diverging):
    scene = ball()
    plan = pyworm.plan(scene, ACCURACY, ("isothermal", "shear-thinning"))
    solver = PointContactSolver(plan.simplified(scene), plan)
    narrow, _ = solver.begin(plan.grids)
    usual, _ = solver.in_wider_window(plan.wider_grids, narrow)
    lost = diverging(lambda film: bool(film.levels) and not was_lost)
    was_lost = lost
    wider, _ = solver.in_wider_window(plan.wider_grids, narrow)
    assert lost
    films = settled(usual, wider)
    assert films[1] == pytest.approx(films[0], rel=1e-4)


def stresses_of(monkeypatch):
    """Factors of the stresses that a solver's films are sheared with."""
    factors = []
    shear = ContactSolver._shear

    def noted(solver, level, stresses=1.0):
        factors.append(stresses)
        shear(solver, level, stresses)

    monkeypatch.setattr(ContactSolver, "_shear", noted)
    return factors


def hot_roller():
    scene = roller()
    plan = pyworm.plan(scene, ACCURACY, "all")
    return scene, plan, LineContactSolver(plan.simplified(scene), plan)


def test_a_film_that_is_lost_as_it_is_heated_is_heated_under_larger_stresses(
    diverging, monkeypatch
):
    """And softened to its own law, where it is the film that is found without."""
    _, plan, solver = hot_roller()
    usual, _ = solver.begin(plan.grids)
    factors = stresses_of(monkeypatch)
    lost = diverging(lambda film: film.heated and max(factors) < 4)
    level, _ = solver.begin(plan.grids)
    assert len(lost) == 2
    assert 4 in factors and factors[-1] == 1
    assert not level.diverged()
    films = settled(usual, level)
    assert films[1] == pytest.approx(films[0], rel=1e-4)


def test_a_film_that_no_stresses_bear_heated_is_left_under_its_own_law(diverging, monkeypatch):
    scene, plan, _ = hot_roller()
    factors = stresses_of(monkeypatch)
    diverging(lambda film: film.heated)
    solution = pyworm.solve(scene, plan)
    assert max(factors) == MAX_STRESS_FACTOR and factors[-1] == 1
    assert not solution.converged
    assert "no film was found" in solution.stop_reason or "residual" in solution.stop_reason


def test_a_finer_grid_that_larger_stresses_do_not_reach_begins_again(diverging):
    """From the dry contact, where neither the coarser film nor those of larger stresses lead to a film."""
    scene = ball()
    plan = pyworm.plan(scene, ACCURACY, "all")
    solver = PointContactSolver(plan.simplified(scene), plan)
    level, _ = solver.begin(plan.grids)
    settled(level)
    usual, _ = solver.refined(level)
    solver._guesses = lambda level: iter(())
    lost = diverging(on_grid(level.grid.finer().shape, 1))
    finer, _ = solver.refined(level)
    assert lost and finer.film not in lost
    films = settled(usual, finer)
    assert films[1] == pytest.approx(films[0], rel=1e-4)


def test_a_dry_contact_that_does_not_converge_is_the_reason(monkeypatch):
    """Films converge without it, but the figures beside the dry contact's are not to be trusted."""
    scene = ball()
    plan = pyworm.plan(scene, ACCURACY, "isothermal")
    monkeypatch.setattr(DRY_CONTACT, "_MOST_DRY_ITERATIONS", 1)
    solution = pyworm.solve(scene, plan)
    assert not solution.converged
    assert solution.stop_reason == "the dry contact did not converge"


def test_a_film_that_does_not_follow_its_bodies_has_no_model_uncertainty(monkeypatch):
    """It is unbounded; the film stays as it was."""
    scene = roller()
    warmer = tuple(
        replace(body, bulk_temperature=INLET + rise)
        for body, rise in zip(scene.bodies, (6.0, 11.0), strict=True)
    )
    scene = replace(scene, bodies=warmer)
    plan = pyworm.plan(scene, ACCURACY, "all")
    usual = pyworm.solve(scene, plan)
    monkeypatch.setattr(arrival_uncertainty, "MOST_STEPS", 0)
    solution = pyworm.solve(scene, plan)
    assert np.isfinite(usual.figures.film_central.model)
    assert solution.figures.film_central.model == np.inf
    assert solution.figures.film_central.value == pytest.approx(
        usual.figures.film_central.value, rel=1e-3
    )


@pytest.mark.parametrize("film", ["lost", "inaccurate", "accurate", "lucky"])
def test_a_finer_request_ends_no_worse_than_a_coarser_one(film, monkeypatch):
    """Its window is wider, its tolerance lower: where it loses by either, the coarser film is taken.

    Where that is luckily as accurate as asked it is a film like any other.
    """
    scene = ball()
    coarse = pyworm.plan(scene, 0.05, "isothermal", ("film",))
    usual = pyworm.solve(scene, coarse)
    finish, asked = GridSequence.finish, []

    def spoiled(sequence):
        accuracy = sequence._plan.accuracy
        asked.append(accuracy)
        solution = finish(sequence)
        if accuracy == 0.05 and film == "lucky":
            known = {
                name: replace(getattr(solution.figures, name), grid=0.003, domain=0.003)
                for name in ("film_min", "film_central")
            }
            return solution.changed(figures=replace(solution.figures, **known))
        if accuracy == 0.05 or film == "accurate":
            return solution
        figures = replace(solution.figures, film_min=replace(solution.figures.film_min, grid=0.4))
        return solution.changed(
            converged=film != "lost",
            ending=Ending.WINDOW_OF_FILM,
            stop_reason="films depend on surfaces far out",
            figures=figures,
        )

    monkeypatch.setattr(GridSequence, "finish", spoiled)
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.01, "isothermal", ("film",)))
    assert asked == ([0.01] if film == "accurate" else [0.01, 0.05])
    assert solution.accuracy == 0.01
    assert (solution.ending is Ending.COARSER_REQUEST) == (film in ("lost", "inaccurate"))
    if film == "lucky":
        assert solution.accurate and solution.figures.film_min.value == usual.figures.film_min.value
    elif film != "accurate":
        assert solution.figures.film_min == usual.figures.film_min
        assert solution.converged
        assert solution.stop_reason.startswith("less accurate than requested, ")
        assert solution.stop_reason.endswith("requested 1 %, films depend on surfaces far out")


def test_pressure_of_a_lost_outer_film_is_none_of_the_next_window(monkeypatch):
    """Beyond that window it may exceed the load, and none would be left for the contact."""
    scene = ball()
    plan = pyworm.plan(scene, ACCURACY, effects="isothermal")
    found, _ = PointContactSolver(scene, plan).begin(plan.grids)
    step, shapes = Film.step, []

    def lost(film, forcing):
        if film.pressure.shape != plan.grids[0].shape:
            return step(film, forcing)
        shapes.append(film.pressure.shape)
        film.pressure[1:-1, 1:-1] = scene.load / 1e-8
        film.balance = Balance(1e3, 0.0)
        raise KernelError(NOT_CONVERGED)

    monkeypatch.setattr(Film, "step", lost)
    again, _ = PointContactSolver(scene, plan).begin(plan.grids)
    assert shapes and 0 < again.load <= 1.1 * scene.load
    first, second = settled(found, again)
    assert second == pytest.approx(first, rel=0.02)


@pytest.mark.parametrize(("film", "widened"), [(0.0, True), (0.3, False)])
def test_a_window_is_doubled_once_where_friction_alone_depends_on_it(film, widened, monkeypatch):
    """Where films do as well the next grid is tried, which may show them better."""
    asked = []

    def far_off(*given):
        limits = in_wider_window(*given)
        asked.append(limits)
        if len(asked) > 1:
            return limits
        off = {"friction_coefficient": 0.3, "film_central": film}
        return limits | {name: replace(limits[name], error=error) for name, error in off.items()}

    monkeypatch.setattr(grid_sequence, "in_wider_window", far_off)
    scene = ball()
    plan = pyworm.plan(scene, ACCURACY, ("isothermal", "shear-thinning"), ("friction",))
    solution = pyworm.solve(scene, plan)
    assert solution.accurate and len(asked) == 2
    x = solution.fields.x.values
    west, east, *_ = plan.wider_grids[-1].box
    assert (x[-1] - x[0] > 0.99 * (east - west)) == widened


def test_a_film_that_depends_on_surfaces_far_out_is_used_with_its_uncertainty(monkeypatch):
    """The grid after the first tells what grids leave, without which nothing would be known of it."""

    def far_off(*given):
        limits = in_wider_window(*given)
        return limits | {"film_central": replace(limits["film_central"], error=0.3)}

    monkeypatch.setattr(grid_sequence, "in_wider_window", far_off)
    monkeypatch.setattr(error_budget, "WINDOW", 0.0)
    scene = ball()
    solution = pyworm.solve(scene, pyworm.plan(scene, ACCURACY, "isothermal", ("film",)))
    assert solution.converged and not solution.accurate
    assert "domain truncation error of the film 30 %" in solution.stop_reason
    assert 0.3 <= solution.figures.film_central.error < 0.4
