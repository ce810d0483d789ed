"""Heat that surfaces remember from films before.

A place of a surface was heated on its way through the contact, by the flux of those times. Steady conduction,
the kernel's, takes the present flux all along the way. With q the flux into a body, u its velocity and e^2 =
k rho c,

    rise - steady rise = 1 / (sqrt(pi) e) int_0 [q(X(s), t - s) - q(x - u s, t)] / sqrt(s) ds,             (1)

X(s) being where the place was a time s ago (one-dimensional conduction along a path; Carslaw and Jaeger 1959,
section 2.9, and Sharif et al. 2001, Part 1, eq. 19). The bracket is zero at s = 0 and smooth; it is taken as
linear between ages of which each is about `RATIO` times the one before, or a part of the surface's passage
through the grid later. Of the time before the first film the present flux is taken.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import cos, pi, sin, sqrt

import numpy as np

from pyworm import kernel
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.scene.contact import Array
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.transient.moving_grid import at_places

RATIO = 1.4
"""Ratio of successive ages."""

PARTS = 16
"""Ages at least, in a passage of a surface through the grid: some six on its way through the contact."""


@dataclass(frozen=True)
class HeatedInstant:
    """Heat of the surfaces at one time.

    Attributes
    ----------
    seconds : float
        The time [s].
    grid : Grid or LineGrid
        The moving grid then.
    flux : numpy.ndarray
        Flux into each body at its nodes [W/m2], body along the last axis.
    velocities : tuple of tuple of float
        Velocity of each body at the contact point along each direction [m/s].
    """

    seconds: float
    grid: Grid | LineGrid
    flux: Array
    velocities: tuple[tuple[float, ...], ...]

    def finer(self, window: tuple[slice, slice] | None = None) -> "HeatedInstant":
        """Interpolated to nodes of half the spacing, of a point contact within a window."""
        grid = self.grid if window is None else self.grid.part(window)
        flux = kernel.prolong_levels(self.flux if window is None else self.flux[window])
        return HeatedInstant(self.seconds, grid.finer(), flux, self.velocities)


def velocities_at_origin(contact: Scene | LineScene) -> tuple[tuple[float, ...], ...]:
    """Velocity of each body at the contact point along each direction [m/s]."""
    origin = [np.zeros(1)] * (1 if isinstance(contact, LineScene) else 2)
    return tuple(
        tuple(float(component.item()) for component in of) for of in contact.velocities_at(*origin)
    )


def remembered_rise(
    history: Sequence[HeatedInstant],
    contact: Scene | LineScene,
    grid: Grid | LineGrid,
    coarse: Grid | LineGrid,
    seconds: float,
    turning: float,
) -> Array:
    """What both surfaces are warmer than steady conduction has them, equation 1 [K].

    Parameters
    ----------
    history : sequence of HeatedInstant
        Heat at times before, the latest first.
    contact : Scene or LineScene
        The contact now.
    grid : Grid or LineGrid
        The moving grid now, of as many nodes as before.
    coarse : Grid or LineGrid
        Every so many of its nodes, on which the rise is found; it is as smooth as the contact is large.
    seconds : float
        The time [s].
    turning : float
        Angular velocity of the axes [rad/s].

    Returns
    -------
    ndarray
        Rise at the nodes, body along the last axis.
    """
    places = coarse.mesh()
    # solved for the film's nodes already, of which those of the coarse grid are some
    nodes = tuple(
        slice(None, None, (of - 1) // (few - 1))
        for of, few in zip(grid.shape, coarse.shape, strict=True)
    )
    now = velocities_at_origin(contact)
    present = _onward(history, seconds)
    rises = []
    for number, (body, velocity) in enumerate(
        zip(contact.bodies, contact.velocities_at(*grid.mesh()), strict=True)
    ):
        effusivity = sqrt(body.conductivity * body.density * body.specific_heat)
        chosen = _ages(history, seconds, _passage(grid, now[number]))
        weights = _weights([seconds - one.seconds for one in chosen])
        ways = _ways(history, chosen[-1], seconds, now[number], number)
        flux = present[..., number]
        rise = np.zeros(coarse.shape)
        for one, weight in zip(chosen, weights, strict=True):
            age = seconds - one.seconds
            steady = [at - of[nodes] * age for at, of in zip(places, velocity, strict=True)]
            own = zip(steady, now[number], ways[one.seconds], strict=True)
            then = _turned([at + of * age - moved for at, of, moved in own], -turning * age)
            rise += weight * (_at(one.grid, one.flux[..., number], then) - _at(grid, flux, steady))
        rises.append(at_places(coarse, rise / (sqrt(pi) * effusivity), grid))
    return np.stack(rises, axis=-1)


def _onward(history: Sequence[HeatedInstant], seconds: float) -> Array:
    """The present flux, straight on from the last two."""
    latest = history[0]
    if len(history) == 1:
        return latest.flux
    before = history[1]
    share = (seconds - latest.seconds) / (latest.seconds - before.seconds)
    return np.maximum(latest.flux + share * (latest.flux - before.flux), 0.0)


def _passage(grid: Grid | LineGrid, velocity: Sequence[float]) -> float:
    """Time of a surface's way through a grid [s]."""
    lengths = [abs(axis[-1] - axis[0]) for axis in _axes(grid)]
    rate = max(abs(of) / length for of, length in zip(velocity, lengths, strict=True))
    return 1 / rate if rate > 0 else np.inf


