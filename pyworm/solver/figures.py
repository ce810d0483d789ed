"""Figures read off fields between the nodes of a grid."""

from collections.abc import Sequence
from math import nan

import numpy as np
import scipy

from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.solver import extremum
from pyworm.solver.error_estimate import Peak
from pyworm.solver.extremum import minimum, surface_at

Array = np.ndarray


def film_minimum(
    grid: Grid | LineGrid, film: Array, pressurised: Array, covered: Array
) -> tuple[float, tuple[float, ...]]:
    """Smallest film and its place [m] along each direction, between nodes, about pressurised ones."""
    value, node, _ = extremum.film_minimum(film, pressurised, covered)
    return value, grid.place(node)


def maximum(field: Array, covered: Array | bool = True) -> float:
    """Largest value of a field, between nodes, where both surfaces exist."""
    counted = np.broadcast_to(covered, field.shape)
    if field.ndim == 1:
        return -minimum(-field, counted, counted)[0]
    lowest = np.min(field, where=counted, initial=np.inf)
    highest = np.max(field, where=counted, initial=-np.inf)
    # only the upper half has peaks to look for: a pressure is flat, at zero, in most places
    upper = counted & ~(field < (lowest + highest) / 2)
    return -minimum(-field, upper, counted)[0]


def peak(field: Array, covered: Array | bool, largest: float) -> Peak:
    """Resolution of the largest value of a field at nodes, by the one between them."""
    counted = np.broadcast_to(covered, field.shape)
    known = np.where(counted, field, np.nan)
    above = sum(_above_neighbours(known, axis) for axis in range(field.ndim))
    above = np.where(counted, np.maximum(above, 0.0), 0.0)
    may = (field > 0) & (field + above > largest)
    # a ridge has the same sum of second differences whichever way it runs
    narrowest = np.max(above[may] / field[may], initial=0.0)
    nodes = 2 / np.sqrt(narrowest) if narrowest > 0 else np.inf
    return Peak(float(np.max(field + above / 2, where=counted, initial=largest)), float(nodes))


def _above_neighbours(field: Array, axis: int) -> Array:
    """Negative second difference along an axis.

    Where a neighbour is missing (NaN): height above the line through the next two nodes on the other side.
    """
    line = np.moveaxis(field, axis, 0)
    above = np.full(line.shape, np.nan)
    above[1:-1] = (line[1:-1] - line[:-2]) - (line[2:] - line[1:-1])
    i, *across = np.nonzero(np.isnan(above))
    beyond = np.pad(line, [(2, 2)] + [(0, 0)] * (line.ndim - 1), constant_values=np.nan)
    two_before, before, here, behind, two_behind = (beyond[(i + k, *across)] for k in range(5))
    sides = np.fmax(
        (here - before) - (before - two_before), (two_behind - behind) - (behind - here)
    )
    above[(i, *across)] = np.nan_to_num(sides)
    return np.moveaxis(above, 0, axis)


FINE_LEVELS = 201
"""Places at which a column across the film is searched: its peak is at most 1e-4 higher."""


SEARCHED_NODES = 12
"""Nodes to each side of the hottest one whose columns are searched: those on which the surface depends."""


def maximum_across(field: Array, positions: Array, within: Array, highest: Array) -> float:
    """Largest value of a field (nodes, levels) across the film, between nodes and between levels.

    Across the film the field is the polynomial through the levels, as in the kernel, at positions from -1/2
    to 1/2; `highest` has the largest value of each column at its levels. No number where none is within: a
    film under hardly any load has no contact.
    """
    if not np.any(within):
        return nan
    nodal = np.where(within, highest, -np.inf)
    node = np.unravel_index(np.argmax(nodal), nodal.shape)
    about = tuple(
        slice(max(index - SEARCHED_NODES, 0), index + SEARCHED_NODES + 1) for index in node
    )
    between = lagrange_weights(positions, np.linspace(-0.5, 0.5, FINE_LEVELS))
    columns = (field[about] @ between.T).max(axis=-1)
    return maximum(columns, within[about])


def lagrange_weights(nodes: Array, places: Array) -> Array:
    """Lagrange weights of values at nodes in the polynomial through them, at other places.

    SciPy's interpolator draws the order of its nodes at random, and with it the last digits.
    """
    weights = np.ones((places.size, nodes.size))
    for k, node in enumerate(nodes):
        for other in np.delete(nodes, k):
            weights[:, k] *= (places - other) / (node - other)
    return weights


SIDE_LOBE_DISTANCE = 0.35
"""Distance from the entrainment line beyond which a minimum is in a side lobe, in half extents."""


