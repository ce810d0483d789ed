"""Sheared and heated line contacts: their limits, symmetries and balances."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from contact_edge import shares_of_contact
from folders import CASES
from gear_draws import drive

import pyworm
from pyworm.case.case import case_of
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.materials.body import Body
from pyworm.materials.flow_laws import NEWTONIAN, FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Barus, Density, Roelands
from pyworm.planning.model import Model
from pyworm.scene.line import LineScene, Parabola

CASE = CASES / "line_thermal.toml"

INLET = 333.15
STEEL = Body(206e9, 0.3, 7850.0, 47.0, 460.0, INLET)
HEAT = OilHeat(INLET, 1.1, 0.14, 2000.0, expansivity=6.5e-4)
EYRING = FlowLaw("eyring", stress=5e6)
OIL = Oil(Roelands.from_alpha(0.04, 20e-9), Density.dowson_higginson(870.0), EYRING, HEAT)
SCENE = LineScene(
    name="line",
    gap=Parabola(0.01),
    radius=0.01,
    velocities=(2.5, 1.5),
    load=2e5,
    bodies=(STEEL, STEEL),
    oil=OIL,
)


def solved(scene, effects="all", accuracy=0.01):
    solution = pyworm.solve(scene, pyworm.plan(scene, accuracy, effects))
    assert solution.converged, solution.stop_reason
    return solution


@pytest.fixture(scope="module")
def heated():
    return solved(SCENE)


@pytest.fixture(scope="module")
def gears():
    return pyworm.load(CASE).scene()


def test_the_shipped_case(gears):
    solution = solved(gears)
    figures, summary = solution.figures, solution.summary()
    assert abs(figures.heat_balance) < 0.01
    sliding = abs(gears.sliding)
    # the work of sliding is part of the loss, that of rolling the other
    work = figures.friction_coefficient.value * gears.load * sliding
    assert work < figures.power_loss.value < 1.3 * work
    assert 0.015 < figures.friction_coefficient.value < 0.035 + 4.2e6 / 8.6e8
    middle, *walls = (
        solution.fields[f"temperature_{place}"] for place in ("middle", "body_1", "body_2")
    )
    assert figures.temperature_max_film.value >= float(middle.max())
    assert max(float(wall.max()) for wall in walls) < figures.temperature_max_film.value
    assert min(float(wall.min()) for wall in walls) > gears.oil.heat.inlet_temperature - 0.01
    assert summary["power_loss_per_length_W_m"] == figures.power_loss.value
    assert set(summary["temperature_max_C"]) == {"body_1", "body_2", "film"}
    assert set(solution.profile) == {"profile_temperature", "profile_velocity_x", "profile_x"}
    assert solution.profile.profile_velocity_x[[0, -1]].values == pytest.approx(gears.velocities)
    assert float(solution.profile.profile_temperature.max()) == pytest.approx(
        figures.temperature_max_film.value, rel=1e-4
    )


def test_all_heat_is_accounted_for(heated):
    fields = heated.fields
    assert abs(heated.figures.heat_balance) < 1e-4
    inside = shares_of_contact(fields.pressure.values)
    loss = float((inside * fields.friction_power.values).sum() * (fields.x[1] - fields.x[0]))
    assert heated.figures.power_loss.on_grid == pytest.approx(loss, rel=1e-5)


def test_a_newtonian_oil_of_one_temperature_is_the_isothermal_film():
    plan = pyworm.plan(SCENE, 0.001, "isothermal")
    newtonian = replace(SCENE, oil=replace(OIL, flow=NEWTONIAN))
    plain, sheared = (
        pyworm.solve(newtonian, replace(plan, model=Model(levels))) for levels in (0, 7)
    )
    assert np.array_equal(plain.fields.x, sheared.fields.x)
    assert np.allclose(sheared.fields.film, plain.fields.film, rtol=1e-6, atol=0)
    assert sheared.figures.film_min.value == pytest.approx(plain.figures.film_min.value, rel=1e-6)


def test_heat_without_influence_leaves_the_sheared_film():
    """Viscosity and density do not depend on temperature; both films in one window."""
    indifferent = replace(HEAT, viscosity_exponent=0.0, expansivity=0.0)
    scene = replace(SCENE, oil=replace(OIL, heat=indifferent))
    plan = pyworm.plan(scene, 0.005, "all")
    heated = pyworm.solve(scene, plan)
    sheared = pyworm.solve(
        scene,
        replace(
            pyworm.plan(scene, 0.005, ("all", "-film-heating")), grids=plan.grids, wider_grids=()
        ),
    )
    heated_film = heated.fields.film.interp(x=sheared.fields.x)
    assert heated.figures.temperature_max_film.value > INLET + 2
    middle = abs(sheared.fields.x) < 1e-4
    assert np.allclose(heated_film[middle], sheared.fields.film[middle], rtol=5e-3)


def test_a_cold_film_is_the_sheared_one():
    """A hundredth of the velocities heats hardly; friction falls by some 5 % with each kelvin it does."""
    slow = replace(SCENE, velocities=(0.025, 0.015), load=5e4)
    sheared, heated = (
        solved(slow, effects, 0.002).figures for effects in (("all", "-film-heating"), "all")
    )
    rise = heated.temperature_max_film.value - INLET
    assert rise < 0.2
    for name in ("film_central", "film_min", "friction_coefficient"):
        one, other = getattr(sheared, name), getattr(heated, name)
        assert one.value == pytest.approx(other.value, rel=one.error + other.error + 0.05 * rise)


def test_without_sliding_there_is_no_traction():
    rolling = solved(replace(SCENE, velocities=(2.0, 2.0)))
    assert rolling.figures.friction_coefficient.value == 0
    assert rolling.figures.power_loss.value > 0
    largest = abs(rolling.fields.shear_stress_x).max()
    assert largest < 1e-3 * OIL.flow.stress
    assert rolling.figures.temperature_max_body_1.value == pytest.approx(
        rolling.figures.temperature_max_body_2.value, rel=1e-6
    )


def test_traction_is_antisymmetric(heated):
    other = solved(replace(SCENE, velocities=SCENE.velocities[::-1]))
    assert np.allclose(
        other.fields.shear_stress_x, -heated.fields.shear_stress_x, rtol=1e-4, atol=1e3
    )
    assert np.allclose(other.fields.film, heated.fields.film, rtol=1e-5)
    assert np.allclose(
        other.fields.temperature_body_1, heated.fields.temperature_body_2, rtol=0, atol=1e-2
    )
    assert (other.figures.friction_coefficient.value) == pytest.approx(
        heated.figures.friction_coefficient.value, rel=1e-4
    )


def test_reversing_the_velocities_mirrors_the_temperature(heated):
    back = solved(replace(SCENE, velocities=tuple(-u for u in SCENE.velocities))).fields
    for name in ("film", "temperature_middle", "temperature_body_1", "shear_rate"):
        forth = heated.fields[name]
        assert np.allclose(back[name][::-1], forth, rtol=1e-4, atol=1e-9), name


def test_traction_rises_and_falls_again_with_sliding():
    """Eyring's logarithm, and heat: the peak of a traction curve."""
    friction = [
        solved(
            replace(SCENE, velocities=(10 * (1 + ratio / 2), 10 * (1 - ratio / 2))), accuracy=0.02
        ).figures.friction_coefficient.value
        for ratio in (0.003, 0.1, 1.5)
    ]
    assert friction[0] < 0.7 * friction[1]
    assert friction[2] < friction[1]


