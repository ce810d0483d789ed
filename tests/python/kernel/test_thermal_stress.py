"""Thermal stress of a half-space against closed forms: steady heat, a moving line source, fast bodies."""

import numpy as np
import pytest
from scipy.special import k0e, k1e

from pyworm.formulas.thermal_stress import ThermalSolid
from pyworm.kernel import thermal_stress

STEEL = ThermalSolid(210e9, 0.3, 11.5e-6, 1.2e-5, 300.0)
EXPANDED = STEEL.youngs_modulus * STEEL.expansion


def test_steady_heat_strains_the_body_across_the_plane_only():
    """Boley and Weiner, section 8.13 (after Muki and McDowell), in plane strain."""
    x = 0.05 * np.arange(-256, 256)
    rise = np.exp(-(x**2))
    stress = thermal_stress(rise, (0.05,), (0.0,), STEEL, [0.0, 0.5])
    assert np.abs(stress[[0, 2, 3, 4, 5]]).max() < 1e-9 * EXPANDED
    assert stress[1, 0] == pytest.approx(-EXPANDED * rise, abs=1e-6 * EXPANDED)


def test_steady_heat_leaves_planes_along_the_surface_free():
    x = 0.1 * np.arange(-32, 32)
    stress = thermal_stress(np.exp(-(x[:, None] ** 2) - x**2), (0.1, 0.1), (0, 0), STEEL, [0.3])
    assert np.abs(stress[[2, 4, 5]]).max() < 1e-9 * EXPANDED
    assert np.abs(stress[[0, 1]]).max() > 0.1 * EXPANDED


def test_a_moving_line_source():
    """sigma_xx = -E alpha q/((1 - nu) pi k) [sgn(x) exp(l x) K1(l |x|) - 1/(l x)], l = V/2 kappa.

    Barber, J. Appl. Mech. 51 (1984) 636; here of sources spread as exp(-x^2/2 w^2).
    """
    scale, step, count, width = 4.0, 0.04, 8192, 0.3
    x = step * (np.arange(count) - count / 3)
    source = np.linspace(-6 * width, 6 * width, 401) + 1e-7
    strength = np.exp(-((source / width) ** 2) / 2) * (source[1] - source[0])

    def spread(place, wave):
        away = scale * (place - source)
        return float((strength * wave(away, np.abs(away))).sum())

    rise = np.array([spread(at, lambda d, a: np.exp(d - a) * k0e(a)) for at in x])
    end = np.clip((x[-1] - x) / 60, 0, 1)
    rise *= (1 - np.cos(np.pi * end)) / 2
    velocity = (2 * STEEL.diffusivity * scale,)
    found = thermal_stress(rise, (step,), velocity, STEEL, [0.0])[0, 0]
    for at in (-0.5, 0.0, 0.3, 1.0, 3.0):
        exact = spread(at, lambda d, a: np.sign(d) * np.exp(d - a) * k1e(a) - 1 / d)
        assert np.interp(at, x, found) == pytest.approx(-STEEL.restrained * exact, rel=0.005)


def test_a_fast_body_cannot_expand_along_its_surface():
    x = 1e-5 * np.arange(-128, 128)
    rise = np.exp(-((x / 2e-4) ** 2))
    stress = thermal_stress(rise, (1e-5,), (5000.0,), STEEL, [0.0])[:, 0]
    for component in (0, 1):
        assert stress[component] == pytest.approx(
            -STEEL.restrained * rise, abs=0.02 * STEEL.restrained
        )
    assert np.abs(stress[2:]).max() < 1e-6 * STEEL.restrained


def test_thermal_stress_is_in_equilibrium():
    x = 1e-5 * np.arange(-64, 64)
    rise = np.exp(-((x[:, None] / 1e-4) ** 2) - (x / 8e-5) ** 2)
    depths = 2e-5 + 1e-6 * np.array([-1, 0, 1])
    xx, yy, zz, xy, xz, yz = thermal_stress(rise, (1e-5, 1e-5), (1.0, 0.5), STEEL, depths)

    def slope(field, axis):
        waves = 1j * 2 * np.pi * np.fft.fftfreq(128, 1e-5)
        waves = waves[:, None] if axis == 0 else waves
        return np.fft.ifft(waves * np.fft.fft(field[1], axis=axis), axis=axis).real

    for a, b, c in ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)):
        force = slope(a, 0) + slope(b, 1) + (c[2] - c[0]) / 2e-6
        assert np.abs(force).max() < 2e-3 * STEEL.restrained / 1e-4
