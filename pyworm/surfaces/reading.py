"""Files of measured surfaces and profiles: arrays, texts, lists of points, formats of instruments."""

from math import prod
from pathlib import Path

import numpy as np

from pyworm.surfaces.compressed_file import unpacked
from pyworm.surfaces.instrument_file import read_instrument
from pyworm.surfaces.plausible import (
    likely_unit,
    plausible_side,
    require_plausible_sides,
    require_possible_heights,
)
from pyworm.surfaces.point_list import evenly_spaced, on_grid
from pyworm.surfaces.text_file import TextHeights, read_text
from pyworm.surfaces.text_header import metres_of

Array = np.ndarray

MOST_POINTS = 25_000_000
"""Points of the largest file that is read, 5000 by 5000: 200 MB."""

LEAST_POINTS, LEAST_OF_PROFILE = 16, 64
"""Points along the shorter side of the smallest area, and of the shortest profile."""

MOST_BYTES_A_POINT = 40
"""Length of a number in a text, beyond which no file of `MOST_POINTS` has to go."""

TEXTS, MOSTLY_TEXTS = (".csv", ".txt", ".tsv", ".xyz"), (".asc", ".dat")
"""Endings of texts of numbers, and those that instruments use for other files too."""

LIBRARY_TEXTS = (b"Wyko ASCII", b"# File Format")
"""How texts of programs begin whose headers SurfaceTopography knows: Wyko, SPIP."""

SNIFFED = 4096
"""Bytes from the beginning in which a file that is no text has a zero."""


class IsProfileError(ValueError):
    """A profile stands where an area is needed."""


def read_heights(
    path: Path,
    spacing: float | None = None,
    height_unit: str | None = None,
    channel: str | int | None = None,
) -> tuple[Array, tuple[float, ...]]:
    """Heights [m] of an area, shape (nx, ny), or of a profile, (nx,), and their spacing [m] along each axis.

    NaN where points are missing. The file, which may be compressed as a whole, is `.npy` or a text with rows
    along y and columns along x, with columns x, y and z of points on a regular grid, or x and z of a profile,
    or a format of an instrument, of whose channels one is read by its name or number. Spacing, of lists of
    points that along x, and unit count where it gives none. ValueError for no such file, none that can be
    read, without unit or spacing, too large or too small.
    """
    if not path.is_file():
        raise ValueError("no such file")
    if path.stat().st_size == 0:
        raise ValueError("is empty")
    metres = None if height_unit is None else _metres(height_unit)
    with unpacked(path) as plain:
        heights, steps = _read(plain, metres, spacing, channel)
    _require_size(heights)
    require_possible_heights(heights)
    require_plausible_sides(heights.shape, steps, spacing is not None)
    return np.ascontiguousarray(heights), steps


def read_area(
    path: Path,
    spacing: float | None = None,
    height_unit: str | None = None,
    channel: str | int | None = None,
) -> tuple[Array, tuple[float, float]]:
    """Heights [m] of an area, shape (nx, ny), and their spacing [m]; arguments and errors as `read_heights`.

    IsProfileError, a ValueError, for a profile.
    """
    heights, steps = read_heights(path, spacing, height_unit, channel)
    if heights.ndim == 1:
        raise IsProfileError(
            "is a profile along a line; heights of an area are needed, or profiles as across or along"
        )
    return heights, (steps[0], steps[1])


def read_profile(
    path: Path, spacing: float | None = None, height_unit: str | None = None
) -> tuple[Array, float]:
    """Heights [m] of a profile, shape (n,), and their spacing [m]; arguments and errors as `read_heights`.

    ValueError for an area, too.
    """
    heights, steps = read_heights(path, spacing, height_unit)
    if heights.ndim != 1:
        raise ValueError("holds the heights of an area, not a profile; give it as file")
    return heights, steps[0]


def read_numbers(path: Path) -> Array:
    """Plain numbers of an `.npy` or text file, a row for each y; ValueError if it holds none."""
    if not path.is_file():
        raise ValueError("no such file")
    with unpacked(path) as plain:
        return _read_npy(plain) if plain.suffix.lower() == ".npy" else _text(plain).numbers


def _read(
    path: Path, metres: float | None, spacing: float | None, channel: str | int | None
) -> tuple[Array, tuple[float, ...]]:
    """Heights and spacing of a file that is not compressed."""
    is_array = path.suffix.lower() == ".npy"
    if is_array or _is_text(path):
        if channel is not None:
            raise ValueError("has one channel; omit channel")
        return (
            _of_array(path, metres, spacing) if is_array else _of_text(_text(path), metres, spacing)
        )
    return read_instrument(path, metres, spacing, MOST_POINTS, channel)


def _of_array(
    path: Path, metres: float | None, spacing: float | None
) -> tuple[Array, tuple[float, ...]]:
    """Heights [m] and spacing [m] of an array, of a profile where it has one row."""
    numbers = np.squeeze(_read_npy(path))
    if numbers.ndim not in (1, 2):
        raise ValueError(f"must hold heights along one or two dimensions, not {numbers.ndim}")
    metres, step = _require_given(numbers, metres, spacing)
    with np.errstate(invalid="ignore"):  # by the other kind of NaN, which damaged files have
        return numbers.T * metres, (step,) * numbers.ndim


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


def _require_size(heights: Array) -> None:
    least = LEAST_OF_PROFILE if heights.ndim == 1 else LEAST_POINTS
    if min(heights.shape) < least:
        size = " x ".join(f"{count}" for count in heights.shape)
        needed = (
            f"a profile needs at least {least}"
            if heights.ndim == 1
            else f"at least {least} along each side are needed, such as 256 x 256"
        )
        raise ValueError(f"has {size} points, {needed}")


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
) -> tuple[Array, tuple[float, ...]]:
    """Heights [m] and spacing [m] of a text, by its header or by what is given in its place."""
    header, numbers = text.header, text.numbers
    numbers = numbers[:, : 1 + np.flatnonzero(np.isfinite(numbers).any(axis=0)).max(initial=0)]
    rows, columns = numbers.shape
    if header.height_metres is not None and metres is not None:
        raise ValueError("gives its own unit in its header; omit height_unit")
    metres = header.height_metres if metres is None else metres
    if columns == 2:
        return _of_places(numbers, header.metres, metres, spacing)
    if min(rows, columns) == 1:
        metres, step = _require_given(numbers, metres, spacing)
        return numbers.ravel() * metres, (step,)
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


def _of_places(
    points: Array,
    file_units: tuple[float, float] | None,
    metres: float | None,
    spacing: float | None,
) -> tuple[Array, tuple[float, ...]]:
    """Heights [m] and spacing [m] of a profile's columns x and z, `file_units` the metres of x."""
    if file_units is not None and spacing is not None:
        raise ValueError("gives the unit of x in its header; omit spacing")
    metres, step = _require_given(
        points[:, 1], metres, spacing if file_units is None else file_units[0]
    )
    heights, distance = evenly_spaced(points, MOST_POINTS)
    return heights * metres, (step if file_units is None else distance * step,)
