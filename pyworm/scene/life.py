"""The life of a contact: its states from its first touch to its last."""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from typing import Generic, TypeVar

import numpy as np

from pyworm.formulas.arrays import Array

Contact = TypeVar("Contact")

TIME_STEP_RATIO = 1e-5
"""Part of a life over which the turning of its axes is differenced."""


def unturned(seconds: float) -> Array:
    """Axes of contacts whose axes do not turn."""
    return np.eye(3)


@dataclass(frozen=True)
class Life(Generic[Contact]):
    """The states of a contact from its first touch to its last."""

    duration: float
    """Time from the first touch to the last [s]."""
    at: Callable[[float], Contact]
    """Time since the first touch [s] -> the contact then, in axes that move with the contact point;
    ValueError where it carries no load."""
    axes_at: Callable[[float], Array] = unturned
    """Time -> x, y and normal of the tangent plane, as rows in a frame at rest."""
    kinks: tuple[float, ...] = ()
    """Times between which its changes are smooth, where they are known [s]."""
    touch: float = inf
    """Load from which on surfaces that come together carry that of the contact, whatever the separation given
    [N], of a line contact for each length [N/m]; inf where a separation that is given holds."""
    touched: float = 0.0
    """Time from which its films begin with a steady one where those before are not found [s]."""

    def turning(self, seconds: float) -> float:
        """Angular velocity of the axes about the normal [rad/s], positive from x to y."""
        before = max(seconds - TIME_STEP_RATIO * self.duration, 0.0)
        after = min(seconds + TIME_STEP_RATIO * self.duration, self.duration)
        x_before, x_after = self.axes_at(before)[0], self.axes_at(after)[0]
        return float((x_after - x_before) @ self.axes_at(seconds)[1]) / (after - before)


@dataclass(frozen=True)
class Past(Generic[Contact]):
    """The present of a contact in its life."""

    life: Life[Contact]
    """Its life."""
    seconds: float
    """Time since the first touch [s]."""
    until: float | None = None
    """Time up to which all its films are wanted [s]; None where those up to the present suffice."""

    @property
    def last(self) -> float:
        """Time up to which films are wanted [s]."""
        return self.seconds if self.until is None else self.until

    def before(self, seconds: float) -> Contact:
        """The contact some time before the present [s]; ValueError where it carried no load."""
        return self.life.at(self.seconds - seconds)
