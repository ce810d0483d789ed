"""Exact sensitivities of the figures of a steady film, by its adjoint.

With the equations R(x; z) = 0 of the film on a grid and a figure J(x; z), dJ/dz = J_z - lambda . R_z with
R_x^T lambda = J_x: one linear solve for each figure, whatever the number of inputs (Giles and Pierce, Flow
Turbul. Combust. 65 (2000) 393). What the load, the gap and the moduli change follows from the solution in
closed form; R_z and J_z by all else are differences at the same pressure and film. So whatever changes a
contact has its sensitivity: an oil constant, a radius, or a key of a drawing that changes gap, velocities and
load together.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from pyworm.formulas.arrays import Array, Flags
from pyworm.kernel.film import Adjoints
from pyworm.planning.plan import Plan
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.waves import opening
from pyworm.solver.alike import gaps_alike, laws_alike, motions_alike, spread_alike
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
from pyworm.solver.interpolated_guess import interpolated_level, restricted_guess
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import InitialGuess, Level
from pyworm.solver.newton import newton_step
from pyworm.solver.solution import Solution

TOLERANCE, MOST_ITERATIONS = 1e-5, 240
"""Residual of a linear solve over that of no solution, and most iterations of it. The change by the load, a
small rest of large weights, is known ten times less well than films by oil."""

CONVERGED_RESIDUAL, MAX_RESIDUAL, MOST_STEPS = 1e-6, 1e-4, 40
"""Residual to which a film is solved before its adjoint, that beyond which it is not found, and most Newton
steps to it."""

RELATIVE_TO_LOAD = ("friction_coefficient", "asperity_load_fraction")
"""Figures that are relative to the load."""

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

    beside: Level
    """A film on the same grid, to which other contacts' oil, motions and roughness are given in turn."""

    def change(self, scene_plus: AnyContact, scene_minus: AnyContact) -> dict[str, float]:
        """Difference of each figure between two contacts near the solved one, to first order.

        Of the same kind and with the same effects. Figures in SI units.
        """
        plus, minus = (self.plan.simplified(scene) for scene in (scene_plus, scene_minus))
        changes = self.change_but_spread(plus, minus) + self.change_by_spread(plus, minus)
        return dict(zip(self.figures, changes.tolist(), strict=True))

    def change_but_spread(self, plus: AnyContact, minus: AnyContact) -> Array:
        """As `change`, in order, of contacts without the effects that are off whose heat spreads as here."""
        return self._towards(plus) - self._towards(minus)

    def change_by_spread(self, plus: AnyContact, minus: AnyContact) -> Array:
        """As `change_but_spread` by how heat spreads in the bodies alone, known to single precision."""
        return self._spread(plus) - self._spread(minus)

    def spreads_alike(self, scene: AnyContact) -> bool:
        """Whether heat spreads in the bodies of another contact alike, or is not simulated."""
        return not self.level.film.heated or spread_alike(
            scene, self.level.scene, self.level.grid.mesh()
        )

    def by_gap(self, name: str) -> Array:
        """Change of a figure by the undeformed gap at each node of the grid [figure/m]."""
        return self.adjoints.by_gap[..., list(self.figures).index(name)]

    def _towards(self, scene: AnyContact) -> Array:
        """Change of each figure from the solved contact to another near it whose heat spreads alike.

        Its parts by load, by gap and deflection, and by all else add up.
        """
        here, film = self.level.scene, self.level.film
        found = self.adjoints.by_load * (scene.load - here.load)
        if not gaps_alike(scene, here):
            found = found + _summed(
                opening(scene, *self.level.grid.mesh())[0] - self.level.gap, self.adjoints.by_gap
            )
        if (scene.bending_modulus, scene.layers) != (here.bending_modulus, here.layers):
            found = found + self._by_stiffness(scene)
        if laws_alike(scene, here, self.level.grid.mesh(), film.heated, film.rough):
            return found + self._by_own_load(scene)
        other = self.solver.of(scene).displaced(self.level, self.beside)
        found = found + self._own_changes(other)
        found = found - _summed(self._missed(other) - self._missed_here, self.adjoints.rows)
        if film.heated:
            found = found - _summed(other.film.heat_change(film), self.adjoints.heat_rows)
        return found

    def _spread(self, scene: AnyContact) -> Array:
        """Change of each figure to a contact whose bodies alone differ, by how heat spreads in them."""
        if self.spreads_alike(scene):
            return np.zeros(len(self.figures))
        other = self.solver.of(scene).displaced(self.level, self.beside)
        return -_summed(other.film.spread_change(self.level.film), self.adjoints.heat_rows)

    def _by_stiffness(self, scene: AnyContact) -> Array:
        """Change of each figure by the deflection of a contact's bodies, under the same pressure."""
        here, film = self.level.scene, self.level.film
        if scene.layers == here.layers == (None, None):
            return (here.bending_modulus / scene.bending_modulus - 1) * self._by_compliance
        other = self.solver.of(scene).unsolved(self.level)
        other.film.start(film.pressure, film.rigid_film)
        return _summed(other.film.convolve() - film.convolve(), self.adjoints.by_gap)

    @cached_property
    def _by_compliance(self) -> Array:
        """Change of each figure by the relative change of all deflections."""
        return _summed(self.level.film.convolve(), self.adjoints.by_gap)

    @cached_property
    def _missed_here(self) -> Array:
        return self._missed(self.level)

    def _missed(self, level: Level) -> Array:
        """What the nodes' equations miss: net outflow where active, else total less asperities' pressure."""
        _, _, outflow = level.film.fields()
        if not level.film.rough:
            return np.where(self.adjoints.active, outflow, 0.0)
        asperities = level.film.asperities()
        return np.where(self.adjoints.active, outflow, asperities.pressure - asperities.curve)

    @cached_property
    def _own_sums(self) -> dict[str, float]:
        """The figures as sums of the film's fields."""
        return {name: _weighed(parts, self.fields) for name, parts in self.weights.items()}

    @cached_property
    def _in_contact(self) -> Flags:
        """Nodes whose shear counts in figures."""
        return self.level.share_of_contact() > 0

    def _by_own_load(self, scene: AnyContact) -> Array:
        """Change of each figure by the load that it is relative to."""
        lighter = self.level.scene.load / scene.load - 1 if scene.separation is None else 0.0
        return np.array(
            [
                lighter * self._own_sums[name] if name in RELATIVE_TO_LOAD else 0.0
                for name in self.figures
            ]
        )

    def _own_weights(self, other: Level) -> dict[str, Weights]:
        """Weights of the figures that change by the contact itself."""
        here, there = self.level.scene, other.scene
        if other.film.rough:
            # averages over the roughness make another mean film of the same gap
            return self.weights | weights_of_figures(other, LOAD_RATIOS)
        if here.load != there.load or not motions_alike(here, there, self.level.grid.mesh()):
            return weights_of_figures(other, LOAD_RATIOS)
        return {name: self.weights[name] for name in LOAD_RATIOS if name in self.weights}

    def _own_changes(self, other: Level) -> Array:
        """Change of each figure by the contact itself, at the same pressure and rigid film."""
        weights = self._own_weights(other)
        fields = fields_of(other, self._in_contact) if weights else {}
        changes = dict.fromkeys(self.figures, 0.0) | {
            name: _weighed(parts, fields) - self._own_sums[name] for name, parts in weights.items()
        }
        if other.film.heated:
            inlet, here = (
                level.scene.oil.thermal.inlet_temperature for level in (other, self.level)
            )
            changes |= dict.fromkeys(HEAT_FIGURES, inlet - here)
        return np.array([changes[name] for name in self.figures])


