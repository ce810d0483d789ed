"""A result on disk: what is read is what was written, and other files are refused."""

import gc
import weakref
from dataclasses import replace

import netCDF4
import numpy as np
import pytest
import xarray as xr
from synthetic_solution import (
    line_with_heat,
    make_hot_worm,
    make_line_solution,
    make_mesh_cycle,
    make_result,
    make_solution,
)

from pyworm.io.quantities import describe
from pyworm.result.result import open_result, open_solution


@pytest.fixture(scope="module")
def result():
    return make_result()


@pytest.fixture
def saved(result, tmp_path):
    return result.save(tmp_path / "result.nc")


def assert_same(one, other):
    assert one.case_name == other.case_name
    assert one.case == other.case
    assert one.provenance == other.provenance
    assert len(one.solutions) == len(other.solutions)
    for first, second in zip(one.solutions, other.solutions, strict=True):
        xr.testing.assert_identical(first.fields, second.fields)
        xr.testing.assert_identical(first.history, second.history)
        for name in first.fields:
            assert first.fields[name].dtype == second.fields[name].dtype
            assert first.fields[name].values.tobytes() == second.fields[name].values.tobytes()
        assert first.summary() == second.summary()
        assert (first.profile is None) == (second.profile is None)
        if first.profile is not None:
            xr.testing.assert_identical(first.profile, second.profile)
        empty = dict.fromkeys(("fields", "history", "profile"))
        assert replace(first, **empty) == replace(second, **empty)


def test_round_trip_bit_for_bit(result, saved):
    read = open_result(saved)
    assert_same(result, read)
    xr.testing.assert_identical(result.mesh_cycle, read.mesh_cycle)


def test_round_trip_without_a_drive(result, tmp_path):
    solutions = (make_solution(phase=None), make_line_solution())
    plain = replace(result, mesh_cycle=None, solutions=solutions)
    read = open_result(plain.save(tmp_path / "plain.nc"))
    assert_same(plain, read)
    assert read.mesh_cycle is None
    assert read.solutions[0].phase is None
    assert read.solutions[1].figures.dry is None


def test_round_trip_with_heat(result, tmp_path):
    ball = replace(make_solution(), slide_roll_ratio=-0.5)
    solutions = (make_hot_worm(), line_with_heat(make_line_solution()), ball)
    path = replace(result, mesh_cycle=None, solutions=solutions).save(tmp_path / "hot.nc")
    read = open_result(path)
    assert_same(replace(result, solutions=solutions), read)
    assert read.solutions[0].figures.temperature_max_film.grid == 0.01
    assert read.solutions[2].figures.friction_coefficient is None
    assert [solution.slide_roll_ratio for solution in read.solutions] == [None, None, -0.5]
    with netCDF4.Dataset(path) as file:
        scene = file["scene_000"]
        hottest = scene.temperature_max_C_film + 273.15
        assert hottest == pytest.approx(solutions[0].figures.temperature_max_film.value)
        for group in ("fields", "profile"):
            for name, variable in scene[group].variables.items():
                assert variable.units and variable.long_name, name


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
        {"load_N": 14e3, "drive": "worm", "effects": ["heat", "shear"], "grid": [3, 4]},
    )


def test_datasets_of_every_kind_are_kept(result, dataset, tmp_path):
    path = replace(result, mesh_cycle=dataset).save(tmp_path / "result.nc")
    read = open_result(path).mesh_cycle
    xr.testing.assert_identical(dataset, read)
    assert list(dataset.variables) == list(read.variables)
    for name, variable in dataset.variables.items():
        if name != "axis":
            assert variable.dtype == read[name].dtype, name
            assert variable.values.tobytes() == read[name].values.tobytes(), name


def test_only_what_repeats_is_compressed(result, dataset, tmp_path):
    path = replace(result, mesh_cycle=dataset).save(tmp_path / "result.nc")
    with netCDF4.Dataset(path) as file:
        variables = file["mesh_cycle"].variables
        compressed = {name for name, of in variables.items() if (of.filters() or {}).get("zlib")}
    assert compressed == {"covered"}


