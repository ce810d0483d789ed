"""Interference of a worm's thread and the wheel's tooth beside the contact point."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pyworm.drives.zi_worm.helicoid import Array
from pyworm.drives.zi_worm.tooth_outline import ToothOutline
from pyworm.scene.point import Gap

PHASES = 0.0, 0.5, 1.0
"""Phases at which interference is sought; it grows towards one end of the mesh cycle."""

NODES = 49
"""Number of places along each axis of the tangent plane at which the gap is sampled."""

TOLERATED = 0.1e-6
"""Depth that is neglected [m], the rounding of a design table, far below the approach under load."""


@dataclass(frozen=True)
class Interference:
    """The place of the deepest interference.

    Attributes
    ----------
    depth : float
        Depth of the worm in the wheel [m].
    phase : float
        Phase of the mesh cycle.
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
    """Find the deepest interference of unloaded worm and wheel; None where there is none.

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
