"""Lists of points x, y, z on a regular grid, as heights over that grid."""

import numpy as np

Array = np.ndarray

OFF_GRID = 0.1
"""Farthest that a point may lie beside its place on the grid, over the distance of points."""

SAME_PLACE = 0.25
"""Distance, over the widest gap between neighbours, below which two coordinates are of one place."""


def on_grid(points: Array, most: int) -> tuple[Array, tuple[float, float]]:
    """Heights (nx, ny) of points x, y, z, NaN where there is none, and distances along x and y.

    ValueError if the points lie on no regular grid, twice at one place, or on one that is too large.
    """
    points = points[np.isfinite(points[:, :2]).all(axis=1)]
    (row, dx), (column, dy) = (_places(points[:, k], name) for k, name in enumerate("xy"))
    shape = int(row.max()) + 1, int(column.max()) + 1
    if shape[0] * shape[1] > most:
        raise ValueError(
            f"is a list of {len(points)} points on a grid of {shape[0]} x {shape[1]}, {most} at most are read"
        )
    place = row * shape[1] + column
    if len(np.unique(place)) < len(place):
        raise ValueError(
            "is a list of points of which two lie at one place; an area has one height at each"
        )
    heights = np.full(shape, np.nan)
    heights[row, column] = points[:, 2]
    return heights, (dx, dy)


def _places(coordinate: Array, name: str) -> tuple[Array, float]:
    """Number of each coordinate on an even scale, and the distance of its marks."""
    ordered = np.unique(coordinate)
    gaps = np.diff(ordered)
    if not gaps.size:
        raise ValueError(f"is a list of points of which all have one {name}; an area is needed")
    step = float(np.median(gaps[gaps > SAME_PLACE * gaps.max()]))
    number = np.rint((coordinate - ordered[0]) / step).astype(np.int64)
    if number.max() > 0:  # the step again, from all of them
        from_mean = number - number.mean()
        step = float(from_mean @ (coordinate - coordinate.mean()) / (from_mean @ from_mean))
        number = np.rint((coordinate - ordered[0]) / step).astype(np.int64)
    beside = float(np.abs(coordinate - ordered[0] - number * step).max() / step)
    if not beside <= OFF_GRID:
        raise ValueError(
            f"is a list of points on no regular grid: along {name} they lie up to {beside:.2g} of their "
            "distance away from it; give heights over a grid, interpolated by the instrument's program"
        )
    return number, step
