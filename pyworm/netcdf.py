"""Datasets as groups of a NetCDF-4 file, each in one pass over the group.

The layout is that of xarray and h5netcdf, which read and write it too, but ask the file for every dimension
of every variable many times over: with the result of a mesh cycle that took longer than its numbers.
"""

from collections.abc import Mapping
from typing import Any

import h5py
import numpy as np
import xarray as xr

_NO_VARIABLE = "This is a netCDF dimension but not a netCDF variable."
"""Begins the name of a scale that only gives a dimension's size."""

_LAYOUT = {
    *("CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST", "coordinates", "_FillValue"),
    *("_Netcdf4Dimid", "_Netcdf4Coordinates", "_NCProperties"),
}
"""Attributes that belong to the layout, not to the dataset."""

_WORTH, _REPEATED = 1000, 0.1
"""Least size of values that are compressed, and least share of them that repeat their neighbours."""


def write_dataset(group: h5py.Group, data: xr.Dataset) -> None:
    """Write a dataset of numbers and texts into an empty group that tracks its order.

    Raises
    ------
    TypeError
        A variable holds anything else.
    """
    write_attributes(group, data.attrs)
    for name, size in data.sizes.items():
        if name not in data.variables:
            scale = group.create_dataset(name, (size,), ">f4")
            scale.make_scale(f"{_NO_VARIABLE}{size:10d}")
    for name, variable in data.variables.items():
        values, attributes = variable.values, dict(variable.attrs)
        if values.dtype.kind == "f":
            attributes["_FillValue"] = values.dtype.type(np.nan)
        others = [one for one in data[name].coords if one not in data.sizes and one != name]
        if others:
            attributes["coordinates"] = " ".join(others)
        if values.dtype.kind in "UO":
            values = values.astype(h5py.string_dtype())
        stored = group.create_dataset(name, data=values, **_storage(values))
        write_attributes(stored, attributes)
        if name in data.sizes:
            stored.make_scale(name)
    for name in data.variables.keys() - data.sizes.keys():
        for axis, dimension in enumerate(data[name].dims):
            group[name].dims[axis].attach_scale(group[dimension])


def read_dataset(group: h5py.Group) -> xr.Dataset:
    """The dataset in a group."""
    stored = {name: item for name, item in group.items() if isinstance(item, h5py.Dataset)}
    scales = {item: name for name, item in stored.items() if item.is_scale}
    variables, coordinates = {}, set()
    for name, item in stored.items():
        layout = dict(item.attrs)
        if layout.get("NAME", b"").startswith(_NO_VARIABLE.encode()):
            continue
        references = layout.get("DIMENSION_LIST", ())
        dimensions = [name] if item in scales else [scales[group[one]] for (one,) in references]
        texts = h5py.check_string_dtype(item.dtype)
        values = item.asstr()[()].astype(str) if texts else item[()]
        variables[name] = (dimensions, values, read_attributes(item))
        coordinates |= set(layout.get("coordinates", "").split())
    return xr.Dataset(variables, attrs=read_attributes(group)).set_coords(coordinates)


def write_attributes(item: h5py.HLObject, attributes: Mapping[str, Any]) -> None:
    """Write attributes; a number as a list of one, as NetCDF has it."""
    for name, value in attributes.items():
        item.attrs[name] = value if isinstance(value, str) or np.ndim(value) else [value]


def read_attributes(item: h5py.HLObject) -> dict[str, Any]:
    """The attributes of a group or a variable."""
    return {
        name: value[0] if np.shape(value) == (1,) else value
        for name, value in item.attrs.items()
        if name not in _LAYOUT
    }


def _storage(values: np.ndarray) -> dict[str, Any]:
    """How values are kept: of those that do not repeat, compression saves a tenth for most of the time."""
    if values.size < _WORTH or np.mean(values[1:] == values[:-1]) < _REPEATED:
        return {}
    return {"compression": "gzip", "compression_opts": 1, "shuffle": True, "chunks": values.shape}
