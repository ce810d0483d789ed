"""A straight round shaft on two simple supports, loaded at one place between them."""

from dataclasses import dataclass
from math import inf, pi


@dataclass(frozen=True)
class Bending:
    """A shaft at the place of its load, in one plane."""

    deflection: float
    """Deflection along the force [m]."""
    slope: float
    """Derivative of the deflection along the shaft [rad]."""
    reactions: tuple[float, float]
    """Forces of the two supports on the shaft, along the same direction [N]."""


def second_moment(diameter: float) -> float:
    """Second moment of area of a round section of a diameter [m], pi d^4 / 64 [m4]."""
    return pi * diameter**4 / 64


def support_forces(
    force: float, moment: float, before: float, beyond: float
) -> tuple[float, float]:
    """Forces of two supports on a shaft under a force [N] and a moment [N m] as of `bending`, in order."""
    last = -(force * before + moment) / (before + beyond)
    return -force - last, last


def bending(
    force: float,
    moment: float,
    before: float,
    beyond: float,
    rigidity: float,
    stiffness: float = inf,
) -> Bending:
    """Bending of a uniform shaft by a force F [N] and a moment M [N m] at one place between its supports.

    With a and b before and beyond the load [m] and L = a + b they give there

        w = (F a^2 b^2 + M a b (b - a)) / (3 E I L),   w' = (F a b (b - a) + M (a^2 - a b + b^2)) / (3 E I L)

    where M turns towards larger slopes (Bernoulli and Euler; J. E. Shigley and C. R. Mischke, Mechanical
    Engineering Design, 1989, table A-9, cases 6 and 8). Supports that yield (`stiffness` of each [N/m]) move
    the shaft as a rigid one besides; `rigidity` is E I [N m2].
    """
    span = before + beyond
    crossed = before * beyond * (beyond - before)
    deflection = force * before**2 * beyond**2 + moment * crossed
    slope = force * crossed + moment * (before**2 - before * beyond + beyond**2)
    first, last = support_forces(force, moment, before, beyond)
    sunk, rise = -first / stiffness, (first - last) / stiffness / span
    flexible = 3 * rigidity * span
    return Bending(
        deflection / flexible + sunk + rise * before, slope / flexible + rise, (first, last)
    )
