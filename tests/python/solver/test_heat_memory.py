"""Heat that surfaces remember of films before, against quadratures of conduction along their paths."""

from dataclasses import replace
from itertools import pairwise
from math import pi, sqrt

import numpy as np
import pytest
import scipy
from plan_scenes import STEEL, mineral, point

from pyworm.planning.effects.geometry import as_line
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.scene.point import RigidMotion
from pyworm.solver.transient.heat_memory import HeatedTimeLevel, residual_rise

HALF, FLUX = 0.2e-3, 2e8
EFFUSIVITY = sqrt(STEEL.conductivity * STEEL.density * STEEL.specific_heat)
SPEEDS = (3.0, 0.6)
STEP = 2 * HALF / 1.8 / 24


def time_grid(seconds):
    """Factor of the flux over time."""
    return 1 + 0.4 * np.sin(seconds / (40 * STEP)) + 0.2 * np.tanh(seconds / (8 * STEP))


def shape(x):
    return np.sqrt(np.maximum(1 - (x / HALF) ** 2, 0.0))


def line(speeds=SPEEDS):
    ball = point(
        "ball", (0.02, 0.02), 50.0, ((1.0, 0.0), (1.0, 0.0)), (STEEL, STEEL), mineral(0.09, 2e-8)
    )
    return replace(as_line(ball), velocities=speeds)


def spread_shape(x, age):
    """The shape after its heat has spread along the surface for a time, by a fine sum over its width."""
    width = sqrt(2 * STEEL.diffusivity * age)
    if width == 0:
        return float(shape(x))
    angle = (np.arange(200) + 0.5) / 200 * pi  # of places in the contact, dense at its ends
    place = HALF * np.cos(angle)
    weight = shape(place) * HALF * np.sin(angle) * pi / 200
    return float(np.sum(weight * np.exp(-((x - place) ** 2) / (2 * width**2)))) / (
        width * sqrt(2 * pi)
    )


def exact(x, moved, speed, factor):
    """Rise less steady rise at a place, by quadrature over the age of its heat."""

    def over_root(root):  # s = root^2, ds / sqrt(s) = 2 d root
        age = root**2
        then = spread_shape(x - moved(age), age) * factor(-age)
        return 2 * (then - spread_shape(x - speed * age, age) * factor(0.0))

    last = sqrt(3 * HALF / min(abs(speed), 0.3))
    return FLUX / (sqrt(pi) * EFFUSIVITY) * scipy.integrate.quad(over_root, 0, last, limit=2000)[0]


def history(grid, speed_at, factor, count=400):
    """Fluxes at times before the present, 0, on a grid that does not move."""
    flux = FLUX * shape(grid.x)
    return [
        HeatedTimeLevel(
            -STEP * k, grid, np.stack([flux, flux], -1) * factor(-STEP * k), speed_at(-STEP * k)
        )
        for k in range(1, count)
    ]


GRID = LineGrid(HALF / 60, -90, 181)


@pytest.mark.parametrize("body", [0, 1])
def test_a_flux_that_changes_is_remembered(body):
    found = residual_rise(
        history(GRID, lambda at: tuple((of,) for of in SPEEDS), time_grid),
        line(),
        GRID,
        GRID,
        0.0,
        0.0,
    )
    places = np.arange(45, 150, 15)
    expected = [
        exact(GRID.x[at], lambda s: SPEEDS[body] * s, SPEEDS[body], time_grid) for at in places
    ]
    assert found[places, body] == pytest.approx(expected, abs=0.05 * np.abs(expected).max())


def test_a_speed_that_changes_is_remembered():
    """The slower surface has doubled its speed within the time that oil takes."""

    def speed(seconds):
        return 0.6 * (1 + seconds / (24 * STEP) / 2) if seconds > -24 * STEP else 0.3

    def moved(age):
        ramp = min(age, 24 * STEP)
        return 0.6 * (ramp - ramp**2 / (96 * STEP)) + 0.3 * max(age - 24 * STEP, 0.0)

    found = residual_rise(
        history(GRID, lambda at: ((3.0,), (speed(at),)), lambda seconds: 1.0),
        line(),
        GRID,
        GRID,
        0.0,
        0.0,
    )
    places = np.arange(45, 150, 15)
    expected = [exact(GRID.x[at], moved, 0.6, lambda seconds: 1.0) for at in places]
    assert (
        np.abs(found[:, 0]).max() < 1e-3 * np.abs(expected).max()
    )  # the other one has kept its own
    assert found[places, 1] == pytest.approx(expected, abs=0.05 * np.abs(expected).max())


