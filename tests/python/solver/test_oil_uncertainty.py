"""Uncertainty of films by pressure-viscosity coefficients that were not measured."""

import csv
from dataclasses import replace

import pytest
from folders import CASES, DATA

import pyworm
from pyworm.formulas.oil_properties import gold_alpha
from pyworm.materials.base_stock import BASES, base_stock
from pyworm.solver.oil_uncertainty import FILMS, oil_uncertainty

DATA = DATA / "measured_alpha.csv"
BALL = CASES / "ball_pag_460.toml"

with DATA.open() as file:
    MEASURED = list(csv.DictReader(file))


def ball(oil: str, **changed) -> pyworm.Scene:
    """A smooth ball on a disc in an oil of the library at 60 degC."""
    scene = pyworm.load(BALL).scene()
    bodies = tuple(replace(body, roughness=None) for body in scene.bodies)
    return replace(scene, bodies=bodies, oil=replace(pyworm.named_oil(oil).oil(333.15), **changed))


@pytest.mark.parametrize("row", MEASURED, ids=lambda row: f"{row['oil']} at {row['temperature_C']}")
def test_measured_oils_lie_within_the_spread_of_their_base_stock(row):
    stock = base_stock(row["base"])
    gold = float(gold_alpha(float(row["viscosity_mm2_s"]) * 1e-6, stock.gold_s, stock.gold_t))
    assert abs(float(row["alpha_per_GPa"]) * 1e-9 / gold - 1) <= stock.alpha_spread


@pytest.mark.parametrize(("base", "below"), [("mineral", 0.22), ("PAG", 0.30)])
def test_a_library_oil_may_be_as_far_below_measured_ones_as_was_found(base, below):
    """13 to 22 % of mineral oils and 30 % of polyglycol at 30 degC, of the measured coefficient."""
    assert 1 / (1 - below) - 1 < base_stock(base).alpha_spread + 0.005


def test_every_base_stock_has_a_spread_and_a_source_of_it():
    for base in BASES:
        assert base_stock(base).alpha_spread > 0
        assert "alpha_spread" in base_stock(base).sources


@pytest.mark.parametrize("oil", ["mineral VG 220", "PAG VG 460"])
def test_films_follow_the_coefficient_as_solved_anew(oil):
    """The closed form's change against that of two whole solutions, within a tenth of it."""
    scene = ball(oil)
    law = scene.oil.viscosity
    thinner = replace(law, z=law.z / (1 + scene.oil.alpha_spread))
    solved = [
        pyworm.solve(at, pyworm.plan(at, accuracy=0.05)).figures
        for at in (scene, replace(scene, oil=replace(scene.oil, viscosity=thinner)))
    ]
    for name in FILMS:
        change = getattr(solved[0], name).value / getattr(solved[1], name).value - 1
        assert getattr(solved[0], name).model == pytest.approx(change, rel=0.1)
    assert solved[0].pressure_max.model is None


def test_a_measured_coefficient_has_no_spread():
    scene = ball("PAO VG 220", alpha_spread=0.0)
    assert oil_uncertainty(scene) == {}
    assert pyworm.load(BALL).scene().oil.alpha_spread == 0  # its file gives alpha


def test_it_adds_to_that_of_roughness_by_squares():
    rough = replace(ball("mineral VG 220"), bodies=pyworm.load(BALL).scene().bodies)
    known = replace(rough, oil=replace(rough.oil, alpha_spread=0.0))
    both, alone = (
        pyworm.solve(at, pyworm.plan(at, accuracy=0.05)).figures for at in (rough, known)
    )
    by_oil = oil_uncertainty(rough)
    for name in FILMS:
        total = getattr(both, name).model ** 2
        assert total == pytest.approx(by_oil[name] ** 2 + getattr(alone, name).model ** 2, rel=1e-6)
    assert both.friction_coefficient.model == alone.friction_coefficient.model
