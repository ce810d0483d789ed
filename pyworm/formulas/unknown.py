"""A value that is not known, with the reason: what depends on it cannot be computed, all else can."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

T = TypeVar("T")


@dataclass(frozen=True)
class Unknown:
    """A value that is not known."""

    why: str
    """The reason, a clause; names the key that would give it, if there is one."""


def known(value: T | Unknown) -> T:
    """The value; ValueError with the reason where it is not known."""
    if isinstance(value, Unknown):
        raise ValueError(value.why)
    return value


def attempt(compute: Callable[[], T]) -> T | Unknown:
    """What a computation returns, or the reason of its ValueError."""
    try:
        return compute()
    except ValueError as error:
        return Unknown(str(error))


def or_none(value: T | Unknown) -> T | None:
    """The value; None where it is not known."""
    return None if isinstance(value, Unknown) else value
