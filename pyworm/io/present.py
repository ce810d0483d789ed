"""Values that are missing elsewhere and are there where they are asked for."""

from typing import TypeVar

T = TypeVar("T")


def present(value: T | None, name: str) -> T:
    """A value that is there.

    Parameters
    ----------
    value : any
        The value.
    name : str
        What it is called in case files or in Python, such as "oil.heat".

    Raises
    ------
    ValueError
        It is missing.
    """
    if value is None:
        raise ValueError(f"{name} is missing: needed here, and not given")
    return value
