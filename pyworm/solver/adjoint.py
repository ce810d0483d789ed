"""Exact sensitivities of the figures of a steady film, by its adjoint.

With the equations R(x; z) = 0 of the film on a grid and a figure J(x; z), dJ/dz = J_z - lambda . R_z with
R_x^T lambda = J_x: one linear solve for each figure, whatever the number of inputs (Giles and Pierce, Flow
Turbul. Combust. 65 (2000) 393). R_z and J_z are differences at the same pressure and rigid film, of any
contact near the solved one, so that whatever changes a contact has its sensitivity: an oil constant, a
radius, or a key of a drawing that changes gap, velocities and load together.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.kernel.film import Adjoints
from pyworm.planning.plan import Plan
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.line import LineScene
from pyworm.solver.contact import ContactSolver
from pyworm.solver.figure_weights import (
    LOAD_RATIOS,
    Weights,
    by_outline,
    fields_of,
    rise_weights_of,
    stacked,
    weights_of_figures,
)
from pyworm.solver.interpolated_guess import interpolated_guess
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import Level
from pyworm.solver.newton import newton_step
from pyworm.solver.solution import Solution

TOLERANCE, MOST_ITERATIONS = 1e-5, 240
"""Residual of a linear solve over that of no solution, and most iterations of it. The change by the load, a
small rest of large weights, is known ten times less well than films by oil."""

CONVERGED_RESIDUAL, MAX_RESIDUAL, MOST_STEPS = 1e-6, 1e-4, 40
"""Residual to which a film is solved before its adjoint, that beyond which it is not found, and most Newton
steps to it."""

PLACES = np.array([[0.0, 1e-3, 0.0], [0.0, 0.0, 1e-3]])
"""Places along x and y at which motions are compared [m]."""

FORCING = 0.1
"""Residual to which its Newton steps solve their linear systems."""


class NoAdjointError(ValueError):
    """A contact whose film has no adjoint here, or was not found on the grid."""


@dataclass(frozen=True)
class Adjoint:
    """Adjoint of a film on one grid."""

    plan: Plan
    """Plan whose effects the film has."""
    solver: ContactSolver[Any, Any]
    """Solver of the contact."""
    level: Level
    """The film, solved on its grid, which bears the whole load."""
    figures: dict[str, float]
    """Its figures that have an adjoint solution."""
    weights: dict[str, Weights]
    """Weights of the film's fields in each."""
    fields: Weights
    """Those fields."""
    adjoints: Adjoints
    """The solutions, in the same order."""

    def change(self, scene_plus: AnyContact, scene_minus: AnyContact) -> dict[str, float]:
        """Difference of each figure between two contacts near the solved one, to first order.

        Of the same kind and with the same effects. Figures in SI units.
        """
        after, before = self.towards(scene_plus), self.towards(scene_minus)
        return {name: change - before[name] for name, change in after.items()}

    def towards(self, scene: AnyContact) -> dict[str, float]:
        """Change of each figure from the solved contact to another near it, to first order."""
        other = self._at(scene)
        missed = self._missed(other) - self._missed(self.level)
        nodes = tuple(range(missed.ndim))
        by_rows = np.tensordot(missed, self.adjoints.rows, axes=(nodes, nodes))
        load = other.scene.load - self.level.scene.load
        followed = self.adjoints.by_load * load - by_rows
        if self.level.film.heated:
            lacked = other.film.heat_change(self.level.film, self.spreads_alike(scene))
            nodes = tuple(range(lacked.ndim))
            followed -= np.tensordot(lacked, self.adjoints.heat_rows, axes=(nodes, nodes))
        by_contact = self._own_changes(other)
        return {
            name: by_contact[name] + float(change)
            for name, change in zip(self.figures, followed, strict=True)
        }

    def spreads_alike(self, scene: AnyContact) -> bool:
        """Whether heat spreads in the bodies of another contact alike, or is not simulated."""
        return not self.level.film.heated or _same_bodies(scene, self.level.scene)

    def by_gap(self, name: str) -> Array:
        """Change of a figure by the undeformed gap at each node of the grid [figure/m]."""
        return self.adjoints.by_gap[..., list(self.figures).index(name)]

    def _at(self, scene: AnyContact) -> Level:
        """Another contact at this film's pressure and rigid film."""
        solver = self.solver.of(self.plan.simplified(scene))
        level = solver.unsolved(self.level)
        level.film.evaluate_at(self.level.film)
        return level

    def _missed(self, level: Level) -> Array:
        """What the nodes' equations miss: net outflow where active, else total less asperities' pressure."""
        _, _, outflow = level.film.fields()
        if not level.film.rough:
            return np.where(self.adjoints.active, outflow, 0.0)
        asperities = level.film.asperities()
        return np.where(self.adjoints.active, outflow, asperities.pressure - asperities.curve)

    def _own_changes(self, other: Level) -> dict[str, float]:
        """Change of each figure by the contact itself, at the same pressure and rigid film."""
        fields = fields_of(other)
        weights = self.weights | weights_of_figures(other, LOAD_RATIOS)
        inlets = [
            level.scene.oil.thermal.inlet_temperature if level.film.heated else 0.0
            for level in (other, self.level)
        ]
        return {
            name: inlets[0] - inlets[1]
            if name in HEAT_FIGURES
            else sum(
                float((part * fields[field] - self.weights[name][field] * self.fields[field]).sum())
                for field, part in weights[name].items()
            )
            for name in self.figures
        }


