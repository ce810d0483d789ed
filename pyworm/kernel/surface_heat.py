"""What a surface is warmer than by steady conduction, since it was heated by other fluxes before."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.kernel import core
from pyworm.kernel.core import fortran_array
from pyworm.materials.body import Body


@dataclass(frozen=True)
class SurfacePast:
    """A body's surface at the present, the first time, and before."""

    ages: Array
    """Age of each time [s]."""
    velocities: Array
    """Velocity at the contact point then [m/s], direction along the last axis."""

    def chosen(
        self, shape: tuple[int, ...], spacing: Sequence[float], diffusivity: float
    ) -> list[int]:
        """Numbers of the times whose fluxes count on a grid, 0 the present, by the diffusivity [m2/s]."""
        numbers, count = core.bindings.heated_times(
            self.ages,
            *_nodes(shape),
            _two(spacing, 1.0),
            _two(self.velocities[0], 0.0),
            diffusivity,
        )
        return [int(number) - 1 for number in numbers[:count]]


@dataclass(frozen=True)
class FluxRecord:
    """Flux into a body at one time."""

    flux: Array
    """Flux at the nodes of that time's grid [W/m2]."""
    first: tuple[float, ...]
    """First node along each direction [m]."""
    spacing: tuple[float, ...]
    """Spacing along each direction [m]."""


def extrapolated_flux(latest: Array, before: Array, ahead: float) -> Array:
    """Present flux into both bodies, along the last axis, by the last two [W/m2].

    `ahead` is the time since the last over that between them.
    """
    present: Array = core.bindings.extrapolated_flux(
        *(fortran_array(flux.reshape(-1, 2)) for flux in (latest, before)), ahead
    )
    return present.reshape(latest.shape)


def residual_rise(
    past: SurfacePast,
    chosen: Sequence[int],
    records: Sequence[FluxRecord],
    body: Body,
    turning: float,
    velocity: Sequence[Array],
) -> Array:
    """What a surface is warmer than by steady conduction at the nodes of the present grid [K].

    Args:
        past: The surface at the present and before.
        chosen: Numbers of the times whose fluxes count (`SurfacePast.chosen`).
        records: Their fluxes.
        body: The body.
        turning: Angular velocity of the axes [rad/s].
        velocity: Velocity of the surface at the nodes along each direction [m/s].
    """
    shape = records[0].flux.shape
    nodes = _nodes(shape)
    u, v = velocity if len(velocity) == 2 else (velocity[0], np.zeros(shape))
    rise: Array = core.bindings.surface_residual_rise(
        past.ages,
        fortran_array([_two(velocity, 0.0) for velocity in past.velocities]).T,
        np.array(chosen, dtype=np.int32) + 1,
        fortran_array(np.stack([record.flux.reshape(nodes) for record in records], axis=-1)),
        fortran_array(np.transpose([_two(record.first, 0.0) for record in records])),
        fortran_array(np.transpose([_two(record.spacing, 1.0) for record in records])),
        np.array([body.diffusivity, body.thermal_inertia]),
        turning,
        *(fortran_array(component.reshape(nodes)) for component in (u, v)),
    )
    return rise.reshape(shape)


def _nodes(shape: tuple[int, ...]) -> tuple[int, int]:
    """Nodes along both directions, of which a line has one."""
    return shape[0], shape[1] if len(shape) > 1 else 1


def _two(numbers: Sequence[float] | Array, second: float) -> Array:
    """Numbers along both directions, with one along a second direction that a line has not."""
    return np.array([*numbers, second][:2], dtype=float)
