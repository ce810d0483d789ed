"""What acts on the surface of a body: pressure and shear of film and asperities."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import sqrt

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.kernel import subsurface_stress
from pyworm.solver.level import MIN_SLIDING_SPEED
from pyworm.solver.solution import Solution

EDGE_PRESSURE = 1e-3
"""Pressure over the largest beyond which a traction is neglected: its stress is of its own size."""

CELL_MEAN, RESTRICTED = 1 / 24, 1 / 16
"""Means over cells, and the weights 1, 2, 1 of a coarser grid, less what is smoothed, over its second
difference on the cells: half the variance of their weights over the square of the spacing."""

HERTZ_RATIOS = {1: 4.0, 2: 5.0}
"""Dimensions of a contact -> square of a half-width of Hertz's over the mean square distance of its load."""


@dataclass(frozen=True)
class Tractions:
    """Pressure and shear stress on the surface of a body, on a grid."""

    pressure: Array
    """Pressure [Pa], shape (nx, ny) or (nx,)."""
    shear: tuple[Array, ...]
    """Shear stress on the body along each direction [Pa]."""
    first: tuple[float, ...]
    """Position of the first node along each direction [m]."""
    spacing: tuple[float, ...]
    """Grid spacing along each direction [m]."""
    smoothing: float = 0.0
    """What the values exceed those at the nodes by, over the second difference: 1/24 of means over cells."""

    def coarser(self) -> "Tractions":
        """The tractions on a grid of twice the spacing, with the same forces."""
        return replace(
            self,
            pressure=_restricted(self.pressure),
            shear=tuple(_restricted(component) for component in self.shear),
            spacing=tuple(2 * step for step in self.spacing),
            smoothing=self.smoothing / 4 + RESTRICTED,
        )

    def widened(self, share: float) -> "Tractions":
        """The tractions with room that bears none on both sides, over the extent of the grid."""
        nodes = [round(share * count) for count in self.pressure.shape]
        width = [(count, count) for count in nodes]
        first = (
            start - count * step
            for start, count, step in zip(self.first, nodes, self.spacing, strict=True)
        )
        return replace(
            self,
            pressure=np.pad(self.pressure, width),
            shear=tuple(np.pad(component, width) for component in self.shear),
            first=tuple(first),
        )

    def stress(self, poisson_ratio: float, depths: Sequence[float] | Array) -> Array:
        """Stress below the nodes [Pa], (component, depth, nx[, ny]); z points into the body.

        Of fourth order: what values and constant tractions of cells smooth away is given back to them.
        """
        pressure, *shear = self.sharpened(CELL_MEAN)
        return subsurface_stress(pressure, shear, self.spacing, poisson_ratio, depths)

    def sharpened(self, constant: float = 0.0) -> list[Array]:
        """Pressure and shear less what their values smooth, and tractions that are constant on cells."""
        smoothing = self.smoothing + constant
        return [_sharper(part, smoothing) for part in (self.pressure, *self.shear)]

    def axes(self) -> tuple[Array, ...]:
        """Positions of the nodes along each direction [m]."""
        return tuple(
            first + step * np.arange(count)
            for first, step, count in zip(
                self.first, self.spacing, self.pressure.shape, strict=True
            )
        )

    def position(self, nodes: Sequence[float]) -> tuple[float, ...]:
        """Position of a place given in nodes [m]."""
        return tuple(
            float(first + step * node)
            for first, step, node in zip(self.first, self.spacing, nodes, strict=True)
        )

    @property
    def half_width(self) -> float:
        """Smaller half-width of Hertz's contact with the same spread of pressure [m]."""
        weights = self.pressure / self.pressure.sum()
        places = np.meshgrid(*self.axes(), indexing="ij")
        away = np.stack([(place - (weights * place).sum()).ravel() for place in places])
        covariance = (weights.ravel() * away) @ away.T
        smallest = float(np.linalg.eigvalsh(covariance)[0])
        return sqrt(HERTZ_RATIOS[self.pressure.ndim] * smallest)


def has_shear(solution: Solution) -> bool:
    """Whether the shear stress of a film was simulated."""
    return "shear_stress_x" in solution.dataset("fields")


def tractions(solution: Solution, body: int, boundary_friction: float) -> Tractions:
    """What acts on body 1 or 2 of a solved contact, within the nodes that bear `EDGE_PRESSURE`.

    `boundary_friction` is the friction coefficient of asperities. The shear stress is that in the middle of
    the film, without the part by the pressure gradient at its walls, and of asperities; none where the shear
    of the film was not simulated.
    """
    fields = solution.dataset("fields")
    axes = ("x", "y") if solution.kind == "point" else ("x",)

    def field(name: str) -> Array:
        return np.asarray(fields[name].values.T, dtype=float)

    positions = [np.asarray(fields[axis].values, dtype=float) for axis in axes]
    pressure = field("pressure")
    shear = [np.zeros(pressure.shape) for _ in axes]
    if has_shear(solution):
        shear = [field(f"shear_stress_{axis}") for axis in axes]
        if "asperity_pressure" in fields:
            sliding = [field(f"sliding_{axis}") for axis in axes]
            speed = np.maximum(np.sqrt(sum(part**2 for part in sliding)), MIN_SLIDING_SPEED)
            rubbing = boundary_friction * field("asperity_pressure") / speed
            wetted = 1 - field("real_area")
            shear = [
                wetted * stress - rubbing * part
                for stress, part in zip(shear, sliding, strict=True)
            ]
    bearing = _bearing(pressure)
    return Tractions(
        pressure[bearing],
        tuple((1 if body == 1 else -1) * component[bearing] for component in shear),
        tuple(float(axis[part.start]) for axis, part in zip(positions, bearing, strict=True)),
        tuple(float(axis[1] - axis[0]) for axis in positions),
    )


def _bearing(pressure: Array) -> tuple[slice, ...]:
    """Smallest part of a grid that has all nodes with `EDGE_PRESSURE`."""
    nodes = np.nonzero(pressure > EDGE_PRESSURE * pressure.max())
    return tuple(slice(max(int(axis.min()) - 1, 0), int(axis.max()) + 2) for axis in nodes)


def _restricted(field: Array) -> Array:
    """Means over the cells of every second node, with none beyond the grid."""
    for axis in range(field.ndim):
        line = np.moveaxis(field, axis, 0)
        width = [(1, 1 + (len(line) + 1) % 2), *[(0, 0)] * (field.ndim - 1)]
        line = np.pad(line, width)
        means = (line[:-2:2] + 2 * line[1:-1:2] + line[2::2]) / 4
        field = np.moveaxis(means, 0, axis)
    return field


def _sharper(field: Array, smoothing: float) -> Array:
    """A field less so many of its second differences along each direction; there is none beyond the grid."""
    sharp = field.copy()
    for axis in range(field.ndim):
        width = [(1, 1) if other == axis else (0, 0) for other in range(field.ndim)]
        sharp -= smoothing * np.diff(np.pad(field, width), 2, axis=axis)
    return sharp