def test_eyring_friction_without_heat():
    """Where the film is even, tau = tau0 asinh(eta us / (tau0 h)) with the viscosity at its pressure."""
    fields = solved(SCENE, ("all", "-film-heating")).fields
    x = fields.x.values
    middle = abs(x) < 3e-5
    eta = np.array([OIL.viscosity(float(p)) for p in fields.pressure.values[middle]])
    newtonian = eta * -SCENE.sliding / fields.film.values[middle]
    stress = EYRING.stress * np.arcsinh(newtonian / EYRING.stress)
    assert np.allclose(fields.shear_stress_x.values[middle], stress, rtol=2e-2)


def test_a_parabola_of_temperature_is_near_the_whole_film(heated):
    mean = solved(SCENE, ("all", "-viscosity-across")).figures
    full = heated.figures
    assert mean.film_central.value == pytest.approx(full.film_central.value, rel=0.05)
    assert mean.friction_coefficient.value == pytest.approx(
        full.friction_coefficient.value, rel=0.05
    )


def test_levels_across_the_film_suffice():
    coarse, fine = (solved(SCENE, accuracy=accuracy).figures for accuracy in (0.02, 0.001))
    for name in ("film_central", "film_min", "friction_coefficient", "power_loss"):
        one, other = getattr(coarse, name), getattr(fine, name)
        assert one.value == pytest.approx(other.value, rel=one.error + other.error + 2e-3), name


def test_a_fast_film_is_found_by_continuation_in_speed():
    """Cold, it would be thrice as thick, and its pressure would heat it without bound."""
    fast = replace(SCENE, velocities=(36.0, 30.0))
    cold, hot = (solved(fast, effects).figures for effects in ("isothermal", "all"))
    assert hot.film_central.value < 0.5 * cold.film_central.value
    assert abs(hot.heat_balance) < 0.01


