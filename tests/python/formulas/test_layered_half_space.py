"""A coated half-space against closed forms: compliance of its surface, no layer, bonded faces."""

import numpy as np
import pytest

from pyworm.formulas.layered_half_space import Layer, _stress, layered_stress

HARD = Layer(2.0, (400e9, 200e9), (0.2, 0.3))


def test_compliance_of_the_surface():
    """Closed form of O'Sullivan and King, J. Tribol. 110 (1988) 235."""
    k = np.array([0.005, 0.1, 0.5, 2.0, 15.0])
    (stiff, below), (nu_1, nu_2) = HARD.shear_moduli, HARD.poisson_ratios
    ratio, thick = stiff / below, 2 * k * HARD.thickness
    a = 1 - 4 * (1 - nu_1) / (1 + ratio * (3 - 4 * nu_2))
    b = (ratio - 1) / (ratio + 3 - 4 * nu_1)
    fall = np.exp(-thick)
    exact = (1 + 2 * thick * b * fall - a * b * fall**2) / (
        1 - (a + b + b * thick**2) * fall + a * b * fall**2
    )
    assert HARD.compliance(k) == pytest.approx((1 - nu_1) / stiff * exact, rel=1e-9, abs=0)


def test_a_layer_of_the_same_material_changes_nothing():
    x = np.linspace(-3, 3, 64)
    pressure = np.sqrt(np.maximum(1 - x[:, None] ** 2 - x**2, 0))
    acting = (pressure, 0.3 * pressure, 0.1 * pressure)
    same = Layer(0.5, (200e9, 200e9), (0.3, 0.3))
    for depth in (0.0, 0.3, 0.5, 0.9):
        assert np.abs(layered_stress(acting, (6 / 63, 6 / 63), same, depth)).max() < 1e-9


@pytest.mark.parametrize("depth", [0.0, 0.7, 1.999999])
def test_waves_of_the_bare_half_space(depth):
    """Pressure p cos kx: sigma_xx = -(1 - kz) p exp(-kz), sigma_zz = -(1 + kz) p exp(-kz)."""
    k = np.array([0.2, 1.0, 3.0])
    none, one = np.zeros(3, complex), np.ones(3, complex)
    bare = Layer(2.0, (200e9, 200e9), (0.3, 0.3))
    fall = np.exp(-k * depth)
    pressed = _stress(bare, k, (one, none, none), depth)
    assert pressed.along == pytest.approx(-(1 - k * depth) * fall)
    assert pressed.normal == pytest.approx(-(1 + k * depth) * fall)
    sheared = _stress(bare, k, (none, one, one), depth)
    assert sheared.shear == pytest.approx(-(1 - k * depth) * fall)
    assert sheared.antiplane == pytest.approx(-fall)


def test_tractions_go_through_the_lower_face():
    k = np.array([0.2, 1.0, 3.0])
    acting = (np.ones(3, complex), 0.5j * np.ones(3), 0.2 * np.ones(3, complex))
    above, below = (_stress(HARD, k, acting, 2.0 * side) for side in (1 - 1e-10, 1 + 1e-10))
    for name in ("normal", "shear", "antiplane"):
        assert getattr(above, name) == pytest.approx(getattr(below, name), abs=1e-8)
    assert np.abs(above.along - below.along).max() > 0.01
    strains = (above.twist / HARD.shear_moduli[0], below.twist / HARD.shear_moduli[1])
    assert strains[0] == pytest.approx(strains[1], rel=1e-8, abs=0)
    surface = _stress(HARD, k, acting, 0.0)
    assert surface.normal == pytest.approx(-acting[0])
    assert surface.shear == pytest.approx(-acting[1])


def test_a_stiff_thin_layer_bears_more_stress():
    x = np.linspace(-3, 3, 128)
    pressure = np.sqrt(np.maximum(1 - x[:, None] ** 2 - x**2, 0))
    acting = (pressure, 0 * pressure, 0 * pressure)
    layer = Layer(0.002, (400e9, 200e9), (0.3, 0.3))
    change = layered_stress(acting, (6 / 127, 6 / 127), layer, 0.0)
    # strained as what is below, Hertz's -0.8 p0 in the middle: E eps = -0.26 p0; half as compliant
    borne = 2 * -0.26 / (1 - 0.3) - 0.3 / (1 - 0.3)
    assert change[0, 64, 64] == pytest.approx(borne + 0.8, rel=0.02)
    assert np.abs(change[2]).max() < 1e-6
