"""Files of measured surfaces: arrays of numbers, and instruments' formats through SurfaceTopography."""

from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.io.number_with_unit import unit_of

Array = np.ndarray

MOST_POINTS = 25_000_000
"""Points of the largest file that is read, 5000 by 5000: 200 MB."""

LEAST_POINTS = 16
"""Points along the shorter side of the smallest."""

MOST_BYTES_A_POINT = 40
"""Length of a number in a text, beyond which no file of `MOST_POINTS` has to go."""

NO_INSTRUMENT = ("hgt",)
"""Formats of maps of land, for which any file of the right length may be taken."""

ARRAYS = (".npy", ".csv", ".txt")
"""Endings of files of bare numbers, whose unit and spacing the file does not tell."""


def read_heights(
    path: Path, spacing: float | None = None, height_unit: str | None = None
) -> tuple[Array, tuple[float, float]]:
    """Heights [m] of a file, shape (nx, ny), NaN where points are missing, and their spacing [m].

    Parameters
    ----------
    path : Path
        `.npy`, `.csv` or `.txt` with rows along y and columns along x, or a format of an instrument.
    spacing : float, optional
        Distance of points [m], where the file does not give it.
    height_unit : str, optional
        Unit of the heights, such as "um", where the file does not give it.

    Raises
    ------
    ValueError
        No such file, none that can be read, without unit or spacing, too large or too small.
    """
    if not path.is_file():
        raise ValueError("no such file")
    if path.stat().st_size == 0:
        raise ValueError("is empty")
    metre = None if height_unit is None else _metres(height_unit)
    if path.suffix.lower() not in ARRAYS:
        return _read_instrument(path, spacing, metre)
    if metre is None:
        raise ValueError(
            'has numbers without a unit; give height_unit = "um" beside it, or its own'
        )
    if spacing is None:
        raise ValueError(
            'does not give the distance of its points; give spacing = "0.5 um" beside it, or its own'
        )
    numbers = _read_npy(path) if path.suffix.lower() == ".npy" else _read_text(path)
    return _checked(numbers.T * metre), (spacing, spacing)


def _metres(unit: str) -> float:
    """Metres of a unit of length."""
    try:
        meant = unit_of(unit)
    except ValueError:
        meant = None
    if meant is None or meant.base != "m":
        raise ValueError(f'height_unit = "{unit}" is no unit of length, such as "um"')
    return meant.factor


def _require_readable(shape: tuple[int, ...]) -> None:
    if prod(shape) > MOST_POINTS:
        size = " x ".join(f"{one}" for one in shape)
        raise ValueError(f"has {size} points, {MOST_POINTS} are read at most; give a part of it")


def _checked(heights: Array) -> Array:
    if heights.ndim != 2:
        raise ValueError(f"must be an area, two dimensions of heights, not {heights.ndim}")
    if min(heights.shape) < LEAST_POINTS:
        size = " x ".join(f"{one}" for one in heights.shape)
        raise ValueError(
            f"has {size} points, at least {LEAST_POINTS} along each side are needed, such as 256 x 256"
        )
    return np.ascontiguousarray(heights)


def _read_npy(path: Path) -> Array:
    try:
        mapped = np.lib.format.open_memmap(path, mode="r")
    except Exception as error:  # whatever a damaged file makes the library stumble over
        raise ValueError(f"cannot be read as an npy file of numbers ({error})") from None
    if mapped.dtype.kind not in "iuf":
        raise ValueError(f"cannot be read as an npy file of numbers (it holds {mapped.dtype})")
    _require_readable(mapped.shape)
    return np.array(mapped, dtype=float)


def _read_text(path: Path) -> Array:
    if path.stat().st_size > MOST_POINTS * MOST_BYTES_A_POINT:
        raise ValueError(
            f"has {path.stat().st_size / 1e9:.1f} GB of text, {MOST_POINTS} numbers are read at most"
        )
    try:
        with path.open() as file:
            first = file.readline()
        separator = next((one for one in (";", ",", "\t") if one in first), None)
        numbers = np.genfromtxt(path, delimiter=separator, dtype=float, ndmin=2)
    except (ValueError, UnicodeDecodeError) as error:
        reason = str(error).splitlines()[0]
        raise ValueError(f"cannot be read as rows of numbers ({reason})") from None
    _require_readable(numbers.shape)
    return numbers


def _library() -> Any:
    try:
        import SurfaceTopography
    except ImportError:
        raise ValueError(
            "is a format of an instrument, which the package SurfaceTopography reads: "
            'pip install "pyworm[surfaces]"'
        ) from None
    return SurfaceTopography


def _read_instrument(
    path: Path, spacing: float | None, metre: float | None
) -> tuple[Array, tuple[float, float]]:
    library = _library()
    try:
        with library.open_topography(str(path)) as reader:
            if reader.format() in NO_INSTRUMENT:
                raise ValueError("is no file of an instrument that SurfaceTopography knows")
            channel = reader.default_channel
            shape, sides, unit = channel.nb_grid_pts, channel.physical_sizes, channel.unit
            if len(shape) != 2:
                raise ValueError("is a profile along a line; heights of an area are needed")
            _require_readable(shape)
            own = None if unit is None else _metres(str(unit))
            if own is None and metre is None:
                raise ValueError('does not give its unit; give height_unit = "um" beside it')
            if own is not None and metre is not None:
                raise ValueError(f"gives its own unit, {unit}; leave out height_unit")
            if sides is None and spacing is None:
                raise ValueError(
                    'does not give the distance of its points; give spacing = "0.5 um" beside it'
                )
            if sides is not None and spacing is not None:
                raise ValueError("gives the distance of its points; leave out spacing")
            known = {} if sides is not None else {"physical_sizes": shape}
            heights = np.ma.filled(channel.topography(**known).heights().astype(float), np.nan)
    except ValueError:
        raise
    except Exception as error:  # whatever a damaged file makes the library stumble over
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise ValueError(f"cannot be read by SurfaceTopography ({reason})") from None
    scale = own if own is not None else metre
    steps = (
        (spacing, spacing)
        if sides is None
        else tuple(float(side) * own / n for side, n in zip(sides, shape, strict=True))
    )
    return _checked(heights * scale), steps
