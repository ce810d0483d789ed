"""Stress below the surface of one body under its tractions by the kernel."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
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
