"""Stress below the surface by the kernel against closed forms of sliding contacts, equilibrium, symmetry."""

import numpy as np
import pytest
from sliding_contacts import sliding_line, sliding_sphere

from pyworm.kernel import KernelError, subsurface_stress

FRICTION, NU = 0.3, 0.3

DEPTHS = np.array([0.3, 0.48, 1.2])
"""Depths over the half-width of the contact."""


def sliding_below(nodes, depths, friction=FRICTION):
    """Nodes' coordinates and the stress below a sliding sphere of p0 = a = 1 on a grid."""
    x = np.linspace(-1.5, 1.5, nodes)
    pressure = np.sqrt(np.maximum(1 - x[:, None] ** 2 - x**2, 0))
    shear = (friction * pressure, np.zeros_like(pressure))
    return x, subsurface_stress(pressure, shear, (x[1] - x[0],) * 2, NU, depths)


def largest_error(nodes, depths=DEPTHS):
    """Largest error of any component below the sliding sphere, over p0."""
    x, stress = sliding_below(nodes, depths)
    every = nodes // 16
    x = x[::every]
    exact = [sliding_sphere(x[:, None], x, depth, FRICTION, NU) for depth in depths]
    return np.abs(stress[..., ::every, ::every] - np.stack(exact, axis=1)).max()


def test_the_sliding_sphere_is_met_to_a_thousandth_and_of_second_order():
    coarse, fine = largest_error(65), largest_error(129)
    print(f"largest error over p0: {coarse:.1e}, then {fine:.1e}")
    assert fine < 4e-4
    assert fine < coarse / 3


def test_the_reference_is_in_equilibrium_and_has_the_tractions():
    place = np.array([0.3, -0.4, 0.5])

    def slope(axis):
        step = 1e-4 * np.eye(3)[axis]
        stresses = (sliding_sphere(*(place + side * step), FRICTION, NU) for side in (1, -1))
        return np.subtract(*stresses) / 2e-4

    by_x, by_y, by_z = (slope(axis) for axis in range(3))
    xx, yy, zz, xy, xz, yz = range(6)
    assert abs(by_x[xx] + by_y[xy] + by_z[xz]) < 1e-7
    assert abs(by_x[xy] + by_y[yy] + by_z[yz]) < 1e-7
    assert abs(by_x[xz] + by_y[yz] + by_z[zz]) < 1e-7
    near, far = (sliding_sphere(*place[:2], depth, FRICTION, NU) for depth in (0.04, 0.08))
    surface, pressure = 2 * near - far, np.sqrt(1 - 0.25)
    assert surface[[zz, xz, yz]] == pytest.approx([-pressure, -FRICTION * pressure, 0], abs=0.01)


def test_the_sliding_line_is_met():
    x = np.linspace(-1.5, 1.5, 513)
    pressure = np.sqrt(np.maximum(1 - x**2, 0))
    stress = subsurface_stress(pressure, (FRICTION * pressure,), (x[1] - x[0],), NU, DEPTHS)
    for depth, found in zip(DEPTHS, np.swapaxes(stress, 0, 1), strict=True):
        exact = sliding_line(x, depth, FRICTION)
        assert np.abs(found[[0, 2, 4]] - exact).max() < 1e-5
        assert found[1] == pytest.approx(NU * (exact[0] + exact[1]), abs=1e-5)
        assert not found[[3, 5]].any()


def test_the_divergence_of_the_stress_vanishes():
    step = 0.02
    x, stress = sliding_below(129, 0.5 + step * np.array([-1, 0, 1]))
    xx, yy, zz, xy, xz, yz = stress
    h = x[1] - x[0]

    def balance(along_x, along_y, along_z):
        slopes = np.gradient(along_x[1], h, axis=0) + np.gradient(along_y[1], h, axis=1)
        return (slopes + (along_z[2] - along_z[0]) / (2 * step))[1:-1, 1:-1]

    forces = balance(xx, xy, xz), balance(xy, yy, yz), balance(xz, yz, zz)
    largest = max(np.abs(force).max() for force in forces)
    print(f"largest force over p0/a: {largest:.1e}")
    assert largest < 5e-3


def test_tractions_are_those_of_the_surface_and_mirrored_ones_mirror_the_stress():
    _, stress = sliding_below(65, [0.0, 0.4])
    _, against = sliding_below(65, [0.0, 0.4], -FRICTION)
    middle = stress[:, 0, 32, 32]
    assert middle[[2, 4, 5]] == pytest.approx([-1, -FRICTION, 0], abs=1e-6)
    signs = np.array([1, 1, 1, -1, -1, 1])[:, None, None, None]
    assert stress == pytest.approx(signs * against[..., ::-1, :], abs=1e-5)
    signs = np.array([1, 1, 1, -1, 1, -1])[:, None, None, None]
    assert stress == pytest.approx(signs * stress[..., ::-1], abs=1e-5)


def test_a_depth_above_the_surface_is_refused():
    with pytest.raises(KernelError, match="makes no sense"):
        sliding_below(9, [-0.1])
