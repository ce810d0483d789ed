"""The smallest value of a field between the nodes of a grid, as a continuous function of its nodal values.

One surface goes through all nodes: cubic convolution (Keys, IEEE Trans. ASSP 29, 1981, 1153-1160), of
third order and with continuous slopes. Its minimum does not jump where the lowest node changes, as that of
surfaces fitted about the lowest node does.
"""

import numpy as np

from pyworm.formulas.whole_numbers import whole

Array = np.ndarray

SEARCHES = ((8, 2.0), (128, 0.125))
"""Searches about a low node, then about the lowest place of the search before: places to a cell, and cells to
each side. The error is 1e-4 of that of the lowest node; places do not depend on which node is the lowest."""

MOST_CELLS, NEWTON_STEPS = 4, 8
"""Cells in which the place of a least value is refined, and steps of Newton's method in each."""

MARGIN_NODES = 6
"""Nodes to each side on which the surface depends: one beyond its cell, and three more from which that one is
extrapolated where it has no value."""

MOST_VALLEYS = 8
"""Number of low nodes, beside the lowest, about which the surface is searched."""

LEAST_OF_NODES = 0.9
"""Smallest film over that of the lowest node, at least: on a grid that resolves its minimum the surface dips
by some per cent."""

DIP = 0.25
"""Largest depth of the surface below a low node, over the sum of the second differences along x and y:
along one of them a parabola reaches 1/8, this surface 0.15."""


def minimum(field: Array, within: Array, usable: Array) -> tuple[float, tuple[float, ...]]:
    """Smallest value of the surface, or curve, through a field (nx, ny) or (n,), and its place in nodes.

    The surface counts in cells whose corners are all usable and one of them `within`, beside it nodes within,
    from which it is extrapolated; infinite without any.
    """
    if field.ndim == 1:
        return _line_minimum(field, within, usable)
    if not within.any():
        return np.inf, (0.0, 0.0)
    # what lies farther off than the surface depends on is not looked at
    near = tuple(_near(np.asarray(within.any(axis=1 - axis))) for axis in (0, 1))
    value, place = _surface_minimum(field[near], within[near], usable[near])
    return value, (place[0] + near[0].start, place[1] + near[1].start)


def film_minimum(
    film: Array, within: Array, usable: Array
) -> tuple[float, tuple[float, ...], bool]:
    """Smallest film, its place in nodes, and whether it is `LEAST_OF_NODES` of the lowest node's.

    Arguments as of `minimum`. Beside the wall of an edge that the grid does not resolve the surface through
    the nodes dips by up to a sixteenth of the wall's height, below any film that there is, and below zero.
    """
    value, place = minimum(film, within, usable)
    nodal = np.where(within, film, np.inf)
    lowest = np.unravel_index(np.argmin(nodal), nodal.shape)
    least = LEAST_OF_NODES * float(nodal[lowest])
    if least <= 0 or least == np.inf or value >= least:
        return value, place, False
    return least, tuple(float(node) for node in lowest), True


def surface_at(field: Array, i: Array, j: Array) -> Array:
    """Values of the surface through a field over a plane at places given in nodes, all within the grid."""
    rows, on_x = _four(i, field.shape[0])
    columns, on_y = _four(j, field.shape[1])
    return np.einsum("pa,pab,pb->p", on_x, field[rows[:, :, None], columns[:, None, :]], on_y)


def _four(places: Array, count: int) -> tuple[Array, Array]:
    """Four nodes about each place along x or y, and the weights of their values."""
    cell = np.clip(whole(np.floor(places)), 0, count - 2)
    weights = _keys(np.abs(places[:, None] - cell[:, None] - np.arange(-1, 3)))
    for end, order in ((0, 1), (count - 2, -1)):
        # the node beyond a side, extrapolated from three
        beyond, a, b, c = weights[cell == end, ::order].T
        weights[cell == end, ::order] = np.stack(
            [a + 3 * beyond, b - 3 * beyond, c + beyond, np.zeros_like(beyond)], axis=1
        )
    return np.clip(cell - 1, 0, count - 4)[:, None] + np.arange(4), weights


def weights_at(place: tuple[float, ...], shape: tuple[int, ...]) -> Array:
    """Weights of the nodes of a grid in the surface, or curve, through them at a place given in nodes."""
    weights = np.ones(())
    for along, count in zip(place, shape, strict=True):
        nodes, parts = _four(np.array([along]), count)
        line = np.zeros(count)
        line[nodes[0]] = parts[0]
        weights = np.multiply.outer(weights, line)
    return weights


