"""Values of a case file's content at dotted keys, places in lists in brackets: "motion.velocity_1[0]"."""

import re
from collections.abc import Mapping
from copy import deepcopy
from itertools import pairwise
from typing import Any

from pyworm.io.input_error import CaseError

_STEP = re.compile(r"([^.\[\]]+)((?:\[\d+\])*)")
"""A table's key, and places in lists after it."""


def with_values(content: dict[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """The content of a case file with some values replaced, by dotted key; missing tables are created.

    Raises:
        CaseError: What is no dotted key, or leads through what is no table or list.
    """
    changed = deepcopy(content)
    for key, value in values.items():
        _put(changed, key, value)
    return changed


def value_at(content: Mapping[str, Any], key: str) -> Any:
    """The value of a case file's content at a dotted key.

    Raises:
        CaseError: What is no dotted key, or one that the content has not.
    """
    inner: Any = content
    for step in _steps(key):
        inner = _inner(inner, step, key)
    return inner


def _steps(key: str) -> list[str | int]:
    """Keys of tables and places in lists on the way to a value."""
    steps: list[str | int] = []
    for part in key.split("."):
        match = _STEP.fullmatch(part)
        if match is None:
            raise CaseError(f'"{key}": must be a dotted key, such as "motion.velocity_1[0]"')
        steps += [match[1], *(int(place) for place in re.findall(r"\d+", match[2]))]
    return steps


def _put(content: dict[str, Any], key: str, value: Any) -> None:
    """Set the value at a dotted key; missing tables are created, for the case to check."""
    steps = _steps(key)
    inner: Any = content
    for step, following in pairwise(steps):
        if isinstance(inner, dict) and not isinstance(following, int):
            inner.setdefault(step, {})
        inner = _inner(inner, step, key)
    _inner(inner, steps[-1], key, there=False)
    inner[steps[-1]] = value


def _inner(outer: Any, step: str | int, key: str, there: bool = True) -> Any:
    """The entry of a table or a list at one part of a key."""
    if isinstance(step, int):
        if not (isinstance(outer, list) and step < len(outer)):
            raise CaseError(f'"{key}": the case has no list with a place [{step}] there')
        return outer[step]
    if not isinstance(outer, dict) or (there and step not in outer):
        raise CaseError(f'"{key}": the case has no table with {step} there')
    return outer.get(step)
