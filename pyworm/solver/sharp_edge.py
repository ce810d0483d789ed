"""Whether a contact rests on a sharp edge of its surfaces, where the pressure is unbounded.

At a sharp edge the elastic pressure grows without bound as the grid is refined (Johnson, Contact Mechanics,
1985, section 2.4), and no film converges there; a relieved edge has no such pressure.
"""

import numpy as np

from pyworm.io.plain_dataset import PlainDataset

LEAST_RATIO = 0.3
"""Least ratio of the dry pressure beside an edge to the largest for a contact that rests on it."""

CURE = (
    "; the load rests on a sharp edge of the surfaces, where pressure has no bound: ease the edge, as tip "
    "relief of teeth does (tip_relief, tip_relief_length), or keep the contact within the surfaces, by more "
    "crowning or less load"
)
"""Advice that a stop reason adds then."""


def rests_on_edge(fields: PlainDataset) -> bool:
    """Whether the dry pressure of a solution's fields is large beside the end of a surface.

    Parameters
    ----------
    fields : PlainDataset
        Fields of a solution; "dry_pressure" [Pa], or "pressure" where there is none, and "covered".
    """
    if "covered" not in fields:
        return False
    covered = fields["covered"].values.astype(bool)
    pressure = fields["dry_pressure" if "dry_pressure" in fields else "pressure"].values
    beside = np.zeros_like(covered)
    for axis in range(covered.ndim):
        ends = np.diff(covered.astype(np.int8), axis=axis) != 0
        before, after = ([slice(None)] * covered.ndim for _ in range(2))
        before[axis], after[axis] = slice(None, -1), slice(1, None)
        beside[tuple(before)] |= ends
        beside[tuple(after)] |= ends
    at_edge = pressure[beside & covered]
    return bool(at_edge.size and at_edge.max() > LEAST_RATIO * pressure.max())
