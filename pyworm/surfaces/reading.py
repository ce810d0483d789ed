"""Files of measured surfaces: arrays, texts with or without a header, lists of points, instruments."""

from math import prod
from pathlib import Path

import numpy as np

from pyworm.surfaces.instrument_file import is_compressed, read_instrument
from pyworm.surfaces.plausible import (
    likely_unit,
    plausible_side,
    require_plausible_sides,
    require_possible_heights,
)
from pyworm.surfaces.point_list import on_grid
from pyworm.surfaces.text_file import TextHeights, read_text
from pyworm.surfaces.text_header import metres_of

Array = np.ndarray

MOST_POINTS = 25_000_000
"""Points of the largest file that is read, 5000 by 5000: 200 MB."""

LEAST_POINTS = 16
"""Points along the shorter side of the smallest."""

MOST_BYTES_A_POINT = 40
"""Length of a number in a text, beyond which no file of `MOST_POINTS` has to go."""

TEXTS, MOSTLY_TEXTS = (".csv", ".txt", ".tsv", ".xyz"), (".asc", ".dat")
"""Endings of texts of numbers, and those that instruments use for other files too."""

LIBRARY_TEXTS = (b"Wyko ASCII", b"# File Format")
"""How texts of programs begin whose headers SurfaceTopography knows: Wyko, SPIP."""

SNIFFED = 4096
"""Bytes from the beginning in which a file that is no text has a zero."""


def read_heights(
    path: Path, spacing: float | None = None, height_unit: str | None = None
) -> tuple[Array, tuple[float, float]]:
    """Heights [m] of a file, shape (nx, ny), NaN where points are missing, and their spacing [m].

    The file is `.npy` or a text with rows along y and columns along x, or with columns x, y and z of points
    on a regular grid, or a format of an instrument; spacing, of a list of points that along x, and unit count
    where it gives none. ValueError for no such file, none that can be read, without unit or spacing, too
    large or too small.
    """
    if not path.is_file():
        raise ValueError("no such file")
    if path.stat().st_size == 0:
        raise ValueError("is empty")
    metres = None if height_unit is None else _metres(height_unit)
    if path.suffix.lower() == ".npy":
        numbers = _read_npy(path)
        metres, step = _require_given(numbers, metres, spacing)
        with np.errstate(invalid="ignore"):  # by the other kind of NaN, which damaged files have
            heights, steps = numbers.T * metres, (step, step)
    elif _is_text(path):
        heights, steps = _of_text(_text(path), metres, spacing)
    else:
        heights, steps = read_instrument(path, metres, spacing, MOST_POINTS)
    _require_area(heights)
    require_possible_heights(heights)
    require_plausible_sides(heights.shape, steps, spacing is not None)
    return np.ascontiguousarray(heights), steps


def _metres(unit: str) -> float:
    metres = metres_of(unit)
    if metres is None:
        raise ValueError(f'height_unit = "{unit}" is no unit of length, such as "um"')
    return metres


def _is_text(path: Path) -> bool:
    """Whether a file is a text of numbers, and none whose header the library has to read."""
    if path.suffix.lower() not in TEXTS + MOSTLY_TEXTS:
        return False
    with path.open("rb") as file:
        begin = file.read(SNIFFED)
    if is_compressed(begin):
        return False
    if b"\0" in begin and path.suffix.lower() in MOSTLY_TEXTS:
        return False
    return not begin.lstrip().startswith(LIBRARY_TEXTS)


def _require_given(
    heights: Array, metres: float | None, spacing: float | None
) -> tuple[float, float]:
    """Unit [m] and distance [m] of numbers; refused where neither file nor case give both."""
    if metres is None:
        finite = heights[np.isfinite(heights)]
        unit = likely_unit(float(finite.std()) if finite.size else 0.0)
        distance = ' and spacing = "0.5 um"' if spacing is None else ""
        raise ValueError(
            f'has numbers without a unit; give height_unit = "{unit}"{distance} with it, or its own'
        )
    if spacing is None:
        raise ValueError(
            'does not give the distance of its points; give spacing = "0.5 um" with it, or its own'
        )
    return metres, spacing


def _require_readable(shape: tuple[int, ...]) -> None:
    if prod(shape) > MOST_POINTS:
        size = " x ".join(f"{count}" for count in shape)
        raise ValueError(f"has {size} points, {MOST_POINTS} are read at most; give a part of it")


def _require_area(heights: Array) -> None:
    if heights.ndim != 2:
        raise ValueError(f"must be an area, two dimensions of heights, not {heights.ndim}")
    if min(heights.shape) < LEAST_POINTS:
        size = " x ".join(f"{count}" for count in heights.shape)
        raise ValueError(
            f"has {size} points, at least {LEAST_POINTS} along each side are needed, such as 256 x 256"
        )


def _read_npy(path: Path) -> Array:
    try:
        mapped = np.lib.format.open_memmap(path, mode="r")
    except Exception as error:  # whatever a damaged file makes the library stumble over
        raise ValueError(f"cannot be read as an npy file of numbers ({error})") from None
    if mapped.dtype.kind not in "iuf":
        raise ValueError(f"cannot be read as an npy file of numbers (it holds {mapped.dtype})")
    _require_readable(mapped.shape)
    return np.array(mapped, dtype=float)


def _text(path: Path) -> TextHeights:
    if path.stat().st_size > MOST_POINTS * MOST_BYTES_A_POINT:
        raise ValueError(
            f"has {path.stat().st_size / 1e9:.1f} GB of text, {MOST_POINTS} numbers are read at most"
        )
    text = read_text(path)
    _require_readable(text.numbers.shape)
    return text


def _of_text(
    text: TextHeights, metres: float | None, spacing: float | None
) -> tuple[Array, tuple[float, float]]:
    """Heights [m] and spacing [m] of a text, by its header or by what is given in its place."""
    header, numbers = text.header, text.numbers
    numbers = numbers[:, : 1 + np.flatnonzero(np.isfinite(numbers).any(axis=0)).max(initial=0)]
    rows, columns = numbers.shape
    if min(rows, columns) == 1 or columns == 2:
        raise ValueError("is a profile along a line; heights of an area are needed")
    if header.height_metres is not None and metres is not None:
        raise ValueError("gives its own unit in its header; omit height_unit")
    metres = header.height_metres if metres is None else metres
    if columns == 3 and header.sides is None:
        return _of_points(numbers, header.metres, metres, spacing)
    file_steps = header.steps
    if header.sides is not None:
        file_steps = header.sides[0] / columns, header.sides[1] / rows
    if file_steps is not None and spacing is not None:
        if plausible_side((columns, rows), file_steps):
            raise ValueError("gives the distance of its points in its header; omit spacing")
        file_steps = None
    metres, step = _require_given(numbers, metres, spacing if file_steps is None else file_steps[0])
    return numbers.T * metres, (step, step) if file_steps is None else file_steps


def _of_points(
    points: Array,
    file_units: tuple[float, float] | None,
    metres: float | None,
    spacing: float | None,
) -> tuple[Array, tuple[float, float]]:
    """Heights [m] and spacing [m] of a list of points, `file_units` the metres of its x and y."""
    if file_units is not None and spacing is not None:
        raise ValueError("gives the units of x and y in its header; omit spacing")
    metres, step = _require_given(
        points[:, 2], metres, spacing if file_units is None else file_units[0]
    )
    heights, (dx, dy) = on_grid(points, MOST_POINTS)
    scales = (step / dx, step / dx) if file_units is None else file_units
    return heights * metres, (dx * scales[0], dy * scales[1])