def test_more_than_ten_scenes_keep_their_order(result, tmp_path):
    small = make_solution(points=(5, 5))
    many = replace(result, solutions=tuple(replace(small, phase=i / 12) for i in range(12)))
    read = open_result(many.save(tmp_path / "many.nc"))
    assert [solution.phase for solution in read.solutions] == [i / 12 for i in range(12)]


def test_converged_needs_every_scene(result):
    assert not result.converged
    assert replace(result, solutions=result.solutions[:1]).converged


def test_file_explains_itself(saved):
    """Readable without pyworm: scalars with units in their names, every variable described."""
    with netCDF4.Dataset(saved) as file:
        assert file.format == "pyworm result"
        assert file["scene_000"].load_N == 14e3
        assert file["scene_001"].converged == 0
        for group in ("scene_000/fields", "scene_000/history", "mesh_cycle"):
            for name, variable in file[group].variables.items():
                assert variable.units, name
                assert variable.long_name, name


def test_nothing_keeps_a_result_that_was_read_and_saved(saved):
    """Not even until garbage is collected: what goes through many results would need memory for several."""
    gc.collect()
    gc.disable()
    try:
        read = open_result(saved)
        read.save(saved)
        pressure = weakref.ref(read.solutions[0].fields["pressure"].values)
        assert pressure() is not None
        del read
        assert pressure() is None
    finally:
        gc.enable()


def test_saving_over_a_result_leaves_only_the_new_one(result, saved):
    replace(result, case_name="again").save(saved)
    assert open_result(saved).case_name == "again"
    assert [path.name for path in saved.parent.iterdir()] == [saved.name]


def test_failed_save_leaves_the_old_file(result, saved):
    broken = replace(result, provenance={"tolerances": {1, 2}})
    with pytest.raises(AttributeError):
        broken.save(saved)
    unwritable = replace(result, mesh_cycle=xr.Dataset({"bad": ("phase", [{}])}))
    with pytest.raises(TypeError, match="dict"):
        unwritable.save(saved)
    assert [path.name for path in saved.parent.iterdir()] == [saved.name]
    assert_same(result, open_result(saved))


def test_files_that_are_not_results_are_refused(tmp_path):
    text = tmp_path / "notes.nc"
    text.write_text("not a result")
    with pytest.raises(ValueError, match=r"notes\.nc is not a pyworm result: it cannot be read"):
        open_result(text)
    other = tmp_path / "other.nc"
    xr.Dataset({"a": ("n", np.arange(3.0))}).to_netcdf(other, engine="netcdf4")
    with pytest.raises(ValueError, match=r"other\.nc is not a pyworm result: it is another kind"):
        open_result(other)
    with pytest.raises(FileNotFoundError, match="there is no result file at"):
        open_result(tmp_path / "missing.nc")


def test_another_format_version_is_refused(saved):
    tree = xr.load_datatree(saved, engine="netcdf4")
    tree.attrs["format_version"] = 99
    tree.to_netcdf(saved, engine="netcdf4")
    with pytest.raises(ValueError, match="has result format 99; this version of pyworm reads"):
        open_result(saved)


def test_mesh_cycle_data():
    cycle = make_mesh_cycle(5)
    assert cycle.sizes == {"phase": 5, "axis": 3}
    assert cycle["wheel_angle"].values == pytest.approx(cycle["worm_angle"].values * 3 / 59)
    assert cycle["radius_x"].values[0] == 3.5
    assert list(cycle["axis"].values) == ["x", "y", "z"]
    assert cycle["transmission_error"].attrs["units"] == "rad"


def test_unknown_variables_are_not_described():
    with pytest.raises(KeyError, match="surprise"):
        describe(xr.Dataset({"surprise": ("x", [1.0])}))


def test_a_result_of_several_solutions_is_no_solution(result, saved):
    with pytest.raises(ValueError, match=rf"has {len(result.solutions)} solutions: open it by pyw"):
        open_solution(saved)
