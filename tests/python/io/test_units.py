"""Quantities come in with their unit and go on in SI."""

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pyworm.io import units
from pyworm.io.given import kind_of
from pyworm.io.number_with_unit import converted, parse_any
from pyworm.io.quantity import SHARE_KIND, Kind, parse, possible

FORCE = Kind("a force", "N", "14 kN")
LENGTH = Kind("a length", "m", "305 mm", "any")
ANGLE = Kind("an angle", "rad", "27.5 deg")
SPEED = Kind("a speed of rotation", "rad/s", "1500 rpm")
DIFFERENCE = Kind("a temperature difference", "delta_degC", "15 K", "not negative")
HEAT = Kind("a specific heat", "J/(kg K)", "477 J/(kg K)")
TEMPERATURE = Kind("a temperature", "K", "60 degC")
PER_PRESSURE = Kind("a pressure coefficient", "1/Pa", "9.5 1/GPa", "not negative")
TORQUE = Kind("a torque", "N m", "30 N m")
VISCOSITY = Kind("a dynamic viscosity", "Pa s", "0.23 Pa s")
LINE_LOAD = Kind("a force per length", "N/m", "100 kN/m")
CONDUCTIVITY = Kind("a thermal conductivity", "W/(m K)", "47 W/(m K)")


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("14 kN", FORCE, 14e3),
        ("14kN", FORCE, 14e3),
        (" 1.4e4  N ", FORCE, 14e3),
        ("-0.5 mm", LENGTH, -0.5e-3),
        ("0.40 deg", ANGLE, math.radians(0.40)),
        ("0.40°", ANGLE, math.radians(0.40)),
        ("1500 rpm", SPEED, 50 * math.pi),
        ("60 degC", TEMPERATURE, 333.15),
        ("60 °C", TEMPERATURE, 333.15),
        ("9.5 1/GPa", PER_PRESSURE, 9.5e-9),
        ("0 1/GPa", PER_PRESSURE, 0.0),
        ("0.148 W/(m K)", CONDUCTIVITY, 0.148),
        ("0.148 W/(m·K)", CONDUCTIVITY, 0.148),
        ("0.148 W m-1 K-1", CONDUCTIVITY, 0.148),
        ("0.148 W/(m °C)", CONDUCTIVITY, 0.148),
        ("600 Nm", TORQUE, 600.0),
        ("0.6 kNm", TORQUE, 600.0),
        ("600 N·m", TORQUE, 600.0),
        ("40 mPas", VISCOSITY, 0.04),
        ("1500 1/min", SPEED, 50 * math.pi),
        ("1500 min-1", SPEED, 50 * math.pi),
        ("1500 min^-1", SPEED, 50 * math.pi),
        ("1500 min⁻¹", SPEED, 50 * math.pi),
        ("1500 r/min", SPEED, 50 * math.pi),
        ("1500 U/min", SPEED, 50 * math.pi),
        ("1500 /min", SPEED, 50 * math.pi),
        ("1500 RPM", SPEED, 50 * math.pi),
        ("80 C", TEMPERATURE, 353.15),
        ("80°C", TEMPERATURE, 353.15),
        ("80 deg C", TEMPERATURE, 353.15),
        ("176 F", TEMPERATURE, 353.15),
        ("15 K", DIFFERENCE, 15.0),
        ("15 degC", DIFFERENCE, 15.0),
        ("15 °C", DIFFERENCE, 15.0),
        ("27 degF", DIFFERENCE, 15.0),
        ("42 W/mK", CONDUCTIVITY, 42.0),
        ("42 W/m K", CONDUCTIVITY, 42.0),
        ("460 J/kgK", HEAT, 460.0),
        ("460 J/(kg K)", HEAT, 460.0),
        ("1%", SHARE_KIND, 0.01),
        ("0.01", SHARE_KIND, 0.01),
    ],
)
def test_quantities_are_read_into_si(text, kind, value):
    assert parse(text, kind) == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize(
    ("value", "kind"),
    [
        (14, FORCE),
        (14.0, FORCE),
        (True, FORCE),
        (None, FORCE),
        ("14", FORCE),
        ("", FORCE),
        ("kN", FORCE),
        ("14 mm", FORCE),
        ("14,5 kN", FORCE),
        ("14 kN)", FORCE),
        ("2*7 kN", FORCE),
        ("nan kN", FORCE),
        ("inf kN", FORCE),
        ("1e400 kN", FORCE),
        ("14 kNewtonian", FORCE),
        ("__import__('os') kN", FORCE),
        ("0.4", ANGLE),
        ("40 %", ANGLE),
        ("25 Hz", SPEED),
        ("25 1/s", SPEED),
        ("1 degC*kN/m/K", LINE_LOAD),
        ("182 pi kN/m", LINE_LOAD),
        ("182 %kN/m", LINE_LOAD),
        ("182 kN/m**(9**9**9)", LINE_LOAD),
        ("182 kN/m 2", LINE_LOAD),
        ("182 kN//m", LINE_LOAD),
        ("182 (kN/m", LINE_LOAD),
        ("1 pi", SHARE_KIND),
        ("5 1", SHARE_KIND),
    ],
)
def test_what_does_not_measure_the_right_thing_is_refused(value, kind):
    with pytest.raises(ValueError, match=kind.example):
        parse(value, kind)


