"""Flash temperatures of two surfaces that move through a contact, from all heat that each place has taken.

Heat goes into depth alone: a flux q into a half-space of thermal inertia e = sqrt(k rho c) that began at time
zero warms its surface by

    T(t) = int_0^t q(t') / (e sqrt(pi (t - t'))) dt',                                              (1)

t' being followed along the path of the place (Carslaw and Jaeger 1959, Conduction of Heat in Solids, 2.9).
1/sqrt(pi t) is a sum of exponentials, 1/pi int exp(-s t) s^(-1/2) ds by the trapezoidal rule in ln s, so that
a sum for each of them is all the history there is.
"""

from dataclasses import dataclass
from math import exp, pi, sqrt
from typing import Any

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.solver.patch.moving_heights import TAPS

RATE_STEP = 1.5
"""Step of ln s: the sum is off by 0.4 %."""

RATE_RANGE = 3e-3, 4.0
"""Least rate over the inverse of the whole time, and largest over that of a time step."""


def rates(step: float, whole: float) -> tuple[Array, Array]:
    """Rates s [1/s] and weights [s^-1/2] of exponentials for times from a step to the whole [s]."""
    logs = np.arange(np.log(RATE_RANGE[0] / whole), np.log(RATE_RANGE[1] / step), RATE_STEP)
    found = np.exp(logs)
    weights = RATE_STEP * np.sqrt(found) / pi
    # what lies below the first interval of the rule, where exponentials are one: 1/pi int_0^s s'^(-1/2) ds'
    weights[0] += 2 / pi * sqrt(found[0]) * exp(-RATE_STEP / 4)
    return found, weights


@dataclass
class HeatedSurface:
    """One surface's history of heat at the nodes of a patch, kept in the surface's own axes."""

    inertia: float
    """Thermal inertia sqrt(k rho c) [J/(m2 K s^1/2)]."""
    speed: float
    """Speed along x [m/s]."""
    dx: float
    """Spacing of the nodes along x [m]."""
    step: float
    """Time step [s]."""
    whole: float
    """Time of the whole computation [s]."""
    shape: tuple[int, int]
    """Nodes along x and y."""

    def __post_init__(self) -> None:
        self._rates, self._weights = rates(self.step, self.whole)
        self._sums: Any = np.zeros((len(self._rates), *self.shape), dtype=np.float32)
        self._moved, self._part = 0.0, 0.0

    @property
    def present(self) -> float:
        """Rise by unit flux during the present step [K m2/W]."""
        return 2 * sqrt(self.step / pi) / self.inertia

    def history(self) -> Array:
        """Move by a step; the rise by all earlier flux at the nodes [K], if none followed in this step."""
        self._moved += self.speed * self.step / self.dx
        whole = int(np.floor(self._moved))
        self._moved -= whole
        self._sums = _moved(self._sums, whole)
        decay = np.exp(-self._rates * self.step)
        self._sums *= decay[:, None, None].astype(np.float32)
        rise = np.tensordot(self._weights / self.inertia, self._sums, axes=1)
        return _between(rise, -self._moved)

    def absorb(self, flux: Array) -> None:
        """Add the flux of the present step [W/m2] to the history."""
        carried = _between(flux, self._moved).astype(np.float32)
        taken = -np.expm1(-self._rates * self.step) / self._rates
        for number, share in enumerate(taken):
            self._sums[number] += np.float32(share) * carried


def _moved(sums: Any, nodes: int) -> Any:
    """Sums moved by whole nodes along x, zero where surface enters."""
    if nodes == 0:
        return sums
    moved = np.zeros_like(sums)
    if nodes > 0:
        moved[:, nodes:] = sums[:, :-nodes]
    else:
        moved[:, :nodes] = sums[:, -nodes:]
    return moved


def _between(field: Array, shift: float) -> Array:
    """A field at places a part of a spacing behind its nodes, by four-point Lagrange interpolation."""
    if shift == 0:
        return field
    whole = int(np.floor(shift))
    part = shift - whole
    weights = (
        -part * (part - 1) * (part - 2) / 6,
        (part + 1) * (part - 1) * (part - 2) / 2,
        -(part + 1) * part * (part - 2) / 2,
        (part + 1) * part * (part - 1) / 6,
    )
    nodes = np.arange(len(field)) + whole
    ends = len(field) - 1
    found: Array = np.zeros(field.shape)
    for weight, tap in zip(weights, TAPS, strict=True):
        found += weight * field[np.clip(nodes + tap, 0, ends)]
    return found


def wall_fluxes(
    heat: Array,
    conductance: Array,
    history: tuple[Array, Array],
    present: tuple[float, float],
    given: Array,
) -> tuple[Array, Array]:
    """Change of the flux into both surfaces [W/m2] by a change of heat in the film [W/m2].

    Half goes to each, and what the film conducts from the warmer surface to the other. `conductance` is that
    of the film [W/(m2 K)], `given` the change of conducted flux at the smooth film's temperatures.
    """
    (first, second), (own_1, own_2) = history, present
    difference = second - first + (own_2 - own_1) * heat / 2 - (own_1 + own_2) * given
    difference = difference / (1 + (own_1 + own_2) * conductance)
    conducted = conductance * difference + given
    return heat / 2 + conducted, heat / 2 - conducted
