"""Initial guess of a film on another grid from the fields of a solution."""

from typing import Any

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.solver.contact import ContactSolver
from pyworm.solver.level import START_PRESSURE_RATIO, InitialGuess
from pyworm.solver.solution import Solution

CONTACT = 0.5
"""Pressure over the largest above which films tell the rigid film."""


def interpolated_guess(
    solver: ContactSolver[Any, Any], solution: Solution, grid: Any, levels: int
) -> InitialGuess:
    """Pressure, rigid film and temperature of a solution at the nodes of a grid.

    The rigid film is that with which films in the contact are the solution's.
    """
    pressure = _at(solution, "pressure", grid, 0.0)
    # a rupture line that starts too far out is found in a few steps, one too near moves by a node a step
    trace = START_PRESSURE_RATIO * pressure.max()
    pressure = _at(solution, "pressure", grid, trace)
    level = solver.isolated(grid, InitialGuess(pressure, 0.0))
    contact = pressure > CONTACT * pressure.max()
    lifted = _at(solution, "film", grid, np.nan) - level.film.thickness()
    rigid_film = float(np.nanmedian(lifted[contact]))
    return InitialGuess(pressure, rigid_film, _rise(solution, grid, levels), _oil(solution, grid))


def _oil(solution: Solution, grid: Any) -> Array | None:
    """Part of the pressure that the oil bears [Pa]; None between smooth surfaces."""
    if "asperity_pressure" not in solution.dataset("fields"):
        return None
    borne = _at(solution, "pressure", grid, 0.0) - _at(solution, "asperity_pressure", grid, 0.0)
    return np.asarray(np.maximum(borne, 0.0))


def _rise(solution: Solution, grid: Any, levels: int) -> Array | None:
    """Temperature above the inlet's at the levels [K], a parabola across the film; None without heat."""
    if "temperature_middle" not in solution.dataset("fields") or solution.inlet_temperature is None:
        return None
    low, middle, high = (
        _at(solution, f"temperature_{place}", grid, None)[..., None] - solution.inlet_temperature
        for place in ("body_1", "middle", "body_2")
    )
    z = kernel.level_positions(levels)
    return np.asfortranarray(middle + (high - low) * z + 2 * (high + low - 2 * middle) * z**2)


def _at(solution: Solution, name: str, grid: Any, beyond: float | None) -> Array:
    """A field at the nodes of a grid, by straight lines; `beyond` the solution's, None its nearest value."""
    fields = solution.dataset("fields")
    found = np.asarray(fields[name].values, dtype=float).T
    inside = np.ones(grid.shape, dtype=bool)
    for number, axis in enumerate(axis for axis in ("x", "y") if axis in fields.sizes):
        known, wanted = fields[axis].values, getattr(grid, axis)
        found = np.moveaxis(found, number, 0)
        lines = [np.interp(wanted, known, line) for line in found.reshape(len(known), -1).T]
        found = np.moveaxis(np.stack(lines, axis=1).reshape(-1, *found.shape[1:]), 0, number)
        within = (wanted >= known[0]) & (wanted <= known[-1])
        inside &= within.reshape([-1 if other == number else 1 for other in range(inside.ndim)])
    return np.asfortranarray(found if beyond is None else np.where(inside, found, beyond))
