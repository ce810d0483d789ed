"""Uncertainty of figures by the assumptions of averaged roughness."""

from dataclasses import replace
from math import hypot

import numpy as np
import pytest
from contacts import ball, steel
from folders import CASES

import pyworm
from pyworm.materials.roughness_assumptions import (
    BOUNDARY_FRICTION_SPREAD,
    HEIGHT_SPREAD,
    LAYS,
    REFITTED,
    SLOPE_POWER,
    STIFFNESS_FACTOR,
    flow_scatter,
    variations,
)
from pyworm.solver import roughness_uncertainty as uncertainty
from pyworm.solver.line.contact import LineContactSolver
from pyworm.solver.newton import iterate

MU_B = 0.1
"""Friction of the asperities of the shipped case."""

FIGURES = (
    "film_min",
    "film_central",
    "friction_coefficient",
    "asperity_load_fraction",
    "temperature_max_film",
)

FILM = np.array([0.3e-6, 0.5e-6])
"""Mean thickness of the gap [m] at two places of a film."""


@pytest.fixture(scope="module")
def film():
    """A heated film in boundary lubrication on one grid, converged, and its surfaces."""
    scene = pyworm.load(CASES / "spur_pair.toml").scene(phase=0.5)
    plan = pyworm.plan(scene, 0.05)
    assert plan.model.rough and plan.model.heated
    level, _ = LineContactSolver(plan.simplified(scene), plan).begin(plan.grids)
    iterate(level, 1e-8)
    return level, scene.rough_pair


def solved_anew(level, path):
    """Figures of the film solved again between other surfaces, through those of parts of the change."""
    found, pair = level.state(), level.scene.rough_pair
    for varied in path:
        before = level.state()
        level.film.roughen(varied.curves, varied.boundary_friction)
        level.film.start(before.pressure, before.rigid_film, before.oil)
        iterate(level, 1e-8)
    assert level.film.balance.worst <= 1e-6
    figures = level.read().figures
    level.film.roughen(pair.curves(), level.scene.boundary_friction)
    level.film.set_rise(found.rise)
    level.film.start(found.pressure, found.rigid_film, found.oil)
    return figures


def test_linear_solves_find_what_solving_again_finds(film):
    """Of the whole uncertainty of each assumption, though found from a tenth of it by two Newton steps."""
    level, pair = film
    before = level.read().figures
    anew = {}
    thickness = level.film.thickness()
    parts = [variations(pair, MU_B, part, thickness) for part in (0.25, 0.5, 0.75, 1.0)]
    for path in zip(*parts, strict=True):
        after = solved_anew(level, [varied for _, varied in path])
        anew[path[0][0]] = {key: abs(after[key] / before[key] - 1) for key in FIGURES}
    lays = [anew.pop(lay) for lay in LAYS]
    anew["lay"] = {key: max(of[key] for of in lays) for key in FIGURES}
    fluid = before["friction_coefficient"] - before["friction_boundary"]
    scatter = float(flow_scatter(before["film_central"] / pair.height))
    stress = scatter * fluid / before["friction_coefficient"]
    found = uncertainty.roughness_uncertainty(level, pair, MU_B)
    for key in FIGURES:
        parts = [of[key] for of in anew.values()]
        expected = hypot(*parts, stress if key == "friction_coefficient" else 0.0)
        assert found[key] == pytest.approx(expected, rel=0.2), key


def test_the_film_is_as_it_was(film):
    level, pair = film
    before, balance = level.read().figures, level.film.balance.worst
    uncertainty.roughness_uncertainty(level, pair, MU_B)
    after = level.read().figures
    assert {key: after[key] for key in FIGURES} == pytest.approx(
        {key: before[key] for key in FIGURES}, rel=1e-5
    )
    assert balance <= 1e-6
    assert level.film.balance.worst <= 1e-5


def test_a_film_that_does_not_follow_has_no_bar(film, monkeypatch):
    monkeypatch.setattr(uncertainty, "newton_step", lambda level, forcing=None: None)
    found = uncertainty.roughness_uncertainty(*film, MU_B)
    assert all(of == np.inf for of in found.values())


