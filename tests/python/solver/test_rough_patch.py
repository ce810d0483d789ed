"""Rough surfaces resolved node by node: limits, heat by closed forms, waves, refusals."""

from dataclasses import replace
from math import pi, sqrt
from types import SimpleNamespace

import numpy as np
import pytest

import pyworm
from pyworm import kernel
from pyworm.kernel.core import NO_DESCENT, KernelError
from pyworm.materials.topography import Topography
from pyworm.planning.grid import Grid
from pyworm.solver.patch.flash_heat import HeatedSurface, wall_fluxes
from pyworm.solver.patch.moving_heights import MovingHeights, resampled
from pyworm.solver.patch.newton import Balances, PatchNewton
from pyworm.solver.patch.rough_patch import rough_patch
from pyworm.solver.patch.sheared_oil import ShearedOil
from pyworm.surfaces.generated import gaussian


@pytest.fixture(scope="module")
def scene():
    return pyworm.load("cases/traction_steel.toml").scene(slide_roll_ratio=0.2)


def waves(length, amplitude):
    height = amplitude * np.cos(2 * pi * np.arange(256) / 32)
    return Topography(np.repeat(height[:, None], 4, axis=1), (length / 32, length), periodic=True)


def test_surfaces_without_height_keep_the_smooth_film_and_its_heat(scene):
    found = rough_patch(scene, (None, waves(1e-4, 0.0)), nodes=65, stride=4, averaged=0.1)
    assert found.mean("film_mean")[0] == pytest.approx(found.smooth.film_mean, rel=1e-6)
    assert found.mean("friction")[0] == pytest.approx(found.smooth.friction, rel=1e-6)
    assert found.mean_temperatures() == pytest.approx(found.smooth.temperatures, abs=1e-4)
    assert found.records[-1].newton == 0
    # a narrower window and a mean viscosity across the film: 3 % off the solver's film on this grid
    solution = pyworm.solve(scene, accuracy=0.03)
    assert found.smooth.film_central == pytest.approx(solution.figures.film_central.value, rel=0.05)
    assert found.smooth.friction == pytest.approx(
        solution.figures.friction_coefficient.value, rel=0.1
    )
    hottest = solution.figures.temperature_max_body_2.value
    assert found.smooth.temperatures[1] == pytest.approx(hottest, abs=0.3)


def test_waves_that_roll_keep_what_the_formula_leaves_of_their_amplitude():
    # Venner and Lubrecht (2000): 0.392 by their fit, whose own numbers differ from it by some per cent
    case = pyworm.load("cases/point_m100_l10.toml")
    rolling = case.scene(**case.places()[0].given)
    size = pyworm.scene.scales.scales(rolling)
    radius, amplitude = size.hertz.semi_axis_x, 0.1 * size.film
    found = rough_patch(
        rolling, (None, waves(2 * radius, amplitude)), nodes=129, stride=2, averaged=2.0
    )
    films = [known.film_central for known in found.records if known.time >= found.taken_from]
    group = 2 * sqrt(size.groups.moes_m / size.groups.moes_l)
    left = 1 / (1 + 0.15 * group + 0.015 * group**2)
    assert (max(films) - min(films)) / 2 / amplitude == pytest.approx(left, rel=0.15)
    assert max(known.residual for known in found.records) <= 1e-3
    assert max(abs(known.load_error) for known in found.records) <= 1e-3
    assert found.summary()["asperity_load_fraction"] == 0


