"""Quantities with units: "14 kN" in a case file becomes 14000.0 in SI.

Inside, every number is a plain float in SI: angles in radians, speeds of rotation in rad/s, temperatures
in kelvin. Pint is imported at the first quantity only, since it takes longer to load than a case to check.

Each kind of quantity has two ranges. Beyond the possible one a value is refused: nothing is built or flows
so, and products of powers of such values overflow. Beyond the usual one it is taken, and told.
"""

import math
import re
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Literal

from pydantic import PlainValidator, ValidationInfo

from pyworm.io.unit_text import ROTATIONS, expression, plain

_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*")

_DECIMAL_COMMA = re.compile(r"\s*([+-]?\d+),(\d+)(?![\d,])\s*(.*?)\s*")

LONGEST = 200
"""Characters of the longest quantity that is read."""

_SIGNS = {
    "positive": (lambda value: value > 0, "greater than zero"),
    "not negative": (lambda value: value >= 0, "zero or more"),
    "any": (lambda value: True, "that is finite"),
}


Range = tuple[str, str]
"""Two quantities, smallest and largest size, as they are told."""


@dataclass(frozen=True)
class Kind:
    """Kind of quantity of a value: its dimension, ranges and the words of messages.

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
    possible : tuple of str
        Sizes between which every value lies that is not zero.
    usual : tuple of str, optional
        Sizes beyond which a value is told, the smallest empty where none is too small; by default none is.
    """

    noun: str
    unit: str
    example: str
    sign: Literal["positive", "not negative", "any"] = "positive"
    possible: Range | None = None
    usual: Range | None = None


SHARE = Kind("a share", "", "1 %", possible=("1e-12 %", "1000 %"))

SI = "SI"
"""Context of validation in which values are plain numbers in SI, as a checked case leaves them."""


@cache
def _registry():
    import pint

    return pint.UnitRegistry()


_SHARES = (("percent",), ("ppm",))
"""Units that are numbers."""


@cache
def _unit(text: str):
    """The pint unit that a text means.

    Raises
    ------
    ValueError
        It means none, or holds a number such as pi under a name.
    """
    try:
        unit = _registry().Unit(expression(text))
    except Exception as error:  # pint lets any error of its tokenizer and its arithmetic through
        raise ValueError(f'"{text}" is no unit') from error
    names = tuple(unit._units)
    for name in names:
        number = (
            not _registry().Quantity(1.0, name).to_base_units().units._units
        )  # not even an angle
        if number and names not in _SHARES:
            raise ValueError(f'"{text}" has a number within')
    return unit


