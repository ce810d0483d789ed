"""Deflection of coated bodies against Hankel transforms and limits, of point and line contacts."""

import numpy as np
import pytest
from scipy.special import j0, j1

from pyworm import kernel
from pyworm.formulas.hertz import hertz
from pyworm.formulas.layered_half_space import Layer
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Barus, Density

HALF_WIDTH, NODES = 1e-3, 97
BELOW, POISSON = 200e9, 0.3
MODULUS = BELOW / (1 - POISSON**2)
"""E' of two bodies of BELOW."""
OIL = Oil(Barus(0.05, 1e-15), Density(870.0, 0.0, 1e-9))
X = np.linspace(-2 * HALF_WIDTH, 2 * HALF_WIDTH, NODES)
STEP = X[1] - X[0]
RADIUS = np.hypot(X[:, None], X)
SEMICIRCLE = 1e9 * np.sqrt(np.maximum(1 - (RADIUS / HALF_WIDTH) ** 2, 0))


def layer(thickness, modulus=2 * BELOW, poisson_ratio=0.25):
    return Layer(thickness * HALF_WIDTH, (modulus, BELOW), (poisson_ratio, POISSON))


def deflection(layers=(), pressure=SEMICIRCLE):
    return kernel.elastic_deflection(pressure, STEP, STEP, MODULUS, layers)


def hankel(places, layers):
    """Deflection [m] at distances from the middle of a semicircle of pressure, by its Hankel transform."""
    size = np.linspace(1e-4, 400, 400_001)
    pressure = 1e9 * (np.sin(size) - size * np.cos(size)) / size**3
    k = size / HALF_WIDTH
    compliance = sum(
        2 / MODULUS if each is None else np.interp(k, KNOTS, each.compliance(KNOTS))
        for each in layers
    )
    return np.array(
        [HALF_WIDTH * np.trapezoid(compliance * pressure * j0(k * place), size) for place in places]
    )


KNOTS = np.geomspace(1e-5, 500, 4000) / HALF_WIDTH


@pytest.mark.parametrize(("thickness", "tolerance"), [(0.1, 1e-3), (0.3, 1.5e-3), (1.0, 5e-3)])
@pytest.mark.parametrize("modulus", [0.5 * BELOW, 4 * BELOW])
def test_deflection_is_that_of_the_hankel_transform(thickness, tolerance, modulus):
    """What the layer adds; its part that reaches beyond the window grows with its thickness."""
    coated, bare = (layer(thickness, modulus), None), (None, None)
    at = NODES // 2 + np.array([0, 12, 24, 36])
    found = (deflection(coated) - deflection())[at, NODES // 2]
    exact = hankel(X[at], coated) - hankel(X[at], bare)
    assert found == pytest.approx(exact, rel=0, abs=tolerance * deflection().max())


@pytest.mark.parametrize("modulus", [0.5 * BELOW, 4 * BELOW])
def test_the_shape_of_a_line_s_deflection_is_that_of_its_cosine_transform(modulus):
    load, coated = np.pi / 2 * 1e9 * HALF_WIDTH, (None, layer(0.2, modulus))
    pressure = 1e9 * np.sqrt(np.maximum(1 - (X / HALF_WIDTH) ** 2, 0))
    films = [
        kernel.LineFilm(X**2, X < 1, 1 + 0 * X, STEP, MODULUS, load, OIL, 1e-9, layers)
        for layers in ((), coated)
    ]
    for film in films:
        film.start(pressure, 1e-3)
    at = NODES // 2 + np.array([0, 12, 20, 36])
    found = (films[1].convolve() - films[0].convolve())[at]
    size = np.linspace(1e-4, 200, 200_001)
    spectrum = np.pi * HALF_WIDTH * 1e9 * j1(size) / size
    added = np.interp(size / HALF_WIDTH, KNOTS, coated[1].compliance(KNOTS)) - 2 / MODULUS
    exact = [
        np.trapezoid(added * spectrum * np.cos(size * place / HALF_WIDTH) / size, size) / np.pi
        for place in X[at]
    ]
    # a line's datum is arbitrary; that of the padded grid is off by 4 % of what the layer adds
    relative, shape = (np.subtract(added_there, added_there[0]) for added_there in (found, exact))
    assert relative == pytest.approx(shape, rel=0, abs=0.02 * np.abs(exact).max())


def test_a_layer_like_the_body_changes_nothing():
    bare = deflection()
    assert deflection((layer(0.3, BELOW, POISSON), None)) == pytest.approx(bare, rel=1e-9, abs=0)
    assert (deflection((None, None)) == bare).all()


def test_thick_and_thin_layers_are_their_limits():
    bare = deflection()
    share = 0.5 + 0.5 * (1 - 0.25**2) / 2 / (1 - POISSON**2)
    thick, thin = (deflection((layer(thickness), None)) for thickness in (1e4, 1e-5))
    assert thick == pytest.approx(share * bare, rel=1e-3, abs=0)
    assert thin == pytest.approx(bare, rel=1e-4, abs=0)


def test_both_bodies_and_their_order():
    soft, hard = layer(0.2, BELOW / 3), layer(0.4)
    together = deflection((soft, hard))
    assert deflection((hard, soft)) == pytest.approx(together, rel=1e-12, abs=0)
    apart = deflection((soft, None)) + deflection((None, hard)) - deflection()
    assert together == pytest.approx(apart, rel=1e-9, abs=0)


@pytest.mark.parametrize("modulus", [0.5 * BELOW, 2 * BELOW])
def test_the_dry_contact_is_flat_by_the_hankel_transform(modulus):
    """Sphere on a coated flat: its pressure deflects the bodies, by quadrature, to a constant approach."""
    coated, load, ball = (layer(0.5, modulus), None), 1500.0, 0.1
    bare = hertz(ball, ball, load, MODULUS)
    gap = RADIUS**2 / (2 * ball)
    dry = kernel.dry_contact(
        gap, RADIUS >= 0, STEP, STEP, MODULUS, load, bare.pressure(X[:, None], X), 1e-6, coated
    )
    assert dry.converged
    middle = dry.pressure[NODES // 2 :, NODES // 2]
    fine = np.linspace(0, X[-1], 2000)
    radial = np.interp(fine, X[NODES // 2 :], middle)
    k = np.linspace(1e-3, 60, 6000) / HALF_WIDTH
    spectrum = np.array([np.trapezoid(radial * j0(each * fine) * fine, fine) for each in k])
    compliance = 2 / MODULUS + coated[0].compliance(k)
    inside = X[NODES // 2 :][middle > 0.1 * middle.max()]
    w = [np.trapezoid(compliance * spectrum * j0(k * place), k) for place in inside]
    flat = w + inside**2 / (2 * ball)
    assert flat == pytest.approx(dry.approach, rel=5e-3, abs=0)
    assert (middle.max() > bare.pressure_max) == (modulus > BELOW)
