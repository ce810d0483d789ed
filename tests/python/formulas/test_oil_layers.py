"""Layers of oil from a bath or from jets."""

from math import sqrt

import pytest

from pyworm.formulas.oil_layers import (
    GRAVITY,
    SURFACE_TENSION,
    dragged_layer,
    drained_layer,
    sprayed_layer,
)


def test_dragged_layer_of_slow_and_fast_surfaces():
    """Landau and Levich's 0.944 l_c Ca^(2/3), and at most sqrt(eta U / rho g)."""
    length = sqrt(SURFACE_TENSION / (870 * GRAVITY))
    slow = dragged_layer(0.01, 870.0, 1e-3)
    assert slow == pytest.approx(0.944 * length * (0.01 * 1e-3 / SURFACE_TENSION) ** (2 / 3))
    assert slow == pytest.approx(8.5e-6, rel=0.01)
    fast = dragged_layer(0.1, 870.0, 10.0)
    assert fast == pytest.approx(sqrt(0.1 * 10 / (870 * GRAVITY)))


@pytest.mark.parametrize("time", [1e-3, 0.1, 1.0, 10.0, 1e3])
def test_drained_layer_is_jeffreys(time):
    """Of the exact solution, the thinner of the first layer and sqrt(eta y / rho g t), within sqrt(2)."""
    first, height = 0.4e-3, 5e-3
    exact = min(first, sqrt(0.05 * height / (870 * GRAVITY * time)))
    found = drained_layer(first, 0.05, 870.0, GRAVITY, height, time)
    assert exact / sqrt(2) <= found * (1 + 1e-12)
    assert found <= exact
    if time in (1e-3, 1e3):
        assert found == pytest.approx(exact, rel=0.02)


def test_sprayed_layer_keeps_the_oil():
    """Two flanks on either body take up all that is sprayed."""
    assert 4 * 2e-4 * 25 * sprayed_layer(1e-5, 2e-4, 25.0) == pytest.approx(1e-5)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: dragged_layer(-0.1, 870.0, 1.0), "viscosity"),
        (lambda: dragged_layer(0.1, 870.0, 0.0), "speed"),
        (lambda: drained_layer(0.0, 0.1, 870.0, 10.0, 1e-3, 1.0), "first"),
        (lambda: sprayed_layer(1e-5, 0.0, 1.0), "flank"),
    ],
)
def test_impossible_layers_are_refused(call, words):
    with pytest.raises(ValueError, match=words):
        call()
