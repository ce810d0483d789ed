"""Hertz contacts against published ellipses, exact limits and quadrature of their own pressure."""

from math import cos, isclose, pi, sin, sqrt

import numpy as np
import pytest
from folders import DATA
from scipy.integrate import quad

from pyworm.formulas.hertz import hertz, hertz_line

ELLIPSES = np.loadtxt(DATA / "hertz_ellipses.csv", delimiter=",", skiprows=6)


def test_worm_contact_of_sharif_2001():
    """Radii 3.046 m and 95.4 mm at 14 kN: 21.56 x 2.339 mm and 530.2 MPa."""
    contact = hertz(3.046, 0.0954, 14e3, 170.81e9)
    assert round(2e3 * contact.semi_axis_x, 2) == 21.56
    assert round(2e3 * contact.semi_axis_y, 3) == 2.339
    assert round(contact.pressure_max / 1e6, 1) == 530.2


@pytest.mark.parametrize(("ratio", "kappa", "beta"), ELLIPSES)
def test_published_ellipses(ratio, kappa, beta):
    contact = hertz(ratio * 0.01, 0.01, 50.0, 2e11)
    found = contact.semi_axis_x * 2e11 / (pi * contact.pressure_max * ratio * 0.01)
    assert contact.ellipticity == pytest.approx(kappa, abs=5.1e-5)
    assert found == pytest.approx(beta, abs=5.1e-6)


def test_circle_is_exact():
    load, radius, modulus = 15.0, 12.5e-3, 110e9
    contact = hertz(radius, radius, load, modulus)
    semi_axis = (1.5 * load * radius / modulus) ** (1 / 3)
    assert isclose(contact.semi_axis_x, semi_axis, rel_tol=1e-14)
    assert contact.semi_axis_x == contact.semi_axis_y
    assert isclose(contact.pressure_max, 1.5 * load / (pi * semi_axis**2), rel_tol=1e-14)
    assert isclose(contact.approach, semi_axis**2 / radius, rel_tol=1e-14)


def test_nearly_circular_is_smooth():
    circle = hertz(1.0, 1.0, 1.0, 1.0)
    nearly = hertz(1.0 + 1e-13, 1.0, 1.0, 1.0)
    assert isclose(nearly.ellipticity, circle.ellipticity, rel_tol=1e-12)


@pytest.mark.parametrize("radius_ratio", [1.0, 1.1, 10.0, 1e3, 1.4e5])
def test_turning_the_contact_swaps_the_axes(radius_ratio):
    one = hertz(radius_ratio, 1.0, 3.0, 7.0)
    other = hertz(1.0, radius_ratio, 3.0, 7.0)
    assert (one.semi_axis_x, one.semi_axis_y) == (other.semi_axis_y, other.semi_axis_x)
    assert (one.pressure_max, one.approach) == (other.pressure_max, other.approach)


@pytest.mark.parametrize("radius_ratio", [1.0, 3.0, 32.0, 1e4, 1.4e5])
def test_pressure_carries_the_load_and_presses_the_gap_flat(radius_ratio):
    """The half-space integral of the pressure gives the approach and the given gap, on both axes.

    Polar coordinates about the point of observation cancel 1/r, and along each line through it
    the pressure is the root of a parabola with a closed integral; quadrature does the rest. The
    largest ratio has semi-axes of about 1000 to 1.
    """
    contact = hertz(radius_ratio, 1.0, 1.0, 1.0)
    a, b, p = contact.semi_axis_x, contact.semi_axis_y, contact.pressure_max
    assert isclose(2 / 3 * pi * a * b * p, 1.0, rel_tol=1e-13)

    def deflection(x, y):
        # Along a line the pressure is p sqrt(c + 2 s t - q t^2), whose integral between its ends
        # is p pi (c + s^2/q) / (2 sqrt(q)).
        c = 1 - (x / a) ** 2 - (y / b) ** 2

        def chord(tangent):
            # The tangent of the angle stretched by the axes keeps slender ellipses smooth.
            u, v = a * cos(tangent), b * sin(tangent)
            length = sqrt(u**2 + v**2)
            q = 1 / length**2
            s = -(x / a * cos(tangent) + y / b * sin(tangent)) / length
            turn = a * b / length**2
            return turn * p * pi * (c + s**2 / q) / (2 * sqrt(q))

        return 2 / pi * quad(chord, 0, pi, points=[pi / 2], limit=2000, epsrel=1e-12)[0]

    assert isclose(deflection(0.0, 0.0), contact.approach, rel_tol=1e-9)
    for x, y in [(0.7 * a, 0.0), (0.0, 0.7 * b), (0.5 * a, 0.5 * b)]:
        gap = x**2 / (2 * radius_ratio) + y**2 / 2
        assert isclose(contact.approach - deflection(x, y), gap, rel_tol=1e-7)


def test_pressure_field():
    contact = hertz(3.046, 0.0954, 14e3, 170.81e9)
    x = np.linspace(-2, 2, 9) * contact.semi_axis_x
    pressure = contact.pressure(x, 0.0)
    assert pressure[4] == contact.pressure_max
    assert np.all(pressure[[0, 1, 2, 6, 7, 8]] == 0)
    assert pressure[3] == pytest.approx(contact.pressure_max * sqrt(0.75), rel=1e-14)


def test_line_is_the_limit_of_slender_ellipses():
    """Across the middle, a long ellipse is a line contact under the local load per length."""
    ellipse = hertz(1.4e5, 1.0, 1.0, 1.0)
    local_load = pi / 2 * ellipse.pressure_max * ellipse.semi_axis_y
    line = hertz_line(1.0, local_load, 1.0)
    assert line.half_width == pytest.approx(ellipse.semi_axis_y, rel=1e-4)
    assert line.pressure_max == pytest.approx(ellipse.pressure_max, rel=1e-4)


def test_line_carries_the_load():
    line = hertz_line(14.1e-3, 1.5708e6, 226e9)
    x = np.linspace(-1, 1, 20001) * line.half_width
    assert np.trapezoid(line.pressure(x), x) == pytest.approx(1.5708e6, rel=1e-5)
    assert line.pressure_max == pytest.approx(2e9, rel=2e-3)  # Venner and Lubrecht (1994)
    assert line.pressure(1.01 * line.half_width) == 0


@pytest.mark.parametrize("bad", [0.0, -1.0, float("inf"), float("nan")])
def test_bad_input_names_the_quantity(bad):
    with pytest.raises(ValueError, match="radius_y is"):
        hertz(1.0, bad, 1.0, 1.0)
    with pytest.raises(ValueError, match="load is"):
        hertz(1.0, 1.0, bad, 1.0)
    with pytest.raises(ValueError, match="radius is"):
        hertz_line(bad, 1.0, 1.0)
