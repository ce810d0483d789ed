"""Heat that the oil of transient films stores."""

from dataclasses import replace
from math import exp
from types import SimpleNamespace

import numpy as np
import pytest
from plan_scenes import STEEL, line, point

import pyworm
from pyworm.kernel.interpolation import at_levels, level_positions
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil, OilHeat
from pyworm.materials.viscosity_density import Barus, Density
from pyworm.planning.expected_work import STEPS_A_TRANSIT
from pyworm.planning.grid import Grid
from pyworm.scene.life import Life, Past
from pyworm.scene.line import LineScene
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.newton import converge
from pyworm.solver.transient import next_film, settling
from pyworm.solver.transient.next_film import heated_levels, prompt
from pyworm.solver.transient.time_grid import time_grid_of
from pyworm.solver.transient.time_integration import RateOfChange, integrate_in_time

INLET, EXPANSIVITY = 333.15, 7e-4
HEAT = OilHeat(INLET, 0.0, 0.14, 2000.0, EXPANSIVITY)
"""Heat of an oil whose viscosity it leaves as it is."""

OIL = Oil(Barus(0.02, 1e-8), Density.incompressible(850.0), FlowLaw("newtonian"), HEAT)
SPEEDS = 1.5, 0.5


def ball():
    return point("ball", (0.02, 0.02), 20.0, tuple((u, 0.0) for u in SPEEDS), (STEEL, STEEL), OIL)


def roller():
    return line("roller", 0.02, 5e4, SPEEDS, (STEEL, STEEL), OIL)


@pytest.mark.parametrize("contact", [ball, roller])
def test_oil_that_warms_stores_heat_and_oil_that_is_pressed_is_warmed(contact):
    """Storing evenly, a film is rho c dT/dt h^2/(8 k) colder in its middle; pressing it makes up for that."""
    scene = contact()
    plan = pyworm.plan(scene, 0.05, "all")
    steady, _ = SOLVERS[type(scene)](scene, plan).begin(plan.grids)
    grid, levels = steady.grid, steady.film.levels
    converge(steady, 1e-6, plan.target, 1e-5)
    origin = tuple(int(np.argmin(np.abs(axis))) for axis in axes(grid))
    capacity = OIL.density.rho0 * HEAT.specific_heat
    cold = capacity * steady.film.thickness()[origin] ** 2 / (8 * HEAT.conductivity)
    drop = 0.2 * above_walls(steady.film.rise()[origin])
    none = np.zeros(grid.shape)
    rate = np.where(steady.contact(), drop / cold, 0.0)
    warming = np.repeat(rate[..., np.newaxis], levels + 2, axis=-1)  # of a transient solve
    pressing = capacity * rate / (EXPANSIVITY * INLET)
    middles = []
    for pressed in (none, pressing):
        term = RateOfChange(grid, none, warming=warming, pressing=pressed)
        level = SOLVERS[type(scene)](scene, plan, term).with_rate(steady)
        converge(level, 1e-6, plan.target, 1e-5)
        middles.append(above_walls(level.film.rise()[origin]))
    assert drop / 0.2 - middles[0] == pytest.approx(drop, rel=0.03)
    assert middles[1] == pytest.approx(drop / 0.2, abs=0.05 * drop)


