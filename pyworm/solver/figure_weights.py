"""Figures of a film as weighted sums of its fields, to first order: what an adjoint solution is asked for.

A figure read between nodes is a sum of nodal values about its place, which to first order does not move.
Friction and loss are sums over the contact, whose outline moves with the pressure.
"""

from collections.abc import Callable, Sequence
from math import hypot

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array, Flags
from pyworm.kernel.film import WEIGHED
from pyworm.planning.grid import Grid
from pyworm.planning.target import HEAT_FIGURES
from pyworm.solver import extremum
from pyworm.solver.extremum import weights_at
from pyworm.solver.figures import FINE_LEVELS, lagrange_weights, value_at_origin
from pyworm.solver.level import CONTACT_PRESSURE, LEAST_LOAD, MIN_SLIDING_SPEED, Level

Weights = dict[str, Array]
"""Weights of the nodes of some of the fields (`WEIGHED`)."""


OVER_CONTACT = ("friction_coefficient", "power_loss")
"""Figures that are sums over the contact, within its outline (`CONTACT_PRESSURE`)."""

LOAD_RATIOS = ("friction_coefficient", "power_loss", "asperity_load_fraction")
"""Figures whose weights follow from the contact itself, its load and sliding, too."""


def weights_of_figures(level: Level, names: Sequence[str] | None = None) -> dict[str, Weights]:
    """Weights of each figure that a film has, or of some, by its name."""
    found: dict[str, Callable[[Level], Weights]] = {
        "film_min": _film_min,
        "film_central": _film_central,
        "pressure_max": _pressure_max,
    }
    if level.film.levels and level.scene.oil.flow is not None:
        found["power_loss"] = _power_loss
        if _slides(level):
            found["friction_coefficient"] = _friction
    if level.film.rough:
        found["asperity_load_fraction"] = _asperity_load
    if level.film.heated:
        found |= dict.fromkeys(HEAT_FIGURES, _no_weights)
    return {name: weigh(level) for name, weigh in found.items() if names is None or name in names}


def _no_weights(level: Level) -> Weights:
    """A temperature weighs the rise alone (`rise_weights_of`)."""
    return {}


def rise_weights_of(level: Level, name: str) -> Array:
    """Weights of the rise at the nodes and levels in a temperature; zero for other quantities."""
    shape = (*level.film.pressure.shape, max(level.film.levels, 1))
    weights = np.zeros(shape)
    if name not in HEAT_FIGURES:
        return weights
    rise = level.film.rise()
    if name == HEAT_FIGURES[-1]:
        # across the film the polynomial through the levels, at the height of each column's largest value
        places = np.linspace(-0.5, 0.5, FINE_LEVELS)
        between = lagrange_weights(kernel.level_positions(level.film.levels), places)
        columns = rise @ between.T
        across = between[columns.argmax(axis=-1)]
        field, counted = columns.max(axis=-1), level.contact()
    else:
        number = HEAT_FIGURES.index(name)
        across = np.zeros(shape)
        across[..., -number] = 1.0
        field, counted = rise[..., -number], np.broadcast_to(True, shape[:-1])
    upper = counted & (field >= (field[counted].max() + field[counted].min()) / 2)
    _, place = extremum.minimum(-field, upper, np.asarray(counted))
    along = weights_at(extremum.refined_place(-field, place), field.shape)
    return np.asarray(along[..., None] * across)


def _slides(level: Level) -> bool:
    """Whether the surfaces slide at the contact point: without, friction has no direction there."""
    return hypot(*_sliding(level)) > 0


def _sliding(level: Level) -> list[float]:
    """Sliding velocity at the contact point [m/s]."""
    origin = [np.array(0.0) for _ in level.film.pressure.shape]
    return [float(component) for component in level.scene.sliding_at(*origin)]


def fields_of(level: Level, counted: Flags | None = None) -> Weights:
    """The fields that figures weigh; of a sheared film with its shear, of a rough one with its asperities.

    Shear may be left out at nodes that are not `counted`.
    """
    found = {"film": level.film.thickness(), "pressure": level.film.pressure}
    if level.film.levels:
        shear = level.film.shear_fields(counted=counted)
        wetted = 1 - level.film.asperities().area if level.film.rough else 1.0
        found |= {
            f"stress_{axis}": wetted * part
            for axis, part in zip("xy"[: len(shear.stress)], shear.stress, strict=True)
        }
        found["heat"] = shear.friction
    if level.film.rough:
        found["asperities"] = level.film.asperities().pressure
    return found


def stacked(weights: Weights, shape: tuple[int, ...]) -> Array:
    """Weights as an array (nodes, `WEIGHED`)."""
    return np.stack([weights.get(name, np.zeros(shape)) for name in WEIGHED], axis=-1)


