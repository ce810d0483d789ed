"""Transient films, whose thickness and density change with time."""

import numpy as np
import pytest
from plan_scenes import STEEL, mineral, point
from scipy.interpolate import CubicSpline, RectBivariateSpline

import pyworm
from pyworm.kernel.core import KernelError
from pyworm.planning.effects.geometry import as_line
from pyworm.scene.scales import line_scales, scales
from pyworm.solver.line.level import first_level
from pyworm.solver.newton import iterate
from pyworm.solver.point.level import first_level as first_point_level

THIRD_ORDER = (11 / 6, -3.0, 3 / 2, -1 / 3)
"""Weights of the present and of three equal steps back in a rate of change (Gear's)."""


def ball(speed):
    velocities = ((speed, 0.0), (speed, 0.0))
    return point("ball", (0.02, 0.02), 50.0, velocities, (STEEL, STEEL), mineral(0.09, 2e-8))


def film_of(scene, grid, term=None):
    return led(first_point_level(scene, scene, scales(scene), grid), term)


def led(level, term):
    if term is not None:
        level.film.set_transient_term(*term)
        level.film.restart()
    iterate(level, 1e-8)
    assert level.film.balance.worst <= 1e-8
    return level


def test_a_film_in_moving_axes_is_that_in_its_own_axes():
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
    films = [level.read().figures for level in (own, fast, moving)]
    for name in ("film_central", "film_min"):
        slow, steady, carried = (film[name] for film in films)
        assert carried - slow == pytest.approx(0.0, abs=0.03 * (steady - slow))


def line_of(scene, grid, term=None):
    return led(first_level(scene, line_scales(scene), grid, line_scales(scene).film), term)


def test_a_line_film_in_moving_axes_is_that_in_its_own_axes():
    own, fast = (as_line(ball(speed)) for speed in (1.0, 1.2))
    (grid,) = pyworm.plan(own, 0.01, "isothermal", ("film",)).grids
    steady = [line_of(scene, grid) for scene in (own, fast)]
    film, density, _ = steady[0].film.fields()
    seconds = grid.dx / 0.4
    present, *past = THIRD_ORDER
    lift = CubicSpline(grid.x, density * film - own.gap(grid.x)[0])
    squeeze = 0.0
    for back, weight in enumerate(past, start=1):
        there = grid.x + 0.2 * back * seconds
        squeeze = squeeze + weight * (lift(there) + own.gap(there)[0])
    moving = line_of(fast, grid, (present / seconds, squeeze / seconds))
    for name in ("film_central", "film_min"):
        slow, fast_one, carried = (level.read().figures[name] for level in (*steady, moving))
        assert carried - slow == pytest.approx(0.0, abs=0.03 * (fast_one - slow))


@pytest.mark.parametrize("wrong", ["not finite", "another grid"])
def test_impossible_transient_terms_are_refused(wrong):
    grid = pyworm.plan(ball(1.0), 0.05, "isothermal", ("film",)).grids[-1]
    line = as_line(ball(1.0))
    (axis,) = pyworm.plan(line, 0.05, "isothermal", ("film",)).grids
    for level in (film_of(ball(1.0), grid), line_of(line, axis)):
        shape = np.shape(level.gap)
        fields = {"not finite": np.full(shape, np.nan), "another grid": np.zeros([3] * len(shape))}
        with pytest.raises(KernelError):
            level.film.set_transient_term(1.0, fields[wrong])
