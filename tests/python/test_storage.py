"""Films that store oil as they change."""

import numpy as np
import pytest
from plan_scenes import STEEL, mineral, point
from scipy.interpolate import RectBivariateSpline

import pyworm
from pyworm import climb
from pyworm.kernels import KernelError
from pyworm.ladder import lead
from pyworm.scales import scales

THIRD_ORDER = (11 / 6, -3.0, 3 / 2, -1 / 3)
"""Weights of the present and of three equal steps back in a rate of change (Gear's)."""


def ball(speed):
    velocities = ((speed, 0.0), (speed, 0.0))
    return point("ball", (0.02, 0.02), 50.0, velocities, (STEEL, STEEL), mineral(0.09, 2e-8))


def film_of(scene, grid, store=None):
    rung = climb.first_rung(scene, scene, scales(scene), grid)
    if store is not None:
        rung.film.store(*store)
        rung.film.restart()
    lead(rung, 1e-8)
    assert rung.film.balance.worst <= 1e-8
    return rung


def test_a_film_in_axes_that_it_moves_through_is_that_of_its_own():
    """A ball that runs at 0.2 m/s into oil of 1.2 m/s has the film of 1 m/s."""
    grid = pyworm.plan(ball(1.0), 0.05, "isothermal", ("film",)).grids[-1]
    own, fast = (film_of(ball(speed), grid) for speed in (1.0, 1.2))
    film, density, _ = own.film.fields()
    held = RectBivariateSpline(grid.x, grid.y, density * film - own.gap)
    seconds = grid.dx / 0.4
    x, y = grid.mesh()
    present, *past = THIRD_ORDER
    squeeze = 0.0
    for back, weight in enumerate(past, start=1):
        there = x + 0.2 * back * seconds, y
        squeeze = squeeze + weight * (held(*there, grid=False) + ball(1.0).gap(*there)[0])
    moving = film_of(ball(1.2), grid, (present / seconds, squeeze / seconds))
    films = [rung.read().figures for rung in (own, fast, moving)]
    for name in ("film_central", "film_min"):
        slow, steady, carried = (film[name] for film in films)
        assert carried - slow == pytest.approx(0.0, abs=0.03 * (steady - slow))


def test_what_is_not_finite_is_not_stored():
    rung = film_of(ball(1.0), pyworm.plan(ball(1.0), 0.05, "isothermal", ("film",)).grids[-1])
    with pytest.raises(KernelError):
        rung.film.store(np.inf, np.zeros(rung.grid.shape))
