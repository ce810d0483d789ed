"""Values that are missing elsewhere and are there where they are asked for."""

from typing import TypeVar

T = TypeVar("T")


def present(value: T | None, name: str) -> T:
    """A value that is there; ValueError with its name, such as "oil.heat", if it is missing."""
    if value is None:
        raise ValueError(f"{name} is missing: needed here, and not given")
    return value
