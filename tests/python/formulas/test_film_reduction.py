"""Films reduced by heat and shear thinning: limits, the thermal contacts of the atlas, and a solve."""

import csv
import sys
import warnings
from dataclasses import fields, replace

import numpy as np
import pytest
import xarray as xr
from folders import ROOT

import pyworm
from pyworm.formulas.film_atlas import AtlasGroups
from pyworm.formulas.film_reduction import HeatGroups, reduction
from pyworm.scene.formula_heat import heat_groups

ATLAS = ROOT / "atlas"

CONTACT = AtlasGroups(80.0, 4.0, 3.0, 0.4, 0.0, 0.9, 0.1)
HEAT = HeatGroups(0.3, 1.0, 1.0, 0.01, 0.006, 0.07, 0.2, 1e4, 1.0, 1.0)


@pytest.fixture(scope="module")
def study():
    """The benchmark's own modules."""
    sys.path.insert(0, str(ROOT / "benchmarks"))
    try:
        from atlas import fit_thermal, table, thermal_contacts

        yield fit_thermal, table, thermal_contacts
    finally:
        sys.path.remove(str(ROOT / "benchmarks"))


def test_without_heat_and_shear_nothing_is_reduced():
    for smaller in (1e-6, 1e-9):
        cold = replace(HEAT, loading=smaller**1.6, shear=smaller)
        found = reduction(CONTACT, 3.0, cold)
        assert float(found.central) == pytest.approx(1, abs=300 * smaller)
        assert float(found.minimum) == pytest.approx(1, abs=300 * smaller)


def test_factors_lie_between_nothing_and_one_everywhere():
    random = np.random.default_rng(4)
    count = 5000
    heat = HeatGroups(
        *(
            np.exp(random.uniform(np.log(low), np.log(high), count))
            for low, high in (
                (1e-4, 1e3), (1e-3, 4.0), (1e-4, 1e3), (1e-4, 1.0), (1e-4, 0.1), (0.01, 1.0),
                (1e-6, 1e3), (1.0, 1e9), (1e-6, 1e3), (1e-6, 1e3),
            )
        )
    )  # fmt: skip
    contacts = AtlasGroups(
        10 ** random.uniform(-1, 4, count), 10 ** random.uniform(-1, 1.5, count), 5.0, 1.0
    )
    found = reduction(contacts, 2.0, heat)
    for factor in (found.central, found.minimum):
        assert np.isfinite(factor).all()
        assert ((factor >= 0) & (factor <= 1)).all()
    assert not found.inside.all()


def test_factors_are_smooth():
    near = HeatGroups(*(getattr(HEAT, of.name) * 1.001 for of in fields(HEAT)))
    here, there = reduction(CONTACT, 3.0, HEAT), reduction(CONTACT, 3.0, near)
    assert float(there.central / here.central) == pytest.approx(1, abs=0.01)
    assert float(there.minimum / here.minimum) == pytest.approx(1, abs=0.01)


def test_the_thermal_files_are_one_table(study):
    _, _, thermal = study
    with (ATLAS / "thermal.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    with xr.open_dataset(ATLAS / "thermal.nc", engine="netcdf4") as found:
        assert set(rows[0]) == set(found.data_vars)
        np.testing.assert_array_equal(
            found.film_central, [float(of["film_central"]) for of in rows]
        )
        assert all(of.attrs["long_name"] for of in found.data_vars.values())
    order = thermal.thermal_order()
    assert {int(of["number"]) for of in rows} <= set(order[:1500])
    certified = [of for of in rows if of["certified"] == "1"]
    assert len(certified) > 0.9 * len(rows)
    assert len(rows) == 1500
    assert max(float(of["film_min_error"]) for of in certified) <= 0.05
    heats = thermal.heats()
    for of in certified[::40]:
        assert heats[int(of["number"])].loading == pytest.approx(float(of["loading"]), rel=1e-5)


def test_contacts_that_the_fit_has_not_seen_lie_within_the_bars(study):
    fit, table, thermal = study
    data = table.known(ATLAS / "thermal.csv", fit.FITTED_BAR)
    held = set(thermal.thermal_order()[4::5])
    data = {name: of[[int(one) in held for one in data["number"]]] for name, of in data.items()}
    of = table.groups(data)
    central, lost, bars = fit.factors(data, of, table.known(ATLAS / "films.csv", fit.LARGEST_BAR))
    found = reduction(of, central, fit.heat_of(data, central))
    told = np.stack([found.central, found.minimum], axis=1)
    errors = np.stack([found.central_error, found.minimum_error], axis=1)
    missed = np.abs(np.log(told) + lost)
    print(len(of.moes_m), np.percentile(missed, [50, 95], axis=0))
    assert len(of.moes_m) > 250
    assert (np.median(missed, axis=0) < 0.04).all()
    assert ((missed <= errors + bars).mean(axis=0) > 0.9).all()


def test_a_contact_beyond_the_set_agrees_with_a_solve(study):
    """One whose numbers end long after those of the set: no fit has seen its like."""
    _, _, thermal = study
    scene = thermal.thermal_contact(thermal.thermal_order()[1600])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pyworm.UnusualWarning)
        plan = pyworm.plan(scene, 0.05, "all", ("film",))
    solved = pyworm.solve(scene, plan).figures
    cold, found = pyworm.film_of(scene), pyworm.film_of(scene, reduced=True)
    assert "film-heating" in found.holds
    assert cold.holds == ()
    for told, error, film, without in (
        (found.central, found.central_error, solved.film_central, cold.central),
        (found.minimum, found.minimum_error, solved.film_min, cold.minimum),
    ):
        print(float(told), float(error), film, float(without))
        assert abs(float(told) / film.value - 1) <= float(error) + film.error


def test_a_scene_has_the_groups_that_its_numbers_have(study):
    _, _, thermal = study
    number = thermal.thermal_order()[5]
    scene, heat = thermal.thermal_contact(number), thermal.heats()[number]
    found = heat_groups(scene, 1e-7)
    for name in ("loading", "sliding", "conductivity_ratio", "eyring"):
        assert float(getattr(found, name)) == pytest.approx(getattr(heat, name), rel=1e-3)
    assert float(found.limiting) == pytest.approx(heat.limiting + heat.eyring, rel=1e-3)


def test_without_data_films_are_those_without_heat():
    scene = pyworm.load(ROOT / "cases" / "ellipse10_oblique.toml").scene()
    assert pyworm.film_of(scene, reduced=True) == pyworm.film_of(scene)
