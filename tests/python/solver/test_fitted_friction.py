"""Friction of asperities fitted to the worm standard, each row predicted by a fit to all others.

tests/data/boundary_friction.csv has contacts of the standard's reference gear, solved by
`benchmarks/validation/boundary_friction.py`: fit, rows left out and constants of the library are made of them
here anew.
"""

import tomllib
from functools import partial
from pathlib import Path
from unittest.mock import patch

import numpy as np
import pytest
from boundary_friction import watched
from boundary_friction_fit import (
    MATERIAL,
    OILS,
    PHASES,
    REFERENCE,
    ROWS,
    WHEELS,
    Row,
    contact_model,
    contacts_of,
    fitted,
    over_the_mesh,
    refitted,
)

import pyworm
from pyworm.case.case import case_of
from pyworm.case.fitted_friction import FITTED_SPREADS
from pyworm.formulas.worm_wheel_material import WHEEL_MATERIALS
from pyworm.materials.base_stock import base_stock
from pyworm.materials.body import Body
from pyworm.materials.roughness_assumptions import (
    BOUNDARY_FRICTION_SPREAD,
    REFITTED,
)
from pyworm.result.contact_loss import contact_losses

MANY = Row(MATERIAL, "mineral", 150), Row(MATERIAL, "mineral", 1500)
"""Rows solved at nine phases too."""


@pytest.fixture(scope="module")
def fit():
    return fitted()


def test_nineteen_of_twenty_rows_left_out_lie_in_the_model_uncertainty(fit):
    print(
        f"{fit.held.sum()} of {len(ROWS)} rows, bars {fit.bars.min():.1%} to {fit.bars.max():.1%}"
    )
    assert fit.held.sum() >= 0.95 * len(ROWS)
    assert np.median(fit.bars) < 0.25 and fit.bars.max() < 0.32


def test_a_row_left_out_is_not_in_its_own_fit(fit):
    """Some would need a mu_b more than a tenth off, and predictions are not the standard's values."""
    assert np.abs(fit.off).max() > 0.1
    assert np.abs(fit.predicted / fit.wanted - 1).min() > 0
    whole = np.array([fit.mu_b[row.oil] * fit.factors.get(row.wheel, 1.0) for row in ROWS])
    closer = [
        abs(over_the_mesh(row).friction(mu_b) - wanted) < abs(predicted - wanted)
        for row, mu_b, wanted, predicted in zip(ROWS, whole, fit.wanted, fit.predicted, strict=True)
    ]
    assert all(closer)


def test_the_library_has_the_fit(fit):
    for oil, mu_b in fit.mu_b.items():
        assert base_stock(oil).boundary_friction == pytest.approx(mu_b, abs=6e-4), oil
    for wheel, factor in fit.factors.items():
        assert Body.from_name(wheel).boundary_friction_factor == pytest.approx(factor, abs=6e-3), (
            wheel
        )
    assert pytest.approx(fit.spreads, abs=2e-3) == FITTED_SPREADS
    assert pytest.approx(refitted(), abs=0.015) == REFITTED


@pytest.mark.parametrize("row", MANY, ids=lambda row: str(row.speed))
def test_five_phases_make_the_mesh_mean(row):
    many = over_the_mesh(row, tuple(np.arange(1, 10) / 10)).loss.friction
    assert over_the_mesh(row).loss.friction == pytest.approx(many, rel=0.02)


@pytest.mark.long
@pytest.mark.parametrize("row", [Row(MATERIAL, "PAG", 1500)], ids=str)
def test_a_kept_contact_is_what_the_solver_finds(row):
    """With the mu_b and the spread of the library, and how friction follows mu_b and laws of contact."""
    (kept,) = contacts_of(row, (0.5,))
    scene, changes = row.case().scene(phase=0.5), {}
    assert scene.oil.boundary_friction_spread == FITTED_SPREADS["tin bronze"]
    # its first grid had the usual cells
    with (
        patch("pyworm.planning.expected_work.MAX_SPACING_FACTOR", 1.0),
        patch("pyworm.solver.contact.roughness_uncertainty", partial(watched, changes)),
    ):
        solution = pyworm.solve(scene, pyworm.plan(scene, 0.2, ("auto", "-squeeze")))
    (contact,) = contact_losses([solution])
    ratio = scene.boundary_friction / kept["mu_b"]
    expected = kept["friction"] * (1 + kept["rubbing"] * (ratio - 1))
    assert contact.friction == pytest.approx(expected, rel=0.02)
    assert contact.model == pytest.approx(contact_model(kept, "tin bronze"), rel=0.03)
    assert changes == pytest.approx({key: kept[key] for key in changes}, rel=0.05)


def test_rows_were_solved_with_the_friction_of_the_library():
    """So near to it that friction follows mu_b in a straight line."""
    for row in ROWS:
        solved = over_the_mesh(row).mu_b
        assert row.case().scene(phase=0.5).boundary_friction == pytest.approx(solved, rel=0.03), row
        assert {one["mu_b"] for one in contacts_of(row, PHASES)} == {solved}


OTHERS = {
    "own mu_b": ("[oil]\n", "[oil]\nboundary_friction = 0.08\n"),
    "own factor": ("[bodies.wheel]\n", "[bodies.wheel]\nboundary_friction_factor = 1.1\n"),
    "brass": (MATERIAL, "CuZn37Mn3Al2PbSi"),
    "ester": (OILS["mineral"], "ester VG 320"),
}


@pytest.mark.parametrize("other", OTHERS)
def test_what_was_not_fitted_has_the_uncertainty_of_what_is_assumed(other):
    assert OTHERS[other][0] in REFERENCE
    data = tomllib.loads(REFERENCE.replace(*OTHERS[other]))
    drive = case_of(data, "reference_gear", Path()).drive
    assert drive.oil.boundary_friction_spread is None


def test_what_was_fitted_has_the_spread_of_its_group_of_materials():
    for wheel in WHEELS:
        spread = Row(wheel, "mineral", 150).case().drive.oil.boundary_friction_spread
        assert spread == FITTED_SPREADS[WHEEL_MATERIALS[wheel].family]
    assert max(FITTED_SPREADS.values()) < BOUNDARY_FRICTION_SPREAD
