"""Contact of rough surfaces by closed forms."""

import numpy as np
import pytest
import scipy

from pyworm.formulas.rough_contact import greenwood_tripp, overlap_moment, self_affine


@pytest.mark.parametrize("order", [2.0, 2.5, 0.5])
@pytest.mark.parametrize("gap", [-2.0, 0.0, 0.5, 1.0, 2.0, 4.0, 8.0])
def test_moments_are_those_of_the_integral(order, gap):
    """Greenwood and Tripp (1970), equation 4, by quadrature."""

    def heights(over):
        return over**order * np.exp(-((gap + over) ** 2) / 2) / np.sqrt(2 * np.pi)

    exact, _ = scipy.integrate.quad(heights, 0, 12 + max(-gap, 0), epsabs=0, epsrel=1e-10)
    assert overlap_moment(order, gap) == pytest.approx(exact, rel=1e-6)


def test_moment_of_order_two_has_a_closed_form():
    """F_2(H) = (1 + H^2) Q(H) - H phi(H)."""
    gap = np.linspace(-3, 5, 40)
    normal = np.exp(-(gap**2) / 2) / np.sqrt(2 * np.pi)
    exact = (1 + gap**2) * scipy.special.ndtr(-gap) - gap * normal
    assert overlap_moment(2, gap) == pytest.approx(exact, rel=1e-6, abs=1e-12)


def test_no_height_reaches_a_wide_gap():
    """No number is lost far apart, where the integral underflows."""
    assert np.all(overlap_moment(2.5, [40.0, 1e4]) == 0)


def test_pressure_and_area_of_spherical_asperities():
    """(16 sqrt2 pi/15) 0.04^2 sqrt(0.01) E* F_5/2 and (pi 0.04)^2 F_2; integrals of both by quadrature."""
    pressure, area = greenwood_tripp(1.0, density=0.04, sharpness=0.01, modulus=100e9)
    assert pressure == pytest.approx(4.7390774 * 0.04**2 * 0.1 * 100e9 * 0.0805623, rel=1e-5)
    assert area == pytest.approx((np.pi * 0.04) ** 2 * 0.0753398, rel=1e-5)


def test_surfaces_rough_on_all_scales_bear_exponentially():
    """Pressure falls e-fold over 0.47 times the roughness; the real area goes with it, and is at most all."""
    pressure, area = self_affine([0.0, 0.47, 0.94], slope=0.05, modulus=100e9)
    assert pressure[:-1] / pressure[1:] == pytest.approx(np.e)
    assert area == pytest.approx(2 * pressure / (0.05 * 100e9))
    assert self_affine(-5.0, slope=0.05, modulus=100e9)[1] == 1
