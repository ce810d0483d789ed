"""Quantities of a known kind: "14 kN" in a case file becomes the force of 14000.0.

Each kind has two ranges. Beyond the possible one a value is refused: nothing is built or flows so, and
products of powers of such values overflow. Beyond the usual range it is accepted with a warning.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Literal

from pyworm.io.number_with_unit import measure, number_and_unit, number_hint, unit_of

Sign = Literal["positive", "not negative", "any"]
"""Which values of a kind are taken."""

_SIGNS: dict[Sign, tuple[Callable[[float], bool], str]] = {
    "positive": (lambda value: value > 0, "greater than zero"),
    "not negative": (lambda value: value >= 0, "zero or more"),
    "any": (lambda value: True, "that is finite"),
}

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
    "kg": ("kg",),
    "kg m^2": ("kg mm^2", "kg m^2"),
    "kg/m^3": ("g/cm^3", "kg/m^3"),
    "K": ("degC", "K"),
    "delta_degC": ("K",),
    "W/(m K)": ("W/(m K)", "mW/(m K)"),
    "J/(kg K)": ("J/(kg K)", "kJ/(kg K)"),
    "m^2/s": ("mm^2/s",),
    "m^3/s": ("l/min",),
    "s": ("h", "s"),
    "rad": ("deg", "rad"),
}
"""SI unit -> what is meant where it, or one of its multiples, is a slip."""

Range = tuple[str, str]
"""Two quantities, smallest and largest size, as shown to the user."""


@dataclass(frozen=True)
class Kind:
    """Kind of quantity of a value: its dimension, ranges and the words of messages."""

    noun: str
    """What it is called, article included ("a force")."""
    unit: str
    """The SI unit it is kept in; empty for a share."""
    example: str
    """A right value, to be shown beside a wrong one."""
    sign: Sign = "positive"
    """Which values are taken: "positive", "not negative" or "any"."""
    possible: Range | None = None
    """Sizes between which every value lies that is not zero."""
    usual: Range | None = None
    """Sizes beyond which a value gives a warning, the smallest empty where none is too small; by default
    none."""


SHARE_KIND = Kind("a share", "", "1 %", possible=("1e-12 %", "1000 %"))


def parse(text: object, kind: Kind) -> float:
    """The value in `kind.unit` of a text such as "14 kN".

    ValueError of what is not a text, not a number and a unit, of another dimension, not finite, of the wrong
    sign, or of an impossible size.
    """
    with_unit = f"{kind.noun} with its unit" if kind.unit else kind.noun
    value = _in_kind(text, kind)
    if value is None:
        raise ValueError(
            f'must be {with_unit}, such as "{kind.example}"{number_hint(text) or _case_hint(text, kind)}'
        )
    allowed, wanted = _SIGNS[kind.sign]
    if not (math.isfinite(value) and allowed(value)):
        raise ValueError(f'must be {kind.noun} {wanted}, such as "{kind.example}"')
    if value and kind.possible is not None and not _lies(value, kind, kind.possible):
        low, high = kind.possible
        raise ValueError(
            f'must be {kind.noun} between {low} and {high}, such as "{kind.example}"{_meant(text, kind)}'
        )
    return value


def possible(value: float, kind: Kind) -> bool:
    """Whether `parse` would take a value that is given in `kind.unit` already."""
    allowed, _ = _SIGNS[kind.sign]
    return (
        math.isfinite(value)
        and allowed(value)
        and (not value or kind.possible is None or _lies(value, kind, kind.possible))
    )


def doubt(text: str, kind: Kind) -> str | None:
    """The warning about a possible but unusual value, a text that `parse` takes; None for a usual one."""
    value = _in_kind(text, kind)
    if not value or kind.usual is None or _lies(value, kind, kind.usual):
        return None
    low, high = kind.usual
    lies = f"lies between {low} and {high}" if low else f"is at most {high}"
    return f"unusual, {kind.noun} {lies} as a rule{_meant(text, kind)}"


def _case_hint(text: object, kind: Kind) -> str:
    """The question whether a unit is meant with other capitals, "14 KN" as "14 kN"; empty where it is not."""
    parts = number_and_unit(text) if isinstance(text, str) else None
    if parts is None:
        return ""
    number, written = parts
    for unit in (written.replace("K", "k"), written.lower(), written[:1] + written[1:].lower()):
        if unit != written and _in_kind(f"{number} {unit}", kind) is not None:
            return f'; did you mean "{number} {unit}"?'
    return ""


def _in_kind(text: object, kind: Kind) -> float | None:
    """A text as a number in the unit of a kind; None where its dimension differs."""
    measured = measure(text, kind.unit) if isinstance(text, str) else None
    if measured is None:
        return None
    value, written = measured
    unit = unit_of(kind.unit)
    return value / unit.factor if written.powers == unit.powers else None


def _lies(value: float, kind: Kind, between: Range) -> bool:
    low, high = (_bound(text, kind) if text else 0.0 for text in between)
    return low <= abs(value) <= high


@cache
def _bound(text: str, kind: Kind) -> float:
    value = _in_kind(text, kind)
    if value is None:
        raise TypeError(f"{text} is not {kind.noun}")
    return value


def _meant(text: object, kind: Kind) -> str:
    """The units with which a number would be a usual value, as a question."""
    parts = number_and_unit(text) if isinstance(text, str) else None
    usual = kind.usual or kind.possible
    if parts is None or usual is None:
        return ""
    number, _ = parts
    meant = []
    for unit in _SLIPS.get(kind.unit, ()):
        value = _in_kind(f"{number} {unit}", kind)
        if value and _lies(value, kind, usual):
            meant.append(f'"{number} {unit}"')
    return f"; did you mean {' or '.join(meant)}?" if meant else ""
