"""Numbers with units of any dimension, such as "540 MPa"."""

import math
import re
from functools import cache

from pyworm.io.unit_table import Unit, product
from pyworm.io.unit_text import MEANT, factors, plain

_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*")

_COMMA = re.compile(r"\s*([+-]?\d+(?:[. ']\d{3})*),(\d+)(?![\d,.])\s*(.*?)\s*")

_BLANKS = re.compile(r"\s*([+-]?\d{1,3}(?:[ ']\d{3})+(?:\.\d+)?)\s*([^\d\s].*?)\s*")

MAX_QUANTITY_LENGTH = 200
"""Characters of the longest quantity that is read."""


def number_and_unit(text: str) -> tuple[str, str] | None:
    """Number and unit of a quantity, both as they are written; None where there are no such two."""
    match = _QUANTITY.fullmatch(text) if len(text) <= MAX_QUANTITY_LENGTH else None
    return None if match is None else (match[1], match[2])


def measure(text: str, unit: str | None = None) -> tuple[float, Unit] | None:
    """The number that a text means in SI base units, and its unit; None where it means none.

    Where a unit is wanted, what people write for it is understood: "1/min" of a speed of rotation is
    revolutions, "C" of a temperature degrees.
    """
    parts = number_and_unit(text)
    if parts is None:
        return None
    number, written = parts
    written = MEANT.get(unit or "", {}).get(plain(written), written)
    try:
        meant = unit_of(written)
    except ValueError:
        return None
    return float(number) * meant.factor + meant.zero, meant


def converted(value: float, unit: str, other: str) -> float:
    """A value in one unit as a number in another of the same kind."""
    before, after = unit_of(unit), unit_of(other)
    return (value * before.factor + before.zero - after.zero) / after.factor


def parse_any(text: str) -> tuple[float, str]:
    """Value in SI base units, and these units ("kg/m/s**2"), of a text; ValueError if it is not such."""
    measured = measure(text) if isinstance(text, str) else None
    if measured is None or not math.isfinite(measured[0]):
        raise ValueError(f'must be a number with its unit, such as "540 MPa"{number_hint(text)}')
    value, unit = measured
    return value, unit.base


def parse_in(text: str, unit: str | None = None) -> tuple[float, str]:
    """Number of a text in a unit, by default the one that it is written with, and that unit.

    ValueError if it is not a number and a unit, or of another dimension.
    """
    parts = number_and_unit(text) if isinstance(text, str) else None
    if parts is None or measure(text) is None:
        raise ValueError(f'must be a number with its unit, such as "540 MPa"{number_hint(text)}')
    number, written = parts
    if unit is None or unit == written:
        return float(number), written
    if unit_of(written).powers != unit_of(unit).powers:
        raise ValueError(f'must be in a unit of the same kind as "{unit}"')
    return converted(float(number), written, unit), unit


def number_hint(text: object) -> str:
    """The hint about a comma or blanks in a number, to be added to a message; empty where there are none."""
    if not isinstance(text, str) or len(text) > MAX_QUANTITY_LENGTH:
        return ""
    comma, blanks = _COMMA.fullmatch(text), _BLANKS.fullmatch(text)
    if blanks is not None:
        number = re.sub("[ ']", "", blanks[1])
        return f'; thousands stand together, write "{number} {blanks[2]}"'
    if comma is None:
        return ""
    before, after, unit = re.sub("[. ']", "", comma[1]), comma[2], comma[3]
    other = f' or "{before}{after} {unit}"' if len(after) == 3 and before == comma[1] else ""
    return f'; decimals follow a point, not a comma, write "{before}.{after} {unit}"{other}'


@cache
def unit_of(text: str) -> Unit:
    """The unit that a text means; ValueError if it means none."""
    return product(factors(text))