def _ages(history: Sequence[HeatedInstant], seconds: float, passage: float) -> list[HeatedInstant]:
    """Instants of growing distance, up to those so long ago that the heated place has left the grid."""
    chosen = [history[0]]
    for one in history[1:]:
        last = seconds - chosen[-1].seconds
        if last > passage:
            break
        if seconds - one.seconds >= min(RATIO * last, last + passage / PARTS):
            chosen.append(one)
    return chosen


def _weights(ages: Sequence[float]) -> list[float]:
    """Weights of a function's values at some ages in its integral over 1/sqrt(age) [sqrt(s)].

    It is zero at age zero and linear between the ages.
    """
    nodes = [0.0, *ages]
    weights = np.zeros(len(nodes))
    for number, (a, b) in enumerate(pairwise(nodes)):
        whole = 2 * (sqrt(b) - sqrt(a))
        first = 2 / 3 * (sqrt(b) ** 3 - sqrt(a) ** 3)
        late = (first - a * whole) / (b - a)
        weights[number] += whole - late
        weights[number + 1] += late
    return weights[1:].tolist()


def _ways(
    history: Sequence[HeatedInstant],
    since: HeatedInstant,
    seconds: float,
    now: Sequence[float],
    body: int,
) -> dict[float, Array]:
    """Way of a body's surface through the contact point from each instant since one of them [m].

    It is found by the instant's time.
    """
    some = [one for one in history if one.seconds >= since.seconds]
    times = np.array([seconds, *(one.seconds for one in some)])
    velocities = np.array([now, *(one.velocities[body] for one in some)])
    parts = (velocities[1:] + velocities[:-1]) / 2 * (times[:-1] - times[1:])[:, np.newaxis]
    return dict(zip(times[1:].tolist(), np.cumsum(parts, axis=0), strict=True))


def _turned(places: list[Array], angle: float) -> list[Array]:
    """Components of places in axes turned by an angle [rad]."""
    if len(places) == 1:
        return places
    x, y = places
    return [cos(angle) * x + sin(angle) * y, cos(angle) * y - sin(angle) * x]


def _axes(grid: Grid | LineGrid) -> tuple[Array, ...]:
    return (grid.x,) if isinstance(grid, LineGrid) else (grid.x, grid.y)


def _at(grid: Grid | LineGrid, field: Array, places: Sequence[Array]) -> Array:
    """A field at places, straight between nodes, zero beyond the grid."""
    nodes = [
        (of - axis[0]) / step
        for of, axis, step in zip(places, _axes(grid), grid.spacing, strict=True)
    ]
    return kernel.between_nodes(field, nodes)
