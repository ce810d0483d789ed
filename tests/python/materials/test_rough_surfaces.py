"""Averages of two rough surfaces over the gap between their mean planes."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
import scipy

from pyworm.materials.body import Body
from pyworm.materials.rough_surfaces import RoughPair, RoughSurface, rough_pair

SMOOTHER, ROUGHER = RoughSurface(0.3e-6, 0.02), RoughSurface(0.4e-6, 0.02, hardness=1e9)
PAIR = RoughPair((SMOOTHER, ROUGHER), 85e9)


def test_composite_roughness():
    """Root of the sum of squares."""
    assert PAIR.height == pytest.approx(0.5e-6)


def test_mean_thickness_is_the_mean_of_what_is_open():
    """Mean of max(gap + height, 0) over heights spread normally, by quadrature."""
    for gap in (0.5, 1.0, 3.0):
        mean, _ = scipy.integrate.quad(
            lambda z, gap=gap: (gap + z) * np.exp(-(z**2) / 2) / np.sqrt(2 * pi), -gap, 12
        )
        assert PAIR.mean_thickness(gap) == pytest.approx(mean, rel=1e-4)


def test_softer_body_yields():
    """Asperities bear the hardness at most, over the area of overlap; harder ones the elastic pressure."""
    hard = RoughPair((SMOOTHER, RoughSurface(0.4e-6, 0.02)), 85e9)
    gap = np.linspace(-2, 4, 30)
    yielding, elastic = PAIR.contact(gap)[0], hard.contact(gap)[0]
    assert np.all(yielding < elastic)
    assert np.all(yielding < 1e9 * scipy.special.ndtr(-gap))
    assert np.all(np.diff(yielding) < 0)
    assert np.all((PAIR.contact(gap)[1] > 0) & (PAIR.contact(gap)[1] <= 1))


def test_asperities_of_one_radius_bear_as_greenwood_and_tripp_have_it():
    """Those of the rougher surface, by quadrature of the heights that overlap; the hardness caps them."""
    body = Body(2e11, 0.3, roughness=0.4e-6, asperity_sharpness=0.01)
    other = Body(2e11, 0.3, roughness=0.3e-6, asperity_sharpness=0.03, asperity_density=0.05)
    pair = rough_pair((body, other), (0.0, 0.0))
    moment, _ = scipy.integrate.quad(
        lambda z: (z - 1) ** 2.5 * np.exp(-(z**2) / 2) / np.sqrt(2 * pi), 1, 12
    )
    expected = 16 * np.sqrt(2) * pi / 15 * 0.04**2 * np.sqrt(0.01) * pair.modulus * moment
    assert pair.contact(1.0)[0] == pytest.approx(expected, rel=1e-6)
    soft = rough_pair((replace(body, hardness=1e8), other), (0.0, 0.0))
    gap = np.linspace(-2, 4, 30)
    assert np.all(soft.contact(gap)[0] < pair.contact(gap)[0])
    assert np.all(soft.contact(gap)[0] < 1e8 * scipy.special.ndtr(-gap))
    assert np.isfinite(pair.curves().values).all()


def test_lays_of_both_surfaces_add():
    """Flow is alike both ways over crossed ridges, not over parallel ones; oblique ones turn it."""
    ridges = RoughSurface(0.4e-6, 0.02, aspect=6.0)
    across = RoughSurface(0.4e-6, 0.02, aspect=6.0, lay=pi / 2)
    oblique = RoughSurface(0.4e-6, 0.02, aspect=6.0, lay=pi / 4)
    xx, yy, xy = RoughPair((ridges, across), 85e9).flow_factors(np.array([3.0]))[0]
    assert xx == pytest.approx(yy)
    assert xy == pytest.approx(0, abs=1e-12)
    xx, yy, xy = RoughPair((ridges, ridges), 85e9).flow_factors(np.array([3.0]))[0]
    assert xx > 1 > yy
    xx, yy, xy = RoughPair((oblique, oblique), 85e9).flow_factors(np.array([3.0]))[0]
    assert xx == pytest.approx(yy)
    assert xy > 0


def test_shear_factors_cancel_between_equal_surfaces():
    """What a rough wall drags forward its equal drags back; the rougher one rules."""
    equal = RoughPair((SMOOTHER, SMOOTHER), 85e9).flow_factors(np.array([2.0]))[1]
    assert equal == pytest.approx(0, abs=1e-15)
    assert PAIR.flow_factors(np.array([2.0]))[1][0] < 0  # body 2 is rougher


def test_tables_hold_the_curves():
    """Values at the rows, all finite; those of scaled surfaces at scaled gaps."""
    curves = PAIR.curves()
    row = curves.first + curves.spacing * np.arange(curves.values.shape[1])
    gap = np.sinh(row)
    assert np.all(np.isfinite(curves.values)) and np.all(np.isfinite(curves.slopes))
    near = np.abs(gap) < 5
    assert np.exp(curves.values[0, near]) == pytest.approx(PAIR.contact(gap[near])[0], rel=1e-9)
    assert curves.values[1] + PAIR.height * gap == pytest.approx(
        PAIR.height * PAIR.mean_thickness(gap), rel=1e-6, abs=1e-15
    )
    double = RoughPair(
        tuple(RoughSurface(2 * s.height, s.slope, hardness=s.hardness) for s in PAIR.surfaces),
        85e9,
    ).curves()
    assert curves.scaled(2.0).values == pytest.approx(double.values, rel=1e-9, abs=1e-15)


def test_lay_counts_from_the_surface_s_motion():
    """Directions of motion and lay add up."""
    body = Body(210e9, 0.3, roughness=0.4e-6, roughness_aspect=3.0, lay=0.2)
    pair = rough_pair((body, body), (0.1, -0.3))
    assert [surface.lay for surface in pair.surfaces] == pytest.approx([0.3, -0.1])
    assert pair.modulus == pytest.approx(210e9 / (1 - 0.09) / 2)