@pytest.mark.parametrize("pace", [0.0, 0.6])
def test_waves_that_slide_are_flattened_and_oil_carries_waves_of_another_length(pace):
    case = pyworm.load("cases/point_m100_l10.toml")
    rolling = case.scene(**case.places()[0].given)
    speed, length = rolling.motions[0].u, 0.5
    motions = pyworm.RigidMotion((2 - pace) * speed, 0.0), pyworm.RigidMotion(pace * speed, 0.0)
    size = pyworm.scene.scales.scales(rolling)
    radius, amplitude = size.hertz.semi_axis_x, 0.1 * size.film
    found = rough_patch(
        replace(rolling, motions=motions),
        (None, waves(length * radius, amplitude)),
        nodes=97,
        averaged=0.1,
    )
    inside = np.abs(found.grid.x) < 0.7 * radius
    x, number = found.grid.x[inside], 2 * pi / (length * radius)
    film = (found.last.film - found.smooth_film)[inside, found.grid.ny // 2] / amplitude
    numbers = [number, *([pace * number] if pace else [])]
    place = x / radius
    columns = [x**0, place, place**2, *(f(k * x) for k in numbers for f in (np.cos, np.sin))]
    best = np.linalg.lstsq(np.array(columns).T, film, rcond=None)[0]
    kept = [np.hypot(best[first], best[first + 1]) for first in range(3, len(best), 2)]
    # closed form (Morales-Espejel and Brizmer 2011) for a viscosity that lets no pressure flow: the oil's
    # compression alone, C/(1 + C), leaves some of the wave
    p, h = found.smooth_pressure.max(), found.smooth.film_central
    stiffness = rolling.bending_modulus * number / 4
    density = rolling.oil.density
    compressed = h * stiffness * (density(1.01 * p) / density(p) - 1) / (0.01 * p)
    assert kept[0] == pytest.approx(compressed / (1 + compressed), abs=0.02)
    if pace:
        # and oil carries what the inlet lets through: linear theory of benchmarks/validation/linear_waves.py
        assert kept[1] == pytest.approx(0.72, abs=0.05)


def test_heights_move_by_parts_of_a_spacing_and_grow_behind_their_front():
    grid = Grid(0.0, 0.0, 1e-6, 1e-6, 65, 9)
    surface = gaussian(0.1e-6, 13e-6, seed=2)
    known = MovingHeights(resampled(surface, grid), 2.0, 1e-3, 1e-7)
    before, after = (known.at(grid.x, time, grid.dx) for time in (0.0, 3.25e-6))
    shifted = known.at(grid.x - 6.5e-6, 0.0, grid.dx)
    assert after == pytest.approx(shifted, abs=1e-18)
    assert before.std() > 0.02e-6
    ahead = MovingHeights(known.height, 2.0, 32e-6, 1e-7).at(grid.x, 0.0, grid.dx)
    assert not ahead[40:].any()
    assert ahead[:24] == pytest.approx(before[:24], abs=1e-15)
    growing = MovingHeights(known.height, -2.0, 0.0, 1e-7, growth=2e-6)
    assert not growing.at(grid.x, 0.0, grid.dx).any()
    assert growing.at(grid.x, 1e-6, grid.dx) == pytest.approx(
        known.at(grid.x + 4e-6, 1e-6, grid.dx) / 2, abs=1e-18
    )
    turned = resampled(surface.turned(0.3), grid)
    assert turned[0] == pytest.approx(turned[-1])


def test_a_flux_warms_a_moving_surface_as_the_closed_form_says():
    dx, speed, step, count = 1e-6, 1.7, 1e-6, 40
    surface = HeatedSurface(1e4, speed, dx, step, count * step, (200, 1))
    flux = np.full((200, 1), 1e9)
    for _ in range(count):
        rise = surface.history() + surface.present * flux
        surface.absorb(flux)
    # places near the outflow have had the flux all the time: 2 q sqrt(t/pi)/e
    assert rise[-1, 0] == pytest.approx(2e9 * sqrt(count * step / pi) / 1e4, rel=0.02)
    # a place x behind the inlet since x/u, whatever the part of a spacing that it moved
    assert rise[34, 0] == pytest.approx(2e9 * sqrt(34 * dx / speed / pi) / 1e4, rel=0.04)


def test_fluxes_into_both_walls_meet_their_temperatures():
    heat, conductance, given = np.array([2e8]), np.array([3e5]), np.array([1e6])
    history, present = (np.array([4.0]), np.array([7.0])), (1e-7, 3e-7)
    first, second = wall_fluxes(heat, conductance, history, present, given)
    assert first + second == pytest.approx(heat)
    apart = history[1] + present[1] * second - history[0] - present[0] * first
    assert first == pytest.approx(heat / 2 + conductance * apart + given)


def test_the_stress_of_oil_between_summits_stays_at_its_limit(scene):
    oil = ShearedOil(scene.oil, 0.4)
    pressure, film = np.array([[2e9, 4e9, 8e9]]), np.array([[1e-9, 1e-9, 1e-16]])
    newtonian = [scene.oil.eta(2e9) * 0.4e9, scene.oil.eta(4e9) * 0.4e9, 1e20]
    expected = [
        scene.oil.flow.stress_at(s, p) for s, p in zip(newtonian, (2e9, 4e9, 4e9), strict=True)
    ]
    assert oil.stress(pressure, 0.0, film)[0] == pytest.approx(expected, rel=0.01)


def test_tables_of_the_oil_are_its_laws(scene):
    oil = ShearedOil(scene.oil, 0.4)
    pressure, rise, film = (np.array([[value]]) for value in (0.83e9, 7.3, 2e-7))
    newtonian = scene.oil.eta(0.83e9, 7.3) * 0.4 / 2e-7
    stress = scene.oil.flow.stress_at(newtonian, 0.83e9)
    assert oil.stress(pressure, rise, film)[0, 0] == pytest.approx(stress, rel=0.02)
    # along the sliding pressure meets the viscosity of a small change of shear
    faster = scene.oil.flow.stress_at(1.01 * newtonian, 0.83e9)
    thinned = (
        0.01 * newtonian / (faster - stress) * scene.oil.eta(0.83e9) / scene.oil.eta(0.83e9, 7.3)
    )
    assert oil.fluidity(pressure, rise, film)[0, 0] == pytest.approx(thinned, rel=0.05)


def test_what_cannot_be_resolved_is_refused(scene):
    surface = gaussian(0.1e-6, 60e-6, seed=1)
    for surfaces, nodes, message in (
        ((None, None), 65, "at least one of them"),
        ((None, surface), 66, "one more than a multiple of 8"),
        ((None, gaussian(0.1e-6, 5e-6)), 65, "give more nodes"),
    ):
        with pytest.raises(ValueError, match=message):
            rough_patch(scene, surfaces, nodes=nodes)
    aside = replace(scene, motions=(pyworm.RigidMotion(1.0, 0.2), pyworm.RigidMotion(1.0, -0.2)))
    with pytest.raises(ValueError, match="along the entrainment alone"):
        rough_patch(aside, (None, surface), nodes=65)
    stopped = replace(scene, motions=(pyworm.RigidMotion(1.0, 0.0), pyworm.RigidMotion(-1.0, 0.0)))
    with pytest.raises(ValueError, match="entrain no oil"):
        rough_patch(stopped, (None, surface), nodes=65)
    law = replace(scene.oil.flow, stress_temperature=0.01)
    with pytest.raises(ValueError, match="stress_temperature"):
        ShearedOil(replace(scene.oil, flow=law), 1.0)


def test_a_step_that_is_too_large_is_made_in_parts_and_ends_in_the_same_film(scene, monkeypatch):
    rolling = pyworm.with_slide_roll_ratio(scene, 0.0)
    surface = waves(1e-4, 0.15e-6)

    def found():
        return rough_patch(
            rolling, (None, surface), nodes=65, stride=4, averaged=0.2, tolerance=1e-4
        )

    whole, step, count = found(), kernel.PointFilm.step, 0

    def stuck_once(film, forcing):
        nonlocal count
        count += forcing == 0.05
        if forcing == 0.05 and count in (30, 31):
            raise KernelError(NO_DESCENT)
        return step(film, forcing)

    monkeypatch.setattr(kernel.PointFilm, "step", stuck_once)
    parted = found()
    assert {known.parts for known in whole.records} == {1}
    assert max(known.parts for known in parted.records) > 1
    assert parted.records[-1].parts == 1
    assert parted.last.film == pytest.approx(whole.last.film, abs=1e-3 * whole.smooth.film_mean)


def test_a_film_that_misses_its_balances_is_returned_as_such_or_an_error_if_it_is_of_no_use():
    class Stuck(PatchNewton):
        residual, aims = 0.05, 0

        def _newton(self, partial, start, rise):
            self.aims += 1
            return self.residual, (1, 2)

        def _balances_of(self, wanted, gap, start, rise):
            return replace(wanted, gap=gap)

    field = np.ones((3, 3))
    film = SimpleNamespace(pressure=field, rigid_film=1e-6)
    stuck = Stuck(film, None, 1e-3, 1e-9, 1.0)
    found = stuck.solve(Balances(field, 1.0, field), 0 * field, (field, 0.0), 0.0)
    assert found.residual == 0.05
    assert found.newton == stuck.aims > 10
    assert found.parts > 1
    Stuck.residual = 0.2
    with pytest.raises(RuntimeError, match="did not converge"):
        stuck.solve(Balances(field, 1.0, field), 0 * field, (field, 0.0), 0.0)


def test_a_step_without_descent_is_an_error(scene, monkeypatch):
    rolling = pyworm.with_slide_roll_ratio(scene, 0.0)
    step = kernel.PointFilm.step

    def stuck(film, forcing):
        if forcing == 0.05:
            raise KernelError(NO_DESCENT)
        return step(film, forcing)

    monkeypatch.setattr(kernel.PointFilm, "step", stuck)
    with pytest.raises(RuntimeError, match="did not converge"):
        rough_patch(rolling, (None, waves(1e-4, 0.5e-6)), nodes=65, stride=8)
