"""A periodic cell of a rough surface: its contact with a rigid flat and flow through the gap between."""

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
from pyworm.kernel import core
from pyworm.kernel.core import check_status, fortran_array

MOST_ITERATIONS = 1000

FLOW_TOLERANCE = 1e-5
"""Residual of the flow's equations, over the first; errors of the factors are its square."""


def press(
    height: npt.ArrayLike,
    spacing: tuple[float, float],
    reduced_modulus: float,
    separation: float,
    hardness: float,
    tolerance: float,
) -> tuple[Array, Array]:
    """Pressure [Pa] and gap [m] of a surface on a rigid flat, elastic up to a hardness [Pa].

    Heights (nx, ny) repeat in both directions; the flat is at a separation from height zero. The gap is
    negative where material has yielded, and has a root mean square of `tolerance` in the contact. KernelError
    if an argument makes no sense, or the iteration did not converge.
    """
    pressure = np.zeros(np.shape(height), order="F")
    gap, _, status = core.bindings.cell_press(
        fortran_array(height),
        *spacing,
        reduced_modulus,
        separation,
        hardness,
        tolerance,
        MOST_ITERATIONS,
        pressure,
    )
    check_status(status)
    return pressure, gap


def conduct(gap: npt.ArrayLike, spacing: tuple[float, float]) -> tuple[Array, Array]:
    """Flow through a gap above zero [m] that repeats itself, (nx, ny): tensors xx, yy, xy.

    The cube of the gap that conducts as much [m3], and the thickness that a wall carries along with its own
    roughness [m]. KernelError if an argument makes no sense, or the iteration did not converge.
    """
    conducted, carried, _, status = core.bindings.cell_conduct(
        fortran_array(gap), *spacing, FLOW_TOLERANCE, MOST_ITERATIONS
    )
    check_status(status)
    return conducted, carried
