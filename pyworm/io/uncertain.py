"""Quantities with their uncertainty: "0.4 um +- 0.1 um", "15 N +- 2 %", "206 nm to 212 nm"."""

import math
import re
from dataclasses import dataclass

from pyworm.io.number_with_unit import converted, number_hint, parse_in, unit_of

EXAMPLE = '"0.4 um +- 0.1 um", "15 N +- 2 %" or "206 nm to 212 nm"'
"""Quantities with their uncertainty as messages show them."""

UNIFORM = math.sqrt(3.0)
"""Half width over standard deviation of a uniform distribution."""

_PLUS_MINUS = re.compile(r"(.+?)\s*(?:\+-|\+/-|±)\s*(.+)")
_BETWEEN = re.compile(r"(.+?)\s+to\s+(.+)")


@dataclass(frozen=True)
class Uncertain:
    """A quantity and its standard uncertainty, both in the unit in which it is written."""

    value: float
    """Best estimate."""
    standard: float
    """Standard uncertainty (one standard deviation); of temperatures a difference."""
    unit: str
    """Unit as written, empty without one."""

    def moved(self, steps: float = 0.0) -> str | float:
        """The quantity moved by some standard uncertainties, as a case file has it; a number without unit."""
        number = float(f"{self.value + steps * self.standard:.12g}")
        return f"{number:.12g} {self.unit}" if self.unit else number

    def in_unit(self, unit: str) -> "Uncertain":
        """The quantity in another unit of the same kind.

        Raises:
            ValueError: A unit of another kind.
        """
        if unit_of(self.unit).powers != unit_of(unit).powers:
            raise ValueError(f'must be in a unit of the same kind as "{unit}"')
        value = converted(self.value, self.unit, unit)
        width = self.standard * unit_of(self.unit).factor / unit_of(unit).factor
        return Uncertain(value, width, unit)


def parse_uncertain(written: object) -> Uncertain:
    """A quantity with its uncertainty, of any kind.

    "A +- B" gives the standard uncertainty B, in the unit of A, as its difference or in per cent of A;
    "A to B" a uniform distribution between the two, whose standard uncertainty is a half of the width over
    the square root of 3. One without either, or a plain number, is exact.

    Raises:
        ValueError: No such text, an uncertainty of another kind, or a negative one, a range from large to
            small, or what is not finite.
    """
    if isinstance(written, int | float) and not isinstance(written, bool):
        return _finite(Uncertain(float(written), 0.0, ""), str(written))
    if not isinstance(written, str):
        raise ValueError(f"must be a quantity with its uncertainty, such as {EXAMPLE}")
    text = written.strip()
    if match := _PLUS_MINUS.fullmatch(text):
        value, unit = _quantity(match[1])
        return _finite(Uncertain(value, _width(match[2], value, unit), unit), text)
    if match := _BETWEEN.fullmatch(text):
        unit = _quantity(match[2])[1]
        first, last = _in_unit(match[1], unit), _quantity(match[2])[0]
        if not first < last:
            raise ValueError(f'"{text}": must be a range from the smaller value to the larger one')
        return _finite(Uncertain((first + last) / 2, (last - first) / 2 / UNIFORM, unit), text)
    value, unit = _quantity(text)
    return _finite(Uncertain(value, 0.0, unit), text)


def _quantity(text: str) -> tuple[float, str]:
    """Number and unit of a text."""
    try:
        return parse_in(text.strip())
    except ValueError:
        raise ValueError(
            f'"{text.strip()}": must be a quantity, such as {EXAMPLE}{number_hint(text)}'
        ) from None


def _in_unit(text: str, unit: str) -> float:
    """Number in a unit of a text, which may have none of its own: "206" of "206 to 212 nm"."""
    value, written = _quantity(text)
    if written and unit_of(written).powers != unit_of(unit).powers:
        raise ValueError(f'"{text.strip()}": must be in a unit of the same kind as "{unit}"')
    return converted(value, written, unit) if written else value


def _width(text: str, value: float, unit: str) -> float:
    """Standard uncertainty in the unit of a value: in per cent of it, or a difference of its kind."""
    width, written = _quantity(text)
    if written == "%" and unit != "%":
        if unit_of(unit).zero:
            raise ValueError(
                f'"{text.strip()}": must be a difference in K, not in per cent of {unit}'
            )
        width, written = abs(value) * width / 100, unit
    if unit_of(written or unit).powers != unit_of(unit).powers:
        wanted = (
            f'in a unit of the same kind as "{unit}"' if unit else "without unit, as its value is"
        )
        raise ValueError(f'"{text.strip()}": must be {wanted}, or in %')
    if width < 0:
        raise ValueError(f'"{text.strip()}": must be zero or more')
    return width * unit_of(written or unit).factor / unit_of(unit).factor


def _finite(found: Uncertain, text: str) -> Uncertain:
    if not (math.isfinite(found.value) and math.isfinite(found.standard)):
        raise ValueError(f'"{text}": must be finite')
    return found
