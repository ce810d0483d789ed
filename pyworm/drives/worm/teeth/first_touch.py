"""Where flanks without load touch first: at their contact point, or at an edge where they are misaligned."""

from dataclasses import dataclass

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.scene.point import Gap

NODES = 49
"""Places along each side of the wheel's tooth at which the gap is sampled first."""

FINER = 17
"""Places along each side of the neighbourhood of the least of them, in which it is sampled again, twice."""


@dataclass(frozen=True)
class FirstTouch:
    """The place of the least gap between a worm's thread and a wheel's tooth."""

    x: float
    """Place along x on the contact's tangent plane [m]."""
    y: float
    """Place along y on the contact's tangent plane [m]."""
    gap: float
    """Gap there without load where the flanks are as their contact point has them [m]; negative where they
    would cross, and touch at this place instead."""


def first_touch(gap: Gap, rim_x: Array, rim_y: Array) -> FirstTouch | None:
    """The place of the least gap within a tooth's outline [m]; None where worm and wheel do not face."""
    x, y = (np.linspace(side.min(), side.max(), NODES) for side in (rim_x, rim_y))
    found = _least(gap, x, y)
    for _ in range(2):
        if found is None:
            return None
        steps = x[1] - x[0], y[1] - y[0]
        x, y = (
            place + step * np.linspace(-1, 1, FINER)
            for place, step in zip((found.x, found.y), steps, strict=True)
        )
        found = _least(gap, x, y)
    return found


def _least(gap: Gap, x: Array, y: Array) -> FirstTouch | None:
    opening, covered = gap(*np.meshgrid(x, y, indexing="ij"))
    known = np.where(covered & np.isfinite(opening), opening, np.inf)
    i, j = np.unravel_index(np.argmin(known), known.shape)
    if known[i, j] == np.inf:
        return None
    return FirstTouch(float(x[i]), float(y[j]), float(known[i, j]))
