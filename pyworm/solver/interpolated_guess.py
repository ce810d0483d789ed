"""Films on other grids started from the fields of a solution, or from a film."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array, Flags
from pyworm.formulas.whole_numbers import whole
from pyworm.solver.contact import ContactSolver
from pyworm.solver.level import START_PRESSURE_RATIO, InitialGuess, Level
from pyworm.solver.solution import Solution

CONTACT = 0.5
"""Pressure over the largest above which films tell the rigid film."""

EDGE = 2
"""Nodes from the outline of a solution's window at which its oil flows or has ruptured: on the outline itself
pressure is given."""


def interpolated_level(
    solver: ContactSolver[Any, Any], solution: Solution, grid: Any, levels: int
) -> Level:
    """The film on a grid of its own, which bears the whole load, started from the fields of a solution.

    The rigid film is that with which films in the contact are the solution's. Beyond its window the oil flows
    with a trace of pressure where it flows next to the window: a rupture line that starts too far out is
    found in a few steps, one too near moves by a node a step, and so does one far off.
    """
    pressure = _at(solution, "pressure", grid)
    flowing = _at(solution, "pressure", grid, EDGE) > 0
    trace = np.where(flowing, START_PRESSURE_RATIO * pressure.max(), 0.0)
    pressure = np.asfortranarray(np.where(_within(solution, grid), pressure, trace))
    level: Level = solver.isolated(grid, InitialGuess(pressure, 0.0))
    contact = pressure > CONTACT * pressure.max()
    lifted = _at(solution, "film", grid) - level.film.thickness()
    rise = _rise(solution, grid, levels)
    if rise is not None:
        level.film.set_rise(rise)
    level.film.start(level.film.pressure, float(np.median(lifted[contact])), _oil(solution, grid))
    return level


def restricted_guess(level: Level, grid: Any) -> InitialGuess:
    """The state of a film at the nodes of a coarser grid over its window."""
    state = level.state()
    axes = {axis: getattr(level.grid, axis) for axis in "xy"[: len(grid.shape)]}

    def here(field: Array) -> Array:
        return np.asfortranarray(_interpolated(field, axes, grid))

    pressure = here(state.pressure)
    return InitialGuess(
        pressure,
        level.rigid_film_on(grid, pressure),
        None if state.rise is None else here(state.rise),
        None if state.oil is None else here(state.oil),
    )


def _oil(solution: Solution, grid: Any) -> Array | None:
    """Part of the pressure that the oil bears [Pa]; None between smooth surfaces."""
    if "asperity_pressure" not in solution.dataset("fields"):
        return None
    borne = _at(solution, "pressure", grid) - _at(solution, "asperity_pressure", grid)
    return np.where(_within(solution, grid), np.maximum(borne, 0.0), 0.0)


def _rise(solution: Solution, grid: Any, levels: int) -> Array | None:
    """Temperature above the inlet's at the levels [K], a parabola across the film; None without heat."""
    if "temperature_middle" not in solution.dataset("fields") or solution.inlet_temperature is None:
        return None
    low, middle, high = (
        _at(solution, f"temperature_{place}", grid)[..., None] - solution.inlet_temperature
        for place in ("body_1", "middle", "body_2")
    )
    z = kernel.level_positions(levels)
    return np.asfortranarray(middle + (high - low) * z + 2 * (high + low - 2 * middle) * z**2)


def _axes(solution: Solution) -> dict[str, Array]:
    """Coordinates of a solution's nodes along each direction [m]."""
    fields = solution.dataset("fields")
    return {axis: fields[axis].values for axis in ("x", "y") if axis in fields.sizes}


def _within(solution: Solution, grid: Any) -> Flags:
    """Nodes of a grid within the window of a solution."""
    inside = np.ones(grid.shape, dtype=bool)
    for number, (axis, known) in enumerate(_axes(solution).items()):
        wanted = getattr(grid, axis)
        within = (wanted >= known[0]) & (wanted <= known[-1])
        inside &= within.reshape([-1 if other == number else 1 for other in range(inside.ndim)])
    return inside


def _at(solution: Solution, name: str, grid: Any, edge: int = 0) -> Array:
    """A field at the nodes of a grid; beyond it the nearest value, `edge` nodes from the outline."""
    field = np.asarray(solution.dataset("fields")[name].values, dtype=float).T
    axes = {axis: known[edge : len(known) - edge] for axis, known in _axes(solution).items()}
    inner = field[(slice(edge, -edge or None),) * len(axes)]
    return _interpolated(inner, axes, grid)


def _interpolated(field: Array, axes: Mapping[str, Array], grid: Any) -> Array:
    """A field by straight lines between its nodes, at the nodes of a grid or the nearest place."""
    for number, (axis, known) in enumerate(axes.items()):
        place = np.interp(getattr(grid, axis), known, np.arange(len(known)))
        before = np.minimum(whole(place), len(known) - 2)
        part = (place - before).reshape([-1] + [1] * (field.ndim - 1))
        along = np.moveaxis(field, number, 0)
        field = np.moveaxis((1 - part) * along[before] + part * along[before + 1], 0, number)
    return field
