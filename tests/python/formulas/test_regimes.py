"""Regimes: both numbers against exact and solved limits, and over the atlas of converged films."""

import sys
from dataclasses import replace
from math import sqrt

import numpy as np
import pytest
from folders import ROOT
from scipy.integrate import quad
from scipy.optimize import brentq

from pyworm.formulas.film import LineGroups
from pyworm.formulas.film_atlas import AtlasGroups, films, regime_measures
from pyworm.formulas.hertz import hertz
from pyworm.formulas.regimes import (
    REGIMES,
    Regime,
    flattening,
    line_measures,
    line_regime,
    regime_number,
)


def line_at(moes_m, moes_l, speed=0.5e-12):
    """Groups of a line contact from Moes' parameters, R = 1 m."""
    return LineGroups(1.0, speed, moes_m * sqrt(2 * speed), moes_l * (2 * speed) ** -0.25)


def rigid_line():
    """Largest pressure, and load, of a rigid cylinder with Reynolds' exit condition.

    Places over sqrt(2 R h0), film over h0, pressure over 12 eta u sqrt(2 R h0)/h0^2: dp/dx = (H - H*)/H^3.
    """

    def slope(x, exit_):
        return (x**2 - exit_**2) / (1 + x**2) ** 3

    def pressure(x, exit_):
        return quad(slope, -np.inf, x, args=(exit_,))[0]

    exit_ = brentq(lambda place: pressure(place, place), 0.1, 1.0)
    # integrating by parts, the load is -int x dp, since the pressure vanishes at both ends
    load = -quad(lambda x: x * slope(x, exit_), -np.inf, exit_)[0]
    return pressure(-exit_, exit_), load


def test_thickening_of_a_rigid_line_is_alpha_times_its_isoviscous_pressure():
    peak, load = rigid_line()
    m, el = 1e-8, 5.0
    groups = line_at(m, el)
    u, w = groups.speed, groups.load
    minimum = 24 * load * u / w  # h0/R of a load of 24 eta u R load/h0
    expected = groups.material * 12 * sqrt(2) * peak * u * minimum**-1.5
    deflection, thickening = line_measures(groups)
    assert deflection < 1e-3
    # Moes' constants have four digits
    assert thickening == pytest.approx(expected, rel=3e-3)


@pytest.mark.parametrize(("ratio", "angle"), [(1.0, 0.0), (10.0, 45.0)])
def test_thickening_of_rigid_points_is_alpha_times_their_isoviscous_pressure(ratio, angle):
    sys.path.insert(0, str(ROOT / "benchmarks"))
    from atlas.rigid import factors

    m, el, turned = 1e-3, 5.0, np.radians(angle)
    coarse, fine = (np.array(factors(1 / ratio, turned, nodes)) for nodes in (61, 121))
    more_load, more_pressure = 2 * fine - coarse  # of first order
    u, v = np.cos(turned), np.sin(turned)
    d = 1 / ratio  # smaller radius 1, Rx = 1, Ry = 1/d
    wedge = sqrt(2 * (u / (1 + 2 * d / 3)) ** 2 + 2 / d * (v / (1 + 2 / (3 * d))) ** 2)
    along = 1 / (u**2 + v**2 * d)
    eta = 0.5 * along  # 2U = 1 along the entrainment
    load = m * along**2
    film = (4 * np.pi * eta * wedge * sqrt(1 / d) * more_load / load) ** 2
    expected = el / 1.0 * 1.29904 * eta * wedge * film**-1.5 * more_pressure
    groups = AtlasGroups(m, el, ratio, turned)
    deflection, thickening = regime_measures(groups, films(groups).minimum)
    assert deflection < 1e-3
    assert thickening == pytest.approx(expected, rel=0.1)


@pytest.fixture(scope="module")
def atlas():
    """Groups and solved columns of the atlas's contacts with bars of at most 2 %."""
    sys.path.insert(0, str(ROOT / "benchmarks"))
    from atlas.table import groups, known

    data = known(ROOT / "atlas" / "films.csv", 0.02)
    return groups(data), data


def hertz_of(groups):
    """Half-width along the entrainment, radius along it, and approach; smaller radius 1, E' 1."""
    dry = [hertz(1.0, *of, 1.0) for of in zip(groups.ratio, np.exp(groups.load), strict=True)]
    short, long, approach = np.array(
        [(of.semi_axis_x, of.semi_axis_y, of.approach) for of in dry]
    ).T
    half_width = 1 / np.sqrt(groups.cos2 / short**2 + (1 - groups.cos2) / long**2)
    return half_width, 1 / (groups.cos2 + (1 - groups.cos2) / groups.ratio), approach


