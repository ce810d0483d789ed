"""Flow factors of Patir and Cheng, and their asymptotes."""

import numpy as np
import pytest

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


def test_nothing_flows_through_closed_gaps():
    """Factors stay finite and not negative where mean planes cross."""
    gap = np.linspace(-6, 0.5, 50)
    for aspect in (1 / 9, 1.0, 9.0):
        assert np.all(pressure_flow_factor(gap, aspect) >= 0)
        assert np.all(np.isfinite(pressure_flow_factor(gap, aspect)))
        assert np.all(shear_flow_factor(gap[gap <= 0], aspect) == 0)
