"""ISO 281: worked values, the sources' two examples recomputed, continuity, trends and refusals."""

from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pyworm.formulas.bearing_life import (
    CONTAMINATION,
    LARGEST_MODIFICATION,
    BearingRating,
    basic_life,
    contamination_factor,
    contamination_range,
    fatigue_load_limit,
    life_modification,
    reference_viscosity,
    reliability_factor,
    viscosity_ratio,
)

RPM = pi / 30
MM2 = 1e-6

NU2210 = {
    "elements": "roller",
    "dynamic_rating": 90e3,
    "fatigue_load_limit": 11.4e3,
    "load": 20e3,
    "speed": 600 * RPM,
    "contamination": 0.6,
}

kinds = st.sampled_from(["ball", "roller"])
directions = st.sampled_from(["radial", "thrust"])
ratios = st.floats(0.11, 6)  # at 0.1 the coefficients cancel to their last digit
loads = st.floats(1e-4, 2)


@pytest.mark.parametrize(
    ("elements", "x", "values"),
    [
        ("roller", 0.342, (0.1000, 0.143, 0.2045, 0.4273, 0.7217, 1.0845, 1.7465, 2.8155)),
        ("ball", 0.1, (0.1002, 0.1884, 0.3119, 0.8012, 1.5076, 2.4305, 4.2016, 7.2018)),
    ],
)
def test_life_modification_worked_from_iso_281(elements, x, values):
    for kappa, expected in zip((0.1, 0.2, 0.4, 0.6, 0.8, 1, 2, 4), values, strict=True):
        assert life_modification(kappa, x, elements) == pytest.approx(expected, abs=6e-5)


@pytest.mark.parametrize(
    ("rpm", "millimetres", "expected"),
    [(600, 85, 24.13), (600, 65, 27.6), (600, 70, 26.6), (1000, 85, 15.43)],
)
def test_reference_viscosity_against_the_misprints_of_the_bearing_example(
    rpm, millimetres, expected
):
    """The source prints 27.6 for 600 rpm and 85 mm, which is 65 mm's, and lacks n^-0.5 above 1000 rpm."""
    nu1 = reference_viscosity(rpm * RPM, millimetres * 1e-3)
    assert nu1 / MM2 == pytest.approx(expected, abs=0.06)
    if rpm >= 1000:
        assert nu1 / MM2 * rpm**0.5 == pytest.approx(488, abs=0.5)  # what the source's form gives


@pytest.mark.parametrize(
    ("viscosity", "kappa", "modification", "life"),
    [(22, 0.912, 0.916, 137.8), (42, 1.740, 1.587, 238.8)],
)
def test_nu2210_recomputed_with_the_sources_diameter(viscosity, kappa, modification, life):
    """The source prints kappa 0.80 and 1.52, a_ISO 1.14 and 1.75, L10m 171 and 262.5 Mrev."""
    rating = BearingRating(**NU2210, mean_diameter=0.085, viscosity=viscosity * MM2)
    assert rating.kappa == pytest.approx(kappa, abs=6e-4)
    assert rating.load_ratio == pytest.approx(0.342)
    assert rating.modification == pytest.approx(modification, abs=6e-4)
    assert rating.basic_life / 1e6 == pytest.approx(150.4, abs=0.06)
    assert rating.basic_hours == pytest.approx(4179, abs=0.6)
    assert rating.modified_life / 1e6 == pytest.approx(life, abs=0.06)
    assert rating.modified_hours == pytest.approx(life * 1e6 / 600 / 60, rel=1e-3)


@pytest.mark.parametrize(("kappa", "expected"), [(0.80, 0.717), (1.52, 1.447)])
def test_nu2210_recomputed_with_the_sources_kappa(kappa, expected):
    """0.80 and 1.52 stand for 22/27.6 and 42/27.6."""
    exact = {0.80: 22 / 27.6, 1.52: 42 / 27.6}[kappa]
    assert life_modification(exact, 0.342, "roller") == pytest.approx(expected, abs=2e-3)


@pytest.mark.parametrize(
    ("reliability", "expected"),
    [(0.90, 1.00), (0.95, 0.64), (0.96, 0.55), (0.97, 0.47), (0.98, 0.37), (0.99, 0.25)],
)
def test_reliability_factors_of_the_table(reliability, expected):
    assert reliability_factor(reliability) == pytest.approx(expected, abs=0.006)


@pytest.mark.parametrize("elements", ["ball", "roller"])
@pytest.mark.parametrize("direction", ["radial", "thrust"])
@pytest.mark.parametrize("joint", [0.4, 1.0, 4.0])
@pytest.mark.parametrize("x", [0.01, 0.1, 0.3])
def test_life_modification_is_continuous(elements, direction, joint, x):
    """With the misprint 0.019087 it would jump by a third at 0.4."""
    below, above = (
        life_modification(joint * (1 + side), x, elements, direction) for side in (-1e-9, 1e-9)
    )
    assert below == pytest.approx(above, rel=7e-4)


def test_reference_viscosity_jumps_by_the_2_3_percent_of_the_standard():
    below, above = (reference_viscosity(rpm * RPM, 0.07) for rpm in (999.999, 1000.001))
    assert below / above == pytest.approx(1.0233, abs=2e-4)


