"""Films between bodies warmer or colder than the oil supplied to them, and levels across hot films."""

from dataclasses import replace
from pathlib import Path

import pytest
from contacts import INLET, ball, roller, steel
from draws import warm_line
from gear_draws import drive

import pyworm
from pyworm.case.case import case_of
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Barus, Density
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.target import HEAT_FIGURES
from pyworm.solver import grid_sequence, levels_across

OIL = Oil(
    Barus(0.05, 28e-9),
    Density.dowson_higginson(870.0),
    FlowLaw("eyring-limited", stress=3e6, limit=7e6, limit_pressure=0.05),
    OilHeat(INLET, viscosity_exponent=0.03, conductivity=0.14, specific_heat=2000.0),
)
POLYMER = pyworm.Body(3.2e9, 0.35, 1400.0, 0.31, 1470.0, INLET)


def between(contact, *rises, bodies=None, **changes):
    """A contact whose bodies are warmer than the oil's supply by some kelvin."""
    given = zip(bodies or (steel(), steel()), rises, strict=True)
    warm = tuple(replace(of, bulk_temperature=INLET + rise) for of, rise in given)
    return contact(oil=OIL, bodies=warm, **changes)


def solved(scene, accuracy=0.05, **changes):
    plan = replace(pyworm.plan(scene, accuracy, "all"), **changes)
    return pyworm.solve(scene, plan)


def polymer_on_steel():
    return between(roller, 6.0, 11.0, bodies=(POLYMER, steel()), load=1.6e4, velocities=(0.6, 1.0))


def test_a_line_does_not_depend_on_where_its_window_begins():
    """With the supply's temperature on the window's side it would change by some tenths of a per cent."""
    scene = polymer_on_steel()
    plan = pyworm.plan(scene, 0.02, "all")
    (grid,) = plan.grids
    wide = LineGrid(grid.dx, 3 * grid.first, grid.nodes - 2 * grid.first)
    films = [
        solved(scene, 0.02, grids=(of,), wider_grids=(), largest_grid=of.nodes).figures.film_central
        for of in (grid, wide)
    ]
    near, far = (film.on_grid for film in films)
    assert near == pytest.approx(far, rel=1e-3)


@pytest.mark.parametrize("contact", [ball, roller])
def test_bodies_equally_warm_are_oil_supplied_as_warm(contact):
    """But for the model uncertainty: nothing tells the contact what the oil was before."""
    warm = between(contact, 15.0, 15.0)
    hot = contact(oil=OIL.warmed(15.0), bodies=warm.bodies)
    one, other = (solved(scene).figures for scene in (warm, hot))
    for name in ("film_central", "friction_coefficient", "temperature_max_film"):
        assert getattr(one, name).on_grid == pytest.approx(getattr(other, name).on_grid, rel=1e-6)
    assert other.film_central.model is None
    # some 4 to 6 % of 15 K, of which films have two thirds of the change of viscosity
    assert 0.005 < one.film_central.model < 0.03


def test_a_polymer_that_meets_cold_oil_is_less_certain():
    """A bath cools it by 2.3 K and the steel by 0.5 K; through the film steel warms it again, not at once."""
    scene = polymer_on_steel()
    colder = tuple(replace(of, bulk_temperature=of.bulk_temperature - 1) for of in scene.bodies)
    plain, cooled = (
        solved(replace(scene, bodies=bodies)).figures.film_central
        for bodies in (scene.bodies, colder)
    )
    a_kelvin = cooled.on_grid / plain.on_grid - 1
    assert 0.53 * a_kelvin < plain.model < (2.3 + 0.53) / 2 * a_kelvin


def test_a_body_colder_than_the_other_has_error_bars_of_its_own():
    figures = solved(between(roller, 10.0, -10.0)).figures
    colder = figures.temperature_max_body_2
    assert colder.datum == pytest.approx(INLET - 10)
    assert INLET - 10 < colder.value < INLET + 10
    assert 0 < colder.bar < 1.0


@pytest.fixture(scope="module")
def exchanging():
    """A slow line between bodies 9 K apart, at accuracies of 2, 1 and 0.5 %."""
    scene = case_of(warm_line(1, 4711).tables, "line", Path()).scene()
    return scene, {accuracy: solved(scene, accuracy) for accuracy in (0.02, 0.01, 0.005)}


def test_bodies_that_exchange_heat_far_before_a_line_get_the_window_they_need(exchanging):
    """The plan's windows leave 3 % of its temperatures."""
    scene, found = exchanging
    planned = pyworm.plan(scene, 0.02, "all").wider_grids[0]
    assert found[0.02].accurate
    assert found[0.02].fields.x.values[0] < 1.3 * planned.x[0]
    for name in ("film_min", "friction_coefficient", *HEAT_FIGURES):
        one, other = (getattr(found[accuracy].figures, name) for accuracy in (0.02, 0.005))
        assert one.agrees_with(other), name


