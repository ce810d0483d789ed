"""Flash temperature by quadrature of its heat; Errichello's scuffing temperatures and risks."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from pyworm.formulas.hertz import hertz_line
from pyworm.formulas.scuffing import (
    FLASH_CONSTANT,
    effusivity,
    flash_temperature,
    risk,
    scuffing_probability,
    scuffing_temperature,
)

STEEL = effusivity(47, 7850, 460)


def kelvin(fahrenheit):
    return (fahrenheit - 32) / 1.8 + 273.15


def fahrenheit(kelvin):
    return (kelvin - 273.15) * 1.8 + 32


def rise_of_semi_elliptic_source(x):
    """Rise at x (half-widths) of a fast half-space under heat sqrt(1 - s^2), in Q/(B sqrt(v b)).

    One-dimensional conduction: integral of q(s)/sqrt(pi v (x - s)) over what has passed, with
    q = (2/pi) sqrt(1 - s^2); the substitution x - s = u^2 takes the singularity away.
    """
    heat = lambda u: 2 * np.sqrt(max(0.0, 1 - (x - u * u) ** 2))  # noqa: E731
    return 2 / np.pi**1.5 * quad(heat, 0, np.sqrt(x + 1))[0]


def test_flash_constant_is_that_of_a_semi_elliptic_source():
    hottest = minimize_scalar(
        lambda x: -rise_of_semi_elliptic_source(x), bounds=(-1, 1), method="bounded"
    )
    exact = -hottest.fun
    assert exact == pytest.approx(0.786, abs=5e-4)
    assert FLASH_CONSTANT == pytest.approx(exact, rel=0.02)
    # The form with 0.62 and w^(3/4) (E'/R)^(1/4) is the same: w^(3/4) (E'/R)^(1/4) = (8/pi)^(1/4) w/sqrt(b).
    assert 0.62 * (8 / np.pi) ** 0.25 == pytest.approx(exact, rel=4e-3)


def test_two_forms_agree_for_equal_bodies():
    flash = flash_temperature(0.05, 5e5, 4.0, 1.0, STEEL, STEEL, 3e-4)
    agma = 0.80 * 0.05 * 5e5 * abs(4.0**0.5 - 1.0**0.5) / (STEEL * np.sqrt(3e-4))
    assert flash == pytest.approx(agma)


def test_flash_temperature_by_load_is_the_power_three_quarters():
    def flash(load):
        width = hertz_line(0.015, load, 228e9).half_width
        return flash_temperature(0.05, load, 4.0, 1.0, STEEL, STEEL, width)

    assert flash(16e5) / flash(1e5) == pytest.approx(8)


@given(st.floats(0.1, 50), st.floats(0.1, 50), st.floats(1.01, 2))
def test_flash_temperature_of_sliding(speed_1, speed_2, more):
    args = (0.05, 5e5)
    rest = (STEEL, STEEL, 3e-4)
    flash = flash_temperature(*args, speed_1, speed_2, *rest)
    assert flash_temperature(*args, speed_1, speed_1, *rest) == 0
    assert flash == pytest.approx(flash_temperature(*args, speed_2, speed_1, *rest))
    assert flash_temperature(0.05 * more, 5e5, speed_1, speed_2, *rest) >= flash
    assert flash_temperature(*args, speed_1, speed_2, STEEL * more, STEEL, 3e-4) <= flash


@pytest.mark.parametrize(
    ("grade", "anti_scuff", "printed"), [(100, False, 417.7), (220, True, 563.2)]
)
def test_scuffing_temperatures_of_errichello(grade, anti_scuff, printed):
    """146 + 59 ln(100) and 245 + 59 ln(220) degF; the metric form is the same to its rounding."""
    base = 245 if anti_scuff else 146
    assert base + 59 * np.log(grade) == pytest.approx(printed, abs=0.06)
    assert fahrenheit(scuffing_temperature(grade * 1e-6, anti_scuff)) == pytest.approx(
        printed, abs=3
    )


def test_scuffing_probabilities_of_errichello():
    """63 % at 439 against 418 degF with the original gears, below 5 % at 302 against 563 degF."""
    assert scuffing_probability(kelvin(439), kelvin(418)) == pytest.approx(0.63, abs=0.005)
    assert scuffing_probability(kelvin(302), kelvin(563)) < 0.05
    assert risk(0.63) == "high"
    assert scuffing_probability(kelvin(418), kelvin(418)) == pytest.approx(0.5)


@given(st.floats(350, 700), st.floats(400, 700), st.floats(0.5, 100))
def test_hotter_contacts_scuff_more_and_better_oils_less(contact, scuffing, more):
    probability = scuffing_probability(contact, scuffing)
    assert 0 <= probability <= 1
    assert scuffing_probability(contact + more, scuffing) >= probability
    assert scuffing_probability(contact, scuffing + more) <= probability


@given(st.floats(32e-6, 1e-3), st.floats(1.01, 1.2))
def test_thicker_oils_and_additives_bear_more(viscosity, more):
    plain = scuffing_temperature(viscosity, False)
    assert scuffing_temperature(viscosity * more, False) > plain
    assert scuffing_temperature(viscosity, True) == pytest.approx(plain + 55)


def test_the_risk_of_scuffing_in_words():
    assert [risk(p) for p in (0, 0.1, 0.2, 0.3, 0.31, 1)] == [
        "low", "low", "moderate", "moderate", "high", "high",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: scuffing_temperature(100, False), "kinematic viscosity at 40 degC = 100 m2/s"),
        (lambda: scuffing_probability(439, 145), "scuffing temperature = 145 K"),
        (lambda: flash_temperature(0.05, 5e5, 4, 0, STEEL, STEEL, 3e-4), "speed of surface 2 = 0"),
        (lambda: flash_temperature(0.05, 5e5, 4, 1, STEEL, STEEL, 0.3), "half-width.* = 0.3 m"),
        (lambda: flash_temperature(50, 5e5, 4, 1, STEEL, STEEL, 3e-4), "friction coefficient = 50"),
        (lambda: effusivity(47, 7.85, 460), "density = 7.85 kg/m3"),
        (lambda: risk(63), "probability = 63"),
    ],
)
def test_values_in_wrong_units_are_refused(call, sentence):
    with pytest.raises(ValueError, match=sentence):
        call()
