"""Interference: where a worm's thread would cut into the wheel's tooth beside the contact point."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pyworm.drives.zi_worm.helicoid import Array
from pyworm.drives.zi_worm.tooth_outline import ToothOutline
from pyworm.scene.point import Gap

PHASES = 0.0, 0.5, 1.0
"""Phases at which it is looked for: it grows towards one end of the mesh cycle."""

NODES = 49
"""Places along each axis of the tangent plane at which the gap is looked at."""

TOLERATED = 0.1e-6
"""Depth that is none [m]: rounding of a design table, and far below what a load presses in."""


@dataclass(frozen=True)
class Interference:
    """The deepest place.

    Attributes
    ----------
    depth : float
        By which the worm reaches into the wheel [m].
    phase : float
        Of the mesh cycle.
    x, y : float
        Place on the contact's tangent plane [m].
    """

    depth: float
    phase: float
    x: float
    y: float


def deepest(
    gap_at: Callable[[float], Gap], outline_at: Callable[[float], ToothOutline]
) -> Interference | None:
    """Where worm and wheel interfere most, unloaded; None where they do not.

    Parameters
    ----------
    gap_at, outline_at : callable
        Phase -> undeformed gap over the tangent plane, and the wheel tooth's outline on it.
    """
    found = [_at(phase, gap_at(phase), outline_at(phase)) for phase in PHASES]
    worst = max(found, key=lambda one: one.depth)
    return worst if worst.depth > TOLERATED else None


def _at(phase: float, gap: Gap, outline: ToothOutline) -> Interference:
    x, y = np.meshgrid(_nodes(outline.x), _nodes(outline.y))
    opening, covered = gap(x, y)
    least = np.unravel_index(np.argmin(np.where(covered, opening, np.inf)), x.shape)
    return Interference(-float(opening[least]), phase, float(x[least]), float(y[least]))


def _nodes(outline: Array) -> Array:
    return np.linspace(outline.min(), outline.max(), NODES)
