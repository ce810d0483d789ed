"""Work of asperities at each place of the wheel's flank: pressure times sliding, over a pass in mesh.

Wear is proportional to it. Between solved phases fields and places are interpolated, as for extremes
(`pyworm.result.flank_map`). Each node of a contact gives its share to the cells of the flank around it by
the area it has there, so that the sum over the flank is that over the contact: nothing is worn twice or lost.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy

from pyworm.drives.tooth_loss import FEWEST_PHASES
from pyworm.result.flank_map import LOADED_FRACTION, common_grid, layer_of
from pyworm.result.result import Result

Array = np.ndarray

CELL = 0.5e-3
"""Side of a cell of worn flanks [m]."""

MARGIN = 2e-3
"""Flank beyond the contacts that a map holds [m]."""


@dataclass(frozen=True)
class FlankGrid:
    """Cells over a wheel's flank.

    Attributes
    ----------
    face, radius : ndarray
        Their middles along the face and away from the wheel's axis, evenly spaced [m].
    """

    face: Array
    radius: Array

    @property
    def shape(self) -> tuple[int, int]:
        """Number of cells over (radius, face)."""
        return len(self.radius), len(self.face)

    @property
    def cell(self) -> float:
        """Area of a cell in these coordinates [m2]."""
        return float((self.face[1] - self.face[0]) * (self.radius[1] - self.radius[0]))

    def spread(self, amount: Array, face: Array, radius: Array) -> Array:
        """Amounts of points over the four cells around each, over the cells' area; (radius, face).

        Parameters
        ----------
        amount : ndarray
            Value times area for each point.
        face, radius : ndarray
            Places of the points [m]; those beyond the grid are left out.
        """
        field = np.zeros(self.shape)
        column, across = _between(face, self.face)
        row, along = _between(radius, self.radius)
        inside = (column >= 0) & (column < len(self.face) - 1)
        inside &= (row >= 0) & (row < len(self.radius) - 1)
        column, row, across, along = (of[inside] for of in (column, row, across, along))
        held = amount[inside] / self.cell
        for down, part in ((0, 1 - along), (1, along)):
            for right, share in ((0, 1 - across), (1, across)):
                np.add.at(field, (row + down, column + right), held * part * share)
        return field


def _between(place: Array, axis: Array) -> tuple[Array, Array]:
    """Cell before each place, and the fraction of the way to the next."""
    at = (place - axis[0]) / (axis[1] - axis[0])
    cell = np.floor(at).astype(int)
    return cell, at - cell


@dataclass(frozen=True)
class Pass:
    """What a pass through the mesh does to a wheel's flank.

    Attributes
    ----------
    work : ndarray
        Pressure of asperities times sliding speed, over the time of a pass, (radius, face) [Pa m].
    volume : float
        The same over the flank's true area [N m].
    """

    work: Array
    volume: float


def flank_grid(result: Result) -> FlankGrid:
    """Cells that hold all contacts of a result, with a margin.

    Raises
    ------
    ValueError
        Too few phases converged.
    """
    solved = _solved(result)
    layers = [layer_of(one, *common_grid(solved)) for one in solved]
    axes = []
    for name in ("face", "radius"):
        low = min(float(_loaded(layer, name).min()) for layer in layers) - MARGIN
        high = max(float(_loaded(layer, name).max()) for layer in layers) + MARGIN
        axes.append(low + CELL * np.arange(np.ceil((high - low) / CELL) + 1))
    return FlankGrid(*axes)


def _loaded(layer: dict[str, Array], name: str) -> Array:
    pressure = layer["pressure"]
    return layer[name][pressure > LOADED_FRACTION * pressure.max()]


def _solved(result: Result) -> list:
    solved = [
        one for one in result.solutions if one.converged and "asperity_pressure" in one.fields
    ]
    if len(solved) < FEWEST_PHASES:
        raise ValueError(
            f"{len(solved)} phases converged with simulated roughness; wear needs {FEWEST_PHASES} or more"
        )
    return sorted(solved, key=lambda one: one.phase)


def asperity_pass(result: Result, grid: FlankGrid, phases_per_second: float) -> Pass:
    """A pass through the mesh, from the first to the last solved phase.

    Parameters
    ----------
    result : Result
        Solved phases of a worm drive with simulated roughness.
    grid : FlankGrid
        Cells of the flank.
    phases_per_second : float
        Rate of the phase [1/s].
    """
    solved = _solved(result)
    x, y = common_grid(solved)
    layers = [_with_areas(layer_of(one, x, y), x, y) for one in solved]
    work, volume = np.zeros(grid.shape), 0.0
    for (one, before), (other, after) in pairwise(zip(solved, layers, strict=True)):
        moved = np.hypot(*(np.median(after[of] - before[of]) for of in ("face", "radius")))
        steps = max(int(np.ceil(2 * moved / CELL)), 4)
        seconds = (other.phase - one.phase) / abs(phases_per_second) / steps
        for part in (np.arange(steps) + 0.5) / steps:  # the middle of each step
            now = {name: (1 - part) * before[name] + part * after[name] for name in before}
            rubbing = np.where(now["pressure"] > 0, now["asperity_rubbing"], 0.0) * seconds
            work += grid.spread(
                (rubbing * now["seen_area"]).ravel(), now["face"].ravel(), now["radius"].ravel()
            )
            volume += float((rubbing * now["area"]).sum())
    return Pass(work, volume)


def _with_areas(layer: dict[str, Array], x: Array, y: Array) -> dict[str, Array]:
    """A layer with the area of each node, in its plane and in the coordinates of the flank [m2]."""
    (face_y, face_x), (radius_y, radius_x) = (
        np.gradient(layer[name], y, x) for name in ("face", "radius")
    )
    area = np.full(layer["face"].shape, (x[1] - x[0]) * (y[1] - y[0]))
    seen = np.abs(face_x * radius_y - face_y * radius_x) * area
    return {**layer, "area": area, "seen_area": seen}


def smoothed(field: Array) -> Array:
    """A worn flank without the ripple of its cells, as a spline through them has to be."""
    return scipy.ndimage.gaussian_filter(field, 0.8, mode="nearest")
