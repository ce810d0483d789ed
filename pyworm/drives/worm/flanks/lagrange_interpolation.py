"""Values of a smooth function at the many nodes of a mesh, by polynomials through every few of them.

For an analytic function the error of Lagrange's polynomials falls geometrically with the number of nodes that
they go through, the faster the closer these are (L. N. Trefethen, Approximation Theory and Approximation
Practice, 2013, chapters 11 and 15). What it is, is seen everywhere: polynomials through every second of these
nodes, whose error is larger, are compared at the others. Nodes where it is too large, or the function is not
smooth, are evaluated.
"""

from collections.abc import Callable

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array

THROUGH = 10
"""Number of nodes along each side that a polynomial goes through."""

LONGER_SIDE = 120
"""Least number of intervals between such nodes along the longer side."""

MIN_ERROR_RATIO = 100.0
"""Error of the polynomials through every second of these nodes, over that of those through all, at least:
2 to the power of THROUGH far from singularities."""


def on_mesh(
    find: Callable[[Array, Array], Array], x: Array, y: Array, tolerance: float
) -> Array | None:
    """Values (quantities, ...) at the nodes of a mesh; None of few nodes, and of such that are no mesh.

    `find` gives a row for each quantity at places, of which the last one is 1 where the function is smooth;
    `tolerance` is the largest error of the first one.
    """
    stride = max(x.shape) // LONGER_SIDE if x.ndim == 2 else 0
    if stride < 2 or min(x.shape) <= 2 * THROUGH * stride or (sides := _sides(x, y)) is None:
        return None
    chosen = [np.append(np.arange(0, count - 1, stride), count - 1) for count in x.shape]
    nodes = np.ix_(*chosen)
    values = find(x[nodes].ravel(), y[nodes].ravel()).reshape(-1, *x[nodes].shape)
    smooth = values[-1] == 1
    values = np.where(smooth, values, 0.0)
    coarse = sides[0][chosen[0]], sides[1][chosen[1]]
    every_second = [np.append(np.arange(0, nodes.size - 1, 2), nodes.size - 1) for nodes in coarse]
    seen = _interpolated(values[0][np.ix_(*every_second)], coarse, every_second)
    sound = smooth & (np.abs(seen - values[0]) <= MIN_ERROR_RATIO * tolerance)
    found = np.ones((len(values), *x.shape))
    found[:-1] = _interpolated(values[:-1], sides, chosen)
    if not sound.all():
        left = _reached(~sound, x.shape, chosen)
        found[:, left] = find(x[left], y[left])
    return found


def _sides(x: Array, y: Array) -> tuple[Array, Array] | None:
    """Coordinates along rows and along columns of a mesh; None of other points."""
    for rows, columns in ((x, y), (y, x)):
        if (rows == rows[:, :1]).all() and (columns == columns[:1]).all():
            return rows[:, 0], columns[0]
    return None


def _interpolated(values: Array, sides: tuple[Array, Array], chosen: list[Array]) -> Array:
    """Values at all nodes from those at the chosen ones of each side."""
    rows, columns = (_matrix(side, nodes) for side, nodes in zip(sides, chosen, strict=True))
    return rows @ (values @ columns.T)


def _matrix(side: Array, chosen: Array) -> Array:
    """Matrix from values at the chosen nodes of a side to those at all."""
    through = _through(side.size, chosen)
    places = side[chosen][through]
    apart = places[:, :, None] - places[:, None, :]
    away = np.broadcast_to((side[:, None] - places)[:, None, :], apart.shape)
    same = np.eye(THROUGH, dtype=bool)
    weights = np.where(same, 1.0, away / np.where(same, 1.0, apart)).prod(axis=-1)
    matrix = np.zeros((side.size, chosen.size))
    np.put_along_axis(matrix, through, weights, axis=1)
    return matrix


def _through(count: int, chosen: Array) -> Array:
    """Which of the chosen nodes the polynomial at each of all nodes goes through, (count, THROUGH)."""
    before = np.searchsorted(chosen, np.arange(count), side="right") - 1
    first = np.clip(before - THROUGH // 2 + 1, 0, chosen.size - THROUGH)
    return first[:, None] + np.arange(THROUGH)


def _reached(marked: Array, shape: tuple[int, ...], chosen: list[Array]) -> Array:
    """Nodes whose polynomial goes through a marked one of the chosen nodes."""
    for axis, (count, nodes) in enumerate(zip(shape, chosen, strict=True)):
        marked = np.asarray(np.take(marked, _through(count, nodes), axis=axis).any(axis=axis + 1))
    return marked
