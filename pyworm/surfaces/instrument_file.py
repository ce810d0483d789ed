"""Files of instruments, through the package SurfaceTopography."""

from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.io.present import present
from pyworm.surfaces.plausible import plausible_side
from pyworm.surfaces.text_header import metres_of

Array = np.ndarray

NO_INSTRUMENT = ("hgt",)
"""Formats of maps of land, for which any file of the right length may be taken."""

_COMPRESSED = {b"\x1f\x8b": "gz", b"BZh": "bz2", b"\xfd7zXZ": "xz"}
"""How compressed files begin; formats that are archives themselves begin otherwise."""


def is_compressed(begin: bytes) -> bool:
    """Whether a file that begins so is compressed as a whole."""
    return begin.startswith(tuple(_COMPRESSED))


def read_instrument(
    path: Path, metres: float | None, spacing: float | None, most: int
) -> tuple[Array, tuple[float, float]]:
    """Heights [m] of an instrument's file, NaN where points are missing, and their spacing [m].

    `metres` of a unit and the spacing are used where it does not give them itself. ValueError if it cannot be
    read, has too many points, holds no heights of an area, or lacks unit or spacing.
    """
    with path.open("rb") as file:
        if is_compressed(file.read(8)):
            raise ValueError("is compressed; unpack it, and give the file that was in it")
    library = _library()
    try:
        with library.open_topography(str(path)) as reader:
            channel = _channel(library, reader, most)
            scale, steps = _scales(channel, metres, spacing)
            known = {} if channel.physical_sizes else {"physical_sizes": channel.nb_grid_pts}
            heights = np.ma.filled(channel.topography(**known).heights().astype(float), np.nan)
    except library.Exceptions.CannotDetectFileFormat:
        raise ValueError("is no file of an instrument that SurfaceTopography knows") from None
    except ValueError:
        raise
    except Exception as error:  # whatever a damaged file makes the library stumble over
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise ValueError(
            f"cannot be read by SurfaceTopography ({reason}); if it is whole, export it as text"
        ) from None
    return heights * scale, steps


def _library() -> Any:
    try:
        import SurfaceTopography
        import SurfaceTopography.Exceptions
    except ImportError:
        raise ValueError(
            "is a format of an instrument, which the package SurfaceTopography reads: "
            'pip install "pyworm[surfaces]"'
        ) from None
    return SurfaceTopography


def _channel(library: Any, reader: Any, most: int) -> Any:
    if reader.format() in NO_INSTRUMENT:
        raise ValueError("is no file of an instrument that SurfaceTopography knows")
    channel = reader.default_channel
    if channel.data_kind is not library.IO.Reader.DataKind.HEIGHT:
        raise ValueError(f"holds no heights but {channel.name}, a {channel.data_kind.value}")
    shape = channel.nb_grid_pts
    if len(shape) != 2:
        raise ValueError("is a profile along a line; heights of an area are needed")
    if prod(shape) > most:
        raise ValueError(
            f"has {shape[0]} x {shape[1]} points, {most} are read at most; give a part of it"
        )
    return channel


def _scales(
    channel: Any, metres: float | None, spacing: float | None
) -> tuple[float, tuple[float, float]]:
    """Metres of a unit of the heights, and the distances of points [m], by the file or in its place."""
    unit, sides, shape = channel.unit, channel.physical_sizes, channel.nb_grid_pts
    file_unit = None if unit is None else metres_of(str(unit))
    if unit is not None and file_unit is None:
        raise ValueError(f'has numbers in "{unit}"; heights are needed')
    if file_unit is None and metres is None:
        raise ValueError('does not give its unit; give height_unit = "um" with it')
    if file_unit is not None and metres is not None:
        raise ValueError(f"gives its own unit, {unit}; omit height_unit")
    scale = file_unit if file_unit is not None else present(metres, "height_unit")
    steps = None
    if sides is not None:
        step_x, step_y = (float(side) * scale / n for side, n in zip(sides, shape, strict=True))
        steps = step_x, step_y
    if steps is None and spacing is None:
        raise ValueError(
            'does not give the distance of its points; give spacing = "0.5 um" with it'
        )
    if steps is None or (spacing is not None and not plausible_side(shape, steps)):
        step = present(spacing, "spacing")
        return scale, (step, step)
    if spacing is not None:
        raise ValueError("gives the distance of its points; omit spacing")
    return scale, steps