def minimum_kind(place: Sequence[float], angle: float, half_extents: tuple[float, float]) -> str:
    """Kind of a point contact's minimum by its place [m]: "side lobe", "exit" or "middle".

    `angle` is the direction of entrainment at the contact point from x to y [rad], `half_extents` those of
    the dry contact [m].
    """
    (x, y), (a, b) = place, half_extents
    cosine, sine = np.cos(angle), np.sin(angle)
    along = (x * cosine + y * sine) / _half_width(a, b, cosine, sine)
    across = (y * cosine - x * sine) / _half_width(a, b, -sine, cosine)
    if abs(across) > SIDE_LOBE_DISTANCE:
        return "side lobe"
    return "exit" if along > SIDE_LOBE_DISTANCE else "middle"


def _half_width(a: float, b: float, cosine: float, sine: float) -> float:
    """Half the extent along a direction of an ellipse with semi-axes a along x and b along y [m]."""
    return float(np.hypot(a * cosine, b * sine))


ON_NODE = 1e-6
"""Distance from a node, in spacings, that counts as zero."""


def value_at_origin(grid: Grid | LineGrid, field: Array) -> float:
    """Value of a field at the contact point: of the node there, else of splines through the nearest nodes."""
    if isinstance(grid, LineGrid):
        return float(field[-grid.first])
    i, j = -grid.west / grid.dx, -grid.south / grid.dy
    if max(abs(i - round(i)), abs(j - round(j))) < ON_NODE:
        return float(field[round(i), round(j)])
    columns = _around(i, grid.nx)
    rows = _around(j, grid.ny)
    spline = scipy.interpolate.RectBivariateSpline(
        grid.x[columns], grid.y[rows], field[columns, rows]
    )
    return float(spline(0.0, 0.0, grid=False))


def _around(place: float, count: int) -> slice:
    """The eight nodes around a place given in nodes, or those nearest to it at an end."""
    first = min(max(round(place) - 4, 0), count - 8)
    return slice(first, first + 8)


def exit_minimum(grid: Grid, film: Array, angle: float) -> tuple[float, float]:
    """Smallest film [m] on the line through the contact point along the entrainment, and its place on it [m].

    Only the first minimum behind the contact point counts; the film grows without end beyond it.
    """
    direction = np.array([np.cos(angle), np.sin(angle)])
    sides = np.array(
        [
            grid.x[-1] if direction[0] > 0 else grid.west,
            grid.y[-1] if direction[1] > 0 else grid.south,
        ]
    )
    with np.errstate(divide="ignore"):
        reach = float(np.min(np.abs(sides / direction)))
    along = np.linspace(0.0, reach, 4 * max(film.shape))
    for _ in range(3):  # the whole line, then twice about the place found
        ray = along * direction[:, None]
        thickness = surface_at(
            film, (ray[0] - grid.west) / grid.dx, (ray[1] - grid.south) / grid.dy
        )
        place = int(np.argmin(thickness))
        least, distance = float(thickness[place]), float(along[place])
        along = np.linspace(along[max(place - 1, 0)], along[min(place + 1, along.size - 1)], 65)
    return least, distance


def contact_extent(grid: Grid, pressure: Array) -> tuple[float, float]:
    """Extent [m] of a dry contact along x and along y.

    At the edge of a smooth dry contact the square of the pressure falls linearly, which places the edge
    between nodes.
    """
    return (
        max(_row_extent(row, grid.dx) for row in pressure.T),
        max(_row_extent(column, grid.dy) for column in pressure),
    )


def _row_extent(pressure: Array, spacing: float) -> float:
    inside = np.flatnonzero(pressure > 0)
    if inside.size < 3:
        return float(inside.size) * spacing
    squares = pressure**2
    cells = inside[-1] - inside[0]
    cells += _edge(squares[inside[0]], squares[inside[0] + 1])
    cells += _edge(squares[inside[-1]], squares[inside[-1] - 1])
    return float(spacing * cells)


def _edge(outer: float, inner: float) -> float:
    """Cells from the outermost loaded node to the edge, at most one."""
    return min(outer / (inner - outer), 1.0) if inner > outer else 0.5


def outline_imbalance(
    grid: Grid, flow: tuple[Array, Array], imbalance: Array, pressurised: Array
) -> float:
    """Net over gross flow through the outline of the pressurised film; NaN where nothing flows.

    By the wedge flow per width [m2/s] at the nodes along x and y, which crosses the outline, where pressure
    and its slope vanish, and the net outflow per area [m/s] of each node's cell.
    """
    net = abs(imbalance[pressurised].sum()) * grid.dx * grid.dy
    gross = 0.0
    for axis, width in ((0, grid.dy), (1, grid.dx)):
        change = np.diff(pressurised.astype(np.int8), axis=axis) != 0
        near, far = (
            np.take(flow[axis], range(flow[axis].shape[axis] - 1), axis),
            np.diff(flow[axis], axis=axis),
        )
        gross += np.abs(near + far / 2)[change].sum() * width / 2
    return float(net / gross) if gross > 0 else nan
