"""Regimes: published boundaries, their orientation and the films they rest on."""

from math import sqrt

import pytest

from pyworm.formulas.film import (
    LineGroups,
    PointGroups,
    dowson_higginson,
    line_groups,
    moes_line,
    point_groups,
)
from pyworm.formulas.regimes import line_regime, point_regime


def line_at(viscosity, elasticity, speed=1e-11):
    """Groups of a line contact at a place on the chart, R = 1 m."""
    load = elasticity * sqrt(speed)
    return LineGroups(1.0, speed, load, viscosity / sqrt(load**3 / speed))


def point_at(m, el, material=4500.0, ratio=1.0):
    """Groups of a point contact from Moes' parameters, R = 1 m."""
    speed = (el / material) ** 4 / 2
    return PointGroups(1.0, ratio, speed, m * (2 * speed) ** 0.75, material)


@pytest.mark.parametrize(
    ("viscosity", "elasticity", "axis", "below", "above"),
    [
        # RI-RV at g_V = 5.07
        (5.07, 0.5, 0, "isoviscous-rigid", "piezoviscous-rigid"),
        # RI-EI at g_E = 1.77
        (0.5, 1.77, 1, "isoviscous-rigid", "isoviscous-elastic"),
        # EI-EV at g_V = 2.29 g_E^1.40
        (2.29 * 30**1.40, 30, 0, "isoviscous-elastic", "piezoviscous-elastic"),
        # RV-EV at g_V = 1.0 g_E^3, rigid above it
        (30.0**3, 30, 0, "piezoviscous-elastic", "piezoviscous-rigid"),
    ],
)
def test_line_boundaries(viscosity, elasticity, axis, below, above):
    step = [0.97, 1.03]
    for factor, name in zip(step, (below, above), strict=True):
        place = [viscosity, elasticity]
        place[axis] *= factor
        assert line_regime(line_at(*place)).name == name


def test_line_chart_coordinates():
    groups = line_at(123.0, 45.0)
    parameters = line_regime(groups).parameters
    assert parameters["viscosity"] == pytest.approx(123.0, rel=1e-12)
    assert parameters["elasticity"] == pytest.approx(45.0, rel=1e-12)
    assert parameters["viscosity"] == pytest.approx(sqrt(2) * groups.moes_m**1.5 * groups.moes_l)
    assert parameters["elasticity"] == pytest.approx(sqrt(2) * groups.moes_m)


def test_roller_drive_passes_from_rigid_to_elastic_with_load():
    """R = 6.5 mm, 2 m/s, eta0 = 0.08, alpha = 22 /GPa: g_V = 268 and 7225, g_E = 6.53 and 58.8."""
    light = line_regime(line_groups(6.5e-3, 1e5, 225.6e9, 2.0, 0.08, 2.2e-8))
    heavy = line_regime(line_groups(6.5e-3, 9e5, 225.6e9, 2.0, 0.08, 2.2e-8))
    assert light.parameters["viscosity"] == pytest.approx(268, abs=0.5)
    assert light.parameters["elasticity"] == pytest.approx(6.53, abs=5e-3)
    assert heavy.parameters["viscosity"] == pytest.approx(7225, abs=15)
    assert heavy.parameters["elasticity"] == pytest.approx(58.8, abs=0.05)
    assert light.film_by_regime["piezoviscous-rigid"] == pytest.approx(0.717e-6, rel=4e-3)
    assert light.parameters["viscosity"] == pytest.approx(
        light.parameters["elasticity"] ** 3, rel=0.04
    )
    assert heavy.name == "piezoviscous-elastic"


def test_line_films_agree_with_the_film_formulas():
    groups = line_at(14142.0, 141.42)  # M = 100, L = 10
    films = line_regime(groups).film_by_regime
    assert films["piezoviscous-elastic"] == pytest.approx(moes_line(groups).minimum, rel=0.05)
    assert films["piezoviscous-elastic"] == pytest.approx(
        dowson_higginson(groups).minimum, rel=0.05
    )


@pytest.mark.parametrize(
    ("m", "el", "name"),
    [
        (1.0, 0.1, "isoviscous-rigid"),
        (5.0, 10.0, "piezoviscous-rigid"),
        (200.0, 10.0, "piezoviscous-elastic"),
        (1000.0, 10.0, "piezoviscous-elastic"),
    ],
)
def test_point_regimes(m, el, name):
    assert point_regime(point_at(m, el)).name == name


def test_rubber_ball_is_isoviscous_elastic():
    groups = point_groups(0.01, 0.01, 1.0, 1e7, 0.1, 0.01, 2e-8)
    assert point_regime(groups).name == "isoviscous-elastic"


def test_point_film_by_hand():
    """Circular contact, k = r = 1, with round groups: W/U = 1e4."""
    groups = PointGroups(2.0, 1.0, 1e-10, 1e-6, 1000.0)
    regime = point_regime(groups)
    assert regime.parameters["viscosity"] == pytest.approx(1e5, rel=1e-12)
    assert regime.parameters["elasticity"] == pytest.approx(1e4, rel=1e-12)
    films = {name: film / 2.0 * 1e8 for name, film in regime.film_by_regime.items()}
    assert films["isoviscous-rigid"] == pytest.approx(128 * 0.36 * 1.743738**2, rel=1e-6)
    assert films["piezoviscous-rigid"] == pytest.approx(1.66 * 2154.4347 * 0.4933830, rel=1e-6)
    assert films["isoviscous-elastic"] == pytest.approx(8.70 * 478.63009 * 0.3765700, rel=1e-6)
    assert films["piezoviscous-elastic"] == pytest.approx(
        3.42 * 281.83829 * 4.7863009 * 0.4933830, rel=1e-6
    )


@pytest.mark.parametrize("ratio", [1.0, 0.3, 0.05])
def test_growing_load_never_leads_back_to_a_rigid_contact(ratio):
    rigid = [
        point_regime(point_at(m, 10.0, ratio=ratio)).name.endswith("rigid")
        for m in (1, 3, 10, 30, 100, 300, 1000)
    ]
    assert rigid[0]
    assert not rigid[-1]
    assert rigid == sorted(rigid, reverse=True)