def _summed(field: Array, by_figure: Array) -> Array:
    """Sum of a field times what each figure changes by it at each place, figure along the last axis."""
    weights = by_figure.reshape(-1, by_figure.shape[-1], order="F")
    return np.asarray(field.ravel(order="F") @ weights)


def _weighed(weights: Weights, fields: Weights) -> float:
    return sum(float(np.vdot(part, fields[field])) for field, part in weights.items())


def adjoint_of(
    scene: AnyContact,
    plan: Plan,
    solution: Solution | None = None,
    grid: Any | None = None,
    tolerance: float = TOLERANCE,
    residual: float = CONVERGED_RESIDUAL,
    *,
    finer: Adjoint | None = None,
) -> Adjoint:
    """Solve a steady contact on one grid, and the adjoint for each of its figures.

    Args:
        scene: The contact.
        plan: Its plan, by `pyworm.plan`.
        solution: Its solution, from which the film starts; by default it is solved on coarser grids first.
        grid: The grid, by default the planned wider one: nothing bears load beyond it.
        tolerance: Residual of the linear solves over that of no solution.
        residual: Residual to which the film is solved.
        finer: Its adjoint on a grid of half the spacing, from whose film it then starts.

    Raises:
        NoAdjointError: A limited supply of oil, or a film that is not found on the grid.
        KernelError: If memory does not suffice.
    """
    if scene.oil.supply is not None:
        raise NoAdjointError(
            f"{scene.name}: a film of a limited supply of oil has no adjoint; leave the supply out"
        )
    solver = SOLVERS[type(scene)](plan.simplified(scene), plan)
    nest = plan.wider_grids or plan.grids
    grid = nest[-1] if grid is None else grid
    if finer is not None:
        level = solver.isolated(grid, restricted_guess(finer.level, grid))
    elif solution is None or not solution.converged:
        level = solver.isolated(grid, _guess(solver, nest, grid))
    else:
        level = interpolated_level(solver, solution, grid, plan.model.levels)
    _converge(level, residual)
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
    beside = solver.unsolved(level)
    beside.film.evaluate_at(level.film)
    return Adjoint(plan, solver, level, figures, weights, fields, solved, beside)


def _by_pressure(level: Level, name: str, weights: Weights, fields: Weights) -> Array:
    """Weights of the pressure in a figure: its own, and those by the outline of the contact."""
    direct = weights.get("pressure", 0.0)
    return np.asarray(direct + by_outline(level, name, weights, fields))


def _guess(solver: ContactSolver[Any, Any], nest: Sequence[Any], grid: Any) -> InitialGuess:
    """Initial guess on a grid from coarser ones, first those of a nest."""
    level: Level
    level, _ = solver.begin(nest)
    while level.grid.spacing[0] > 1.5 * grid.spacing[0]:
        level, _ = solver.refined(level)
    return level.state()


def _converge(level: Level, residual: float) -> None:
    """Make Newton steps to a residual on a grid; NoAdjointError where no film is found."""
    for _ in range(MOST_STEPS):
        if level.film.balance.worst <= residual or newton_step(level, FORCING) is None:
            break
    if not level.film.balance.worst <= MAX_RESIDUAL:
        raise NoAdjointError(
            f"{level.scene.name}: no film was found on {level.grid.nodes} nodes for its sensitivities: the "
            f"residual stayed at {level.film.balance.worst:.1e}"
        )