@pytest.mark.parametrize(
    ("text", "kind", "wanted"),
    [
        ("-14 kN", FORCE, "greater than zero"),
        ("0 kN", FORCE, "greater than zero"),
        ("-300 degC", TEMPERATURE, "greater than zero"),
        ("-1 1/GPa", PER_PRESSURE, "zero or more"),
    ],
)
def test_a_wrong_sign_is_refused(text, kind, wanted):
    with pytest.raises(ValueError, match=wanted):
        parse(text, kind)


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("1,5 kN", '"1.5 kN"'),
        ("-0,25 N", '"-0.25 N"'),
        ("14,5kN", '"14.5 kN"'),
        ("1.400,5 N", '"1400.5 N"'),
        ("1,400 N", '"1.400 N" or "1400 N"'),
    ],
)
def test_a_decimal_comma_is_named(text, written):
    said = re.escape(f"; decimals follow a point, not a comma, write {written}") + "$"
    with pytest.raises(ValueError, match=said):
        parse(text, FORCE)
    with pytest.raises(ValueError, match=said):
        parse_any(text)


@pytest.mark.parametrize(
    ("text", "written"),
    [("1 500 N", '"1500 N"'), ("12 345 678.5 N", '"12345678.5 N"'), ("1'500 N", '"1500 N"')],
)
def test_blanks_between_thousands_are_named(text, written):
    with pytest.raises(
        ValueError, match=re.escape(f"; thousands stand together, write {written}") + "$"
    ):
        parse(text, FORCE)


@pytest.mark.parametrize(
    ("text", "kind", "meant"),
    [
        ("14 KN", FORCE, "14 kN"),
        ("305 MM", LENGTH, "305 mm"),
        ("600 NM", TORQUE, "600 Nm"),
        ("60 DEGC", TEMPERATURE, None),
        ("14 mm", FORCE, None),
    ],
)
def test_wrong_capitals_of_a_unit_are_asked_about(text, kind, meant):
    with pytest.raises(ValueError) as refused:
        parse(text, kind)
    message = str(refused.value)
    assert message.endswith(f'; did you mean "{meant}"?' if meant else f'such as "{kind.example}"')


def test_what_is_understood_for_one_quantity_is_not_for_another():
    """A C is no unit of heat per kelvin, mK elsewhere a thousandth of a kelvin."""
    with pytest.raises(ValueError):
        parse_any("80 C")
    assert parse_any("2 W/mK")[0] == pytest.approx(2000.0)


