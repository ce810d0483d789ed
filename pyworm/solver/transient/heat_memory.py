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
between instants of which each is about `AGE_RATIO` times as long ago as the one before, or a part of the
surface's passage through the grid longer. The bracket, zero at s = 0, is linear along the path over `CELLS`
of the grid: read at the instants only, where a fast surface has gone on by many cells, fluxes of that
wavelength would add up as those of a body at rest. Of the time before the first film the present flux is
taken.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, pi, sqrt

import numpy as np
import scipy

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.transient.moving_grid import at_places

AGE_RATIO = 1.4
"""Ratio of successive ages."""

AGES_PER_PASSAGE = 16
"""Instants at least, in a passage of a surface through the grid: some six on its way through the contact."""

SPREADING = 3.0
"""Widths of the Gaussian in which heat spreads up to which it counts."""

CELLS = 2.0
"""Cells of the grid, at most, that a surface passes between two readings of the flux along its path: the
shortest wave of the grid. With 5 a disturbed division of heat grows 70-fold, with 2 and 1 it decays at once
(`tests/python/solver/test_heat_memory.py`)."""


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
    rises = []
    for number, (body, velocity) in enumerate(
        zip(contact.bodies, contact.velocities_at(*grid.mesh()), strict=True)
    ):
        passage = _passage(grid, now[number])
        oldest = _oldest(passage, float(np.hypot.reduce(now[number])), body.diffusivity)
        chosen = _ages(history, seconds, passage, oldest)
        known = [present, *chosen]
        ages = [seconds - time_level.seconds for time_level in known]
        distance = _way([present, *history], chosen[-1].seconds, number)
        rise = kernel.remembered_flux(
            _history(known, ages, number, body.diffusivity, coarse),
            _readings(ages, _passing(coarse, now[number]), distance),
            turning,
            now[number],
            _axes(coarse),
            [component[nodes] for component in velocity],
        )
        rise /= sqrt(pi * body.thermal_inertia)
        rises.append(at_places(coarse, rise, grid))
    return np.stack(rises, axis=-1)


