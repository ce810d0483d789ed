"""Sensitivities of a film by its adjoint, against differences of whole solves on the same grid."""

from dataclasses import replace
from math import isinf

import numpy as np
import pytest
from circular_contact import circular

import pyworm
from pyworm.scene.inputs import inputs_of, with_input
from pyworm.solver import adjoint as adjoint_module
from pyworm.solver import extremum, sensitivities
from pyworm.solver.adjoint import adjoint_of
from pyworm.solver.figure_weights import weights_of_figures
from pyworm.solver.newton import newton_step
from pyworm.solver.sensitivities import Inputs

STEP = 2e-5


def case_scene(name):
    return pyworm.load(f"cases/{name}.toml").scene()


def tooth_scene():
    return pyworm.load("cases/zi_sharif_2001.toml").scene(phase=0.5)


def figures_solved(adjoint, scene, residual=1e-10):
    """Figures of another contact solved on the grid of an adjoint, from its film."""
    solver = adjoint.solver.of(adjoint.plan.simplified(scene))
    level = solver.isolated(adjoint.level.grid, adjoint.level.state())
    for _ in range(30):
        if level.film.balance.worst < 1e-13 or newton_step(level, 1e-6) is None:
            break
    assert level.film.balance.worst < residual
    figures = dict(level.read().figures)
    weights = weights_of_figures(level, ("film_min", "pressure_max"))
    # read between nodes without the search's resolution of a 128th of a cell
    figures["film_min"] = float((weights["film_min"]["film"] * level.film.thickness()).sum())
    figures["pressure_max"] = float(
        (weights["pressure_max"]["pressure"] * level.film.pressure).sum()
    )
    return figures


CONTACTS = {
    "point": (
        lambda: circular(20, 10),
        ("isothermal",),
        ("load", "radius_y", "oil.viscosity.eta0"),
    ),
    "line": (
        lambda: case_scene("line_thermal"),
        ("isothermal", "shear-thinning"),
        ("load", "radius", "bodies[0].youngs_modulus", "velocities[0]", "oil.flow.stress"),
    ),
    "rough line": (
        lambda: pyworm.load("cases/spur_pair.toml").scene(phase=0.5),
        ("isothermal", "roughness"),
        ("load", "bodies[0].roughness", "oil.viscosity.z"),
    ),
    "tooth": (
        tooth_scene,
        ("isothermal", "shear-thinning", "real-gap", "varying-velocity"),
        ("load", "oil.flow.stress"),
    ),
}


def test_a_coating_changes_a_film_by_its_deflection():
    scene = case_scene("line_m20_l10")
    first, second = scene.bodies

    def coated(size):
        layer = pyworm.Coating(size * 5e-6, 2 * first.youngs_modulus, 0.2)
        return replace(scene, bodies=(replace(first, coating=layer), second))

    plan = pyworm.plan(coated(1.0), 0.1, "isothermal")
    adjoint = adjoint_of(coated(1.0), replace(plan, wider_grids=()), tolerance=1e-6)
    more, less = (figures_solved(adjoint, coated(size)) for size in (1.01, 0.99))
    found = adjoint.change(coated(1.01), coated(0.99))
    for name in ("film_min", "pressure_max"):
        assert found[name] == pytest.approx(more[name] - less[name], rel=5e-3, abs=0)
    assert found["pressure_max"] > 0


@pytest.mark.long
def test_a_heated_tooth_has_sensitivities_to_its_oil():
    """Those of whole solves, but for the convection that turns from node to node."""
    scene = tooth_scene()
    plan = pyworm.plan(scene, 0.1, "all")
    adjoint = adjoint_of(scene, replace(plan, wider_grids=()), tolerance=1e-6)
    value = inputs_of(scene)["oil.viscosity.eta0"]
    more, less = (
        with_input(scene, "oil.viscosity.eta0", value * (1 + step)) for step in (1e-3, -1e-3)
    )
    found = adjoint.change(more, less)
    after, before = (figures_solved(adjoint, other, 1e-5) for other in (more, less))
    for name in ("film_central", "power_loss"):
        assert found[name] == pytest.approx(after[name] - before[name], rel=0.02), name


