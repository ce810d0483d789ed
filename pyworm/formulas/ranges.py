"""The ranges in which formulas hold, and the error message for values outside.

Most values outside a range are right numbers in wrong units, so the sentence always names the unit.
"""

from collections.abc import Iterable, Sequence
from math import inf
from typing import TypeVar

import numpy as np

from pyworm.formulas.arrays import Array, Values

ROUNDING = 1e-12
"""What a bound that was given in another unit may have lost by its conversion, over the bound."""

Choice = TypeVar("Choice", bound=str)


def apart(value: float, bound: float, digits: int = 6) -> str:
    """The value in so many digits, or in as many more as tell it from a bound that it is not."""
    for count in range(digits, 18):
        text = f"{value:.{count}g}"
        if value == bound or float(text) != float(f"{bound:.{count}g}"):
            return text
    return repr(value)


def numbers(name: str, value: object) -> Array:
    """A value, or several, as an array of numbers; ValueError for neither a number nor several."""
    try:
        return np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise ValueError(f"{name} = {value!r:.40}: must be a number") from None


def scalar(name: str, value: object) -> float:
    """A single number; ValueError of anything else."""
    number = numbers(name, value)
    if value is None or number.ndim:
        raise ValueError(f"{name} = {value!r:.40}: must be a number")
    return float(number)


def within(name: str, value: Values | Sequence[float], low: float, high: float, unit: str) -> None:
    """Refuse a value outside a closed range by more than the rounding of units (ValueError)."""
    if isinstance(value, float) and low <= value <= high:
        return  # as nearly always; an array of one number takes ten times as long
    values = numbers(name, value)
    above = values >= low - ROUNDING * abs(low)
    outside = ~(above & (values <= high + ROUNDING * abs(high)))
    if outside.any():
        wrong = values[outside].flat[0]
        in_unit = f" {unit}" if unit else ""
        text = apart(wrong, low if wrong < low else high)
        raise ValueError(
            f"{name} = {text}{in_unit}: must lie between {low:g} and {high:g}{in_unit}"
        )


def positive(name: str, value: Values | Sequence[float], unit: str) -> None:
    """Refuse a value that is not finite and greater than zero (ValueError); arguments as of `within`."""
    if isinstance(value, float) and 0 < value < inf:
        return
    values = numbers(name, value)
    wrong = ~(np.isfinite(values) & (values > 0))
    if wrong.any():
        in_unit = f" {unit}" if unit else ""
        raise ValueError(
            f"{name} = {values[wrong].flat[0]:g}{in_unit}: must be finite and greater than zero"
        )


def one_of(name: str, value: str, choices: Iterable[Choice]) -> Choice:
    """The choice that a word is; ValueError for a word that is not among the choices."""
    for choice in choices:
        if choice == value:
            return choice
    listed = ", ".join(f'"{choice}"' for choice in choices)
    raise ValueError(f'{name} = "{value}": must be one of {listed}')