def _history(
    known: Sequence[HeatedTimeLevel],
    ages: Sequence[float],
    body: int,
    diffusivity: float,
    coarse: Grid | LineGrid,
) -> kernel.FluxHistory:
    """Fluxes into a body at some times and the present one, as they have spread since, on a coarse grid.

    `diffusivity` is that of the body [m2/s], `ages` are those of the times [s].
    """
    strides = _strides(known[0].grid, coarse)
    fluxes = [time_level.flux[..., body][strides] for time_level in known]
    spacings = [
        tuple(step * stride.step for step, stride in zip(level.grid.spacing, strides, strict=True))
        for level in known
    ]
    widths = [sqrt(2 * diffusivity * age) for age in ages]
    rims = tuple(
        min(ceil(widths[-1] / step), nodes // 2)
        for step, nodes in zip(spacings[0], fluxes[0].shape, strict=True)
    )
    return kernel.FluxHistory(
        [_spread(*spread, rims) for spread in zip(fluxes, spacings, widths, strict=True)],
        [_spread(fluxes[0], spacings[0], width, rims) for width in widths],
        [
            tuple(
                float(axis[0]) - (rim + 1) * step
                for axis, rim, step in zip(_axes(level.grid), rims, steps, strict=True)
            )
            for level, steps in zip(known, spacings, strict=True)
        ],
        spacings,
    )


def _strides(grid: Grid | LineGrid, coarse: Grid | LineGrid) -> tuple[slice, ...]:
    """Nodes of a grid that those of a coarse one are."""
    return tuple(
        slice(None, None, (nodes - 1) // (nodes_of_coarse - 1))
        for nodes, nodes_of_coarse in zip(grid.shape, coarse.shape, strict=True)
    )


def _spread(flux: Array, spacing: Sequence[float], width: float, rims: Sequence[int]) -> Array:
    """A flux averaged by a Gaussian of a width [m] along each axis, on a rim of further nodes, too.

    The outermost nodes, one more on each side, are zero, so that it ends continuously.
    """
    framed = np.zeros([nodes + 2 * (rim + 1) for nodes, rim in zip(flux.shape, rims, strict=True)])
    if width == 0:
        inner = tuple(slice(rim + 1, -rim - 1) for rim in rims)
        framed[inner] = flux
        return framed
    spread = flux
    for axis, (step, rim) in enumerate(zip(spacing, rims, strict=True)):
        nodes = flux.shape[axis]
        ends = (np.arange(1 - nodes - rim, nodes + rim + 1) - 0.5) * step / (sqrt(2) * width)
        shares = (
            np.diff(scipy.special.erf(ends)) / 2
        )  # at offsets from 1 - nodes - rim on, symmetric
        means = np.lib.stride_tricks.sliding_window_view(shares, nodes)[::-1].copy()
        spread = means @ spread if axis == 0 else spread @ means.T
    framed[(slice(1, -1),) * flux.ndim] = spread
    return framed


def _onward(history: Sequence[HeatedTimeLevel], seconds: float) -> Array:
    """The present flux by the last two: their sum over both bodies extrapolated, divided as the last was.

    A thin film makes both walls nearly equally warm, and so decides how the heat is divided by what the
    surfaces remember. With the flux of each body extrapolated by itself, a deviation of the division that is
    multiplied by z in a time step satisfies (1 - 1/z)^2 = -S(1/z), S > 0 from equation 1, which has a root
    with |z| > 1: at phase 0.9 of a worm gear with films of half the roughness temperatures swung by 120 K.
    Taken from the last step it satisfies 1 - 1/z = -S(1/z), whose roots are stable. The sum follows from load
    and sliding and is not fed back.
    """
    latest = history[0].flux
    if len(history) == 1:
        return latest
    last, before = (time_level.flux.sum(axis=-1) for time_level in history[:2])
    ahead = (seconds - history[0].seconds) / (history[0].seconds - history[1].seconds)
    parts = np.abs(latest)
    whole = parts.sum(axis=-1, keepdims=True)
    shares = np.divide(parts, whole, out=np.full(parts.shape, 0.5), where=whole > 0)
    return latest + np.maximum(ahead * (last - before), -np.abs(last))[..., np.newaxis] * shares


def _passage(grid: Grid | LineGrid, velocity: Sequence[float]) -> float:
    """Time of a surface's way through a grid [s]."""
    lengths = [abs(axis[-1] - axis[0]) for axis in _axes(grid)]
    rate = max(abs(component) / length for component, length in zip(velocity, lengths, strict=True))
    return 1 / rate if rate > 0 else np.inf


def _oldest(passage: float, speed: float, diffusivity: float) -> float:
    """Age at which a surface has carried heat out of a grid, that which spreads against its motion, too [s].

    It is the root of u s - n sqrt(2 kappa s) = u T, T being the time of its way through the grid and n
    `SPREADING`.
    """
    if not passage < np.inf:
        return np.inf
    spreading = SPREADING * sqrt(2 * diffusivity)
    return ((spreading + sqrt(spreading**2 + 4 * speed**2 * passage)) / (2 * speed)) ** 2


def _ages(
    history: Sequence[HeatedTimeLevel], seconds: float, passage: float, oldest: float
) -> list[HeatedTimeLevel]:
    """Instants of growing distance, up to those so long ago that their heat has left the grid."""
    chosen = [history[0]]
    for time_level in history[1:]:
        last = seconds - chosen[-1].seconds
        if last > oldest:
            break
        longer = passage / AGES_PER_PASSAGE if last < passage else np.inf
        if seconds - time_level.seconds >= min(AGE_RATIO * last, last + longer):
            chosen.append(time_level)
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
    return [float(weight) for weight in weights[1:]]


def _passing(grid: Grid | LineGrid, velocity: Sequence[float]) -> float:
    """Time in which a surface passes `CELLS` of a grid [s]."""
    rate = max(
        abs(component) / step for component, step in zip(velocity, grid.spacing, strict=True)
    )
    return CELLS / rate if rate > 0 else np.inf


def _readings(
    ages: Sequence[float], most: float, distance: Callable[[float], Array]
) -> list[kernel.FluxReading]:
    """Readings up to each of some ages, the first of which is zero, not more than a time apart [s]."""
    places = []
    for interval, (later, earlier) in enumerate(pairwise(ages)):
        count = max(1, ceil((earlier - later) / most))
        shares = [(number + 1) / count for number in range(count)]
        places += [(later + share * (earlier - later), interval, share) for share in shares]
    weights = _weights([age for age, _, _ in places])
    return [
        kernel.FluxReading(age, weight, interval, share, tuple(distance(age)))
        for (age, interval, share), weight in zip(places, weights, strict=True)
    ]


def _way(known: Sequence[HeatedTimeLevel], since: float, body: int) -> Callable[[float], Array]:
    """Way of a body's surface through the contact point over the age at which it began there [m].

    It is that of instants from the present, the first, to a time [s].
    """
    some = [time_level for time_level in known if time_level.seconds >= since]
    ages = some[0].seconds - np.array([time_level.seconds for time_level in some])
    velocities = np.array([time_level.velocities[body] for time_level in some])
    parts = (velocities[1:] + velocities[:-1]) / 2 * np.diff(ages)[:, np.newaxis]
    ways = np.vstack([np.zeros_like(velocities[:1]), np.cumsum(parts, axis=0)])
    return lambda age: np.array([np.interp(age, ages, distances) for distances in ways.T])


def _axes(grid: Grid | LineGrid) -> tuple[Array, ...]:
    return (grid.x,) if isinstance(grid, LineGrid) else (grid.x, grid.y)