@given(st.floats(min_value=1e-12, max_value=1e12), st.sampled_from(["mm", "um", "m", "inch"]))
def test_a_length_survives_the_round_trip(metres, unit):
    factor = {"mm": 1e-3, "um": 1e-6, "m": 1.0, "inch": 0.0254}[unit]
    assert parse(f"{metres / factor!r} {unit}", LENGTH) == pytest.approx(metres, rel=1e-14)


@given(st.text(max_size=12))
def test_no_text_brings_anything_but_a_finite_length_or_a_refusal(text):
    try:
        value = parse(text, LENGTH)
    except ValueError:
        return
    assert math.isfinite(value)


def test_any_quantity_is_read_with_its_unit():
    assert parse_any("540 MPa") == (540e6, "kg/m/s**2")
    with pytest.raises(ValueError, match="number with its unit"):
        parse_any("much")


@pytest.mark.parametrize(
    ("text", "value", "base"),
    [
        ("1 psi", 6894.757293168361, "kg/m/s**2"),
        ("1 microreyn", 6.894757293168361e-3, "kg/m/s"),
        ("1 lbf", 4.4482216152605, "kg*m/s**2"),
        ("1 hp", 745.69987158227022, "kg*m**2/s**3"),
        ("1 PS", 735.49875, "kg*m**2/s**3"),
        ("32 degF", 273.15, "K"),
        ("1 1/degF", 1.8, "1/K"),
        ("220 cSt", 220e-6, "m**2/s"),
        ("3 cP", 3e-3, "kg/m/s"),
        ("2 millimetres", 2e-3, "m"),
        ("1 turn/s", 2 * math.pi, "rad/s"),
        ("1 arcmin", math.pi / 10800, "rad"),
        ("1 kWh", 3.6e6, "kg*m**2/s**2"),
        ("50 ppm", 50e-6, ""),
        ("4 W/(m^2 K)", 4.0, "kg/K/s**3"),
    ],
)
def test_units_are_worth_what_is_defined(text, value, base):
    """Inch, pound, standard gravity and calorie are exact by definition (NIST SP 811, appendix B)."""
    found, unit = parse_any(text)
    assert (found, unit) == (pytest.approx(value, rel=1e-14), base)


@pytest.mark.parametrize("text", ["3 kdegC", "3 kilofoot", "3 mhp", "3 N pi", "3 dozen"])
def test_units_that_are_not_known_are_refused(text):
    with pytest.raises(ValueError, match="number with its unit"):
        parse_any(text)


def test_temperatures_are_converted_with_their_zeros():
    assert converted(100.0, "degC", "degF") == pytest.approx(212.0, rel=1e-14)
    assert converted(333.15, "K", "degC") == pytest.approx(60.0, rel=1e-14)


@pytest.mark.parametrize("unit", ["in-lb", "lb in", "in-lbs", "lbf in", "in-lbf", "in·lbf"])
def test_pound_inches_of_torques_are_forces(unit):
    """A pound-force is 4.4482216 N; elsewhere lb stays a mass."""
    assert parse(f"300 {unit}", TORQUE) == pytest.approx(300 * 4.4482216152605 * 0.0254)
    feet = unit.replace("in", "ft")
    assert parse(f"25 {feet}", TORQUE) == pytest.approx(25 * 4.4482216152605 * 0.3048)


@pytest.mark.parametrize(
    "kind", [FORCE, LENGTH, kind_of(units.Modulus), kind_of(units.Temperature)]
)
@pytest.mark.parametrize(
    "value", [-1.0, 0.0, 1e-30, 1e-6, 1.0, 300.0, 2e11, 1e30, math.inf, math.nan]
)
def test_a_number_is_possible_where_its_text_is_taken(value, kind):
    try:
        parse(f"{value!r} {kind.unit}", kind)
        taken = True
    except ValueError:
        taken = False
    assert possible(value, kind) == taken