def test_no_solved_contact_that_deflects_much_is_rigid(atlas):
    groups, data = atlas
    deflection, _ = regime_measures(groups, films(groups).minimum)
    half_width, radius, approach = hertz_of(groups)
    solved = flattening(half_width, radius, data["film_min"] * radius)
    rigid = deflection <= 1
    assert rigid.sum() > 500 and (~rigid).sum() > 2000
    assert solved[rigid].max() < 1.1
    assert (approach / (data["film_min"] * radius))[rigid].max() < 10
    assert np.all(np.abs(np.log(solved / deflection)) < np.log(1.25))


def test_no_solved_contact_with_thickened_inlet_is_isoviscous(atlas):
    groups, data = atlas
    deflection, thickening = regime_measures(groups, films(groups).minimum)
    half_width, radius, _ = hertz_of(groups)
    film = data["film_central"] * radius
    # Hertz's gap outside a strip is (b^2/2R) (4 sqrt(2)/3) s^(3/2) at a distance of b s, and his pressure
    # as far inside is p_H sqrt(2 s): where the gap is the film, oil has the pressure of the inlet
    place = np.minimum((film * 2 * radius / half_width**2 / (4 * sqrt(2) / 3)) ** (2 / 3), 0.5)
    alpha_p = data["alpha_pressure"] * groups.alpha_ratio
    inlet = np.where(deflection > 1, alpha_p * np.sqrt(2 * place), alpha_p * data["pressure_max"])
    isoviscous = thickening <= 1
    assert isoviscous.sum() > 1000 and (~isoviscous).sum() > 1000
    assert inlet[isoviscous].max() < 3
    assert thickening[inlet > 3].min() > 1


@pytest.mark.parametrize(
    ("m", "el", "name"),
    [
        (0.1, 0.1, "isoviscous-rigid"),
        (5.0, 20.0, "piezoviscous-rigid"),
        (300.0, 0.1, "isoviscous-elastic"),
        (20.0, 10.0, "piezoviscous-elastic"),
        (200.0, 10.0, "piezoviscous-elastic"),
        (1000.0, 10.0, "piezoviscous-elastic"),
    ],
)
def test_regimes_of_circular_contacts(m, el, name):
    groups = AtlasGroups(m, el, 1.0, 0.0)
    number = int(regime_number(*regime_measures(groups, films(groups).minimum)))
    assert REGIMES[number] == name


@pytest.mark.parametrize(
    ("m", "el", "name"),
    [
        (0.1, 0.1, "isoviscous-rigid"),
        (1.0, 10.0, "piezoviscous-rigid"),
        (300.0, 0.1, "isoviscous-elastic"),
        (200.0, 10.0, "piezoviscous-elastic"),
    ],
)
def test_regimes_of_lines(m, el, name):
    assert line_regime(line_at(m, el)).name == name


@pytest.mark.parametrize(("ratio", "angle"), [(1.0, 0.0), (10.0, 0.0), (10.0, 0.7), (30.0, 1.57)])
@pytest.mark.parametrize("el", [0.3, 3.0, 20.0])
def test_growing_load_deflects_bodies_and_thickens_oil(ratio, angle, el):
    m = np.geomspace(0.1, 3000, 60)
    groups = AtlasGroups(m, np.full(60, el), np.full(60, ratio), np.full(60, angle))
    deflection, thickening = regime_measures(groups, films(groups).minimum)
    assert np.all(np.diff(deflection) > 0)
    assert deflection[0] < 1 < deflection[-1]
    # with deflection the pressure of the inlet rises but slowly, and fitted limits meet within 2 %
    assert np.all(np.diff(np.log(thickening)) > -0.02)
    assert thickening[-1] > thickening[0]


def test_a_turned_circle_has_one_regime():
    numbers = [
        regime_measures(AtlasGroups(30.0, 3.0, 1.0, angle), 1.0) for angle in (0.0, 0.5, np.pi / 2)
    ]
    assert np.ptp(np.array(numbers, dtype=float), axis=0) == pytest.approx([0, 0], abs=1e-6)


def test_a_border_within_its_uncertainty_is_named():
    regime = Regime(1.2, 4.0, 0.1, 0.3, 20.0, 10.0)
    assert (regime.name, regime.close_to) == ("piezoviscous-elastic", ())
    near = replace(regime, deflection_error=0.3)
    assert near.close_to == ("piezoviscous-rigid",)
    assert near.words == "piezoviscous-elastic, close to piezoviscous-rigid"
    both = replace(near, thickening=0.9)
    assert (
        both.words == "isoviscous-elastic, close to piezoviscous-elastic, close to isoviscous-rigid"
    )
    assert both.summary()["regime_close_to"] == ["piezoviscous-elastic", "isoviscous-rigid"]
