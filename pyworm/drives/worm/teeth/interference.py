"""Misaligned flanks: where a worm's thread would cross the wheel's tooth beside their contact point."""

from collections.abc import Callable
from dataclasses import dataclass

from pyworm.drives.worm.teeth.first_touch import FirstTouch

PHASES = 0.0, 0.5, 1.0
"""Phases at which interference is sought; it grows towards one end of the mesh cycle."""

TOLERATED = 0.1e-6
"""Depth that is neglected [m], the rounding of a design table, far below the approach under load."""


@dataclass(frozen=True)
class Interference:
    """The place of the deepest interference of flanks held by their contact point."""

    depth: float
    """Depth of the worm in the wheel [m]; by so much the flanks stand off, and touch at this place."""
    phase: float
    """Phase of the mesh cycle."""
    x: float
    """Place along x on the contact's tangent plane [m]."""
    y: float
    """Place along y on the contact's tangent plane [m]."""


def deepest(touch_at: Callable[[float], FirstTouch | None]) -> Interference | None:
    """The deepest interference of worm and wheel without load, by where they touch first; None without."""
    found = [
        Interference(-touch.gap, phase, touch.x, touch.y)
        for phase, touch in ((phase, touch_at(phase)) for phase in PHASES)
        if touch is not None
    ]
    worst = max(found, key=lambda overlap: overlap.depth, default=None)
    return worst if worst is not None and worst.depth > TOLERATED else None