def test_a_heated_line_has_sensitivities_to_its_bodies():
    scene = case_scene("line_thermal")
    adjoint = adjoint_of(scene, pyworm.plan(scene, 0.1, "all"), tolerance=1e-8, residual=1e-9)
    for given in ("load", "bodies[0].conductivity", "oil.heat.conductivity"):
        value = inputs_of(scene)[given]
        more, less = (with_input(scene, given, value * (1 + step)) for step in (1e-3, -1e-3))
        found = adjoint.change(more, less)
        after, before = (figures_solved(adjoint, other, 1e-6) for other in (more, less))
        for name in ("film_min", "power_loss"):
            assert found[name] == pytest.approx(after[name] - before[name], rel=5e-4), (given, name)


def test_films_of_a_heated_line_follow_its_velocities():
    """Both change convection, which turns at a node with long steps, and how heat spreads in the bodies."""
    scene, name = case_scene("line_thermal"), "velocities[0]"
    plan = pyworm.plan(scene, 0.1, "all")
    adjoint = adjoint_of(scene, plan, tolerance=1e-8, residual=1e-9)
    value = inputs_of(scene)[name]
    found = Inputs(scene, plan, {name: value}).relative_changes(adjoint)
    more, less = (
        figures_solved(adjoint, with_input(scene, name, value * (1 + step)), 1e-6)
        for step in (1e-3, -1e-3)
    )
    for figure in ("film_min", "film_central"):
        solved = (more[figure] - less[figure]) / (2e-3 * adjoint.figures[figure])
        assert found[figure][name] == pytest.approx(solved, rel=2e-4), figure


@pytest.mark.parametrize("name", CONTACTS)
def test_sensitivities_are_those_of_whole_solves(name):
    make, effects, names = CONTACTS[name]
    scene = make()
    plan = pyworm.plan(scene, 0.1, effects)
    adjoint = adjoint_of(scene, plan, tolerance=1e-9, residual=1e-12)
    for given in names:
        if given not in inputs_of(scene):
            pytest.fail(f"{given} is no number of {scene.name}")
        value = inputs_of(scene)[given]
        more, less = (with_input(scene, given, value * (1 + step)) for step in (STEP, -STEP))
        found = adjoint.change(more, less)
        after, before = (figures_solved(adjoint, other) for other in (more, less))
        for figure, change in found.items():
            solved = after[figure] - before[figure]
            noise = 1e-5 * STEP * abs(adjoint.figures[figure])
            assert change == pytest.approx(solved, rel=1e-5, abs=noise), (given, figure)


def test_a_gap_has_a_sensitivity_at_each_node():
    """Uniform wear of both surfaces is no more than a shift of the rigid film: figures do not change."""
    scene = circular(20, 10)
    adjoint = adjoint_of(scene, pyworm.plan(scene, 0.1, "isothermal"), tolerance=1e-8)
    by_gap = adjoint.by_gap("film_central")
    assert by_gap.shape == adjoint.level.grid.shape
    assert abs(by_gap.sum()) < 1e-6 * np.abs(by_gap).sum()


def test_values_between_nodes_are_linear_in_the_nodes_about_a_refined_place():
    grid = np.linspace(-1, 1, 21)
    field = 1 + (grid[:, None] - 0.013) ** 2 + 2 * (grid[None, :] + 0.027) ** 2
    inside = np.ones(field.shape, dtype=bool)
    value, place = extremum.minimum(field, inside, inside)
    refined = extremum.refined_place(field, place)
    weights = extremum.weights_at(refined, field.shape)
    assert (weights * field).sum() <= value + 1e-15
    assert refined == pytest.approx(((0.013 + 1) * 10, (1 - 0.027) * 10), abs=1e-9)


def test_a_place_on_the_side_of_a_cell_is_refined_in_the_next():
    grid = np.arange(12.0)
    field = (grid[:, None] - 5.02) ** 2 + (grid[None, :] - 6.4) ** 2
    assert extremum.refined_place(field, (4.98, 6.4)) == pytest.approx((5.02, 6.4), abs=1e-9)


