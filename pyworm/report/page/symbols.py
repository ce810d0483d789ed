"""Symbols of the standards as they are printed: theta_B_C 106.5 becomes θ with the index B, 106.5 °C."""

import re
from html import escape

from pyworm.io.quantities import read_key
from pyworm.io.quantity_text import short
from pyworm.ratings.rating import Safety, Value

_GREEK = {
    "alpha": "α", "delta": "δ", "gamma": "γ", "lambda": "λ", "mu": "µ", "rho": "ρ", "sigma": "σ", "tau": "τ",
    "theta": "θ",
}  # fmt: skip

_INDEXED = re.compile(rf"\b({'|'.join(_GREEK)}|Ra|[A-Za-z])_([A-Za-z0-9]+(?:,[a-z]\b)?)(\*?)")
_ALONE = re.compile(r"\b(lambda|mu|sigma|gamma)\b")


def typeset(text: str) -> str:
    """Text as HTML, its symbols in Greek and with their indices lowered."""
    lowered = _INDEXED.sub(_lowered, escape(text))
    return _ALONE.sub(lambda found: _GREEK[found[0]], lowered)


def _lowered(found: re.Match) -> str:
    index = _GREEK.get(found[2], found[2])
    return f"{_GREEK.get(found[1], found[1])}<sub>{index}</sub>{found[3]}"


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
    if not more or not (first in _GREEK or len(first) == 1):
        return key.replace("_", " ")
    index, *rest = more
    if len(rest) == 1 and len(rest[0]) == 1:
        return f"{first}_{index},{rest[0]}"
    return " ".join((f"{first}_{index}", *rest))
