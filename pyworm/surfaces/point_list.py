"""Lists of points x, y, z on a regular grid, or x, z of a profile, as heights over that grid."""

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


def evenly_spaced(points: Array, most: int) -> tuple[Array, float]:
    """Heights of a profile's points x, z at even distances along x, and that distance.

    Where the points lie off an even scale, as those of styluses that record in time, heights are interpolated
    between them, at their median distance; NaN where a height is missing. ValueError if two lie at one place,
    or if there are too many places.
    """
    points = points[np.isfinite(points[:, 0])]
    points = points[np.argsort(points[:, 0], kind="stable")]
    place, height = points.T
    gaps = np.diff(place)
    if not gaps.size or not gaps.min() > 0:
        raise ValueError("is a profile of which two points lie at one place")
    step = float(np.median(gaps))
    mean = float(place[-1] - place[0]) / len(gaps)
    if np.abs(place - place[0] - np.arange(len(place)) * mean).max() <= OFF_GRID * mean:
        return height, mean
    count = int(float(place[-1] - place[0]) / step) + 1
    if count > most:
        raise ValueError(f"is a profile of {count} places, {most} at most are read")
    return np.interp(place[0] + np.arange(count) * step, place, height), step


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
