"""Datasets in NetCDF files: xarray reads what is written here, and here is read what xarray writes."""

import h5py
import numpy as np
import pytest
import xarray as xr

from pyworm.netcdf import read_dataset, write_dataset


@pytest.fixture
def dataset():
    """All that results hold: numbers with NaN, counts, texts, scalars, and coordinates of both kinds."""
    digits = np.random.default_rng(1).random((40, 50))
    digits[3, 4] = np.nan
    dry = np.zeros((40, 50))
    dry[10:20] = digits[10:20]
    return xr.Dataset(
        {
            "film": (("y", "x"), digits, {"units": "m"}),
            "dry": (("y", "x"), dry, {"units": "Pa"}),
            "covered": (("y", "x"), np.ones((40, 50), np.int8)),
            "outline": ("edge", np.arange(7.0)),
            "place": ((), 0.25),
            "speed": ("level", np.arange(4)),
        },
        {
            "y": np.linspace(0, 1, 40),
            "x": ("x", np.linspace(0, 2, 50), {"units": "m"}),
            "axis": ["x", "long name"],
            "position": ("level", np.arange(4.0)),
        },
        {"load_N": 14e3, "drive": "zi-worm", "effects": ["heat", "shear"], "grid": [3, 4]},
    )


def assert_same(one, other):
    xr.testing.assert_identical(one, other)
    assert list(one.variables) == list(other.variables)
    for name, variable in one.variables.items():
        assert variable.dtype == other[name].dtype, name


def write(data, path):
    with h5py.File(path, "w", track_order=True) as file:
        write_dataset(file, data)
    return path


def test_xarray_reads_what_is_written(dataset, tmp_path):
    read = xr.load_dataset(write(dataset, tmp_path / "a.nc"), engine="h5netcdf")
    assert_same(dataset, read)


def test_what_xarray_writes_is_read(dataset, tmp_path):
    dataset.to_netcdf(tmp_path / "a.nc", engine="h5netcdf")
    with h5py.File(tmp_path / "a.nc") as file:
        assert_same(dataset, read_dataset(file))


def test_only_what_repeats_is_compressed(dataset, tmp_path):
    with h5py.File(write(dataset, tmp_path / "a.nc")) as file:
        assert {name for name in file if file[name].compression} == {"dry", "covered"}
        assert file["dry"].id.get_storage_size() < dataset["dry"].nbytes / 2
        assert_same(dataset, read_dataset(file))
