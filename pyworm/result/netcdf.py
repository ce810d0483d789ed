"""Datasets, plain or xarray's, as the groups of a NetCDF file, as xarray reads them.

All variables are defined before the first is written, which xarray does not do: the library goes through all
definitions at each change from one to the other.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from pyworm.io.on_demand import xarray as xr
from pyworm.io.plain_dataset import PlainDataset

_WORTH, _REPEATED = 1000, 0.9
"""Least number of values, and least fraction that repeat their neighbours, for compression: of marks
and constants hardly anything is left."""

_LOW_BYTE = np.uint32(0xFF)
"""Last digits of single precision: where all are zero, as of rounded fields, compression is worth it. Other
fields take longer to compress than to write."""


def as_netcdf(groups: "Mapping[str, PlainDataset | xr.Dataset]") -> memoryview:
    """The content of a file of groups by their paths, "/" for that of the file itself.

    It is made in memory, since the library reports a full disk without the reason.
    """
    from netCDF4 import Dataset

    file = Dataset("result", "w", memory=0)
    defined = [
        pair for path, data in groups.items() for pair in _defined(file.createGroup(path), data)
    ]
    for variable, values in defined:
        variable[...] = values
    return file.close()


def _defined(group: Any, data: "PlainDataset | xr.Dataset") -> list[tuple[Any, np.ndarray]]:
    """The variables of a dataset, defined in a group, with their values."""
    beside = [str(name) for name in data.coords if name not in data.dims]
    group.setncatts(dict(data.attrs) | ({"coordinates": " ".join(beside)} if beside else {}))
    for name, size in data.sizes.items():
        group.createDimension(name, size)
    defined = []
    for name, column in data.variables.items():
        values = column.values
        text = values.dtype.kind in "OUT"
        kind, storage = (str, {}) if text else (values.dtype, _storage(values))
        variable = group.createVariable(name, kind, column.dims, **storage)
        variable.setncatts(column.attrs)
        defined.append((variable, values.astype(object) if text else values))
    return defined


def _storage(values: np.ndarray) -> dict[str, Any]:
    """Storage options: values that repeat their neighbours, or are rounded, are compressed."""
    if values.size < _WORTH or not (_is_rounded(values) or _repeats(values)):
        return {"fill_value": False}
    return {"zlib": True, "complevel": 1, "shuffle": True, "chunksizes": values.shape}


def _is_rounded(values: np.ndarray) -> bool:
    if values.dtype != np.float32:
        return False
    return not (np.ascontiguousarray(values).view(np.uint32) & _LOW_BYTE).any()


def _repeats(values: np.ndarray) -> bool:
    return bool(np.mean(values[1:] == values[:-1]) >= _REPEATED)
