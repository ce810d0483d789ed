"""Gap arrays read from npz and NetCDF files."""

from math import prod
from pathlib import Path
from zipfile import ZipFile

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.scene.sampled_gap import SampledGap

METRES = ("m", "metre", "metres", "meter", "meters")
"""Accepted values of the attribute `units`."""

MOST_SAMPLES = 50_000_000
"""Numbers of the largest array that is read: 400 MB."""


def read_gap(path: str | Path) -> SampledGap:
    """Read a gap from an npz or a NetCDF file.

    Args:
        path (str or Path): `.npz` with `gap` (y, x), `dx`, `dy` and, unless the contact point is in the
            middle, the coordinates `x0`, `y0` of the first sample, all in metres; or `.nc` with a variable
            `gap` and coordinates `x`, `y`.

    Raises:
        ValueError: No such file, of another kind, a key missing, or not a gap.
    """
    path = Path(path)
    if not path.is_file():
        raise ValueError("no such file")
    if path.suffix == ".npz":
        return _read_npz(path)
    if path.suffix == ".nc":
        return _read_netcdf(path)
    raise ValueError("must be an .npz or an .nc file")


def require_readable(samples: int) -> None:
    """Refuse an array that is too large, before memory is allocated."""
    if samples > MOST_SAMPLES:
        raise ValueError(f"it holds an array of {samples} numbers, {MOST_SAMPLES} are read at most")


def _read_npz(path: Path) -> SampledGap:
    try:
        with ZipFile(path) as archive:
            held = [name.removesuffix(".npy") for name in archive.namelist()]
            arrays = {
                key: _read_array(archive, key, most)
                for key, most in (*((key, 1) for key in _LENGTHS), ("gap", MOST_SAMPLES))
                if key in held
            }
    except ValueError:
        raise
    except Exception as error:  # whatever a damaged archive makes the library stumble over
        raise ValueError(f"cannot be read as an npz file of numbers ({error})") from None
    for key in ("gap", "dx", "dy"):
        if key not in arrays:
            raise ValueError(f"{key} is missing; it has {', '.join(held) or 'nothing'}")
    gap = arrays.pop("gap")
    if gap.ndim != 2:
        raise ValueError(f"gap must have two dimensions (y, x), not {gap.ndim}")
    axes = []
    for name, count in (("x", gap.shape[1]), ("y", gap.shape[0])):
        spacing = arrays[f"d{name}"]
        if not (np.isfinite(spacing) and spacing > 0):
            raise ValueError(f"d{name} must be one length greater than zero, in metres")
        start = arrays.get(f"{name}0", -(count - 1) / 2 * spacing)
        axes.append(start + spacing * np.arange(count))
    x, y = axes
    return SampledGap(x, y, gap)


_LENGTHS = ("dx", "dy", "x0", "y0")
"""Scalar lengths of an npz file."""

_HEADERS = {
    (1, 0): np.lib.format.read_array_header_1_0,
    (2, 0): np.lib.format.read_array_header_2_0,
}
"""Readers of the header by version of the npy format."""


def _read_array(archive: ZipFile, key: str, most: int) -> Array:
    """Read one array of an npz file, of `most` numbers at most.

    Its header and the archive's directory have to agree on its size before memory is allocated. ValueError if
    it is too large, cut short, or holds no numbers.
    """
    name = f"{key}.npy"
    with archive.open(name) as file:
        shape, _, kind = _HEADERS[np.lib.format.read_magic(file)](file)
        held = archive.getinfo(name).file_size - file.tell()
    if most == 1 and (shape or kind.kind not in "iuf"):
        raise ValueError(f"{key} must be one length, in metres")
    if kind.kind not in "iuf":
        raise ValueError(f"cannot be read as an npz file of numbers ({key} holds {kind})")
    count = prod(shape)
    require_readable(count)
    if held != count * kind.itemsize:
        raise ValueError(
            f"cannot be read as an npz file of numbers ({key} has {held} bytes of numbers for {count})"
        )
    with archive.open(name) as file:
        return np.lib.format.read_array(file, allow_pickle=False).astype(float)


_VARIABLES = ("gap", "x", "y")
"""Variables of a gap in a NetCDF file."""


def _read_netcdf(path: Path) -> SampledGap:
    import xarray as xr

    try:
        with xr.open_dataset(path, engine="netcdf4") as file:
            held = [str(name) for name in file.variables]
            file = file[[key for key in _VARIABLES if key in held]]
            require_readable(max((array.size for array in file.variables.values()), default=0))
            file.load()
    except Exception as error:
        raise ValueError(f"cannot be read as a NetCDF file ({error})") from None
    for key in _VARIABLES:
        if key not in held:
            raise ValueError(f"{key} is missing; it has {', '.join(held)}")
    for key in _VARIABLES:
        unit = file[key].attrs.get("units", "m")
        if unit not in METRES:
            raise ValueError(f"{key} is in {unit}; it must be in metres")
    if set(file["gap"].dims) != {"x", "y"}:
        raise ValueError(f"gap must have the dimensions (y, x), not {file['gap'].dims}")
    gap = file["gap"].transpose("y", "x")
    return SampledGap(*(np.asarray(array, dtype=float) for array in (gap.x, gap.y, gap)))
