"""A chapter of the page of constants: one module or table, its standard."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from constant_slips import Check, Subject

TRANSCRIBED = "one transcription"
MEMORY = "memory"
READ = "read"
OURS = "ours"

KNOWLEDGE = {
    READ: "seen in the named source, or in two independent public programs",
    TRANSCRIBED: "seen in one public program only (mostly the worm gear worksheet of MITCalc); the "
    "standard's text was not read",
    MEMORY: "written from memory; neither the standard nor a transcription was seen",
    OURS: "chosen or fitted in this project",
}
"""Ways a number is known, from the surest to those that no text stands behind."""


@dataclass(frozen=True)
class Clause:
    """What a table or function is in its standard, and how it is known."""

    words: str
    known: str


@dataclass(frozen=True, eq=False)
class Chapter:
    """Numbers of one subject with the checks they must pass.

    `results` are what users get of it in usual conditions: they tell how much an unseen slip would move.
    """

    title: str
    subject: Subject
    source: str
    clauses: Mapping[str, Clause]
    checks: tuple[Check, ...]
    results: Callable[[Any], Sequence[float]]


def within_factor(value: float, other: float, factor: float) -> bool:
    """Whether two positive numbers differ by no more than a factor."""
    return value > 0 and other > 0 and max(value / other, other / value) <= factor


def falls(values) -> bool:
    """Whether a sequence never rises, but for rounding, and ends below its beginning."""
    values = list(values)
    return values[-1] < values[0] and all(
        after <= before * (1 + 1e-9) for before, after in pairwise(values)
    )


def rises(values) -> bool:
    """Whether a sequence never falls, but for rounding, and ends above its beginning."""
    return falls(reversed(list(values)))
