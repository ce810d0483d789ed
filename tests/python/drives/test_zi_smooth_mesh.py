"""Heights on large meshes are polynomials whose error is checked; without them each node is solved."""

import numpy as np
import pytest
from zi_drives import sharif

from pyworm.drives.zi_worm.flank_height import TOLERANCE
from pyworm.drives.zi_worm.smooth_mesh import FEWEST, on_mesh


def mesh(half_x, half_y, indexing):
    sides = np.linspace(-half_x, 0.8 * half_x, 201), np.linspace(-half_y, half_y, 121)
    return np.meshgrid(*sides, indexing=indexing)


def smooth(x, y):
    return np.array([np.exp(x) * np.cos(2 * y), x + y, np.ones(x.shape)])


@pytest.mark.parametrize("indexing", ["ij", "xy"])
def test_an_analytic_function_is_found_to_rounding(indexing):
    x, y = mesh(1.0, 0.5, indexing)
    np.testing.assert_allclose(on_mesh(smooth, x, y, 1e-12), smooth(x, y), rtol=0, atol=1e-13)


@pytest.mark.parametrize("phase", (0.0, 0.5, 1.0))
@pytest.mark.parametrize("half_sides", [(0.004, 0.001), (0.012, 0.003)])
def test_heights_of_both_flanks_are_those_of_each_node(phase, half_sides):
    x, y = mesh(*half_sides, "ij")
    assert x.size > FEWEST
    contact = sharif().contact(phase)
    for flank in (contact.worm_height, contact.wheel_height):
        assert on_mesh(flank._solve_block, x, y, TOLERANCE) is not None
        each = flank._solve_each(x.ravel(), y.ravel())[0].reshape(x.shape)
        np.testing.assert_allclose(flank.solve(x, y)[0], each, rtol=0, atol=1.5 * TOLERANCE)


def test_where_the_flank_ends_each_node_is_solved():
    x, y = mesh(0.025, 0.012, "ij")
    flank = sharif().contact(0.0).worm_height
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        assert on_mesh(flank._solve_block, x, y, TOLERANCE) is None
    height, _, exists = flank.solve(x, y)
    assert np.isfinite(height).all() and 0 < exists.mean() < 1


def test_what_polynomials_do_not_follow_is_left_to_others():
    def kinked(x, y):
        return np.array([np.abs(x - 0.1), np.ones(x.shape)])

    def ending(x, y):
        return np.array([x, x < 0.7])

    x, y = mesh(1.0, 0.5, "ij")
    assert on_mesh(kinked, x, y, 1e-12) is None
    assert on_mesh(ending, x, y, 1e-12) is None
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
