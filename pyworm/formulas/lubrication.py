"""Lubrication regimes by the film over the composite roughness, lambda: full, mixed or boundary.

The bounds 3 and 1 are the field's (T. E. Tallian, ASLE Trans. 10 (1967) 418-439; B. J. Hamrock, S. R. Schmid
and B. O. Jacobson, Fundamentals of Fluid Film Lubrication (2004)), from memory. They are rough: by a fit to
the partial elastohydrodynamic films of Patir and Cheng, exp(-1.8 lambda^1.2), asperities carry 0.12 % of the
load at a central lambda of 3, 1.6 % at 2 and 17 % at 1; D. Zhu and Q. J. Wang, Proc. IMechE J 226 (2012)
1010-1022, find such bounds quantitatively wrong.
"""

from math import isfinite
from typing import Literal

FULL_FILM = 3.0
"""lambda from which surfaces count as separated."""

BOUNDARY = 1.0
"""lambda below which they count as touching nearly everywhere."""

CARRIED = 0.9
"""Share of the load on asperities, where it is simulated, from which lubrication is boundary: oil carries
what little is left. Below it both carry, whatever lambda is (our convention)."""

Lubrication = Literal["full", "unknown", "mixed", "boundary"]

BY_SEVERITY: tuple[Lubrication, ...] = ("full", "unknown", "mixed", "boundary")
"""The regimes, from the one whose simulated friction may be believed to the one where it may be least."""


def lubrication(
    central: float | None, least: float | None, share: float | None = None
) -> Lubrication:
    """The regime of a contact: by its central film, in which its load is carried, and by its minimum film.

    "boundary" below a central film of 1 composite roughness, with a `share` of the load on asperities from
    0.9 on, "mixed" below 3 or where the minimum is below 1, else "full"; "unknown" without both films, or
    with negative ones, which no film has. A lambda below 1 does not show how much asperities carry, from 10 %
    to all; a simulated share does.
    """
    if central is None or least is None or not (isfinite(central) and min(central, least) >= 0):
        return "unknown"
    if central < BOUNDARY if share is None else share >= CARRIED:
        return "boundary"
    return "mixed" if central < FULL_FILM or least < BOUNDARY else "full"


def full_film_roughness(central: float, least: float) -> float:
    """The composite roughness [m] up to which a film [m], at its centre and least, counts as full."""
    return min(central / FULL_FILM, least / BOUNDARY)
