"""Dry contact and elastic deflection of point contacts by the kernel."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
from pyworm.formulas.layered_half_space import Layer
from pyworm.kernel import core
from pyworm.kernel.core import NOT_CONVERGED, check_status, fortran_array
from pyworm.kernel.numbers import layer_numbers


def elastic_deflection(
    pressure: npt.ArrayLike,
    dx: float,
    dy: float,
    reduced_modulus: float,
    layers: Sequence[Layer | None] = (),
) -> Array:
    """Sum of the deflections of both half-spaces [m] under nodal pressure [Pa], shape (nx, ny).

    Layers lie on half-spaces whose E' without them is the reduced modulus [Pa].
    """
    found: tuple[Array, int] = core.bindings.elastic_deflection(
        fortran_array(pressure), dx, dy, reduced_modulus, layer_numbers(layers)
    )
    deflection, status = found
    check_status(status)
    return deflection


@dataclass(frozen=True)
class DryContact:
    """Frictionless contact of a gap under a load."""

    pressure: Array
    """Pressure [Pa], shape (nx, ny)."""
    approach: float
    """Rigid approach of the bodies [m]."""
    iterations: int
    """Conjugate-gradient iterations."""
    converged: bool
    """Whether the iterations met the tolerance."""


def dry_contact(
    gap: npt.ArrayLike,
    covered: npt.ArrayLike,
    dx: float,
    dy: float,
    reduced_modulus: float,
    load: float,
    guess: npt.ArrayLike,
    tolerance: float,
    layers: Sequence[Layer | None] = (),
) -> DryContact:
    """Solve the dry contact of a gap [m], shape (nx, ny), from coarser grids by conjugate gradients.

    Args:
        gap, covered: Undeformed gap [m] and where both bodies exist.
        dx, dy: Grid spacing [m].
        reduced_modulus, load: E' [Pa] without layers and normal load [N].
        guess: Initial pressure; only its sign matters.
        tolerance: Residual gap in the contact, over the approach.
        layers: Coating on each body.

    Raises:
        KernelError: If the kernel refuses the contact.
    """
    pressure = fortran_array(guess).copy(order="F")
    approach, iterations, status = core.bindings.dry_contact_solve(
        fortran_array(gap),
        np.asfortranarray(covered, dtype=np.int32),
        dx,
        dy,
        reduced_modulus,
        layer_numbers(layers),
        load,
        tolerance,
        _MOST_DRY_ITERATIONS,
        pressure,
    )
    if status != NOT_CONVERGED:
        check_status(status)
    return DryContact(pressure, approach, iterations, status != NOT_CONVERGED)


_MOST_DRY_ITERATIONS = 2000
