"""Units at the edge of the house: "14 kN" comes in, 14000.0 goes on.

Inside, every number is a plain float in SI: angles in radians, speeds of rotation in rad/s, temperatures
in kelvin. Pint is imported at the first quantity only, since it takes longer to load than a case to check.
"""

import math
import re
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Literal

from pydantic import PlainValidator, ValidationInfo

_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*")

_SIGNS = {
    "positive": (lambda value: value > 0, "greater than zero"),
    "not negative": (lambda value: value >= 0, "zero or more"),
    "any": (lambda value: True, "that is finite"),
}


@dataclass(frozen=True)
class Kind:
    """What a value measures, and how a sentence speaks of it.

    Attributes
    ----------
    noun : str
        What it is called, article included ("a force").
    unit : str
        The SI unit it is kept in; empty for a share.
    example : str
        A right value, to be shown beside a wrong one.
    sign : str
        Which values are taken: "positive", "not negative" or "any".
    """

    noun: str
    unit: str
    example: str
    sign: Literal["positive", "not negative", "any"] = "positive"


SHARE = Kind("a share", "", "1 %")

SI = "SI"
"""Context of validation in which values are plain numbers in SI, as a checked case leaves them."""

SMALLEST, LARGEST = 1e-24, 1e24
"""Sizes in SI between which every value of a case lies that is not zero. Beyond, products of powers of values
overflow."""


@cache
def _registry():
    import pint

    return pint.UnitRegistry()


def _measure(text: str):
    """The pint quantity that a text means, in SI base units; None where it means none."""
    match = _QUANTITY.fullmatch(text)
    if match is None:
        return None
    try:
        # Built from number and unit apart, so that "60 degC" is a temperature and not a product.
        quantity = _registry().Quantity(float(match[1]), match[2].replace("°", "deg"))
        return quantity.to_base_units()
    except Exception:  # pint lets any error of its tokenizer and its arithmetic through
        return None


def parse(text: str, kind: Kind) -> float:
    """Read a quantity such as "14 kN".

    Parameters
    ----------
    text : str
        Number and unit.
    kind : Kind
        What it must measure.

    Returns
    -------
    float
        The value in `kind.unit`.

    Raises
    ------
    ValueError
        Not a text, not a number and a unit, of another dimension, not finite, or of the wrong sign.
    """
    with_unit = f"{kind.noun} with its unit" if kind.unit else kind.noun
    quantity = _measure(text) if isinstance(text, str) else None
    # Units are compared, not dimensions: to pint "3" and "3 deg", "1 Hz" and "1 rad/s" have the same.
    target = _registry().Quantity(1.0, kind.unit)
    if quantity is None or quantity.units != target.to_base_units().units:
        raise ValueError(f'must be {with_unit}, such as "{kind.example}"')
    value = quantity.to(kind.unit).magnitude
    allowed, wanted = _SIGNS[kind.sign]
    if not (math.isfinite(value) and allowed(value)):
        raise ValueError(f'must be {kind.noun} {wanted}, such as "{kind.example}"')
    if value and not SMALLEST <= abs(value) <= LARGEST:
        raise ValueError(f'must be {kind.noun} of a size that there is, such as "{kind.example}"')
    return value


def parse_any(text: str) -> tuple[float, str]:
    """Read a quantity of any dimension: its value in SI base units and these units ("kg/m/s**2").

    Raises
    ------
    ValueError
        Not a number and a unit.
    """
    quantity = _measure(text) if isinstance(text, str) else None
    if quantity is None or not math.isfinite(quantity.magnitude):
        raise ValueError('must be a number with its unit, such as "540 MPa"')
    return quantity.magnitude, f"{quantity.units:~C}"


def parse_in(text: str, unit: str | None = None) -> tuple[float, str]:
    """Read a quantity of any dimension as a number in a unit, by default the one that it is written with.

    Parameters
    ----------
    text : str
        Number and unit; a number alone is a plain number.
    unit : str, optional
        As a case file writes it.

    Returns
    -------
    tuple of float and str
        The number, and the unit it is in.

    Raises
    ------
    ValueError
        Not a number and a unit, or of another dimension.
    """
    match = _QUANTITY.fullmatch(text) if isinstance(text, str) else None
    if match is None or _measure(text) is None:
        raise ValueError('must be a number with its unit, such as "540 MPa"')
    own = match[2]
    if unit is None or unit == own:
        return float(match[1]), own
    first, other = (_registry().Quantity(1.0, name.replace("°", "deg")) for name in (unit, own))
    if first.to_base_units().units != other.to_base_units().units:
        raise ValueError(f'must be in a unit of the same kind as "{unit}"')
    whole = _registry().Quantity(float(match[1]), own.replace("°", "deg"))
    return float(whole.to(first.units).magnitude), unit


_FINER = {"mm": "µm", "Pa s": "mPa s", "GPa": "MPa", "kN": "N", "kW": "W"}
"""Units shown for values below a twentieth of those of the examples."""


