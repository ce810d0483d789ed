"""Stress below the surface of one body under its tractions by the kernel."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
from pyworm.formulas.thermal_stress import ThermalSolid
from pyworm.kernel import core
from pyworm.kernel.core import check_status, fortran_array

COMPONENTS = ("xx", "yy", "zz", "xy", "xz", "yz")
"""Components of a stress, in the order of arrays."""


def subsurface_stress(
    pressure: Array,
    shear: Sequence[Array],
    spacing: Sequence[float],
    poisson_ratio: float,
    depths: npt.ArrayLike,
) -> Array:
    """Stress [Pa] below the nodes of a grid, along the first axes `COMPONENTS` and depths.

    z points into the body, tractions are constant on the cells of the nodes.

    Args:
        pressure: Pressure [Pa] at the nodes, shape (nx, ny) for a half-space, (nx,) for a half-plane in plane
            strain.
        shear: Shear stress [Pa] that acts on the surface along each direction of the grid.
        spacing: Grid spacing along each direction [m].
        poisson_ratio: Poisson's ratio of the body.
        depths: Depths [m].

    Raises:
        KernelError: A spacing or a depth that there is not, or no memory.
    """
    tractions = fortran_array(np.stack([pressure, *shear], axis=-1))
    depths = fortran_array(np.atleast_1d(depths))
    if pressure.ndim == 2:
        stress, status = core.bindings.point_stress(tractions, *spacing, poisson_ratio, depths)
        check_status(status)
        return np.moveaxis(stress, (2, 3), (0, 1))
    plane, status = core.bindings.line_stress(tractions, *spacing, depths)
    check_status(status)
    xx, zz, xz = np.moveaxis(plane, (1, 2), (0, 1))
    none = np.zeros(xx.shape)
    return np.stack([xx, poisson_ratio * (xx + zz), zz, none, xz, none])


def thermal_stress(
    rise: Array,
    spacing: Sequence[float],
    velocity: Sequence[float],
    solid: ThermalSolid,
    depths: npt.ArrayLike,
    window: Sequence[tuple[int, int]] | None = None,
) -> Array:
    """Stress [Pa] of a rise of the surface temperature, along the first axes `COMPONENTS` and depths.

    z points into the body. The rise repeats periodically: it needs room around it that is not heated.

    Args:
        rise: Surface temperature above that far below [K], shape (nx, ny), or (nx,) of a line contact in
            plane strain; nx even.
        spacing: Grid spacing along each direction [m].
        velocity: Velocity of the body's material past the contact along each direction [m/s].
        solid: The body.
        depths: Depths [m].
        window: First node along each direction, and number of nodes, where the stress is wanted; by default
            all.

    Raises:
        KernelError: A spacing, a depth or a window that there is not, or no memory.
    """
    window = window or [(0, count) for count in rise.shape]
    line = rise.ndim == 1
    first, counts = zip(*window, *[(0, 1)] * line, strict=True)
    found: tuple[Array, int] = core.bindings.heat_stress(
        fortran_array(rise[:, None] if line else rise),
        [*spacing, *spacing][:2],
        [solid.restrained, solid.poisson_ratio, solid.diffusivity, *velocity, 0.0][:5],
        np.add(first, 1),
        *counts,
        fortran_array(np.atleast_1d(depths)),
    )
    stress, status = found
    check_status(status)
    stress = np.moveaxis(stress, (2, 3), (0, 1))
    return stress[..., 0] if line else stress
