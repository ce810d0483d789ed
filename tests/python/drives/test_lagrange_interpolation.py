"""Heights on large meshes are polynomials whose error is checked; where they fail each node is solved."""

import numpy as np
import pytest
from zi_drives import sharif

from pyworm.drives.worm.flanks.flank_height import TOLERANCE
from pyworm.drives.worm.flanks.lagrange_interpolation import on_mesh


def mesh(half_x, half_y, indexing):
    sides = np.linspace(-half_x, 0.8 * half_x, 265), np.linspace(-half_y, half_y, 145)
    return np.meshgrid(*sides, indexing=indexing)


def smooth(x, y):
    return np.array([np.exp(x) * np.cos(2 * y), x + y, np.ones(x.shape)])


@pytest.mark.parametrize("indexing", ["ij", "xy"])
def test_an_analytic_function_is_found_to_rounding(indexing):
    x, y = mesh(1.0, 0.5, indexing)
    np.testing.assert_allclose(on_mesh(smooth, x, y, 1e-12), smooth(x, y), rtol=0, atol=1e-13)


def solved(flank, x, y):
    """Heights found at each node, and how many nodes are solved for those on the mesh, as a share of all."""
    count = 0

    def find(x, y):
        nonlocal count
        count += x.size
        return flank._solve_each(x, y)

    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        found = on_mesh(find, x, y, TOLERANCE)
        each = flank._solve_each(x.ravel(), y.ravel()).reshape(found.shape)
    np.testing.assert_array_equal(found[-1] == 1, each[-1] == 1)
    np.testing.assert_allclose(found[0], each[0], rtol=0, atol=TOLERANCE)
    return count / x.size


@pytest.mark.parametrize("phase", (0.0, 0.5, 1.0))
@pytest.mark.parametrize("half_sides", [(0.004, 0.001), (0.012, 0.003)])
def test_heights_of_both_flanks_are_those_of_each_node(phase, half_sides):
    x, y = mesh(*half_sides, "ij")
    contact = sharif().contact(phase)
    for flank in (contact.worm_height, contact.wheel_height):
        assert solved(flank, x, y) < 0.3
        np.testing.assert_array_equal(
            flank.solve(x, y)[0], on_mesh(flank._solve_each, x, y, TOLERANCE)[0]
        )


def test_where_the_flank_ends_each_node_is_solved():
    x, y = mesh(0.025, 0.012, "ij")
    flank = sharif().contact(0.0).worm_height
    assert 0.3 < solved(flank, x, y) < 1
    height, _, exists = flank.solve(x, y)
    assert np.isfinite(height).all() and 0 < exists.mean() < 1


def test_what_polynomials_do_not_follow_is_found_at_each_node():
    def kinked(x, y):
        return np.array([np.abs(x - 0.1), y, np.ones(x.shape)])

    def ending(x, y):
        return np.array([np.where(x < 0.7, x, x**2), y, x < 0.7])

    x, y = mesh(1.0, 0.5, "ij")
    for function in (kinked, ending):
        np.testing.assert_allclose(on_mesh(function, x, y, 1e-12), function(x, y), atol=1e-12)
    assert on_mesh(smooth, x[:50], y[:50], 1e-12) is None
    assert on_mesh(smooth, x + 1e-3 * y, y, 1e-12) is None


def test_velocities_are_those_of_rigid_bodies_at_their_surfaces():
    drive = sharif()
    contact = drive.contact(0.3)
    x, y = np.array([0.0, 0.004, -0.006]), np.array([0.0, -0.001, 0.002])
    for motion in drive.motions(contact):
        height = motion.flank.solve(x, y)[0]
        for place in zip(x, y, height, motion.velocity(x, y).T, strict=True):
            *local, found = place
            arm = contact.point + contact.axes.T @ local - motion.axis_point
            moved = np.cross(motion.rotation, arm) - contact.velocity
            np.testing.assert_allclose(found, contact.axes @ moved, rtol=0, atol=1e-12)
