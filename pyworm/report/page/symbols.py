"""Symbols of the standards with their values: theta_B_C 106.5 is theta_B = 106.5 °C."""

from pyworm.io.html import GREEK
from pyworm.io.quantities import read_key
from pyworm.io.quantity_text import short
from pyworm.ratings.rating import Safety, Value


def named(symbol: str) -> str:
    """The symbol of a safety: S_B_simulated is S_B."""
    return symbol.removesuffix("_simulated")


def inputs_as_text(safety: Safety) -> str:
    """The inputs of a safety with their units, or why there are none, in a line."""
    if safety.value is None:
        return safety.why[:1].upper() + safety.why[1:]
    return "; ".join(_input(key, value) for key, value in safety.inputs.items() if value != "")


def _input(key: str, value: Value) -> str:
    if value is None or isinstance(value, str):
        return f"{_words(key)}: {value}"
    name, factor, unit = read_key(key)
    return f"{_words(name)} = {short(value * factor)}\N{NO-BREAK SPACE}{unit}".rstrip()


def _words(key: str) -> str:
    """A key without its unit: a symbol with its index, or words."""
    first, *more = key.split("_")
    if not more or not (first in GREEK or len(first) == 1):
        return key.replace("_", " ")
    index, *rest = more
    if len(rest) == 1 and len(rest[0]) == 1:
        return f"{first}_{index},{rest[0]}"
    return " ".join((f"{first}_{index}", *rest))