def refined_place(field: Array, place: tuple[float, ...]) -> tuple[float, ...]:
    """The place of the least value of the surface, or curve, beside that found by `minimum`.

    Within a cell the surface is bicubic, and its least value is found by Newton's method, in the next cell
    where it leads there.
    """
    if field.ndim == 1:
        return place  # in closed form already
    cell = np.floor(np.minimum(place, np.array(field.shape) - 2))
    within = np.array(place) - cell
    for _ in range(MOST_CELLS):
        parts = np.arange(4) / 3
        i, j = np.meshgrid(cell[0] + parts, cell[1] + parts, indexing="ij")
        values = surface_at(field, i.ravel(), j.ravel()).reshape(4, 4)
        inverse = np.linalg.inv(np.vander(parts, increasing=True))
        within = _stationary(inverse @ values @ inverse.T, within)
        if ((within > 0) & (within < 1)).all():
            break
        cell, within = _next_cell(cell, within, np.array(field.shape))
    return tuple(float(nodes) for nodes in cell + within)


def _stationary(cubic: Array, within: Array) -> Array:
    """Where a bicubic, by coefficients of powers, is least in the unit cell, its outline included."""
    powers = np.polynomial.polynomial
    x, y = (powers.polyder(cubic, axis=axis) for axis in (0, 1))
    xx, xy, yy = powers.polyder(x, axis=0), powers.polyder(x, axis=1), powers.polyder(y, axis=1)
    for _ in range(NEWTON_STEPS):
        place = float(within[0]), float(within[1])
        slope = [float(powers.polyval2d(*place, slope)) for slope in (x, y)]
        a, b, c = (float(powers.polyval2d(*place, bend)) for bend in (xx, xy, yy))
        if not (a > 0 and a * c > b * b):
            break
        move = np.array([c * slope[0] - b * slope[1], a * slope[1] - b * slope[0]]) / (
            a * c - b * b
        )
        within = np.clip(within - move, 0.0, 1.0)
    return within


def _next_cell(cell: Array, within: Array, shape: Array) -> tuple[Array, Array]:
    """The cell beyond the side of a cell on which a place lies, and the place there."""
    turned = np.clip(cell + (within >= 1) - (within <= 0), 0, shape - 2)
    return turned, np.clip(cell + within - turned, 0.0, 1.0)


def _near(within: Array) -> slice:
    """The nodes along one direction on which the surface about some of them depends."""
    nodes = np.flatnonzero(within)
    return slice(max(int(nodes[0]) - MARGIN_NODES, 0), int(nodes[-1]) + MARGIN_NODES + 1)


def _surface_minimum(
    field: Array, within: Array, usable: Array
) -> tuple[float, tuple[float, float]]:
    """As `minimum`, of the surface through a field over a plane."""
    nodal = np.where(within, field, np.inf)
    lowest = np.unravel_index(np.argmin(nodal), nodal.shape)
    if not np.isfinite(nodal[lowest]):
        return float(nodal[lowest]), (float(lowest[0]), float(lowest[1]))
    i, j = np.nonzero(_lowest_about(nodal) & within)
    floors = nodal[i, j] - DIP * np.maximum(_bends(field, i, j) + _bends(field.T, j, i), 0)
    promising = np.flatnonzero(~(floors > nodal[lowest]))
    promising = promising[np.argsort(floors[promising], kind="stable")[:MOST_VALLEYS]]
    # the lowest node whatever the floors of others promise: the surface goes through it
    about = {lowest, *zip(i[promising], j[promising], strict=True)}
    found = [_about(field, within, usable, *node) for node in sorted(about)]
    return min(found, key=lambda valley: valley[0])


def _line_minimum(field: Array, within: Array, usable: Array) -> tuple[float, tuple[float]]:
    """As `minimum`, of the curve through a field along a line."""
    known = np.pad(np.where(usable, field, np.nan), 2, constant_values=np.nan)
    before, left, right, behind = known[1:-3], known[2:-2], known[3:-1], known[4:]
    # what is lacking on one side follows from the other
    before = np.where(np.isnan(before), 3 * (left - right) + behind, before)
    behind = np.where(np.isnan(behind), 3 * (right - left) + before, behind)
    slope, step = (right - before) / 2, right - left
    third = slope + (behind - left) / 2 - 2 * step
    bend = step - slope - third  # left + slope s + bend s^2 + third s^3 from node to node
    with np.errstate(invalid="ignore", divide="ignore"):
        s = -slope / (bend + np.sqrt(bend**2 - 3 * third * slope))
        values = left + s * (slope + s * (bend + s * third))
    counted = within | np.append(within[1:], False)
    between = np.where(counted & (s > 0) & (s < 1), values, np.inf)
    nodal = np.where(within, field, np.inf)
    cell, node = int(np.argmin(between)), int(np.argmin(nodal))
    if between[cell] < nodal[node]:
        return float(between[cell]), (float(cell + s[cell]),)
    return float(nodal[node]), (float(node),)