def test_a_finer_request_does_not_end_worse(exchanging):
    """Where the window leaves more than is asked for, figures still have the errors that it leaves."""
    _, found = exchanging
    errors = [
        max(getattr(of.figures, name).error for name in ("film_min", *HEAT_FIGURES))
        for of in found.values()
    ]
    assert all(of.converged for of in found.values())
    assert errors == sorted(errors, reverse=True)


def hot_line():
    """A thick film 100 K warmer than its walls."""
    oil = replace(
        OIL,
        viscosity=Barus(0.21, 23e-9),
        flow=FlowLaw("eyring-limited", stress=7e6, limit=17e6, limit_pressure=0.09),
        heat=replace(OIL.heat, viscosity_exponent=0.048),
    )
    return roller(oil=oil, gap=pyworm.Parabola(0.18), load=1.08e6, velocities=(5.6, 3.9))


def test_a_hot_film_gets_the_levels_that_it_needs():
    """Its friction agrees with that on 17 levels within its error bar; 7 levels are 1 % off."""
    scene = hot_line()
    plan = pyworm.plan(scene, 0.02, "all")
    assert plan.model.levels == 7
    own = solved(scene, 0.02).figures.friction_coefficient
    exact = solved(scene, 0.02, model=replace(plan.model, levels=17)).figures.friction_coefficient
    assert own.on_grid == pytest.approx(exact.on_grid, rel=own.error)
    assert own.on_grid == pytest.approx(exact.on_grid, rel=0.005)


def swinging(phase):
    """A phase of a fast helical pair and its plan: with 9 or 11 levels its film does not settle."""
    scene = case_of(drive(8, 99010).tables, "helical", Path()).scene(phase=phase)
    return scene, pyworm.plan(scene, 0.05)


def test_levels_are_added_beyond_those_whose_film_swings():
    """With 7 it is 5 % too thin."""
    own = pyworm.solve(*swinging(0.1))
    assert own.accurate, own.stop_reason


@pytest.mark.long
def test_a_film_with_enough_levels_is_that_of_many():
    """With 7 it is 16 % too thin."""
    scene, plan = swinging(0.7)
    own = pyworm.solve(scene, plan).figures
    exact = pyworm.solve(scene, replace(plan, model=replace(plan.model, levels=25))).figures
    for name in ("film_central", "friction_coefficient"):
        one, other = getattr(own, name), getattr(exact, name)
        assert one.value == pytest.approx(other.value, rel=one.error), name


def test_where_more_levels_have_no_film_the_last_that_had_one_stays(monkeypatch):
    """Not even one that is known well enough to judge it by."""
    monkeypatch.setattr(levels_across, "_as_judged_by", lambda further, last: None)
    sound = levels_across.film_is_sound
    monkeypatch.setattr(
        levels_across,
        "film_is_sound",
        lambda level, iteration, plan: plan.model.levels <= 9 and sound(level, iteration, plan),
    )
    found = []

    def recorded(*given, **more):
        found.append(levels_across.enough_levels(*given, **more))
        return found[-1]

    monkeypatch.setattr(grid_sequence, "enough_levels", recorded)
    solved(hot_line(), 0.02)
    assert found[0].plan.model.levels == 9
    assert found[0].errors["film_central"] > 0


def drawn_line(number, seed):
    return case_of(warm_line(number, seed).tables, "warm line", Path()).scene()


def test_temperatures_that_windows_change_slowly_are_within_their_error_bars():
    """Bodies exchange heat through a film of 30 nm: a window changes them by 0.9 of the one before."""
    coarse, fine = (solved(drawn_line(6, 55117), accuracy).figures for accuracy in (0.02, 0.005))
    for name in HEAT_FIGURES:
        one, other = getattr(coarse, name), getattr(fine, name)
        allowed = sum(of.error * (of.value - of.datum) for of in (one, other))
        assert abs(one.value - other.value) <= allowed, name


def test_levels_are_judged_on_grids_that_resolve_the_film():
    """On the first grid, whose film is 22 % too thin, two levels more change it by a third of that."""
    coarse, fine = (solved(drawn_line(10, 90210), accuracy).figures for accuracy in (0.02, 0.002))
    assert fine.film_central.error <= 0.002
    for name in ("film_central", "friction_coefficient", "power_loss"):
        one, other = getattr(coarse, name), getattr(fine, name)
        assert one.value == pytest.approx(other.value, rel=one.error + other.error), name
        assert one.approximation > 3e-4, name