@pytest.mark.parametrize("rise", [0.01, 0.02])
def test_a_film_that_slips_at_both_walls_is_reached_through_wide_slip_steps(rise):
    """Limits of 1 and 2 % of the pressure: half the film times the gradient is the limit somewhere.

    With the law's own slip step in all films the continuation of the first ended far above its own stresses.
    """
    law = FlowLaw("eyring-limited", stress=2e6, limit=2e6, limit_pressure=rise)
    oil = replace(OIL, viscosity=Roelands.from_alpha(0.02, 35e-9), flow=law)
    slipping = replace(SCENE, velocities=(1.01, 0.99), load=5e5, oil=oil)
    fields = solved(slipping, accuracy=0.05).fields
    pressure, film = fields.pressure.values, fields.film.values
    gradient = np.diff(pressure) / np.diff(fields.x.values)
    limits = law.limit + law.limit_pressure * (pressure[1:] + pressure[:-1]) / 2
    needed = np.abs(gradient) * (film[1:] + film[:-1]) / 4 / limits
    assert needed.max() == pytest.approx(1.0, abs=0.02)


def test_flash_temperature_of_fast_bodies(heated):
    """Surfaces that take half the heat of friction each, without conduction along them."""
    fields = heated.fields
    x, heat = fields.x.values, fields.friction_power.values
    dx = x[1] - x[0]
    rises = []
    for body, u in zip(SCENE.bodies, SCENE.velocities, strict=True):
        effusivity = np.pi * body.conductivity * body.density * body.specific_heat * u
        before = np.sqrt(np.maximum(np.subtract.outer(x, x) + dx / 2, 0.0))
        after = np.sqrt(np.maximum(np.subtract.outer(x, x) - dx / 2, 0.0))
        rises.append(2 * (before - after) @ (heat / 2) / np.sqrt(effusivity))
    mean = (fields.temperature_body_1.max() + fields.temperature_body_2.max()) / 2 - INLET
    assert float(mean) == pytest.approx(np.mean([rise.max() for rise in rises]), rel=0.1)


def test_bulk_temperatures_are_those_of_the_surfaces_before_the_contact():
    warm = tuple(replace(STEEL, bulk_temperature=INLET + rise) for rise in (20.0, 5.0))
    fields = solved(replace(SCENE, bodies=warm)).fields
    assert float(fields.temperature_body_1[0]) == pytest.approx(INLET + 20, abs=0.1)
    assert float(fields.temperature_body_2[0]) == pytest.approx(INLET + 5, abs=0.1)


@pytest.mark.parametrize(("velocities", "body"), [((2.0, 0.0), 2), ((0.0, 2.0), 1)])
def test_a_body_at_rest_has_no_steady_temperature(velocities, body):
    scene = replace(SCENE, velocities=velocities)
    with pytest.raises(ValueError, match=rf"body {body} is at rest \(0 m/s\)"):
        pyworm.plan(scene)
    assert solved(scene, ("all", "-film-heating")).figures.friction_coefficient.value > 0


def test_effects_without_oil_data_are_not_simulated():
    plain = replace(SCENE, oil=Oil(Barus(0.04, 2e-8), Density.incompressible(870.0)))
    assert pyworm.plan(plain, effects="all").model == Model()
    sheared = pyworm.plan(replace(SCENE, oil=replace(OIL, heat=None)), effects="all").model
    assert sheared.levels > 0
    assert not sheared.heated
    with pytest.raises(ValueError, match=r"\[oil.heat\] is not given"):
        pyworm.plan(plain, effects="film-heating")


def test_the_inlet_temperature_is_in_the_summary(heated):
    assert heated.inlet_temperature == INLET
    assert heated.summary()["inlet_temperature_C"] == pytest.approx(INLET - ZERO_CELSIUS)


def test_a_hot_roller_whose_walls_slip_settles_on_every_grid():
    """With a wedge of third order each grid from 500 nodes on took hundreds of steps until it was lost."""
    case = pyworm.load(CASES / "roller_ref.toml")
    scene = case.scene(section="left", phase=0.5, station=0.5)
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.01))
    assert solution.converged, solution.stop_reason
    points, steps = np.unique(solution.history.points_x, return_counts=True)
    assert max(steps[points > 200]) < 30


def test_a_thick_film_whose_heat_settles_slowly_has_its_steps():
    """A film of 4 um between spur gears, whose temperatures with more levels settle by 6 % a step."""
    gears = case_of(drive(7, 99005).tables, "gears", Path())
    solution = pyworm.solve(gears.scene(phase=0.9), accuracy=0.05)
    assert solution.accurate, solution.stop_reason
