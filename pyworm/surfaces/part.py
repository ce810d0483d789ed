"""Parts of a measured area: a rectangle of it, and points that a mask leaves out."""

from pathlib import Path

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.surfaces.reading import LEAST_POINTS, read_numbers


def cropped(
    heights: Array, spacing: tuple[float, float], rectangle: tuple[float, float, float, float]
) -> Array:
    """Heights (nx, ny) within x from, x to, y from and y to [m], counted from the first point.

    ValueError for a rectangle the wrong way round, beyond the area or of too few points.
    """
    x_from, x_to, y_from, y_to = rectangle
    places = []
    for axis, low, high, step, count in zip(
        "xy", (x_from, y_from), (x_to, y_to), spacing, heights.shape, strict=True
    ):
        if not low < high:
            raise ValueError(
                f"crop runs from {low:g} m to {high:g} m along {axis}; give the lesser first"
            )
        if high > count * step * (1 + 1e-9):
            raise ValueError(
                f"crop ends at {high:g} m along {axis}, beyond the area, which has {count * step:.4g} m"
            )
        first, last = round(low / step), min(round(high / step), count)
        if last - first < LEAST_POINTS:
            raise ValueError(
                f"crop leaves {last - first} points along {axis}, at least {LEAST_POINTS} are needed"
            )
        places.append(slice(first, last))
    return heights[tuple(places)]


def masked(heights: Array, path: Path) -> Array:
    """Heights with NaN where a file of as many numbers has 0 or none; ValueError with the file's name."""
    try:
        counts = read_numbers(path).T
        if counts.shape != heights.shape:
            sizes = [" x ".join(map(str, shape)) for shape in (counts.shape, heights.shape)]
            raise ValueError(f"has {sizes[0]} numbers, the surface {sizes[1]} points")
    except ValueError as error:
        raise ValueError(f"mask {path.name} {error}") from None
    return np.where(np.nan_to_num(counts) != 0, heights, np.nan)
