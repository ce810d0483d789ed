"""What closed forms say of a contact before it is solved, against the textbooks' forms."""

from dataclasses import replace
from math import pi

import pytest
from folders import CASES

import pyworm
from pyworm.planning.prediction import predicted

HEAT = 1e7
"""Heat made for each area [W/m2]."""


def thermal(velocities, **changes):
    """The thermal line contact between surfaces of these velocities [m/s]."""
    scene = pyworm.load(CASES / "line_thermal.toml").scene()
    return replace(scene, velocities=velocities, **changes)


def test_fast_surfaces_warm_as_half_spaces_under_a_heat_that_lasts_as_they_pass():
    """2 q sqrt(t/(pi k rho c)) (Carslaw and Jaeger 1959, section 2.9), t the time to pass the contact."""
    scene = thermal((4.0, 4.0))
    body, prediction = scene.bodies[0], predicted(scene)
    alike = replace(scene, bodies=(body, body))
    passing = 2 * prediction.half_width / 4.0
    effusivity = body.conductivity * body.density * body.specific_heat
    wanted = 2 * (HEAT / 2) * (passing / (pi * effusivity)) ** 0.5
    assert predicted(alike).surface_rise(HEAT) == pytest.approx(wanted, rel=1e-9)
    # a second surface sixteen times as fast takes four times the heat
    faster = predicted(replace(alike, velocities=(4.0, 64.0)))
    assert faster.surface_rise(HEAT) == pytest.approx(wanted * 2 / 5, rel=1e-9)


def test_surfaces_at_rest_warm_no_more_than_conduction_to_all_sides_lets_them():
    """3 q b/(2 k) each, which both share."""
    scene = thermal((1e-9, 1e-9))
    body = scene.bodies[0]
    prediction = predicted(replace(scene, bodies=(body, body)))
    wanted = 1.5 * (HEAT / 2) * prediction.half_width / body.conductivity
    assert prediction.surface_rise(HEAT) == pytest.approx(wanted, rel=1e-9)


def test_the_film_warms_over_its_walls_as_a_slab_that_makes_heat():
    """q h/(8 k), k the oil's at the mean pressure."""
    scene = thermal((4.0, 2.0))
    prediction, heat = predicted(scene), scene.oil.heat
    p = pi / 4 * prediction.pressure_max
    k = heat.conductivity * (1 + heat.conductivity_c1 * p / (1 + heat.conductivity_c2 * p))
    wanted = HEAT * prediction.film_central / (8 * k)
    assert prediction.film_rise(HEAT) == pytest.approx(wanted, rel=1e-9)
