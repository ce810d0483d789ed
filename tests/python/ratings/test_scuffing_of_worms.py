"""Scuffing of worms and rollers: Blok's temperatures of scenes, limits, a solved contact."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import pyworm
from pyworm.case.ratings import ScuffingTable
from pyworm.formulas.scuffing import flash_temperature
from pyworm.ratings.scuffing import NOT_STEEL, flash_over_friction, rate_scuffing

LIMIT = ScuffingTable.model_validate({"temperature": "300 degC"})


@pytest.fixture(scope="module")
def rolling():
    """A hot line contact, and its film."""
    scene = replace(pyworm.load("cases/line_thermal.toml").scene(), phase=0.5)
    return scene, pyworm.solve(scene, accuracy=0.2)


def drive_of(scene):
    return SimpleNamespace(oil_supplied=scene.oil, bodies=scene.bodies, scene=lambda **place: scene)


def result_of(solution):
    return SimpleNamespace(solutions=(solution,))


def test_flash_of_a_line_is_blok_s(rolling):
    scene, _ = rolling
    width = pyworm.formulas.hertz.hertz_line(
        scene.radius, scene.load, scene.reduced_modulus
    ).half_width
    drains = [np.sqrt(body.thermal_inertia) for body in scene.bodies]
    exact = flash_temperature(1.0, scene.load, *scene.velocities, *drains, width)
    assert flash_over_friction(scene) == pytest.approx(exact)
    both = replace(scene, velocities=(scene.velocities[0],) * 2)
    assert flash_over_friction(both) == 0


def test_a_solved_contact_against_a_scuffing_temperature(rolling):
    scene, solution = rolling
    rating = rate_scuffing(drive_of(scene), LIMIT, None, result_of(solution))
    (safety,) = rating.safeties
    rise = solution.figures.temperature_max_body_1.value - scene.oil.heat.inlet_temperature
    assert safety.value <= (573.15 - scene.oil.heat.inlet_temperature) / rise * 1.001
    keys = {figure.key for figure in rating.figures}
    assert {"contact_temperature_blok_C", "contact_temperature_simulated_C"} <= keys
    assert not safety.doubts


def test_bronze_against_the_load_stage_of_steel_is_doubted(rolling):
    scene, solution = rolling
    bronze = pyworm.Body.from_name("CuSn12Ni2-C-GZ", bulk_temperature="60 degC")
    mixed = drive_of(replace(scene, bodies=(scene.bodies[0], bronze)))
    stage = ScuffingTable.model_validate({"scuffing_load_stage": 12})
    rating = rate_scuffing(mixed, stage, "PAG", result_of(solution))
    assert rating.safeties[0].doubts == (NOT_STEEL,)
    unknown = rate_scuffing(mixed, stage, None, result_of(solution))
    assert unknown.safeties[0].why == "base of the oil is missing."