def test_a_finer_grid_takes_the_rise_of_every_second_of_its_nodes():
    fine = LineGrid(GRID.dx / 2, -180, 361)
    found = [
        residual_rise(
            history(grid, lambda at: tuple((of,) for of in SPEEDS), time_grid),
            line(),
            grid,
            GRID,
            0.0,
            0.0,
        )
        for grid in (GRID, fine)
    ]
    assert found[1].shape == (361, 2)
    assert found[1][::2] == pytest.approx(found[0], abs=0.01 * np.abs(found[0]).max())


def test_points_remember_as_lines_do_in_any_direction():
    grid = Grid(-90 * HALF / 60, -4e-3, HALF / 60, 1e-3, 181, 9)
    along = line()
    ball = point(
        "ball", (0.02, 0.02), 50.0, ((1.0, 0.0), (1.0, 0.0)), (STEEL, STEEL), mineral(0.09, 2e-8)
    )
    ball = replace(ball, motions=tuple(RigidMotion(of, 0.0) for of in SPEEDS))
    lines = history(GRID, lambda at: tuple((of,) for of in SPEEDS), time_grid)
    points = [
        HeatedTimeLevel(
            one.seconds,
            grid,
            np.repeat(one.flux[:, None], 9, axis=1),
            tuple((of, 0.0) for of in SPEEDS),
        )
        for one in lines
    ]
    of_line = residual_rise(lines, along, GRID, GRID, 0.0, 0.0)
    assert residual_rise(points, ball, grid, grid, 0.0, 0.0)[:, 4] == pytest.approx(
        of_line, abs=1e-9
    )
    turned = [
        HeatedTimeLevel(
            one.seconds,
            Grid(grid.south, grid.west, grid.dy, grid.dx, 9, 181),
            np.swapaxes(one.flux, 0, 1),
            tuple((0.0, of) for of in SPEEDS),
        )
        for one in points
    ]
    ball = replace(ball, motions=tuple(RigidMotion(0.0, of) for of in SPEEDS))
    found = residual_rise(turned, ball, turned[0].grid, turned[0].grid, 0.0, 0.0)
    assert found[4] == pytest.approx(of_line, abs=1e-9)


def test_a_steady_flux_leaves_nothing_to_remember():
    still = history(GRID, lambda at: tuple((of,) for of in SPEEDS), lambda seconds: 1.0)
    assert np.abs(residual_rise(still, line(), GRID, GRID, 0.0, 0.0)).max() < 1e-9


def conduction(speed):
    """Steady rise by the flux of each cell of the grid over the flux, a matrix [K m2/W].

    A line source warms a place x downstream by exp(p x) K0(p |x|) / (pi k), p = u / (2 kappa) (Carslaw and
    Jaeger 1959, section 10.7).
    """
    p = speed / (2 * STEEL.diffusivity)

    def rise(x):
        return scipy.special.k0e(p * abs(x)) * np.exp(-2 * p * max(-x, 0.0))

    ends = (np.arange(-GRID.x.size + 1, GRID.x.size + 1) - 0.5) * GRID.dx
    cells = [
        scipy.integrate.quad(rise, a, b, points=[0.0] if a < 0 < b else None)[0]
        for a, b in pairwise(ends)
    ]
    cells = np.array(cells) / (pi * STEEL.conductivity)
    return scipy.linalg.toeplitz(cells[GRID.x.size - 1 :], cells[GRID.x.size - 1 :: -1])


@pytest.mark.parametrize("speeds", [SPEEDS, (0.3, 0.03), (0.1, -0.02), (0.02, 0.01)], ids=str)
def test_how_a_thin_film_divides_its_heat_between_the_surfaces_is_stable(speeds):
    """Walls of one temperature decide about the division, which is disturbed once."""
    first, second = (conduction(speed) if speed > 0 else conduction(-speed).T for speed in speeds)
    whole = 2 * FLUX * shape(GRID.x)
    step = STEP * sum(SPEEDS) / sum(np.abs(speeds))

    def divided(difference):
        """Fluxes that make both walls equally warm, the second of them warmer by a difference else."""
        part = np.linalg.solve(first + second, second @ whole + difference)
        return np.stack([part, whole - part], axis=-1)

    rest = divided(np.zeros(GRID.x.size))
    velocities = tuple((of,) for of in speeds)
    disturbed = rest + 0.1 * np.outer(whole * np.sin(5 * GRID.x / HALF), [1, -1])
    time_levels = [
        HeatedTimeLevel(0.0, GRID, disturbed, velocities),
        HeatedTimeLevel(-step, GRID, rest, velocities),
    ]
    deviations = []
    for number in range(1, 150):
        rise = residual_rise(time_levels, line(speeds), GRID, GRID, number * step, 0.0)
        flux = divided(rise[:, 1] - rise[:, 0])
        time_levels.insert(0, HeatedTimeLevel(number * step, GRID, flux, velocities))
        deviations.append(np.abs(flux - rest).max())
    print(deviations[::10])
    assert max(deviations) < np.abs(disturbed - rest).max()
    assert deviations[-1] < 0.02 * deviations[0]
