"""Flow factors of Patir and Cheng, and their asymptotes."""

import numpy as np
import pytest
import scipy

from pyworm.formulas.flow_factors import pressure_flow_factor, shear_flow_factor


@pytest.mark.parametrize(("gap", "factor"), [(1, 0.486), (2, 0.706), (3, 0.832), (4, 0.904)])
def test_isotropic_pressure_flow(gap, factor):
    """1 - 0.9 exp(-0.56 H), Patir and Cheng (1978), table 1."""
    assert pressure_flow_factor(gap, 1.0) == pytest.approx(factor, abs=6e-4)


@pytest.mark.parametrize(("gap", "factor"), [(1, 0.796), (2, 0.727), (3, 0.553), (4, 0.415)])
def test_isotropic_shear_flow(gap, factor):
    """1.899 H^0.98 exp(-0.92 H + 0.05 H^2), Patir and Cheng (1979), table 2."""
    assert shear_flow_factor(gap, 1.0) == pytest.approx(factor, abs=6e-4)


def test_ridges_far_apart():
    """Longitudinal ridges 1 + 3/H^2, transverse ones 1 - 6/H^2, exact to second order (Tripp 1983)."""
    assert pressure_flow_factor(20.0, 1e9) == pytest.approx(1 + 3 / 400, rel=1e-6)
    assert pressure_flow_factor(20.0, 1e-9) == pytest.approx(1 - 6 / 400, rel=1e-6)
    assert shear_flow_factor(20.0, 1.0) == pytest.approx(1.5 / 20)


@pytest.mark.parametrize("aspect", [1 / 9, 1 / 3, 1.0, 2.0, 3.0, 9.0])
@pytest.mark.parametrize("factor", [pressure_flow_factor, shear_flow_factor])
def test_fits_and_asymptotes_meet(factor, aspect):
    """No jump where one passes to the other, nor between the tables' aspects."""
    gap = np.linspace(0.6, 12, 2000)
    values = factor(gap, aspect)
    assert np.abs(np.diff(values)).max() < 0.03
    assert np.abs(factor(gap, 1.001 * aspect) - values).max() < 2e-3


@pytest.mark.parametrize("aspect", [1 / 9, 1.0, 9.0])
def test_factors_of_closed_gaps(aspect):
    """Pressure flow is finite and not negative; valleys move with their wall, no faster, none against it."""
    gap = np.linspace(-3, 0.5, 50)
    assert np.all(pressure_flow_factor(gap, aspect) >= 0)
    assert np.all(np.isfinite(pressure_flow_factor(gap, aspect)))
    # thickness as the integral of the probability that the gap is open at some height
    thickness = [scipy.stats.norm.expect(lambda z, h=h: h - z, ub=h) for h in gap]
    part = shear_flow_factor(gap, aspect) / thickness
    assert part == pytest.approx(np.full(50, part[-1]), rel=1e-5)
    assert 0.5 < part[-1] < 1


@pytest.mark.parametrize("aspect", [1.0, 3.0, 9.0])
def test_a_rough_wall_at_rest_never_sends_the_film_back(aspect):
    """Mean thickness travels with um - shear factor's change by the gap times half the sliding; the fits for
    ridges across the flow would send some of it back at half the roughness.
    """
    gap = np.linspace(-3, 10, 2000)
    thickness = gap * scipy.stats.norm.cdf(gap) + scipy.stats.norm.pdf(gap)
    factor = shear_flow_factor(gap, aspect)
    # a smooth wall at 2 um and a rough one at rest: half the sliding is the mean velocity
    assert np.all(np.diff(thickness - factor) > 0)
