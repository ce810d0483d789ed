"""The stored atlas: one table in two files, and the formula's constants are of it."""

import csv
import sys

import numpy as np
import pytest
import xarray as xr
from folders import ROOT

ATLAS = ROOT / "atlas"


@pytest.fixture(scope="module")
def atlas():
    with xr.open_dataset(ATLAS / "films.nc", engine="netcdf4") as found:
        return found.load()


@pytest.fixture(scope="module")
def study():
    """The benchmark's own modules."""
    sys.path.insert(0, str(ROOT / "benchmarks"))
    try:
        from atlas import contacts, table

        yield contacts, table
    finally:
        sys.path.remove(str(ROOT / "benchmarks"))


def test_both_files_are_one_table(atlas):
    with (ATLAS / "films.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert set(rows[0]) == set(atlas.data_vars)
    assert len(rows) == atlas.sizes["contact"] == len({row["number"] for row in rows})
    for name in ("moes_m", "film_central", "film_min_error"):
        np.testing.assert_array_equal(atlas[name], [float(row[name]) for row in rows])
    assert all(of.attrs["long_name"] for of in atlas.data_vars.values())
    assert atlas.attrs["license"].startswith("BSD-3-Clause")


def test_certified_films_have_bars_of_half_a_per_cent(atlas):
    certified = atlas.where(atlas.certified == 1, drop=True)
    assert certified.sizes["contact"] > 3000
    for name in ("film_central", "film_min"):
        assert float(certified[f"{name}_error"].max()) <= 0.005
    assert (certified.film_min <= certified.film_central * 1.005).all()
    assert (certified.film_min > 0).all()


def test_contacts_are_those_of_the_sequence(atlas, study):
    contacts, _ = study
    sequence = contacts.sequence()
    for number, m, angle in zip(
        atlas.number.values[::37], atlas.moes_m.values[::37], atlas.angle.values[::37], strict=True
    ):
        assert sequence[int(number)].moes_m == pytest.approx(m, rel=1e-5)
        assert sequence[int(number)].angle == pytest.approx(angle, rel=1e-5)


def test_the_formula_is_that_of_the_table(study):
    """Errors of the fifth of the contacts that no fit has seen."""
    from pyworm.formulas.film_atlas import films

    contacts, table = study
    data = table.known(ATLAS / "films.csv", 0.02)
    held = set(contacts.order()[4::5])
    data = {name: of[[int(one) in held for one in data["number"]]] for name, of in data.items()}
    found = films(table.groups(data))
    missed = np.abs(
        np.log([found.central / data["film_central"], found.minimum / data["film_min"]])
    )
    median, most = np.percentile(missed, [50, 95], axis=1)
    print(len(data["number"]), median, most)
    assert len(data["number"]) > 650
    assert found.inside.mean() > 0.98
    assert (median < 0.02).all()
    assert most[0] < 0.05
    assert most[1] < 0.08
    assert (missed[0] <= found.central_error).mean() > 0.92
    assert (missed[1] <= found.minimum_error).mean() > 0.92
