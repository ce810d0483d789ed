"""Numbers with units of any dimension: "540 MPa" measured by pint.

Pint is imported at the first quantity only, since it takes longer to load than a case to check.
"""

import math
import re
from functools import cache

from pyworm.io.unit_text import ROTATIONS, expression, plain

_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*")

_DECIMAL_COMMA = re.compile(r"\s*([+-]?\d+),(\d+)(?![\d,])\s*(.*?)\s*")

LONGEST = 200
"""Characters of the longest quantity that is read."""

_SHARES = (("percent",), ("ppm",))
"""Units that are numbers."""


def number_and_unit(text: str) -> tuple[str, str] | None:
    """Number and unit of a quantity, both as they are written; None where there are no such two."""
    match = _QUANTITY.fullmatch(text) if len(text) <= LONGEST else None
    return None if match is None else (match[1], match[2])


def measure(text: str, unit: str | None = None):
    """The pint quantity that a text means, in SI base units; None where it means none.

    Where a speed of rotation is wanted, its unit distinguishes revolutions per minute.
    """
    parts = number_and_unit(text)
    if parts is None:
        return None
    number, own = parts
    if unit == "rad/s" and plain(own) in ROTATIONS:
        own = "rpm"
    try:
        # Built from number and unit apart, so that "60 degC" is a temperature and not a product.
        return _registry().Quantity(float(number), _unit(own)).to_base_units()
    except (ValueError, ArithmeticError):
        return None


def base_unit(unit: str):
    """The pint unit in SI base units that a unit of a case file or of SI comes down to.

    Raises
    ------
    ValueError
        It is none.
    """
    return _registry().Quantity(1.0, _unit(unit)).to_base_units().units


def converted(value: float, unit: str, other: str) -> float:
    """A value in one unit as a number in another of the same kind."""
    return float(_registry().Quantity(value, _unit(unit)).to(_unit(other)).magnitude)


def parse_any(text: str) -> tuple[float, str]:
    """Read a quantity of any dimension: its value in SI base units and these units ("kg/m/s**2").

    Raises
    ------
    ValueError
        Not a number and a unit.
    """
    quantity = measure(text) if isinstance(text, str) else None
    if quantity is None or not math.isfinite(quantity.magnitude):
        raise ValueError(f'must be a number with its unit, such as "540 MPa"{comma_hint(text)}')
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
    if not isinstance(text, str) or measure(text) is None:
        raise ValueError(f'must be a number with its unit, such as "540 MPa"{comma_hint(text)}')
    number, own = number_and_unit(text)
    if unit is None or unit == own:
        return float(number), own
    if base_unit(own) != base_unit(unit):
        raise ValueError(f'must be in a unit of the same kind as "{unit}"')
    return converted(float(number), own, unit), unit


def comma_hint(text: object) -> str:
    """The hint about a decimal comma, to be added to a message; empty where there is none."""
    match = _DECIMAL_COMMA.fullmatch(text) if isinstance(text, str) else None
    if match is None or len(text) > LONGEST:
        return ""
    return f'; decimals follow a point, write "{match[1]}.{match[2]} {match[3]}"'


@cache
def _registry():
    import pint

    return pint.UnitRegistry()


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