def adjoint_of(
    scene: AnyContact,
    plan: Plan,
    solution: Solution | None = None,
    grid: Any | None = None,
    tolerance: float = TOLERANCE,
    residual: float = CONVERGED_RESIDUAL,
) -> Adjoint:
    """Solve a steady contact on one grid, and the adjoint for each of its figures.

    Args:
        scene: The contact.
        plan: Its plan, by `pyworm.plan`.
        solution: Its solution, from which the film starts; by default it is solved on coarser grids first.
        grid: The grid, by default the planned wider one: nothing bears load beyond it.
        tolerance: Residual of the linear solves over that of no solution.
        residual: Residual to which the film is solved.

    Raises:
        NoAdjointError: A limited supply of oil, or a film that is not found on the grid.
        KernelError: If memory does not suffice.
    """
    if scene.oil.supply is not None:
        raise NoAdjointError(
            f"{scene.name}: a film of a limited supply of oil has no adjoint; leave the supply out"
        )
    solver = SOLVERS[type(scene)](plan.simplified(scene), plan)
    level = _solved_level(solver, plan, solution, grid, residual)
    weights = weights_of_figures(level)
    shape = level.film.pressure.shape
    fields = fields_of(level)
    whole = np.stack(
        [
            stacked(parts | {"pressure": _by_pressure(level, name, parts, fields)}, shape)
            for name, parts in weights.items()
        ],
        axis=-1,
    )
    rises = np.stack([rise_weights_of(level, name) for name in weights], axis=-1)
    solved = level.film.adjoints(whole, rises, tolerance, MOST_ITERATIONS)
    read = level.read().figures
    figures = {name: read[name] + solver.origins.get(name, 0.0) for name in weights}
    return Adjoint(plan, solver, level, figures, weights, fields, solved)


def _same_bodies(first: AnyContact, second: AnyContact) -> bool:
    """Whether heat spreads in both contacts' bodies alike: by motion and material."""
    return _same_motions(first, second) and all(
        (here.conductivity, here.density, here.specific_heat)
        == (there.conductivity, there.density, there.specific_heat)
        for here, there in zip(first.bodies, second.bodies, strict=True)
    )


def _same_motions(first: AnyContact, second: AnyContact) -> bool:
    """Whether the surfaces of both contacts move alike, at some places."""
    if isinstance(first, LineScene) or isinstance(second, LineScene):
        return getattr(first, "velocities", None) == getattr(second, "velocities", None)
    return all(
        np.array_equal(here(*PLACES), there(*PLACES))
        for here, there in zip(first.motions, second.motions, strict=True)
    )


def _by_pressure(level: Level, name: str, weights: Weights, fields: Weights) -> Array:
    """Weights of the pressure in a figure: its own, and those by the outline of the contact."""
    direct = weights.get("pressure", 0.0)
    return np.asarray(direct + by_outline(level, name, weights, fields))


def _solved_level(
    solver: ContactSolver[Any, Any],
    plan: Plan,
    solution: Solution | None,
    grid: Any | None,
    residual: float,
) -> Level:
    """The film of a contact on one grid that bears the whole load; NoAdjointError where it is not found."""
    nest = plan.wider_grids or plan.grids
    grid = nest[-1] if grid is None else grid
    if solution is None or not solution.converged:
        level, _ = solver.begin(nest)
        while level.grid.spacing[0] > 1.5 * grid.spacing[0]:
            level, _ = solver.refined(level)
        guess = level.state()
    else:
        guess = interpolated_guess(solver, solution, grid, plan.model.levels)
    level = solver.isolated(grid, guess)
    for _ in range(MOST_STEPS):
        if level.film.balance.worst <= residual or newton_step(level, FORCING) is None:
            break
    if not level.film.balance.worst <= MAX_RESIDUAL:
        raise NoAdjointError(
            f"{level.scene.name}: no film was found on {grid.nodes} nodes for its sensitivities: the "
            f"residual stayed at {level.film.balance.worst:.1e}"
        )
    return level