@given(kinds, directions, ratios, loads, st.floats(1.01, 3))
def test_life_modification_grows_with_oil_and_with_cleanliness(elements, direction, kappa, x, more):
    life = life_modification(kappa, x, elements, direction)
    assert 0.09 < life <= LARGEST_MODIFICATION
    assert life_modification(kappa * more, x, elements, direction) >= life * (1 - 7e-4)
    assert life_modification(kappa, x * more, elements, direction) >= life


@given(kinds, ratios, loads)
def test_thrust_bearings_live_shorter(elements, kappa, x):
    assert life_modification(kappa, x, elements, "thrust") <= life_modification(kappa, x, elements)


@pytest.mark.parametrize(("elements", "share"), [("ball", 3.0), ("roller", 2.5)])
def test_thrust_bearings_are_radial_ones_with_a_share_of_the_load_ratio(elements, share):
    thrust = life_modification(0.8, 0.3, elements, "thrust")
    assert thrust == pytest.approx(life_modification(0.8, 0.3 / share, elements))


def test_the_life_modification_factor_is_capped():
    assert life_modification(4, 5, "ball") == LARGEST_MODIFICATION
    assert life_modification(3, 100, "roller") == LARGEST_MODIFICATION
    assert life_modification(9, 0.1, "ball") == life_modification(4, 0.1, "ball")
    assert life_modification(2, 0.0, "ball") == pytest.approx(0.1)


def test_additives_count_as_kappa_1_up_to_3_in_clean_oil():
    plain = life_modification(0.3, 0.342, "roller")
    helped = life_modification(0.3, 0.342, "roller", additives=True, contamination=0.2)
    assert helped == pytest.approx(1.0845, abs=6e-5)
    assert helped > plain
    assert life_modification(0.3, 0.342, "roller", additives=True, contamination=0.19) == plain
    assert life_modification(0.3, 0.6, "ball", additives=True, contamination=1) == 3.0
    # 3 is no cap on what the oil does by itself.
    alone = life_modification(0.9, 0.6, "ball")
    assert life_modification(0.9, 0.6, "ball", additives=True, contamination=1) == alone > 3


@given(
    st.sampled_from(["-/13/10", "-/15/12", "-/17/14", "-/19/16"]),
    ratios,
    st.floats(0.02, 1),
    st.floats(1.01, 3),
)
def test_contamination_factor_grows_with_oil_size_and_filter(code, kappa, diameter, more):
    def factor(lubrication, kappa, diameter):
        return contamination_factor(lubrication, code, kappa, diameter)

    value = factor("inline filter", kappa, diameter)
    assert 0 <= value <= 1
    assert factor("inline filter", kappa * more, diameter) >= value
    assert factor("inline filter", kappa, diameter * more) >= value
    assert factor("oil bath", kappa, diameter) <= value


def test_contamination_factor_worked_from_annex_a():
    """Oil bath -/17/14, kappa 1, 85 mm: 0.0133 85^0.55 (1 - 1.67/85^(1/3)) = 0.1532 x 0.6202."""
    assert contamination_factor("oil bath", "-/17/14", 1.0, 0.085) == pytest.approx(
        0.0951, abs=2e-4
    )
    assert contamination_factor("inline filter", "-/13/10", 4.0, 1.0) == pytest.approx(
        1 - 0.5663 / 10
    )


def test_contamination_in_words_has_all_seven_rows_of_iso_281():
    assert len(CONTAMINATION) == 7
    assert contamination_range("normal cleanliness", 0.085) == (0.5, 0.6)
    assert contamination_range("normal cleanliness", 0.1) == (0.6, 0.8)
    assert contamination_range("severe contamination", 0.5) == (0.0, 0.1)
    for small, large in CONTAMINATION.values():
        assert small[0] <= small[1] and large[0] <= large[1] and small[1] <= large[1]


def test_fatigue_load_limit():
    assert fatigue_load_limit(88e3, "roller", 0.07) == pytest.approx(88e3 / 8.2)
    assert fatigue_load_limit(22e3, "ball", 0.4) == pytest.approx(500)
    with pytest.raises(ValueError, match="take it from the catalogue"):
        fatigue_load_limit(1e6, "roller", 0.3)


def test_basic_life_of_balls_and_rollers():
    assert basic_life(80e3, 10e3, "ball") == pytest.approx(512e6)
    assert basic_life(80e3, 10e3, "roller") == pytest.approx(1024e6)


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: reference_viscosity(600 * RPM, 85), "mean diameter of the bearing = 85 m"),
        (lambda: viscosity_ratio(22, 60, 0.085), "kinematic viscosity = 22 m2/s"),
        (lambda: life_modification(0.05, 0.3, "ball"), "kappa = 0.05: ISO 281 holds from 0.1"),
        (lambda: life_modification(1, 0.3, "needle"), 'elements = "needle"'),
        (lambda: reliability_factor(90), "reliability = 90: must lie between 0.9"),
        (lambda: basic_life(90e3, 60e3, "ball"), "up to half of the dynamic load rating"),
        (lambda: contamination_factor("oil bath", "17/14", 1, 0.1), "must be one of"),
        (lambda: contamination_factor("splash", "-/17/14", 1, 0.1), 'lubrication = "splash"'),
        (lambda: contamination_range("clean", 0.1), 'contamination = "clean"'),
    ],
)
def test_values_outside_the_standard_are_refused(call, sentence):
    with pytest.raises(ValueError, match=sentence) as refused:
        call()
    assert "\n" not in str(refused.value)
