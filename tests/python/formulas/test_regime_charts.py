"""Published charts of regimes: borders, films by hand, and solved limits of rigid bodies."""

import sys
from math import sqrt

import numpy as np
import pytest
from folders import ROOT

from pyworm.formulas.film import LineGroups, PointGroups, dowson_higginson, moes_line
from pyworm.formulas.regime_charts import (
    in_point_range,
    line_chart,
    line_films,
    line_parameters,
    point_chart,
    point_films,
    point_parameters,
)
from pyworm.formulas.regimes import REGIMES, line_measures

BORDERS = [
    # RI-RV at g_V = 5.07
    (5.07, 0.5, 0, "isoviscous-rigid", "piezoviscous-rigid"),
    # RI-EI at g_E = 1.77
    (0.5, 1.77, 1, "isoviscous-rigid", "isoviscous-elastic"),
    # EI-EV at g_V = 2.29 g_E^1.40
    (2.29 * 30**1.40, 30, 0, "isoviscous-elastic", "piezoviscous-elastic"),
    # RV-EV at g_V = 1.0 g_E^3, rigid above it
    (30.0**3, 30, 0, "piezoviscous-elastic", "piezoviscous-rigid"),
]


def line_groups_at(viscosity, elasticity, speed=1e-11):
    """Groups of a line contact at a place on the chart, R = 1 m."""
    load = elasticity * sqrt(speed)
    return LineGroups(1.0, speed, load, viscosity / sqrt(load**3 / speed))


@pytest.mark.parametrize(("viscosity", "elasticity", "axis", "below", "above"), BORDERS)
def test_line_borders(viscosity, elasticity, axis, below, above):
    for factor, name in ((0.97, below), (1.03, above)):
        place = [viscosity, elasticity]
        place[axis] *= factor
        assert REGIMES[int(line_chart(*place))] == name


@pytest.mark.parametrize(("viscosity", "elasticity", "axis", "below", "above"), BORDERS)
def test_line_borders_against_our_own_limits(viscosity, elasticity, axis, below, above):
    """On each published border our number is 1 within a factor of 2.5, and on either side far from it."""
    deflection, thickening = line_measures(line_groups_at(viscosity, elasticity))
    oil = below.split("-")[0] != above.split("-")[0]
    assert 1 / 2.5 < (thickening if oil else deflection) < 2.5


def test_parameters_of_charts():
    groups = line_groups_at(123.0, 45.0)
    assert line_parameters(groups.moes_m, groups.moes_l) == pytest.approx((123.0, 45.0), rel=1e-12)
    u, w, g = 1e-10, 1e-6, 1000.0  # W/U = 1e4
    point = PointGroups(2.0, 1.0, u, w, g)
    expected = g * w**3 / u**2, w ** (8 / 3) / u**2
    assert point_parameters(point.moes_m, point.moes_l) == pytest.approx(expected, rel=1e-12)


def test_point_films_by_hand():
    """Circular contact, k = r = 1."""
    films = point_films(1e5, 1e4, 1.0)
    assert films["isoviscous-rigid"] == pytest.approx(128 * 0.36 * 1.743738**2, rel=1e-6)
    assert films["piezoviscous-rigid"] == pytest.approx(141 * 74.98942 * 0.03796073, rel=1e-6)
    assert films["isoviscous-elastic"] == pytest.approx(8.70 * 478.63009 * 0.3765700, rel=1e-6)
    assert films["piezoviscous-elastic"] == pytest.approx(
        3.42 * 281.83829 * 4.7863009 * 0.4933830, rel=1e-6
    )


@pytest.mark.parametrize(
    ("m", "el", "name"),
    [
        (1.0, 0.1, "isoviscous-rigid"),
        (20.0, 10.0, "piezoviscous-elastic"),
        (100.0, 0.1, "isoviscous-elastic"),
        (1000.0, 10.0, "piezoviscous-elastic"),
    ],
)
def test_the_largest_film_holds(m, el, name):
    assert REGIMES[int(point_chart(*point_parameters(m, el), 1.0))] == name


@pytest.mark.parametrize("ratio", [1.0, 0.3, 0.05])
def test_growing_load_never_leads_back_to_a_rigid_contact(ratio):
    places = point_parameters(np.geomspace(1, 3000, 40), 10.0)
    rigid = point_chart(*places, ratio) < 2
    assert not rigid[-1]
    assert np.all(np.diff(rigid.astype(int)) <= 0)


@pytest.mark.parametrize("ratio", [1.0, 0.03])
def test_rigid_films_against_solutions(ratio):
    """Solved with Reynolds' exit condition and Barus' law, where alpha times the isoviscous pressure is 1."""
    sys.path.insert(0, str(ROOT / "benchmarks"))
    from atlas.rigid import rigid_limits

    solved = rigid_limits(ratio, (61, 121))
    films = point_films(solved.viscosity, 1.0, ratio)
    assert films["isoviscous-rigid"] == pytest.approx(solved.isoviscous, rel=0.04)
    # from memory; between half of the solved film and all of it, the nearer the longer the contact
    assert 0.4 * solved.film < films["piezoviscous-rigid"] < 1.05 * solved.film
    if ratio < 0.1:
        assert films["piezoviscous-rigid"] == pytest.approx(solved.film, rel=0.1)
        assert films["piezoviscous-rigid"] > films["isoviscous-rigid"]


def test_line_films_agree_with_the_film_formulas():
    groups = line_groups_at(14142.0, 141.42)  # M = 100, L = 10
    unit = groups.speed / groups.load
    film = line_films(*line_parameters(groups.moes_m, groups.moes_l))["piezoviscous-elastic"] * unit
    assert film == pytest.approx(moes_line(groups).minimum, rel=0.05)
    assert film == pytest.approx(dowson_higginson(groups).minimum, rel=0.05)


def test_the_range_of_the_chart_of_points():
    assert in_point_range(1.0)
    assert in_point_range(0.05)  # k = 6.9
    assert not in_point_range(0.03)  # k = 9.5
    assert not in_point_range(2.0)  # long axis along
