"""What the sharing of a torque among teeth or rollers has in common."""

from collections.abc import Callable
from typing import Literal

from scipy.optimize import brentq

Sharing = Literal["elastic", "equal"]
"""How those in mesh share the torque: by their compliance, or equally."""

DOUBLINGS = 40
"""Times that a first guess is halved or doubled to enclose the root."""


def rising_root(function: Callable[[float], float], guess: float) -> float:
    """Where a function that rises through zero does so, from a positive first guess of the right size."""
    low, high = guess, guess
    for _ in range(DOUBLINGS):
        if function(low) < 0:
            break
        low /= 2
    for _ in range(DOUBLINGS):
        if function(high) > 0:
            break
        high *= 2
    return float(brentq(function, low, high, xtol=1e-15, rtol=1e-13))
