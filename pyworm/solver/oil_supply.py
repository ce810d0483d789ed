"""What a contact makes of a limited supply of oil: meniscus, side flow and the layer that it leaves."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scipy

from pyworm.formulas.arrays import Array
from pyworm.materials.oil_layer import OilLayer
from pyworm.planning.prediction import predicted
from pyworm.solver.level import InitialGuess, Level

PLACES = 129
"""Places across the track at which layers of oil are read."""

WIDTHS = 2.0
"""Half-widths of the dry contact over which the layer that it leaves is read to either side."""


@dataclass(frozen=True)
class SupplyFigures:
    """Figures of a contact whose supply of oil is limited."""

    supply_ratio: float
    """Mean supply over the dry contact's width over the flooded rho h (Chevalier et al. 1998) [-]."""
    film_over_flooded: float
    """Central film over the flooded one [-]."""
    flooded_error: float
    """Relative error of the flooded film, from two grids [-]."""
    meniscus: float
    """Distance of the inlet meniscus before the contact point, along the entrainment [m]."""
    side_flow: float
    """Share of the oil before the dry contact that flows around its middle [-]."""
    layer: OilLayer
    """The oil that it leaves, over the place across its track."""

    @property
    def layer_left(self) -> float:
        """Thickness of the oil that leaves behind the middle of the contact [m]."""
        return float(self.layer.at(np.zeros(())))


def supply_figures(level: Level, flooded: tuple[float, float, float]) -> SupplyFigures:
    """Figures of a film fed with a layer, by central film [m], its error and density when flooded."""
    scene = level.scene
    film, error, density = flooded
    half_length = _half_length(level)
    offered = scene.supply_at(*_across(level, 0.0, half_length)).mean()
    passing = _content(level, *_across(level, 0.0, half_length)).mean()
    return SupplyFigures(
        supply_ratio=float(offered / (density * film)),
        film_over_flooded=level.read().film_central / film,
        flooded_error=error,
        meniscus=_meniscus(level),
        side_flow=float(1 - passing / offered),
        layer=layer_left(level),
    )


def layer_left(level: Level) -> OilLayer:
    """Oil behind a contact over places to the left of the entrainment, where the next may take it up."""
    width = WIDTHS * _half_length(level)
    behind = _reach(level, 1.0)
    across = np.linspace(-width, width, PLACES)
    thickness = _content(level, *_across(level, behind, width))
    return OilLayer(tuple(across.tolist()), tuple(np.maximum(thickness, 0.0).tolist()))


def mostly_full(guess: InitialGuess, before: Level, window: Any = np.s_[...]) -> InitialGuess:
    """A guess on half the spacing with pressure only where the gap of the coarser level is mostly full.

    It covers a window of the level's nodes. A meniscus that starts too far out or too near moves by a node a
    step.
    """
    full = (before.film.pressure[window] > 0).astype(float)
    for axis in range(full.ndim):
        full = _halved(full, axis)
    return replace(guess, pressure=np.asfortranarray(np.where(full >= 0.5, guess.pressure, 0.0)))


def _halved(field: Array, axis: int) -> Array:
    """A field at nodes of half the spacing along an axis, means between its own."""
    field = np.moveaxis(field, axis, 0)
    finer = np.empty((2 * field.shape[0] - 1, *field.shape[1:]))
    finer[::2] = field
    finer[1::2] = (field[1:] + field[:-1]) / 2
    return np.moveaxis(finer, 0, axis)


def _half_length(level: Level) -> float:
    """Half of the dry contact's length across the entrainment [m]; of a line contact any."""
    length = predicted(level.scene).half_length
    return length if np.isfinite(length) else 1.0


def _direction(level: Level) -> Array:
    origin = (np.zeros(()),) * level.gap.ndim
    vector = np.array([float(component) for component in level.scene.entrainment_at(*origin)])
    return vector / np.linalg.norm(vector)


def _across(level: Level, along: float, width: float) -> tuple[Array, ...]:
    """Places on a line across the entrainment, some distance behind the contact point [m]."""
    direction = _direction(level)
    across = np.linspace(-width, width, PLACES)
    if direction.size == 1:
        return (np.full(PLACES, along * direction[0]),)
    return (
        along * direction[0] - across * direction[1],
        along * direction[1] + across * direction[0],
    )


def _content(level: Level, *places: Array) -> Array:
    """Oil at places, theta rho h [m]; beyond the window that of its outline."""
    film, density, _ = level.film.fields()
    return _at(level, level.film.fraction() * density * film, places)


def _at(level: Level, field: Array, places: tuple[Array, ...]) -> Array:
    """A field between the nodes, linear."""
    axes = (getattr(level.grid, axis) for axis in "xy"[: field.ndim])
    nodes = [
        (place - axis[0]) / (axis[1] - axis[0]) for place, axis in zip(places, axes, strict=True)
    ]
    values: Array = scipy.ndimage.map_coordinates(field, nodes, order=1, mode="nearest")
    return values


def _reach(level: Level, sign: float) -> float:
    """Distance from the contact point to the window's last inner node before or behind it [m]."""
    reaches = []
    direction = _direction(level)
    for axis, part in zip("xy"[: direction.size], direction, strict=True):
        nodes = getattr(level.grid, axis)
        if part:
            end = nodes[-2] if sign * part > 0 else nodes[1]
            reaches.append(abs(end / part))
    return min(reaches)


def _meniscus(level: Level) -> float:
    """Distance before the contact point to which the gap is full [m]."""
    steps = 4 * max(level.gap.shape)
    before = np.linspace(0.0, _reach(level, -1.0), steps)
    places = tuple(-before * part for part in _direction(level))
    full = _at(level, (level.film.pressure > 0).astype(float), places) >= 0.5
    return float(before[-1] if full.all() else before[full.argmin()])