def test_figures_over_no_nodes_are_zero(film):
    level, _ = film
    assert set(level.rubbed(np.zeros(level.grid.x.shape, dtype=bool)).values()) == {0.0}


def test_results_have_both_bars():
    scene = pyworm.load(CASES / "spur_pair.toml").scene(phase=0.5)
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.05))
    friction = solution.figures.friction_coefficient
    summary = solution.summary()
    assert friction.error < 0.05 < friction.model < 0.7
    assert summary["friction_coefficient_error"] == friction.error
    assert summary["friction_coefficient_model_error"] == friction.model
    assert summary["temperature_max_model_error_K"]["film"] > 0
    share = solution.figures.asperity_load_fraction
    said = f"asperities carry {share.value * 100:.2g} % ± {share.value * share.model * 100:.2g} % (model)"
    assert said in solution.neglected_effects.sentence


def test_smooth_films_have_one_bar():
    scene = pyworm.load(CASES / "spur_pair.toml").scene(phase=0.5)
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.2, ("all", "-roughness", "-squeeze")))
    assert solution.figures.friction_coefficient.model is None
    assert not any("model_error" in key for key in solution.summary())


def test_each_assumption_is_varied_alone():
    scene = pyworm.load(CASES / "spur_pair.toml").scene(phase=0.5)
    pair = scene.rough_pair
    curves = pair.curves()
    whole = dict(variations(pair, MU_B, 1.0, FILM))
    assert whole["height"].curves.scale == pytest.approx((1 + HEIGHT_SPREAD) * curves.scale)
    rubbed = whole["boundary friction"]
    assert rubbed.boundary_friction == pytest.approx((1 + BOUNDARY_FRICTION_SPREAD) * MU_B)
    np.testing.assert_array_equal(rubbed.curves.values, curves.values)
    for name, rows in (("pressure flow", slice(3, 6)), ("shear flow", slice(6, 9))):
        changed = whole[name].curves.values
        others = np.ones(9, dtype=bool)
        others[rows] = False
        np.testing.assert_array_equal(changed[others], curves.values[others])
        assert not np.array_equal(changed[rows], curves.values[rows])


def test_slopes_and_lays_are_known_to_a_factor():
    scene = pyworm.load(CASES / "spur_pair.toml").scene(phase=0.5)
    pair, curves = scene.rough_pair, scene.rough_pair.curves()
    whole = dict(variations(pair, MU_B, 1.0, FILM))
    steeper = whole["slope"].curves.values
    # the pressure of elastic asperities is proportional to their slope
    np.testing.assert_allclose(steeper[0, :200], curves.values[0, :200] + np.log(2.0))
    np.testing.assert_array_equal(steeper[1:], curves.values[1:])
    for lay, by in zip(LAYS, (2.0, 0.5), strict=True):
        drawn = [replace(surface, aspect=by * surface.aspect) for surface in pair.surfaces]
        other = whole[lay].curves.values
        np.testing.assert_array_equal(other[:3], curves.values[:3])
        of_lay = replace(pair, surfaces=tuple(drawn)).curves().values
        np.testing.assert_allclose(other[3:], of_lay[3:])


def test_of_longer_and_shorter_lays_the_larger_change_of_each_figure_counts(film, monkeypatch):
    level, pair = film
    names = list(level.read().figures)
    changes = {
        "longer lay": dict.fromkeys(names, 0.3) | {"film_min": -0.1},
        "shorter lay": dict.fromkeys(names, -0.2),
        "slope": dict.fromkeys(names, 0.4),
    }
    monkeypatch.setattr(uncertainty, "changes_by", lambda *given: dict(changes))
    found = uncertainty.roughness_uncertainty(level, pair, MU_B)
    assert found["pressure_max"] == pytest.approx(0.5)
    assert found["film_min"] == pytest.approx(hypot(0.2, 0.4))


