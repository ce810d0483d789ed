"""Statistics of a fit against a straight line by hand, and what data cannot tell."""

import numpy as np
import pytest

from pyworm.formulas.least_squares import LeastSquares
from pyworm.formulas.response_surface import STEP, ResponseSurface


def line(residuals=(0.1, -0.2, 0.1), fixed=()):
    """y = a + b x at x = 0, 1, 2 with a = 2, b = 3, each y known to 0.1."""
    return LeastSquares(
        values=np.array([2.0, 3.0]),
        sensitivity=np.array([[1.0, 0.0], [1.0, 1.0], [1.0, 2.0]]),
        residuals=np.array(residuals),
        uncertainties=np.full(3, 0.1),
        fixed=fixed,
    )


def test_a_straight_line_as_by_hand():
    """(J^T W J)^-1 = 0.01 [[5, -3], [-3, 3]] / 6; chi squared of these residuals is 6 with 1 degree."""
    fit = line()
    by_hand = 0.01 * np.array([[5.0, -3.0], [-3.0, 3.0]]) / 6
    assert fit.chi_squared == pytest.approx(6.0) and fit.degrees == 1
    np.testing.assert_allclose(fit.covariance, 6 * by_hand, rtol=1e-12)
    np.testing.assert_allclose(fit.standard, np.sqrt([0.05, 0.03]), rtol=1e-12)
    assert fit.correlation[0, 1] == pytest.approx(-3 / np.sqrt(15))
    # Student's t of one degree, 95 %: 12.7062
    np.testing.assert_allclose(fit.half_widths / fit.standard, 12.7062, rtol=1e-5)


def test_less_scatter_than_stated_reduces_no_uncertainty():
    np.testing.assert_allclose(
        line((0.01, -0.02, 0.01)).covariance,
        0.01 * np.array([[5.0, -3.0], [-3.0, 3.0]]) / 6,
        rtol=1e-12,
    )


def test_a_value_at_its_bound_has_no_uncertainty_and_gives_none():
    fit = line((0.01, -0.02, 0.01), (False, True))
    np.testing.assert_allclose(fit.standard, [0.1 / np.sqrt(3), 0.0])
    assert fit.degrees == 2 and fit.correlation.tolist() == [[1.0, 0.0], [0.0, 1.0]]


def test_data_that_fix_a_product_alone_say_so():
    """Responses to the product of both unknowns, y = c a b: neither has a bound, the product has."""
    slope = np.array([[3.0, 2.0], [6.0, 4.0], [9.0, 6.0]])
    fit = LeastSquares(np.array([2.0, 3.0]), slope, np.full(3, 0.05), np.full(3, 0.1))
    assert np.isinf(fit.standard).all()
    best, other = fit.combinations
    # the sum of (6, 12, 18)^2 / 0.1^2 is 50400 for a relative change of either
    assert best.words(["a", "b"]) == "a b" and best.determined
    assert best.spread == pytest.approx(1 / np.sqrt(50400))
    assert other.words(["a", "b"]) in ("a b^-1", "a^-1 b") and not other.determined


def test_a_response_surface_meets_power_laws_and_parabolas():
    def model(place):
        return np.array([3.0 * np.exp(0.7 * place[0] - 0.5 * place[1]), 1 + place[0] ** 2])

    steps = np.eye(2) * STEP
    less, more = (np.array([model(sign * step) for step in steps]).T for sign in (-1, 1))
    logarithmic = np.array([True, False])
    surface = ResponseSurface.through(model(np.zeros(2)), less, more, logarithmic)
    place = np.array([0.5, -0.3])
    np.testing.assert_allclose(surface.responses(place), model(place), rtol=1e-12)
    step = np.array([1e-6, 0.0])
    slope = (model(place + step) - model(place - step)) / 2e-6
    np.testing.assert_allclose(surface.sensitivity(place)[:, 0], slope, rtol=1e-6)
    shifted = surface.through_also(place, 1.1 * model(place))
    np.testing.assert_allclose(shifted.responses(place), 1.1 * model(place), rtol=1e-12)
