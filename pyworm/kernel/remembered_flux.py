"""Flux that places of a surface met on their way through a contact, against the present one."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.kernel import core
from pyworm.kernel.core import fortran_array


@dataclass(frozen=True)
class FluxHistory:
    """Fluxes into a body at some times, the present first."""

    flux: Sequence[Array]
    """Flux at the nodes of each time's grid as its heat has spread along the surface since [W/m2]."""
    present: Sequence[Array]
    """Present flux at its grid's nodes, as its heat would have spread within those times [W/m2]."""
    first: Sequence[tuple[float, ...]]
    """First node of that grid along each direction [m]."""
    spacing: Sequence[tuple[float, ...]]
    """Spacing of that grid along each direction [m]."""


@dataclass(frozen=True)
class FluxReading:
    """An age of the heat at which its flux is read."""

    age: float
    """Time before the present [s]."""
    weight: float
    """Weight of what is read in the integral over the age [sqrt(s)]."""
    interval: int
    """Number of the time of the history, from 0 at present, that ends the interval of time it lies in."""
    share: float
    """Part of that interval before its end."""
    distance: tuple[float, ...]
    """Way of the surface through the contact point since then, along each direction [m]."""


def remembered_flux(
    history: FluxHistory,
    readings: Sequence[FluxReading],
    turning: float,
    at_origin: Sequence[float],
    places: Sequence[Array],
    velocity: Sequence[Array],
) -> Array:
    """Integral of the flux a time s ago, less the present one a way u s before, over sqrt(s) ds.

    In W sqrt(s)/m2 at the nodes. The fluxes are linear between their nodes and their times, zero beyond their
    grids. `turning` is the angular velocity of the axes [rad/s], `at_origin` the velocity of the surface at
    the contact point and `velocity` that at the nodes, along each direction [m/s].
    """
    line = len(places) == 1
    x, y = (places[0], np.zeros(1)) if line else places
    u, v = (velocity[0], np.zeros_like(velocity[0])) if line else velocity
    nodes = (*history.flux[0].shape, 1)[:2]
    flux, present = (
        fortran_array(np.stack([field.reshape(nodes) for field in fields], axis=-1))
        for fields in (history.flux, history.present)
    )
    found: Array = core.bindings.integrate_remembered_flux(
        flux,
        present,
        _pairs(history.first, 0.0),
        _pairs(history.spacing, 1.0),
        fortran_array(
            np.transpose([(reading.age, reading.weight, reading.share) for reading in readings])
        ),
        np.array([reading.interval + 1 for reading in readings], dtype=np.int32),
        _pairs([reading.distance for reading in readings], 0.0),
        turning,
        _pairs([at_origin], 0.0)[:, 0],
        x,
        y,
        *(fortran_array(component.reshape(len(x), len(y))) for component in (u, v)),
    )
    return found[:, 0] if line else found


def _pairs(of_directions: Sequence[Sequence[float]], second: float) -> Array:
    """Numbers along each direction in columns, with one along a second direction that a line has not."""
    return fortran_array(np.transpose([(*numbers, second)[:2] for numbers in of_directions]))