def _measure(text: str, unit: str | None = None):
    """The pint quantity that a text means, in SI base units; None where it means none.

    Where a speed of rotation is wanted, its own unit tells that revolutions in a minute are meant.
    """
    match = _QUANTITY.fullmatch(text) if len(text) <= LONGEST else None
    if match is None:
        return None
    own = match[2]
    if unit == "rad/s" and plain(own) in ROTATIONS:
        own = "rpm"
    try:
        # Built from number and unit apart, so that "60 degC" is a temperature and not a product.
        return _registry().Quantity(float(match[1]), _unit(own)).to_base_units()
    except (ValueError, ArithmeticError):
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
        Not a text, not a number and a unit, of another dimension, not finite, of the wrong sign, or of a size
        that there is not.
    """
    with_unit = f"{kind.noun} with its unit" if kind.unit else kind.noun
    value = _in_kind(text, kind)
    if value is None:
        raise ValueError(f'must be {with_unit}, such as "{kind.example}"{_comma(text)}')
    allowed, wanted = _SIGNS[kind.sign]
    if not (math.isfinite(value) and allowed(value)):
        raise ValueError(f'must be {kind.noun} {wanted}, such as "{kind.example}"')
    if value and kind.possible is not None and not _lies(value, kind, kind.possible):
        low, high = kind.possible
        raise ValueError(
            f'must be {kind.noun} between {low} and {high}, such as "{kind.example}"{_meant(text, kind)}'
        )
    return value


def doubt(text: str, kind: Kind) -> str | None:
    """The warning about a possible but unusual value; None for a usual one.

    Parameters
    ----------
    text : str
        The quantity, as of `parse`, which takes it.
    kind : Kind
        What it measures.
    """
    value = _in_kind(text, kind)
    if not value or kind.usual is None or _lies(value, kind, kind.usual):
        return None
    low, high = kind.usual
    lies = f"lies between {low} and {high}" if low else f"is at most {high}"
    return f"unusual, {kind.noun} {lies} as a rule{_meant(text, kind)}"


def _in_kind(text: object, kind: Kind) -> float | None:
    """A text as a number in the unit of a kind; None where its dimension differs."""
    quantity = _measure(text, kind.unit) if isinstance(text, str) else None
    # Units are compared, not dimensions: to pint "3" and "3 deg", "1 Hz" and "1 rad/s" have the same.
    target = _registry().Quantity(1.0, kind.unit)
    if quantity is None or quantity.units != target.to_base_units().units:
        return None
    return float(quantity.to(kind.unit).magnitude)


def _lies(value: float, kind: Kind, between: Range) -> bool:
    low, high = (_bound(text, kind) if text else 0.0 for text in between)
    return low <= abs(value) <= high


@cache
def _bound(text: str, kind: Kind) -> float:
    value = _in_kind(text, kind)
    if value is None:
        raise TypeError(f"{text} is not {kind.noun}")
    return value


def _comma(text: object) -> str:
    """The hint about a decimal comma, if there is one."""
    match = _DECIMAL_COMMA.fullmatch(text) if isinstance(text, str) else None
    if match is None or len(text) > LONGEST:
        return ""
    return f'; decimals follow a point, write "{match[1]}.{match[2]} {match[3]}"'


_SLIPS = {
    "m": ("mm", "um", "m", "uin"),
    "N m": ("N m", "N mm", "kN m"),
    "N": ("N", "kN"),
    "N/m": ("kN/m", "N/m"),
    "N/um": ("N/um",),
    "W": ("W", "kW"),
    "rad/s": ("rpm", "rad/s"),
    "Pa": ("MPa", "GPa", "Pa"),
    "1/Pa": ("1/GPa", "1/Pa"),
    "Pa s": ("mPa s", "Pa s"),
    "kg/m^3": ("g/cm^3", "kg/m^3"),
    "K": ("degC", "K"),
    "W/(m K)": ("W/(m K)", "mW/(m K)"),
    "J/(kg K)": ("J/(kg K)", "kJ/(kg K)"),
    "m^2/s": ("mm^2/s",),
    "s": ("h", "s"),
    "rad": ("deg", "rad"),
}
"""SI unit -> what is meant where it, or one of its multiples, is a slip."""


def _meant(text: str, kind: Kind) -> str:
    """The units with which a number would be a usual value, as a question."""
    number = _QUANTITY.fullmatch(text)[1]
    meant = []
    for unit in _SLIPS.get(kind.unit, ()):
        value = _in_kind(f"{number} {unit}", kind)
        if value and _lies(value, kind, kind.usual or kind.possible):
            meant.append(f'"{number} {unit}"')
    return f"; did you mean {' or '.join(meant)}?" if meant else ""


def parse_any(text: str) -> tuple[float, str]:
    """Read a quantity of any dimension: its value in SI base units and these units ("kg/m/s**2").

    Raises
    ------
    ValueError
        Not a number and a unit.
    """
    quantity = _measure(text) if isinstance(text, str) else None
    if quantity is None or not math.isfinite(quantity.magnitude):
        raise ValueError(f'must be a number with its unit, such as "540 MPa"{_comma(text)}')
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
    if not isinstance(text, str) or _measure(text) is None:
        raise ValueError(f'must be a number with its unit, such as "540 MPa"{_comma(text)}')
    match = _QUANTITY.fullmatch(text)
    own = match[2]
    if unit is None or unit == own:
        return float(match[1]), own
    whole, wanted = _registry().Quantity(float(match[1]), _unit(own)), _unit(unit)
    if whole.to_base_units().units != _registry().Quantity(1.0, wanted).to_base_units().units:
        raise ValueError(f'must be in a unit of the same kind as "{unit}"')
    return float(whole.to(wanted).magnitude), unit


_FINER = {"mm": "µm", "Pa s": "mPa s", "GPa": "MPa", "kN": "N", "kW": "W"}
"""Units shown for values below a twentieth of those of the examples."""


_PRINTED = (("deg", "°"), ("^2", "²"), ("^3", "³"), ("um", "µm"))
"""Parts of units as written -> as printed."""


def shown(value: float, kind: Kind) -> str:
    """A value in SI as text: in the unit of its kind's example, or a smaller one."""
    unit = kind.unit if kind.unit == "" else _QUANTITY.fullmatch(kind.example)[2]
    if kind.unit == "":
        return f"{value * 100:.4g} %"
    number = _in(value, kind.unit, unit)
    if abs(number) < 0.05 and number != 0 and unit in _FINER:
        unit = _FINER[unit]
        number = _in(value, kind.unit, unit)
    for written, printed in _PRINTED:
        unit = unit.replace(written, printed)
    return f"{number:.5g} {unit}"


def shown_like(value: float, unit: str, text: str) -> str:
    """A value in an SI unit as another quantity, given as text, is written."""
    own = _QUANTITY.fullmatch(text)[2]
    if not own:
        return f"{value:.4g}"
    return f"{_in(value, unit, own):.4g} {own}"


