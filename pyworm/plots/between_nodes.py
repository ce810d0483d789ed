"""Fields at places between the nodes of their grid."""

import numpy as np

from pyworm.formulas.whole_numbers import whole


def between_nodes(
    nodes: np.ndarray, field: np.ndarray, places: np.ndarray, axis: int
) -> np.ndarray:
    """A field along one of its axes at places between nodes, linearly; the outermost values beyond them."""
    at = np.interp(places, nodes, np.arange(nodes.size))
    first = np.minimum(whole(at), nodes.size - 2)
    weight = (at - first).reshape(-1, *[1] * (1 - axis))
    before, behind = (np.take(field, first + step, axis) for step in (0, 1))
    between_nodes: np.ndarray = before + weight * (behind - before)
    return between_nodes
