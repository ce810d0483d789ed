"""Moduli that fall with temperature."""

from dataclasses import replace
from math import sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pyworm.materials import solids
from pyworm.materials.body import Body, reduced_modulus
from pyworm.materials.softening import modulus_at

CURVE = (("20 degC", "4 GPa"), ("100 degC", "1 GPa"))
PLASTICS = [
    name for name in solids.materials() if "modulus_by_temperature" in solids.constants(name)
]


def body(**given):
    return Body(4e9, 0.38, modulus_by_temperature=CURVE, **given)


def test_a_body_has_the_modulus_of_its_bulk_temperature():
    assert body(bulk_temperature="20 degC").youngs_modulus == pytest.approx(4e9)
    assert body(bulk_temperature="100 degC").youngs_modulus == pytest.approx(1e9)
    # the logarithm is interpolated: half-way the geometric mean
    halfway = body(bulk_temperature="60 degC")
    assert halfway.youngs_modulus == pytest.approx(sqrt(4e9 * 1e9))
    # without a temperature the one that is given, beyond the points that of the nearest
    assert body().youngs_modulus == 4e9
    assert body(bulk_temperature="180 degC").youngs_modulus == pytest.approx(1e9)


def test_a_body_that_is_warmed_softens_and_one_that_cools_stiffens_again():
    cold = body(bulk_temperature="20 degC")
    hot = replace(cold, bulk_temperature=373.15)
    assert hot.youngs_modulus == pytest.approx(1e9)
    assert replace(hot, bulk_temperature=293.15).youngs_modulus == pytest.approx(4e9)
    assert body().warm_at("100 degC").youngs_modulus == pytest.approx(1e9)


def test_a_soft_body_rules_the_reduced_modulus():
    steel = Body.from_name("42CrMo4", bulk_temperature="100 degC")
    cold, hot = (Body.from_name("PEEK", bulk_temperature=t) for t in ("23 degC", "160 degC"))
    ratio = reduced_modulus(steel, hot) / reduced_modulus(steel, cold)
    assert ratio == pytest.approx(hot.youngs_modulus / cold.youngs_modulus, rel=0.02)
    assert hot.youngs_modulus < cold.youngs_modulus / 3


@pytest.mark.parametrize("name", PLASTICS)
@given(low=st.floats(250, 550), step=st.floats(0, 300))
def test_moduli_of_the_list_never_rise_with_temperature(name, low, step):
    points = Body.from_name(name).modulus_by_temperature
    assert 0 < modulus_at(points, low + step) <= modulus_at(points, low)


def test_plastics_of_wheels_are_in_the_list_with_their_limits():
    assert set(PLASTICS) == {"PA66", "PA46", "POM-C", "POM-H", "PEEK"}
    order = [Body.from_name(name).temperature_limit for name in ("POM-H", "PA46", "PEEK")]
    assert order == sorted(order)
    assert Body.from_name("16MnCr5").temperature_limit is None
    assert solids.named_material("POM") == "POM-C" and solids.named_material("delrin") == "POM-H"


@pytest.mark.parametrize(
    ("curve", "says"),
    [
        ((("100 degC", "1 GPa"), ("20 degC", "1 GPa")), "temperatures must rise"),
        ((("20 degC", "1 GPa"), ("100 degC", "2 GPa")), "must not rise with temperature"),
        ((("20 degC",),), "must be a temperature and a modulus"),
        (("20 degC",), "must be a temperature and a modulus"),
        ((("20 degC", "4 N"),), "must be a modulus of elasticity"),
    ],
)
def test_impossible_moduli_are_refused(curve, says):
    with pytest.raises(ValueError, match=says):
        Body(4e9, 0.38, modulus_by_temperature=curve)
