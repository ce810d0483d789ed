"""Files of instruments, through the package SurfaceTopography."""

from math import prod
from pathlib import Path
from typing import Any
from zipfile import is_zipfile

import numpy as np

from pyworm.io.present import present
from pyworm.surfaces.plausible import plausible_side
from pyworm.surfaces.point_list import evenly_spaced
from pyworm.surfaces.text_header import metres_of

Array = np.ndarray

NO_INSTRUMENT = ("hgt",)
"""Formats of maps of land, for which any file of the right length may be taken."""


def read_instrument(
    path: Path,
    metres: float | None,
    spacing: float | None,
    most: int,
    name: str | int | None = None,
) -> tuple[Array, tuple[float, ...]]:
    """Heights [m] of an instrument's file, NaN where points are missing, and their spacing [m].

    They are those of an area, shape (nx, ny), or of a profile, (n,), of the channel of a name or number, or
    the file's own choice. `metres` of a unit and the spacing are used where it does not give them itself.
    ValueError if it cannot be read, has no such channel, too many points, no heights, or lacks unit or
    spacing.
    """
    library = _library()
    try:
        with library.open_topography(str(path)) as reader:
            channel = _channel(library, reader, most, name)
            scale, steps = _scales(channel, metres, spacing)
            known = {} if channel.physical_sizes else {"physical_sizes": channel.nb_grid_pts}
            measured = channel.topography(**known)
            if channel.dim == 1 and not channel.is_uniform:
                points = np.array(measured.positions_and_heights(), dtype=float).T
                heights, distance = evenly_spaced(points, most)
                steps = (distance * scale,)
            else:
                heights = np.ma.filled(measured.heights().astype(float), np.nan)
    except library.Exceptions.CannotDetectFileFormat:
        if is_zipfile(path):
            raise ValueError("is an archive; unpack it, and give a file that was in it") from None
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


def _channel(library: Any, reader: Any, most: int, name: str | int | None) -> Any:
    if reader.format() in NO_INSTRUMENT:
        raise ValueError("is no file of an instrument that SurfaceTopography knows")
    channel = reader.default_channel if name is None else _named(reader.channels, name)
    if channel.data_kind is not library.IO.Reader.DataKind.HEIGHT:
        raise ValueError(f"holds no heights but {channel.name}, a {channel.data_kind.value}")
    shape = channel.nb_grid_pts
    if prod(shape) > most:
        size = " x ".join(f"{count}" for count in shape)
        raise ValueError(f"has {size} points, {most} are read at most; give a part of it")
    return channel


def _named(channels: Any, name: str | int) -> Any:
    """The first channel of a name, or that of a number from 1 on."""
    if isinstance(name, int):
        if 1 <= name <= len(channels):
            return channels[name - 1]
    else:
        for channel in channels:
            if channel.name == name:
                return channel
    known = ", ".join(f"{number} {channel.name}" for number, channel in enumerate(channels, 1))
    raise ValueError(f"has no channel {name!r}; its channels are {known}")


def _scales(
    channel: Any, metres: float | None, spacing: float | None
) -> tuple[float, tuple[float, ...]]:
    """Metres of a unit of the heights, and the distances of points [m], by the file or in its place."""
    unit, sides, shape = channel.unit, channel.physical_sizes, channel.nb_grid_pts
    file_unit = None if unit is None else metres_of(str(unit))
    if unit is not None and file_unit is None:
        raise ValueError(f'has numbers in "{unit}"; heights are needed')
    if file_unit is None and metres is None:
        distance = ' and spacing = "0.5 um"' if sides is None and spacing is None else ""
        raise ValueError(f'does not give its unit; give height_unit = "um"{distance} with it')
    if file_unit is not None and metres is not None:
        raise ValueError(f"gives its own unit, {unit}; omit height_unit")
    scale = file_unit if file_unit is not None else present(metres, "height_unit")
    steps = None
    if sides is not None:
        steps = tuple(float(side) * scale / n for side, n in zip(sides, shape, strict=True))
    if steps is None and spacing is None:
        raise ValueError(
            'does not give the distance of its points; give spacing = "0.5 um" with it'
        )
    if steps is None or (spacing is not None and not plausible_side(shape, steps)):
        return scale, (present(spacing, "spacing"),) * len(shape)
    if spacing is not None:
        raise ValueError("gives the distance of its points; omit spacing")
    return scale, steps
