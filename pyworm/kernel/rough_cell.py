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
    """Contact of a surface with a rigid flat, elastic up to a hardness.

    Args:
        height: Heights [m], shape (nx, ny), repeated in both directions.
        spacing: Distance of nodes along x and y [m].
        reduced_modulus: E' [Pa].
        separation: Flat from height zero [m].
        hardness: Largest pressure [Pa].
        tolerance: Gap left in the contact [m], root mean square.

    Returns:
        Pressure [Pa], and the gap [m], negative where material has yielded.

    Raises:
        KernelError: An argument makes no sense, or the iteration did not converge.
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
    """Flow through a gap that repeats itself.

    Args:
        gap: Gap [m], above zero, shape (nx, ny).
        spacing: Distance of nodes along x and y [m].

    Returns:
        tuple of numpy.ndarray: Tensors xx, yy, xy: the cube of the gap that conducts as much [m3], and the
            thickness that a wall carries along with its own roughness [m].

    Raises:
        KernelError: An argument makes no sense, or the iteration did not converge.
    """
    conducted, carried, _, status = core.bindings.cell_conduct(
        fortran_array(gap), *spacing, FLOW_TOLERANCE, MOST_ITERATIONS
    )
    check_status(status)
    return conducted, carried