def test_a_solution_has_sensitivities_to_its_numbers():
    scene = circular(20, 10)
    solution = pyworm.solve(scene, accuracy=0.1, effects="isothermal")
    found = solution.sensitivities()
    by_load, by_speed = (found.table["film_central"][name] for name in ("load", "motions[0].u"))
    assert -0.1 < by_load.value < 0
    # both surfaces together: films follow the speed to the power 0.67 (Hamrock and Dowson 1977), or nearly
    assert 2 * by_speed.value == pytest.approx(0.67, abs=0.06)
    assert by_speed.error < 0.1
    assert found.of("film_central", "load") == pytest.approx(
        by_load.value * found.figures["film_central"] / scene.load
    )
    assert found.summary()["film_min"]["load"]["value"] == found.table["film_min"]["load"].value
    assert found.by_gap("film_min").shape == found.adjoint.level.grid.shape
    with pytest.raises(ValueError, match=r"inputs = wind: .* has no such number"):
        solution.sensitivities(["wind"])


def test_a_solution_from_a_file_has_no_contact(tmp_path):
    solution = pyworm.solve(circular(20, 10), accuracy=0.1, effects="isothermal")
    read = pyworm.open_solution(solution.save(tmp_path / "film.nc"))
    with pytest.raises(ValueError, match="read from a file, which has no contact"):
        read.sensitivities()


def test_without_a_film_on_the_coarser_grid_no_uncertainty_is_known(monkeypatch):
    scene = circular(20, 10)
    plan = pyworm.plan(scene, 0.1, "isothermal")

    def fine_alone(scene, plan, solution=None, *, grid=None, finer=None):
        if finer is not None:
            raise pyworm.NoAdjointError("no film")
        return adjoint_of(scene, plan, solution)

    monkeypatch.setattr(sensitivities, "adjoint_of", fine_alone)
    found = pyworm.sensitivities(scene, plan, inputs=["load"])
    assert isinf(found.table["film_min"]["load"].error)
    assert found.summary()["film_min"]["load"]["error"] is None


def test_what_has_no_adjoint_says_why(monkeypatch):
    starved = pyworm.load("cases/starved_ball.toml").scene()
    with pytest.raises(pyworm.NoAdjointError, match="limited supply of oil has no adjoint"):
        pyworm.sensitivities(starved, accuracy=0.1)
    scene = circular(20, 10)
    monkeypatch.setattr(adjoint_module, "MOST_STEPS", 0)
    with pytest.raises(pyworm.NoAdjointError, match=r"no film was found on .* nodes"):
        pyworm.sensitivities(scene, accuracy=0.1, effects="isothermal")


def test_a_line_plans_no_wider_grid_where_it_has_none():
    scene = case_scene("line_m20_l10")
    plan = replace(pyworm.plan(scene, 0.1, "isothermal"), wider_grids=())
    adjoint = adjoint_of(scene, plan)
    assert adjoint.level.grid == plan.grids[-1]


def test_a_number_that_a_contact_has_not_is_refused():
    scene = circular(20, 10)
    with pytest.raises(KeyError, match="has no number spin"):
        with_input(scene, "spin", 1.0)
    for name in ("bodies[2].density", "bodies[0].lay", "bodies[0].name.x", "oil.reduced", "gap"):
        with pytest.raises(KeyError):
            with_input(scene, name, 1.0)
    with pytest.raises(KeyError, match=r"has no number motions\[0\].u"):
        with_input(tooth_scene(), "motions[0].u", 1.0)
    warm = pyworm.load("cases/line_thermal.toml").scene()
    warmer = with_input(warm, "temperature", inputs_of(warm)["temperature"] + 10)
    assert warmer.oil.viscosity.eta0 < warm.oil.viscosity.eta0
    assert warmer.bodies[0].bulk_temperature == warm.bodies[0].bulk_temperature + 10


def test_a_quantity_that_a_solution_has_not_adds_nothing_to_the_uncertainty():
    assert sensitivities._missed(1.0, None) == 0.0
    assert sensitivities._missed(1.0, pyworm.Estimate(-1.0, 0.1)) == 0.0
    assert sensitivities._missed(1.0, pyworm.Estimate(2.0, 0.1)) == pytest.approx(np.log(2))