def _in(value: float, unit: str, other: str) -> float:
    return float(_registry().Quantity(value, unit).to(_unit(other)).magnitude)


def quantity(
    noun: str,
    unit: str,
    example: str,
    sign: str = "positive",
    possible: Range | None = None,
    usual: Range | None = None,
):
    """Make the pydantic type of a dimensional key; arguments as of `Kind`."""
    return _quantity(Kind(noun, unit, example, sign, possible, usual))


def _quantity(kind: Kind):
    def read(value: object, info: ValidationInfo) -> float:
        if info.context != SI:
            return parse(value, kind)
        if not isinstance(value, float | int):
            raise ValueError(f"must be {kind.noun} as a number in SI")
        return value

    return Annotated[float, PlainValidator(read), kind]


# Of machines and their parts, from watches to mills.
_BUILT = {"possible": ("10 um", "20 m"), "usual": ("0.1 mm", "5 m")}
_SET = {"possible": ("1e-24 m", "20 m"), "usual": ("", "1 m")}
Length = quantity("a length", "m", "305 mm", **_BUILT)
LengthOrZero = quantity("a length", "m", "20 mm", sign="not negative", **_BUILT)
Offset = quantity("a length", "m", "-0.5 mm", "any", **_SET)
FaceWidth = quantity(
    "a face width", "m", "60 mm", possible=("10 um", "5 m"), usual=("1 mm", "1.5 m")
)
Relief = quantity(
    "a relief", "m", "20 um", "not negative", ("1 nm", "5 mm"), usual=("0.5 um", "0.3 mm")
)
Radius = quantity("a radius", "m", "10 mm", possible=("1 um", "100 km"), usual=("0.1 mm", "100 m"))
Film = quantity("a film", "m", "1 um", possible=("0.1 nm", "10 mm"), usual=("1 nm", "1 mm"))
Roughness = quantity(
    "a root mean square height",
    "m",
    "0.4 um",
    possible=("0.1 nm", "0.1 mm"),
    usual=("1 nm", "5 um"),
)
"""Root mean square height Rq of a surface; 5 um is a hobbed or milled one."""

_TURN = {"possible": ("1e-24 deg", "360 deg")}
Angle = quantity("an angle", "rad", "27.5 deg", **_TURN)
AngleOrZero = quantity("an angle", "rad", "12 deg", sign="not negative", **_TURN)
Tilt = quantity("an angle", "rad", "-0.4 deg", "any", **_TURN)

Torque = quantity(
    "a torque", "N m", "30 N m", possible=("1e-9 N m", "1e9 N m"), usual=("1 N mm", "100 kN m")
)
Stiffness = quantity(
    "a stiffness",
    "N/m",
    "200 N/um",
    possible=("1e-6 N/um", "1e9 N/um"),
    usual=("0.1 N/um", "1e5 N/um"),
)
Force = quantity("a force", "N", "14 kN", possible=("1e-12 N", "1e12 N"), usual=("0.01 N", "10 MN"))
ForcePerLength = quantity(
    "a force per length",
    "N/m",
    "100 kN/m",
    possible=("1e-3 N/m", "1e6 kN/m"),
    usual=("10 N/m", "5000 kN/m"),
)
_DRIVEN = {"possible": ("1e-12 W", "1e12 W"), "usual": ("0.01 W", "100 MW")}
Power = quantity("a power", "W", "250 kW", **_DRIVEN)
PowerOrZero = quantity("a power", "W", "400 W", "not negative", **_DRIVEN)

Speed = quantity(
    "a speed of rotation",
    "rad/s",
    "1500 rpm",
    possible=("1e-9 rpm", "1e7 rpm"),
    usual=("0.01 rpm", "1e5 rpm"),
)
Spin = quantity(
    "a speed of rotation",
    "rad/s",
    "-20 rad/s",
    "any",
    ("1e-24 rad/s", "1e12 rad/s"),
    ("", "1e4 rad/s"),
)
Velocity = quantity(
    "a velocity", "m/s", "1.2 m/s", "any", ("1e-24 m/s", "3e8 m/s"), ("", "300 m/s")
)

Modulus = quantity(
    "a modulus of elasticity",
    "Pa",
    "207 GPa",
    possible=("0.1 MPa", "1500 GPa"),
    usual=("0.5 GPa", "700 GPa"),
)
"""From rubber to diamond; as a rule from polymers to carbides."""

