"""Common parts of the sharing of a torque among teeth or rollers."""

from collections.abc import Callable
from typing import Literal

import scipy

Sharing = Literal["elastic", "equal"]
"""Sharing of the torque among teeth or rollers in mesh: by compliance, or equally."""

DOUBLINGS = 40
"""Largest number of halvings or doublings of an initial guess to bracket the root."""


def rising_root(function: Callable[[float], float], guess: float) -> float:
    """Root of a rising function, from a positive initial guess of the right order."""
    low, high = guess, guess
    for _ in range(DOUBLINGS):
        if function(low) < 0:
            break
        low /= 2
    for _ in range(DOUBLINGS):
        if function(high) > 0:
            break
        high *= 2
    return float(scipy.optimize.brentq(function, low, high, xtol=1e-15, rtol=1e-13))
