"""Heat that surfaces remember from films before.

A place of a surface was heated on its way through the contact, by the flux of those times. Steady conduction,
the kernel's, takes the present flux all along the way. With q the flux into a body, u its velocity and e^2 =
k rho c,

    rise - steady rise = 1 / (sqrt(pi) e) int_0 [q_s(X(s), t - s) - q_s(x - u s, t)] / sqrt(s) ds,         (1)

X(s) being where the place was a time s ago, and q_s the flux as its heat has spread along the surface in the
time s: averaged by a Gaussian of variance 2 kappa s, kappa being the diffusivity (an instantaneous source on
a half-space; Carslaw and Jaeger 1959, section 10.2). For fast surfaces it is conduction into depth along a
path (section 2.9, and Sharif et al. 2001, Part 1, eq. 19). A slow surface needs the spread: without it the
present flux of equation 1 raises its temperature by more than steady conduction does, a disturbed division of
heat between two such surfaces changes sign from step to step, and it grows
(`tests/python/solver/test_heat_memory.py`). The flux q, seen from the contact, is linear in time
between instants of which each is about 1.4 times as long ago as the one before, or a part of the surface's
passage through the grid longer. The bracket, zero at s = 0, is linear along the path over two cells of the
grid (`fortran/heat/residual_rise.f90`): read at the instants only, where a fast surface has gone on by many
cells, fluxes of that wavelength would add up as those of a body at rest. Of the time before the first film
the present flux is taken. Fluxes are those of `next_film.heated_levels`, without those of wide gaps.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.transient.moving_grid import at_places


@dataclass(frozen=True)
class HeatedTimeLevel:
    """Heat of the surfaces at one time."""

    seconds: float
    """The time [s]."""
    grid: Grid | LineGrid
    """The moving grid then."""
    flux: Array
    """Flux into each body at its nodes [W/m2], body along the last axis."""
    velocities: tuple[tuple[float, ...], ...]
    """Velocity of each body at the contact point along each direction [m/s]."""

    def finer(self, window: tuple[slice, slice] | None = None) -> "HeatedTimeLevel":
        """Interpolated to nodes of half the spacing, of a point contact within a window."""
        grid = self.grid.part(window) if window and isinstance(self.grid, Grid) else self.grid
        flux = kernel.prolong_levels(self.flux if window is None else self.flux[window])
        return HeatedTimeLevel(self.seconds, grid.finer(), flux, self.velocities)


def velocities_at_origin(contact: Scene | LineScene) -> tuple[tuple[float, ...], ...]:
    """Velocity of each body at the contact point along each direction [m/s]."""
    origin = [np.zeros(1)] * (1 if isinstance(contact, LineScene) else 2)
    return tuple(
        tuple(float(component.item()) for component in velocity)
        for velocity in contact.velocities_at(*origin)
    )


def residual_rise(
    history: Sequence[HeatedTimeLevel],
    contact: Scene | LineScene,
    grid: Grid | LineGrid,
    coarse: Grid | LineGrid,
    seconds: float,
    turning: float,
) -> Array:
    """What both surfaces are warmer than steady conduction has them, equation 1 [K].

    Args:
        history: Heat at times before, the latest first.
        grid: The moving grid now, of as many nodes as before.
        coarse: Every so many of its nodes, on which the rise is found; it is as smooth as the contact is
            large.
        seconds: The time [s].
        turning: Angular velocity of the axes [rad/s].

    Returns:
        Rise at the nodes, body along the last axis.
    """
    # solved for the film's nodes already, of which those of the coarse grid are some
    nodes = _strides(grid, coarse)
    now = velocities_at_origin(contact)
    present = HeatedTimeLevel(seconds, grid, _onward(history, seconds), now)
    known = [present, *history]
    ages = np.array([seconds - time_level.seconds for time_level in known])
    rises = []
    # at all of its nodes: the film's gap then has the heights of the flanks there already
    velocities_at_nodes = contact.velocities_at(*grid.mesh())
    for number, (body, velocity) in enumerate(
        zip(contact.bodies, velocities_at_nodes, strict=True)
    ):
        velocities = np.array([time_level.velocities[number] for time_level in known])
        past = kernel.SurfacePast(ages, velocities)
        chosen = past.chosen(coarse.shape, coarse.spacing, body.diffusivity)
        rise = kernel.residual_rise(
            past,
            chosen,
            [_record(known[place], number, nodes) for place in chosen],
            body,
            turning,
            tuple(component[nodes] for component in velocity),
        )
        rises.append(at_places(coarse, rise, grid))
    return np.stack(rises, axis=-1)


def remembered(
    history: Sequence[HeatedTimeLevel], contact: Scene | LineScene
) -> list[HeatedTimeLevel]:
    """Those of some times, the latest first, that later ones still read, and one between each two of them.

    Of growing ages others count; the ones between keep these no farther apart than they are read.
    """
    if len(history) < 2:
        return list(history)
    ages = np.array([history[0].seconds - time_level.seconds for time_level in history])
    grid, counted = history[0].grid, {0}
    for number, body in enumerate(contact.bodies):
        velocities = np.array([time_level.velocities[number] for time_level in history])
        past = kernel.SurfacePast(ages, velocities)
        counted |= {*past.chosen(grid.shape, grid.spacing, body.diffusivity)}
    between = {(before + after) // 2 for before, after in pairwise(sorted(counted))}
    return [history[number] for number in sorted(counted | between)]


def _record(time_level: HeatedTimeLevel, body: int, nodes: tuple[slice, ...]) -> kernel.FluxRecord:
    """Flux into a body at a time, at some nodes of its grid."""
    grid = time_level.grid
    axes = (grid.x,) if isinstance(grid, LineGrid) else (grid.x, grid.y)
    return kernel.FluxRecord(
        time_level.flux[..., body][nodes],
        tuple(float(axis[0]) for axis in axes),
        tuple(step * stride.step for step, stride in zip(grid.spacing, nodes, strict=True)),
    )


def _strides(grid: Grid | LineGrid, coarse: Grid | LineGrid) -> tuple[slice, ...]:
    """Nodes of a grid that those of a coarse one are."""
    return tuple(
        slice(None, None, (nodes - 1) // (nodes_of_coarse - 1))
        for nodes, nodes_of_coarse in zip(grid.shape, coarse.shape, strict=True)
    )


def _onward(history: Sequence[HeatedTimeLevel], seconds: float) -> Array:
    """The present flux by the last two, the latest first; the last where there is one alone."""
    latest = history[0].flux
    if len(history) == 1:
        return latest
    ahead = (seconds - history[0].seconds) / (history[0].seconds - history[1].seconds)
    return kernel.extrapolated_flux(latest, history[1].flux, ahead)
