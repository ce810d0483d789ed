"""Nests of grids share their nodes, and windows reach as far as they should."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from circular_contact import RADIUS, circular
from hypothesis import given
from hypothesis import strategies as st

from pyworm.kernel.interpolation import prolong
from pyworm.planning.grid import CELLS_MULTIPLE, Grid, nest
from pyworm.planning.window import Reach, grown, windows
from pyworm.scene.scales import scales

side = st.floats(0.5, 20.0)


@given(side, side, side, side, st.floats(1.0, 5.0), st.floats(0.05, 0.3), st.floats(0.05, 0.3))
def test_every_grid_of_a_nest_is_a_window_of_the_one_before(w, e, s, n, growth, dx, dy):
    inner = (-w, e, -s, n)
    outer = tuple(growth * place for place in inner)
    grids = nest(inner, outer, dx, dy)
    check_nest(grids, inner, outer, dx, dy)


def check_nest(grids, inner, outer, dx, dy):
    assert grids[-1].dx == dx and grids[-1].dy == dy
    for grid, (west, east, south, north) in ((grids[-1], inner), (grids[0], outer)):
        assert grid.west <= west + 1e-9 and grid.x[-1] >= east - 1e-9
        assert grid.south <= south + 1e-9 and grid.y[-1] >= north - 1e-9
    for grid in grids:
        assert (grid.nx - 1) % CELLS_MULTIPLE == 0 == (grid.ny - 1) % CELLS_MULTIPLE
        assert np.abs(grid.x).min() < 1e-9 and np.abs(grid.y).min() < 1e-9
    for wide, narrow in pairwise(grids):
        columns, rows = wide.window_of(narrow)
        assert np.allclose(wide.x[columns], narrow.x[::2], atol=1e-9)
        assert np.allclose(wide.y[rows], narrow.y[::2], atol=1e-9)


def test_a_finer_grid_keeps_the_nodes():
    grid = Grid(-1.0, -2.0, 0.25, 0.5, 9, 9)
    assert np.allclose(grid.finer().x[::2], grid.x)
    x, y = grid.mesh()
    fine_x, _ = grid.finer().mesh()
    assert np.allclose(prolong(x**3 + y), fine_x**3 + grid.finer().mesh()[1])


def test_a_window_reaches_until_the_gap_has_risen():
    scene = circular(100, 10)
    size = scales(scene)
    ((west, east, south, north),) = windows(scene, size, Reach(inlet=50.0, exit=5.0))
    wanted = size.hertz.approach + 50 * size.film
    assert west**2 / (2 * RADIUS) >= wanted
    assert north**2 / (2 * RADIUS) >= wanted
    assert (west / 1.4) ** 2 / (2 * RADIUS) < wanted
    assert east < -west
    assert south == pytest.approx(-north)


def test_windows_that_grow_together_are_those_that_grow_alone():
    scene = circular(100, 10)
    size, reaches = scales(scene), [Reach(50.0, 5.0), Reach(3.0, 3.0), Reach(600.0, 120.0)]
    alone = tuple(box for reach in reaches for box in windows(scene, size, reach))
    assert windows(scene, size, *reaches) == alone


def test_a_gap_is_looked_at_inside_the_contact_once_and_then_on_the_sides_alone():
    scene, asked = circular(100, 10), []

    def gap(x, y):
        asked.append(np.broadcast(x, y).size)
        return scene.gap(x, y)

    windows(replace(scene, gap=gap), scales(scene), Reach(50.0, 5.0), Reach(100.0, 10.0))
    assert len(asked) > 3
    assert sum(asked[1:]) < len(asked[1:]) * asked[0] / 5


@pytest.mark.parametrize("relief", [-3e-6, 20e-6, 1e-3])
def test_a_window_is_the_same_wherever_the_gap_counts_from(relief):
    scene = circular(100, 10)

    def relieved(x, y):
        gap, covered = scene.gap(x, y)
        return gap + relief, covered

    size, reach = scales(scene), Reach(50.0, 10.0)
    lowered = windows(replace(scene, gap=relieved), size, reach)
    np.testing.assert_allclose(lowered, windows(scene, size, reach))


def test_a_window_ends_where_the_teeth_do():
    scene = circular(100, 10)

    def short(x, y):
        gap, _ = scene.gap(x, y)
        return gap, y < 1e-4

    size = scales(scene)
    reach = Reach(150.0, 10.0)
    (cut,), (whole,) = (windows(of, size, reach) for of in (replace(scene, gap=short), scene))
    assert cut[3] < whole[3]


def test_a_wider_window_does_not_follow_a_valley_of_the_gap():
    """In the distance the gap is low along a line beside the contact, as the contact line of a worm bends."""
    scene = circular(100, 10)
    size, reach = scales(scene), Reach.around(20.0)

    def valley(x, y):
        gap, covered = scene.gap(x, y)
        low = (x > 0) & (np.abs(y + x) < 0.3 * np.abs(x)) & (np.hypot(x, y) > 1.5 * inner[1])
        return np.where(low, 0.02 * gap, gap), covered

    (inner,) = windows(scene, size, reach)
    far = windows(scene, size, reach.doubled())[0]
    assert grown(scene, inner, far)[2:] == far[2:]
    winding = replace(scene, gap=valley)
    followed = windows(winding, size, reach.doubled())[0]
    assert followed[1] > 3 * inner[1]
    assert np.max(np.divide(grown(winding, inner, followed), inner)) == pytest.approx(1.4**2)


@pytest.mark.parametrize("west", [-5.0, -2.0, 2.0])
@pytest.mark.parametrize("count", [4, 8, 20])
def test_nodes_that_two_grids_share_are_at_the_same_places(west, count):
    one, other = Grid(-3.0, -2.0, 1.0, 0.5, 10, 8), Grid(west, 0.0, 1.0, 0.5, count, 9)
    (x, y), (its_x, its_y) = one.nodes_of(other), other.nodes_of(one)
    np.testing.assert_array_equal(one.x[x], other.x[its_x])
    np.testing.assert_array_equal(one.y[y], other.y[its_y])
    assert set(one.x[x]) == set(one.x) & set(other.x)
