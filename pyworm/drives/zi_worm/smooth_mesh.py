"""Values of a smooth function at the many nodes of a mesh, by Chebyshev's polynomials from a few places.

The polynomials agree with the function at Chebyshev's nodes of both sides of the mesh (L. N. Trefethen,
Approximation Theory and Approximation Practice, 2013, chapters 2 and 8: for an analytic function their error
falls geometrically with the order). What it is, is seen at nodes of the mesh where the function is evaluated
as well.
"""

from collections.abc import Callable

import numpy as np
from numpy.polynomial.chebyshev import chebpts1, chebvander

from pyworm.drives.zi_worm.helicoid import Array

ORDERS = 16, 32
"""Numbers of polynomials along each side, tried one after the other."""

SEEN = 12
"""Nodes along each side at which the error is seen, both ends among them."""

FEWEST = 20_000
"""Number of nodes below which polynomials are not worth their while."""


def on_mesh(
    find: Callable[[Array, Array], Array], x: Array, y: Array, tolerance: float
) -> Array | None:
    """Values at the nodes of a mesh.

    Parameters
    ----------
    find : callable
        Places x and y, (places,) -> values, a row for each quantity; the last one is 1 where the function is
        smooth.
    x, y : ndarray
        Nodes, of one shape.
    tolerance : float
        Largest error of the first quantity.

    Returns
    -------
    ndarray or None
        Values (quantities, ...); None of few nodes, of such that are no mesh, and where the polynomials are
        not as accurate.
    """
    sides = _sides(x, y) if x.ndim == 2 and x.size >= FEWEST else None
    if sides is None:
        return None
    seen = np.ix_(*(np.linspace(0, count - 1, SEEN).round().astype(int) for count in x.shape))
    exact = find(x[seen].ravel(), y[seen].ravel()).reshape(-1, SEEN, SEEN)
    for order in ORDERS:
        places = np.meshgrid(*(_spread(side, chebpts1(order)) for side in sides), indexing="ij")
        if x[0, 0] == x[-1, 0]:  # x goes with the columns
            places = places[::-1]
        values = find(*(place.ravel() for place in places)).reshape(-1, order, order)
        if not (values[-1] == 1).all() or not (exact[-1] == 1).all():
            return None
        rows, columns = (_interpolation(side, order) for side in sides)
        found = rows @ values @ columns.T
        if np.abs(found[0][seen] - exact[0]).max() <= tolerance:
            found[-1] = 1.0
            return found
    return None


def _sides(x: Array, y: Array) -> tuple[Array, Array] | None:
    """Coordinates along rows and along columns of a mesh; None of other points."""
    for rows, columns in ((x, y), (y, x)):
        if (rows == rows[:, :1]).all() and (columns == columns[:1]).all():
            return rows[:, 0], columns[0]
    return None


def _spread(side: Array, places: Array) -> Array:
    """Places from -1 to 1 as coordinates along a side."""
    return (side[0] + side[-1]) / 2 + (side[-1] - side[0]) / 2 * places


def _interpolation(side: Array, order: int) -> Array:
    """Matrix from values at Chebyshev's nodes to those at the nodes of a side."""
    places = (2 * side - side[0] - side[-1]) / (side[-1] - side[0])
    at_nodes = chebvander(chebpts1(order), order - 1)
    return np.linalg.solve(at_nodes.T, chebvander(places, order - 1).T).T
