"""Expected film of surfaces that end within the reach of a thick film."""

from math import atan, sqrt

import numpy as np
import pytest
from contacts import INLET, ball, motions

import pyworm
from pyworm.scene import scales as scales_of_scene
from pyworm.scene.scales import scales

RADIUS, ACROSS, SPEED = 5e-3, 4.0, 7.0


def short_roller(half_length, load):
    """A roller, almost straight, that ends at half its length [m]; isoviscous, as it is lightly loaded."""
    whole = pyworm.Paraboloid(RADIUS, ACROSS)

    def gap(x, y):
        height, covered = whole(x, y)
        return height, covered & (np.abs(y) <= half_length)

    return ball(gap=gap, radii=whole.radii, load=load, motions=motions(0.01, SPEED))


def martin_load(film, half_length):
    """Load of a rigid isoviscous film [N]: 4.9 eta u R/h0 for each length (Martin 1916), times h0/h."""
    eta = pyworm.named_oil("PAO VG 220").oil(INLET).viscosity.eta0
    lens = sqrt(2 * ACROSS * film)
    return 4.9 * eta * SPEED * RADIUS / film * 2 * lens * atan(half_length / lens)


@pytest.mark.parametrize(("half_length", "load"), [(5e-3, 10.0), (2e-3, 3.0)])
def test_a_short_roller_under_a_light_load_has_the_film_of_its_own_length(half_length, load):
    expected = scales(short_roller(half_length, load))
    assert martin_load(expected.film, half_length) == pytest.approx(load, rel=0.2)
    assert expected.regime.deflection < 0.1
    # the paraboloid would bear that load over many times that length
    assert scales(short_roller(np.inf, load)).film > 4 * expected.film


def test_ends_beyond_the_film_change_nothing():
    whole = scales(short_roller(np.inf, 100.0)).film
    paraboloid = ball(
        gap=pyworm.Paraboloid(RADIUS, ACROSS), load=100.0, motions=motions(0.01, SPEED)
    )
    assert scales(paraboloid).film == whole
    assert scales(short_roller(0.05, 100.0)).film == whole


def test_a_film_that_does_not_fall_with_the_load_is_kept(monkeypatch):
    """Between teeth under 40 N the formula gives 0.298 um, and 0.285 to 0.299 um under larger loads."""
    of_paraboloid = scales_of_scene._flooded

    def rising(scene, groups, at_rest):
        film, *others = of_paraboloid(scene, groups, at_rest)
        return (film * (scene.load / 10.0) ** 3, *others)

    monkeypatch.setattr(scales_of_scene, "_flooded", rising)
    assert scales(short_roller(5e-3, 10.0)).film == scales(short_roller(np.inf, 10.0)).film