def above_walls(across):
    """The middle of a film over the mean of its walls."""
    return across[len(across) // 2] - (across[0] + across[-1]) / 2


def axes(grid):
    return (grid.x, grid.y) if isinstance(grid, Grid) else (grid.x,)


GROWTH, DURATION = 500.0, 2e-3


def warming_roller():
    """A contact whose sliding grows as exp(s t/2), and its plan."""

    def contact_at(seconds):
        slide = 0.5 * exp(GROWTH * seconds / 2)
        velocities = 1 + slide, 1 - slide
        return line("roller", 0.02, 5e4, velocities, (STEEL, STEEL), OIL)

    life = Life(DURATION, contact_at)
    present = replace(contact_at(DURATION), past=Past(life, DURATION))
    return present, pyworm.plan(present, 0.05, "all", ("temperature",))


def test_oil_warms_at_the_rate_at_which_its_heat_grows():
    """Sliding as exp(s t/2) heats oil of one viscosity as exp(s t), which is how it warms."""
    present, plan = warming_roller()
    time_grid = time_grid_of(present.past.life, plan)
    rate = integrate_in_time(time_grid, 0, 0.0, [DURATION]).rates[DURATION]
    steady, _ = SOLVERS[type(present)](present, plan).begin(plan.grids)
    converge(steady, 1e-6, plan.target, 1e-5)
    (warming,), (rise,) = (
        field[grid.x == 0.0]
        for field, grid in ((rate.warming, rate.grid), (steady.film.rise(), steady.grid))
    )
    assert above_walls(warming) == pytest.approx(GROWTH * above_walls(rise), rel=0.02)


def test_wide_gaps_store_nothing():
    """There temperatures do not follow within a time step, and differ by what is left of their iteration."""
    scene = roller()
    plan = pyworm.plan(scene, 0.05, "all")
    level, _ = SOLVERS[LineScene](scene, plan).begin(plan.grids)
    film = level.film.thickness()
    late = OIL.density.rho0 * HEAT.specific_heat * film**2 / (10 * HEAT.conductivity)
    step = float(np.sqrt(late.min() * late.max()))
    share = prompt(level, step)
    assert share[film.argmin()] > 0.95 and share[film.argmax()] < 0.05
    assert np.all(share * late < step) and np.all(np.diff(share[np.argsort(film)]) <= 1e-12)


@pytest.mark.parametrize("more", [next_film.WARMING_STEPS, 0])
def test_a_film_whose_temperatures_still_move_is_solved_on_before_it_is_begun_again(
    more, monkeypatch
):
    """Each other beginning costs a nest of steady films."""
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 6)
    for name in ("MOST_STEPS", "TRIAL_STEPS"):
        monkeypatch.setattr(next_film, name, 2)
    monkeypatch.setattr(settling, "TEMPERATURE_CHANGE", 1e-5)
    monkeypatch.setattr(next_film, "MAX_TEMPERATURE_RESIDUAL", 1e-5)
    monkeypatch.setattr(next_film, "WARMING_STEPS", more)
    beside, beginnings = next_film._beside, []

    def counted(*how):
        beginnings.append(how)
        return beside(*how)

    monkeypatch.setattr(next_film, "_beside", counted)
    present, plan = warming_roller()
    time_grid = time_grid_of(present.past.life, plan)
    found = integrate_in_time(time_grid, 0, 0.0, [DURATION])
    assert found.failure is None
    assert len(beginnings) == 1 if more else len(beginnings) > 40


def test_surfaces_remember_the_heat_of_films_and_not_of_wide_gaps():
    """Between walls 3.4 mm apart they drove each other, by a factor of 2.5 in each time step."""
    scene = roller()
    plan = pyworm.plan(scene, 0.05, "all")
    level, _ = SOLVERS[LineScene](scene, plan).begin(plan.grids)
    converge(level, 1e-6, plan.target, 1e-5)
    film, flux = level.film.thickness(), level.film.heat_fields().flux
    late = OIL.density.rho0 * HEAT.specific_heat * film**2 / (10 * HEAT.conductivity)
    transit = float(np.sqrt(late.min() * late.max()))
    (known,) = heated_levels(SimpleNamespace(transit=lambda seconds: transit), level, 0.25)
    wide = late > 10 * transit
    assert known.seconds == 0.25
    assert known.flux[film.argmin()] == pytest.approx(flux[film.argmin()], rel=0.01)
    assert np.all(np.abs(known.flux[wide]) <= 0.01 * np.abs(flux[wide]))
    assert np.any(flux[wide] != 0)


def test_a_film_that_hardly_changes_is_the_steady_one_with_the_heat_that_oil_stores(monkeypatch):
    monkeypatch.setitem(STEPS_A_TRANSIT, "line", 12)
    scene = pyworm.load("cases/roller_ref.toml").scene(section="left", phase=0.5, station=0.5)
    films = [
        pyworm.solve(
            scene, pyworm.plan(scene, 0.05, ("all", f"{motion}squeeze"), ("film",))
        ).figures
        for motion in ("", "-")
    ]
    for name in ("film_min", "film_central"):
        moving, steady = (getattr(of, name).value for of in films)
        assert moving == pytest.approx(steady, rel=2e-3)


def test_fields_across_a_film_at_other_levels_are_those_of_one_polynomial():
    few, many = level_positions(5), level_positions(9)
    field = np.stack([few**3 - few, 1 - few**4])
    assert at_levels(field, 9) == pytest.approx(np.stack([many**3 - many, 1 - many**4]), abs=1e-12)
    assert at_levels(at_levels(field, 9), 5) == pytest.approx(field, abs=1e-12)