def _lowest_about(field: Array) -> Array:
    """Nodes whose eight neighbours are no lower; SciPy's filter takes four times as long."""
    least = field
    for axis in (0, 1):
        line, least = np.moveaxis(least, axis, 0), least.copy(order="K")
        lower = np.moveaxis(least, axis, 0)
        np.minimum(lower[1:], line[:-1], out=lower[1:])
        np.minimum(lower[:-1], line[1:], out=lower[:-1])
    return field == least


def _bends(field: Array, i: Array, j: Array) -> Array:
    """Second differences along x at some nodes, by half where one neighbour is outside the grid."""
    before, behind = np.maximum(i - 1, 0), np.minimum(i + 1, field.shape[0] - 1)
    return field[before, j] - 2 * field[i, j] + field[behind, j]


def _about(
    field: Array, within: Array, usable: Array, i: int, j: int
) -> tuple[float, tuple[float, float]]:
    """Smallest value about a node, and its place."""
    (rows, on_x), (columns, on_y) = (
        _around(node, count) for node, count in zip((i, j), field.shape, strict=True)
    )
    nodes, on_grid = np.ix_(rows, columns), np.outer(on_x, on_y)
    known = usable[nodes] & on_grid
    values = _carried_on(np.where(known, field[nodes], np.nan))
    cells = _corners(np.logical_and, known) & _corners(np.logical_or, within[nodes] & on_grid)
    value, place = float(field[i, j]), (0.0, 0.0)
    for parts, reach in SEARCHES:
        offsets = np.arange(-reach * parts, reach * parts + 1) / parts
        x, y = (offset + offsets for offset in place)
        surface = _weights(x) @ values @ _weights(y).T
        if not cells.all():
            surface = np.where(_cells_of(x) @ cells @ _cells_of(y).T, surface, np.inf)
        row, column = np.unravel_index(np.argmin(surface), surface.shape)
        if surface[row, column] < value:
            value, place = float(surface[row, column]), (float(x[row]), float(y[column]))
    return value, (float(i + place[0]), float(j + place[1]))


def _around(node: int, count: int) -> tuple[Array, Array]:
    """Nodes about one along x or y, clipped to the grid, and whether each is on the grid."""
    nodes = np.arange(node - MARGIN_NODES, node + MARGIN_NODES + 1)
    on_grid = np.clip(nodes, 0, count - 1)
    return on_grid, on_grid == nodes


def _corners(combine: np.ufunc, nodes: Array) -> Array:
    """Cells all or one of whose corners are such nodes."""
    return combine.reduce([nodes[:-1, :-1], nodes[1:, :-1], nodes[:-1, 1:], nodes[1:, 1:]])


def _cells_of(places: Array) -> Array:
    """Whether places, counted from the middle node, are in each cell between nodes."""
    return np.abs(places[:, None] - (np.arange(-MARGIN_NODES, MARGIN_NODES) + 0.5)) <= 0.5


def _weights(places: Array) -> Array:
    """Weights of the nodes' values at places, counted from the middle node."""
    return _keys(np.abs(places[:, None] - np.arange(-MARGIN_NODES, MARGIN_NODES + 1)))


def _keys(s: Array) -> Array:
    """Weight of a node's value at a distance in nodes (Keys)."""
    near, far = (1.5 * s - 2.5) * s**2 + 1, ((2.5 - 0.5 * s) * s - 4) * s + 2
    return np.where(s < 1, near, np.where(s < 2, far, 0.0))


def _carried_on(values: Array) -> Array:
    """Extrapolate values to nodes that have none (NaN), by the mean of parabolas along x and y.

    Lines and constants are used where fewer values are in line. At a side of the grid Keys does the same.
    """
    for _ in range(2):  # straight on, then round corners
        if not np.isnan(values).any():
            break
        total, count = np.zeros(values.shape), np.zeros(values.shape)
        for turns in range(4):
            turned = np.pad(np.rot90(values, turns), ((3, 0), (0, 0)), constant_values=np.nan)
            c, b, a = turned[:-3], turned[1:-2], turned[2:-1]
            on = np.where(np.isnan(b), a, np.where(np.isnan(c), 2 * a - b, 3 * (a - b) + c))
            on = np.rot90(on, -turns)
            total += np.nan_to_num(on)
            count += ~np.isnan(on)
        reached = np.isnan(values) & (count > 0)
        values = np.where(reached, total / np.maximum(count, 1), values)
    return np.nan_to_num(values)