def _film_min(level: Level) -> Weights:
    film = level.film.thickness()
    _, place, at_node = extremum.film_minimum(film, level.borne(), level.covered)
    if at_node:
        return {"film": extremum.LEAST_OF_NODES * weights_at(place, film.shape)}
    return {"film": weights_at(extremum.refined_place(film, place), film.shape)}


def _film_central(level: Level) -> Weights:
    shape = level.film.pressure.shape
    if not isinstance(level.grid, Grid):
        weights = np.zeros(shape)
        weights[-level.grid.first] = 1.0
        return {"film": weights}
    # the value is linear in the nodal ones: those of the eight nearest nodes along each direction
    nearest = [
        slice(max(round(place) - 4, 0), round(place) + 5)
        for place in (-level.grid.west / level.grid.dx, -level.grid.south / level.grid.dy)
    ]
    weights, unit = np.zeros(shape), np.zeros(shape)
    for node in zip(*(part.ravel() for part in np.mgrid[tuple(nearest)]), strict=True):
        unit[node] = 1.0
        weights[node] = value_at_origin(level.grid, unit)
        unit[node] = 0.0
    return {"film": weights}


def _pressure_max(level: Level) -> Weights:
    pressure = level.film.pressure
    counted = np.broadcast_to(level.covered, pressure.shape)
    upper = counted & (pressure > pressure.max() / 2)
    _, place = extremum.minimum(-pressure, upper, counted)
    return {"pressure": weights_at(extremum.refined_place(-pressure, place), pressure.shape)}


def _friction(level: Level) -> Weights:
    """Those of the friction coefficient: the stress along the sliding at the contact point over the load."""
    sliding = _sliding(level)
    direction = [-component / hypot(*sliding) for component in sliding]
    per_node = level.share_of_contact() * level.grid.cell / max(level.carried(), LEAST_LOAD)
    weights = {
        f"stress_{axis}": part * per_node
        for axis, part in zip("xy"[: len(direction)], direction, strict=True)
    }
    if level.film.rough:
        everywhere = level.scene.sliding_at(*level.grid.mesh())
        pace = np.maximum(np.sqrt(sum(part**2 for part in everywhere)), MIN_SLIDING_SPEED)
        rubbed = -level.film.boundary_friction * (
            sum(part * local for part, local in zip(direction, everywhere, strict=True)) / pace
        )
        weights["asperities"] = rubbed * per_node
    return weights


def _power_loss(level: Level) -> Weights:
    per_node = level.share_of_contact() * level.grid.cell
    weights = {"heat": per_node}
    if level.film.rough:
        everywhere = level.scene.sliding_at(*level.grid.mesh())
        pace = np.sqrt(sum(part**2 for part in everywhere))
        weights["asperities"] = level.film.boundary_friction * pace * per_node
    return weights


def _asperity_load(level: Level) -> Weights:
    per_node = level.grid.cell / max(level.carried(), LEAST_LOAD)
    return {"asperities": np.full(level.film.pressure.shape, per_node)}


def by_outline(level: Level, name: str, weights: Weights, fields: Weights) -> Array:
    """Change of a sum over the contact by the pressure at each node that moves its outline.

    A share is 1/2 + (p - c max p)/(sum of slopes) where that lies within 0 and 1 (`share_of_contact`).
    """
    pressure = level.film.pressure
    if name not in OVER_CONTACT:
        return np.zeros(pressure.shape)
    shares = level.share_of_contact()
    weighed = sum(part * fields[field] for field, part in weights.items())
    density = np.where(shares > 0, weighed / np.where(shares > 0, shares, 1.0), 0.0)
    above = pressure - CONTACT_PRESSURE * pressure.max()
    slopes = np.gradient(pressure)
    slopes = [slopes] if pressure.ndim == 1 else list(slopes)
    across = sum(np.abs(slope) for slope in slopes)
    crossed = level.covered & (np.abs(above) < across / 2)
    per_slope = np.where(crossed, density / np.where(crossed, across, 1.0), 0.0)
    change = per_slope.copy()
    change[np.unravel_index(np.argmax(pressure), pressure.shape)] -= (
        CONTACT_PRESSURE * per_slope.sum()
    )
    bent = per_slope * np.where(crossed, above / np.where(crossed, across, 1.0), 0.0)
    for axis, slope in enumerate(slopes):
        half = np.moveaxis(bent * np.sign(slope), axis, 0) / 2
        along = np.moveaxis(change, axis, 0)
        # central differences; the outline has no pressure to cross
        along[2:] -= half[1:-1]
        along[:-2] += half[1:-1]
    return change