_PRINTED = (("deg", "°"), ("^2", "²"), ("^3", "³"), ("um", "µm"))
"""Parts of units as written -> as printed."""


def shown(value: float, kind: Kind) -> str:
    """A value in SI as people write it: in the unit of its kind's example, or a finer one."""
    unit = kind.unit if kind.unit == "" else _QUANTITY.fullmatch(kind.example)[2]
    if kind.unit == "":
        return f"{value * 100:.4g} %"
    number = _in(value, kind.unit, unit)
    if abs(number) < 0.05 and number != 0 and unit in _FINER:
        unit = _FINER[unit]
        number = _in(value, kind.unit, unit)
    for plain, printed in _PRINTED:
        unit = unit.replace(plain, printed)
    return f"{number:.5g} {unit}"


def shown_like(value: float, unit: str, text: str) -> str:
    """A value in an SI unit as another quantity, given as text, is written."""
    own = _QUANTITY.fullmatch(text)[2]
    if not own:
        return f"{value:.4g}"
    return f"{_in(value, unit, own.replace('°', 'deg')):.4g} {own}"


def _in(value: float, unit: str, other: str) -> float:
    return float(_registry().Quantity(value, unit).to(other).magnitude)


def quantity(noun: str, unit: str, example: str, sign: str = "positive"):
    """Make the pydantic type of a dimensional key; arguments as of `Kind`."""
    return _quantity(Kind(noun, unit, example, sign))


def _quantity(kind: Kind):
    def read(value: object, info: ValidationInfo) -> float:
        if info.context != SI:
            return parse(value, kind)
        if not isinstance(value, float | int):
            raise ValueError(f"must be {kind.noun} as a number in SI")
        return value

    return Annotated[float, PlainValidator(read), kind]


Length = quantity("a length", "m", "305 mm")
LengthOrZero = quantity("a length", "m", "20 um", sign="not negative")
Offset = quantity("a length", "m", "-0.5 mm", "any")
Angle = quantity("an angle", "rad", "27.5 deg")
AngleOrZero = quantity("an angle", "rad", "12 deg", sign="not negative")
Tilt = quantity("an angle", "rad", "-0.4 deg", "any")
Torque = quantity("a torque", "N m", "30 N m")
Stiffness = quantity("a stiffness", "N/m", "200 N/um")
Force = quantity("a force", "N", "14 kN")
ForcePerLength = quantity("a force per length", "N/m", "100 kN/m")
Power = quantity("a power", "W", "250 kW")
PowerOrZero = quantity("a power", "W", "400 W", sign="not negative")
Speed = quantity("a speed of rotation", "rad/s", "1500 rpm")
Spin = quantity("a speed of rotation", "rad/s", "-20 rad/s", "any")
Velocity = quantity("a velocity", "m/s", "1.2 m/s", "any")
Pressure = quantity("a pressure", "Pa", "207 GPa")
Stress = quantity("a stress", "Pa", "3 MPa")
StressOrZero = quantity("a stress", "Pa", "100 MPa", sign="not negative")
PressureCoefficient = quantity("a pressure coefficient", "1/Pa", "9.5 1/GPa")
PressureCoefficientOrZero = quantity(
    "a pressure coefficient", "1/Pa", "9.5 1/GPa", sign="not negative"
)
PressureCoefficientAnySign = quantity("a pressure coefficient", "1/Pa", "3.3 1/GPa", "any")
SquaredPressureCoefficient = quantity(
    "a squared pressure coefficient", "1/Pa^2", "-2.3 1/GPa^2", "any"
)
Viscosity = quantity("a dynamic viscosity", "Pa s", "0.23 Pa s")
MassDensity = quantity("a density", "kg/m^3", "1025 kg/m^3")
Temperature = quantity("a temperature", "K", "60 degC")
Warmth = quantity("a temperature difference", "K", "15 K", sign="not negative")
ThermalConductance = quantity("a thermal conductance", "W/K", "40 W/K")
TemperatureCoefficient = quantity("a temperature coefficient", "1/K", "0.05 1/K")
TemperatureCoefficientOrZero = quantity(
    "a temperature coefficient", "1/K", "7.1e-4 1/K", sign="not negative"
)
TemperatureCoefficientAnySign = quantity("a temperature coefficient", "1/K", "3.4e-4 1/K", "any")
Conductivity = quantity("a thermal conductivity", "W/(m K)", "47 W/(m K)")
SpecificHeat = quantity("a specific heat", "J/(kg K)", "477 J/(kg K)")
TemperatureDifference = quantity("a temperature difference", "K", "15 K", sign="not negative")
KinematicViscosity = quantity("a kinematic viscosity", "m^2/s", "220 mm^2/s")
Duration = quantity("a duration", "s", "25000 h")
Share = _quantity(SHARE)