Pressure = quantity(
    "a pressure", "Pa", "196 MPa", possible=("1 Pa", "1000 GPa"), usual=("1 kPa", "10 GPa")
)
_SHEAR = {"possible": ("1 Pa", "1000 GPa"), "usual": ("0.01 MPa", "2 GPa")}
Stress = quantity("a stress", "Pa", "3 MPa", **_SHEAR)
StressOrZero = quantity("a stress", "Pa", "100 MPa", sign="not negative", **_SHEAR)
_ALPHA = {"possible": ("1e-6 1/GPa", "1000 1/GPa"), "usual": ("0.1 1/GPa", "60 1/GPa")}
PressureViscosity = quantity("a pressure-viscosity coefficient", "1/Pa", "9.5 1/GPa", **_ALPHA)
PressureViscosityOrZero = quantity(
    "a pressure-viscosity coefficient", "1/Pa", "9.5 1/GPa", "not negative", **_ALPHA
)
_COMPRESSED = {"possible": ("1e-15 1/GPa", "1e6 1/GPa")}
PressureCoefficient = quantity("a pressure coefficient", "1/Pa", "9.5 1/GPa", **_COMPRESSED)
PressureCoefficientOrZero = quantity(
    "a pressure coefficient", "1/Pa", "9.5 1/GPa", "not negative", **_COMPRESSED
)
PressureCoefficientAnySign = quantity(
    "a pressure coefficient", "1/Pa", "3.3 1/GPa", "any", **_COMPRESSED
)
SquaredPressureCoefficient = quantity(
    "a squared pressure coefficient",
    "1/Pa^2",
    "-2.3 1/GPa^2",
    "any",
    ("1e-12 1/GPa^2", "1e12 1/GPa^2"),
)

Viscosity = quantity(
    "a dynamic viscosity",
    "Pa s",
    "0.23 Pa s",
    possible=("1e-6 Pa s", "1e6 Pa s"),
    usual=("0.2 mPa s", "100 Pa s"),
)
KinematicViscosity = quantity(
    "a kinematic viscosity",
    "m^2/s",
    "220 mm^2/s",
    possible=("0.01 mm^2/s", "1e8 mm^2/s"),
    usual=("0.5 mm^2/s", "1e4 mm^2/s"),
)
MassDensity = quantity(
    "a density of a solid",
    "kg/m^3",
    "7850 kg/m^3",
    possible=("100 kg/m^3", "25000 kg/m^3"),
    usual=("800 kg/m^3", "20000 kg/m^3"),
)
OilDensity = quantity(
    "a density of an oil",
    "kg/m^3",
    "870 kg/m^3",
    possible=("100 kg/m^3", "5000 kg/m^3"),
    usual=("600 kg/m^3", "2200 kg/m^3"),
)
Conductivity = quantity(
    "a thermal conductivity",
    "W/(m K)",
    "47 W/(m K)",
    possible=("1 mW/(m K)", "3000 W/(m K)"),
    usual=("0.1 W/(m K)", "450 W/(m K)"),
)
OilConductivity = quantity(
    "a thermal conductivity of an oil",
    "W/(m K)",
    "0.14 W/(m K)",
    possible=("1 mW/(m K)", "100 W/(m K)"),
    usual=("0.05 W/(m K)", "1 W/(m K)"),
)
SpecificHeat = quantity(
    "a specific heat",
    "J/(kg K)",
    "477 J/(kg K)",
    possible=("20 J/(kg K)", "20000 J/(kg K)"),
    usual=("100 J/(kg K)", "5000 J/(kg K)"),
)

Temperature = quantity(
    "a temperature",
    "K",
    "60 degC",
    possible=("-110 degC", "400 degC"),
    usual=("-40 degC", "160 degC"),
)
"""From the glass of thin oils to where the hottest ones decompose; as a rule where oils flow and last."""

ScuffingTemperature = quantity(
    "a scuffing temperature",
    "K",
    "250 degC",
    possible=("0 degC", "1500 degC"),
    usual=("80 degC", "700 degC"),
)
_APART = {"possible": ("1e-12 K", "1000 K"), "usual": ("0.01 K", "150 K")}
TemperatureDifference = quantity("a temperature difference", "K", "15 K", "not negative", **_APART)
ThermalConductance = quantity(
    "a thermal conductance",
    "W/K",
    "40 W/K",
    possible=("1e-6 W/K", "1e9 W/K"),
    usual=("0.1 W/K", "1e4 W/K"),
)
_BETA = {"possible": ("1e-12 1/K", "10 1/K")}
TemperatureCoefficient = quantity("a temperature coefficient", "1/K", "0.05 1/K", **_BETA)
TemperatureCoefficientOrZero = quantity(
    "a temperature coefficient", "1/K", "7.1e-4 1/K", "not negative", **_BETA
)
TemperatureCoefficientAnySign = quantity(
    "a temperature coefficient", "1/K", "3.4e-4 1/K", "any", **_BETA
)
Duration = quantity(
    "a duration", "s", "25000 h", possible=("1e-6 s", "1e7 h"), usual=("1 h", "3e5 h")
)
Share = _quantity(SHARE)
