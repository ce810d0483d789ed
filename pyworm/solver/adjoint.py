"""Exact sensitivities of the figures of a steady film, by its adjoint.

With the equations R(x; z) = 0 of the film on a grid and a figure J(x; z), dJ/dz = J_z - lambda . R_z with
R_x^T lambda = J_x: one linear solve for each figure, whatever the number of inputs (Giles and Pierce, Flow
Turbul. Combust. 65 (2000) 393). R_z and J_z are differences at the same pressure and rigid film, of any two
contacts near the solved one, so that whatever changes a contact has its sensitivity: an oil constant, a
radius, or a key of a drawing that changes gap, velocities and load together.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.io.progress import Progress
from pyworm.kernel.film import Adjoints
from pyworm.planning.plan import Plan
from pyworm.scene.any_contact import AnyContact
from pyworm.solver.contact import ContactSolver
from pyworm.solver.figure_weights import stacked, weights_of_figures
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import Level
from pyworm.solver.newton import newton_step

TOLERANCE, MOST_ITERATIONS = 1e-3, 240
"""Residual of a linear solve over that of no solution, and most iterations of it."""

SETTLED, MOST_STEPS = 1e-10, 40
"""Residual to which a film is settled before its adjoint, and most Newton steps to it."""

UNSETTLED = 1e-5
"""Residual beyond which a film is not settled."""

FORCING = 1e-4
"""Residual to which its Newton steps solve their linear systems."""


class NoAdjointError(ValueError):
    """A contact whose film has no adjoint here, or was not found on the grid."""


@dataclass(frozen=True)
class Adjoint:
    """Adjoint of a film on one grid."""

    plan: Plan
    """Plan whose effects the film has."""
    level: Level
    """The film, settled on its grid, which bears the whole load."""
    figures: dict[str, float]
    """Its figures."""
    names: tuple[str, ...]
    """Figures that have an adjoint solution."""
    adjoints: Adjoints
    """The solutions."""

    def change(self, scene_plus: AnyContact, scene_minus: AnyContact) -> dict[str, float]:
        """Difference of each figure between two contacts near the solved one, to first order.

        Of the same kind and with the same effects. Figures in SI units, temperatures in K.
        """
        plus, minus = (self._at(scene) for scene in (scene_plus, scene_minus))
        flow = _rows(plus, self.adjoints.active) - _rows(minus, self.adjoints.active)
        load = scene_plus.load - scene_minus.load
        nodes = tuple(range(flow.ndim))
        by_rows = np.tensordot(flow, self.adjoints.rows, axes=(nodes, nodes))
        found = self.adjoints.by_load * load - by_rows
        before, after = (_figures(level) for level in (minus, plus))
        return {
            name: after[name] - before[name] + float(change)
            for name, change in zip(self.names, found, strict=True)
        }

    def by_gap(self, name: str) -> Array:
        """Change of a figure by the undeformed gap at each node of the grid [figure/m]."""
        return self.adjoints.by_gap[..., self.names.index(name)]

    def _at(self, scene: AnyContact) -> Level:
        """Another contact at this film's pressure and rigid film."""
        scene = self.plan.simplified(scene)
        level = _solver(scene, self.plan).isolated(self.level.grid, self.level.state())
        level.film.evaluate_at(self.level.film)
        return level


def adjoint_of(
    scene: AnyContact,
    plan: Plan,
    grid: Any | None = None,
    progress: Progress | None = None,
    tolerance: float = TOLERANCE,
) -> Adjoint:
    """Solve a steady contact on one grid, and the adjoint for each of its figures.

    Args:
        scene: The contact.
        plan: Its plan, by `pyworm.plan`.
        grid: The grid, by default the planned wider one: nothing bears load beyond it.
        progress: Called with what is being done and the fraction of it that is done.
        tolerance: Residual of the linear solves over that of no solution.

    Raises:
        NoAdjointError: Films that change with time, of a limited supply of oil, or that are not found.
        KernelError: If memory does not suffice.
    """
    simplified = plan.simplified(scene)
    if scene.oil.supply is not None:
        raise NoAdjointError(
            f"{scene.name}: a film of a limited supply of oil has no adjoint; give it oil in plenty"
        )
    level = settled_level(simplified, plan, grid)
    weights = weights_of_figures(level)
    shape = level.film.pressure.shape
    fields = np.stack([stacked(parts, shape) for parts in weights.values()], axis=-1)
    solved = level.film.adjoints(fields, tolerance, MOST_ITERATIONS)
    return Adjoint(plan, level, _figures(level), tuple(weights), solved)


def settled_level(scene: AnyContact, plan: Plan, grid: Any | None = None) -> Level:
    """The film of a contact on one grid that bears the whole load, settled; NoAdjointError without it."""
    solver = _solver(scene, plan)
    nest = plan.wider_grids or plan.grids
    level, _ = solver.begin(nest)
    while grid is not None and level.grid.spacing[0] > 1.5 * grid.spacing[0]:
        level, _ = solver.refined(level)
    level = solver.isolated(level.grid, level.state())
    for _ in range(MOST_STEPS):
        if level.film.balance.worst <= SETTLED or newton_step(level, FORCING) is None:
            break
    if not level.film.balance.worst <= UNSETTLED:
        raise NoAdjointError(
            f"{scene.name}: no film was settled on {level.grid.nodes} nodes for its sensitivities: "
            f"the residual stayed at {level.film.balance.worst:.1e}"
        )
    return level


def _solver(scene: AnyContact, plan: Plan) -> ContactSolver[Any, Any]:
    return SOLVERS[type(scene)](scene, plan)


def _rows(level: Level, active: Array) -> Array:
    """What the nodes' equations miss: net outflow where active, else total less asperities' pressure."""
    _, _, outflow = level.film.fields()
    if not level.film.rough:
        return np.where(active, outflow, 0.0)
    asperities = level.film.asperities()
    return np.where(active, outflow, asperities.pressure - asperities.curve)


def _figures(level: Level) -> Mapping[str, float]:
    return level.read().figures