@pytest.fixture(scope="module")
def mixed():
    """A ball in mixed lubrication, with its bars."""
    bodies = tuple(
        replace(steel(), roughness=0.15e-6, roughness_slope=0.02, roughness_aspect=of)
        for of in (2.0, 0.7)
    )
    scene = ball(bodies=bodies)
    return scene, bars_of(scene)


def bars_of(scene):
    """Films, friction and share of the load by asperities."""
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.05, "all"))
    assert solution.converged
    return {name: getattr(solution.figures, name) for name in FIGURES[:4]}


@pytest.mark.parametrize(
    "changes",
    [
        {"roughness_slope": 0.04},
        {"roughness_slope": 0.01},
        {"asperity_sharpness": 0.01},
        {"aspect": 2.0},
        {"aspect": 0.5},
    ],
    ids=str,
)
def test_other_surfaces_are_within_the_uncertainty_of_the_model(mixed, changes):
    """Contacts solved anew: slopes twice and half as steep, Greenwood and Tripp's asperities, other lays."""
    scene, bars = mixed
    changes = dict(changes)
    factor = changes.pop("aspect", 1.0)
    bodies = tuple(
        replace(of, roughness_aspect=factor * of.roughness_aspect, **changes) for of in scene.bodies
    )
    for name, other in bars_of(replace(scene, bodies=bodies)).items():
        bar = bars[name]
        assert abs(other.value / bar.value - 1) < bar.model + bar.error + other.error, name


def test_a_fitted_friction_is_smaller_by_a_law_of_contact_by_which_asperities_bear_more():
    """So much that the gears of the fit have the friction to which it was fitted; else nothing changes."""
    pair = pyworm.load(CASES / "spur_pair.toml").scene(phase=0.5).rough_pair
    spread = 0.12
    given = dict(variations(pair, MU_B, 0.5, FILM))
    fitted = dict(variations(pair, MU_B, 0.5, FILM, fitted_spread=spread))
    assert fitted.keys() == given.keys()
    for name, varied in fitted.items():
        np.testing.assert_array_equal(varied.curves.values, given[name].curves.values)
    changed = {name: varied.boundary_friction / MU_B for name, varied in fitted.items()}
    assert changed.pop("contact") == pytest.approx(REFITTED["stiffer"] ** 0.5)
    assert changed.pop("slope") == pytest.approx(REFITTED["stiffer"] ** (0.5 * SLOPE_POWER))
    assert changed.pop("boundary friction") == pytest.approx(1 + 0.5 * spread)
    assert set(changed.values()) == {1.0}
    assert REFITTED["stiffer"] < 1
    assert given["contact"].boundary_friction == MU_B


def test_equal_surfaces_drag_no_oil():
    """Their shear flow factors cancel, so that no other ones change anything."""
    pair = pyworm.load(CASES / "spur_pair.toml").scene(phase=0.5).rough_pair
    equal = replace(pair, surfaces=(replace(pair.surfaces[0], lay=0.3, aspect=2.0),) * 2)
    names = {name for name, _ in variations(equal, MU_B, 1.0, FILM)}
    assert names == {name for name, _ in variations(pair, MU_B, 1.0, FILM)} - {"shear flow"}


def test_the_law_of_contact_that_changes_the_load_most_counts():
    """Of surfaces that yield that without yielding; of others half more at all gaps if the film is thin."""
    pair = pyworm.load(CASES / "spur_pair.toml").scene(phase=0.5).rough_pair
    elastic = pair.curves().values[0]
    varied = dict(variations(pair, MU_B, 1.0, FILM))["contact"]
    np.testing.assert_allclose(varied.curves.values[0], elastic + np.log(STIFFNESS_FACTOR))
    soft = replace(pair.surfaces[1], hardness=1e7)
    yielding = replace(pair, surfaces=(pair.surfaces[0], soft))
    varied = dict(variations(yielding, MU_B, 1.0, FILM))["contact"]
    np.testing.assert_allclose(varied.curves.values[0], elastic)
