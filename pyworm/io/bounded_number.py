"""Bounds of the numbers in files: larger whole numbers have no float, and what is not finite has no size.

What a number may be as a length or as a count is the business of its key; every number of a file is within
these bounds before anything asks for that.
"""

import json
from math import isfinite
from typing import Any

LARGEST_INTEGER = 2**63 - 1
"""Largest size of a whole number: that of 64 bits, which TOML and NetCDF have."""


def fault_of(value: object) -> str | None:
    """What would be right in place of a number out of bounds; None for all else."""
    if isinstance(value, int) and abs(value) > LARGEST_INTEGER:
        return f"whole numbers lie between -{LARGEST_INTEGER} and {LARGEST_INTEGER}"
    if isinstance(value, float) and not isfinite(value):
        return "must be finite"
    return None


def read_json(text: str | bytes) -> Any:
    """The content of a JSON text; ValueError if it is none, or a whole number in it is out of bounds.

    NaN and infinity are read, as Python writes them: a solution that did not converge may hold them.
    """
    return json.loads(text, parse_int=_integer)


def _integer(text: str) -> int:
    value = int(text)
    if fault_of(value) is not None:
        raise ValueError(f"a whole number of {len(text.lstrip('-'))} digits")
    return value
