"""Gap and asperities' share of a rolling line in mixed lubrication beside Masjedi and Khonsari's formulas."""

from dataclasses import replace
from math import log

import numpy as np
import pytest
from rough_bodies import rough

import pyworm
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.rough_surfaces import rough_pair
from pyworm.materials.viscosity_density import Density, Roelands
from pyworm.scene.line import LineScene, Parabola

LOAD, SPEED, MATERIAL, HARDNESS = 1e-4, 1e-11, 4500.0, 0.01
RADIUS, ALPHA, ETA0 = 0.01, 20e-9, 0.04
MODULUS = MATERIAL / ALPHA

SLOPE = 0.016
"""Of each surface: their asperities are stiffer than run-in ones by default."""


def formulas(height):
    """Central gap over the radius and share of the asperities (J. Tribol. 134 (2012) 011503)."""
    rise = 0.2 * height**1.222 * HARDNESS**0.223 * LOAD**-0.229 * SPEED**-0.748 * MATERIAL**-0.842
    gap = 2.691 * LOAD**-0.135 * SPEED**0.705 * MATERIAL**0.556 * (1 + rise)
    group = 4470 * height**6.015 * HARDNESS**1.168 * LOAD**0.485 * SPEED**-3.741 * MATERIAL**-2.898
    percent = 0.005 * LOAD**-0.408 * SPEED**-0.088 * MATERIAL**0.103 * log(1 + group)
    return gap, percent / 100


@pytest.fixture(scope="module")
def line():
    """The rolling line between smooth surfaces."""
    body = Body(MODULUS * (1 - 0.3**2), 0.3)
    velocity = SPEED * MODULUS * RADIUS / ETA0
    return LineScene(
        name="rolling",
        gap=Parabola(RADIUS),
        radius=RADIUS,
        velocities=(velocity, velocity),
        load=LOAD * MODULUS * RADIUS,
        bodies=(body, replace(body)),
        oil=Oil(Roelands.from_alpha(ETA0, ALPHA), Density.dowson_higginson_pole(870.0)),
    )


def test_smooth_line(line):
    solution = pyworm.solve(line, pyworm.plan(line, 0.02, "isothermal"))
    assert solution.figures.film_central.value / RADIUS == pytest.approx(formulas(0.0)[0], rel=0.05)


@pytest.mark.parametrize("height", [5e-6, 2e-5, 5e-5])
def test_rough_line(line, height):
    """Gap of mean planes within 6 %, share within 8 points; theirs lies within the bar of the model's."""
    scene = rough(line, height * RADIUS, roughness_slope=SLOPE, hardness=HARDNESS * MODULUS)
    solution = pyworm.solve(scene, pyworm.plan(scene, 0.02, ("isothermal", "roughness")))
    assert solution.converged
    film, share = solution.figures.film_central, solution.figures.asperity_load_fraction
    curves = rough_pair(scene.bodies, scene.motion_angles).curves()
    gap = np.interp(film.value, curves.thicknesses, curves.gaps) / RADIUS
    theirs, borne = formulas(height)
    assert gap == pytest.approx(theirs, rel=0.06)
    assert share.value == pytest.approx(borne, abs=0.08)
    assert share.value == pytest.approx(borne, abs=share.value * share.model + 1e-3)
