"""Figures of a film as weighted sums of its fields, to first order: what an adjoint solution is asked for.

A figure read between nodes is a sum of nodal values about its place, which to first order does not move.
Friction and loss are sums over the contact, whose outline moves with the pressure.
"""

from collections.abc import Callable
from math import hypot

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.kernel.film import WEIGHED
from pyworm.planning.grid import Grid
from pyworm.solver import extremum
from pyworm.solver.extremum import weights_at
from pyworm.solver.figures import value_at_origin
from pyworm.solver.level import CONTACT_PRESSURE, LEAST_LOAD, MIN_SLIDING_SPEED, Level

Weights = dict[str, Array]
"""Weights of the nodes of some of the fields (`WEIGHED`)."""


def weights_of_figures(level: Level) -> dict[str, Weights]:
    """Weights of each figure that a film has, by its name."""
    weights: dict[str, Callable[[Level], Weights]] = {
        "film_min": _film_min,
        "film_central": _film_central,
        "pressure_max": _pressure_max,
    }
    if level.film.levels:
        weights |= {"friction_coefficient": _friction, "power_loss": _power_loss}
    if level.film.rough:
        weights["asperity_load_fraction"] = _asperity_load
    known = level.read().figures
    return {name: weigh(level) for name, weigh in weights.items() if name in known}


def stacked(weights: Weights, shape: tuple[int, ...]) -> Array:
    """Weights as an array (nodes, `WEIGHED`)."""
    return np.stack([weights.get(name, np.zeros(shape)) for name in WEIGHED], axis=-1)


def _film_min(level: Level) -> Weights:
    film = level.film.thickness()
    _, place = extremum.minimum(film, level.borne(), level.covered)
    return {"film": weights_at(extremum.settled(film, place), film.shape)}


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
    return {"pressure": weights_at(extremum.settled(-pressure, place), pressure.shape)}


def _friction(level: Level) -> Weights:
    """Those of the friction coefficient: the stress along the sliding at the contact point over the load."""
    origin = [np.array(0.0) for _ in level.film.pressure.shape]
    sliding = [float(component) for component in level.scene.sliding_at(*origin)]
    speed = hypot(*sliding)
    if not speed > 0:
        return {}
    direction = [-component / speed for component in sliding]
    per_node = level.share_of_contact() * level.grid.cell / max(level.carried(), LEAST_LOAD)
    weights = {
        f"stress_{axis}": part * per_node for axis, part in zip("xy", direction, strict=False)
    }
    along = _oil_stress(level, direction)
    if level.film.rough:
        everywhere = level.scene.sliding_at(*level.grid.mesh())
        pace = np.maximum(np.sqrt(sum(part**2 for part in everywhere)), MIN_SLIDING_SPEED)
        rubbed = -level.film.boundary_friction * (
            sum(part * local for part, local in zip(direction, everywhere, strict=True)) / pace
        )
        weights["asperities"] = rubbed * per_node
        along = along + rubbed * level.film.asperities().pressure
    weights["pressure"] = _by_outline(
        level, along * level.grid.cell / max(level.carried(), LEAST_LOAD)
    )
    return weights


def _oil_stress(level: Level, direction: list[float]) -> Array:
    """Stress of the oil along a direction, a mean over the area [Pa]."""
    shear = level.film.present_shear()
    stress: Array = sum(part * along for part, along in zip(shear.stress, direction, strict=True))
    return stress * (1 - level.film.asperities().area) if level.film.rough else stress


def _power_loss(level: Level) -> Weights:
    per_node = level.share_of_contact() * level.grid.cell
    weights = {"heat": per_node}
    heat = level.film.present_shear().friction
    if level.film.rough:
        _, rubbing = level.rubbing()
        everywhere = level.scene.sliding_at(*level.grid.mesh())
        pace = np.sqrt(sum(part**2 for part in everywhere))
        weights["asperities"] = level.film.boundary_friction * pace * per_node
        heat = heat + rubbing
    weights["pressure"] = _by_outline(level, heat * level.grid.cell)
    return weights


def _asperity_load(level: Level) -> Weights:
    per_node = level.grid.cell / max(level.carried(), LEAST_LOAD)
    return {"asperities": np.full(level.film.pressure.shape, per_node)}


def _by_outline(level: Level, density: Array) -> Array:
    """Change of sum(share density) by the pressure at each node, the shares those of the contact.

    A share is 1/2 + (p - c max p)/(sum of slopes) where that lies within 0 and 1 (`share_of_contact`).
    """
    pressure = level.film.pressure
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
