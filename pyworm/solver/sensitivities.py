"""Sensitivities of a steady contact to all its inputs, with their numerical uncertainties."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf, isfinite, log

from pyworm.formulas.arrays import Array
from pyworm.io.given import Names, WithUnit
from pyworm.io.shown import Shown, ShownFields
from pyworm.kernel.core import KernelError
from pyworm.planning.plan import Plan
from pyworm.planning.plan import plan as make_plan
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.inputs import inputs_of, with_input
from pyworm.solver.adjoint import Adjoint, NoAdjointError, adjoint_of
from pyworm.solver.estimate import Estimate
from pyworm.solver.solution import Solution
from pyworm.solver.solve import solve

STEP, WARM_STEP = 1e-5, 1e-6
"""Relative change of an input, to both sides, in differences of the equations at one film, and of a heated
one, where larger steps turn the convection of heat from one node upstream to another."""

BODY_STEPS = 5e-3, 1e-2
"""Those by which heat spreads otherwise in a body, which is known to single precision; extrapolated."""

HEATED_SHARE = 2.0
"""Uncertainty of a heated contact's sensitivity over the change from a grid of twice the spacing; of others
it is the change itself. With it 19 of 20 hold on grids of half the spacing, without it 9 of 10."""

MOST_SHOWN = 6
"""Number of inputs that are shown, the most influential."""


@dataclass(frozen=True, repr=False)
class Sensitivity(ShownFields):
    """Relative change of a figure over that of an input, d ln J/d ln z."""

    value: float
    """The value [-]."""
    error: float
    """Its numerical uncertainty [-]; infinite where one grid alone has a film."""


@dataclass(frozen=True, repr=False)
class Sensitivities(Shown):
    """How the output quantities of a contact follow its inputs."""

    name: str
    """The scene's name."""
    figures: dict[str, float]
    """Figures of the film on the grid of the sensitivities, in SI units."""
    inputs: dict[str, float]
    """Inputs of the contact other than zero, in SI units (`pyworm.scene.inputs`)."""
    table: dict[str, dict[str, Sensitivity]]
    """By output quantity and input."""
    adjoint: Adjoint
    """Adjoint of the film on the grid, which has the sensitivity to the gap as a field."""

    def of(self, figure: str, by: str) -> float:
        """Change of a figure by an input, dJ/dz, in SI units; KeyError without it."""
        return self.table[figure][by].value * self.figures[figure] / self.inputs[by]

    def by_gap(self, figure: str) -> Array:
        """Change of a figure by the undeformed gap at each node of the grid [figure/m]."""
        return self.adjoint.by_gap(figure)

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading, and by output quantity the inputs that it follows most."""
        rows = {}
        for figure, by_input in self.table.items():
            largest = sorted(by_input.items(), key=lambda item: -abs(item[1].value))[:MOST_SHOWN]
            rows[figure] = ", ".join(f"{name} {item.value:+.3f}" for name, item in largest)
        return f"Sensitivities of {self.name} (d ln J/d ln z)", rows

    def summary(self) -> dict[str, dict[str, dict[str, float | None]]]:
        """The table as one object: by figure and input the value, and its error if that is known."""
        return {
            figure: {
                name: {"value": item.value, "error": item.error if isfinite(item.error) else None}
                for name, item in by_input.items()
            }
            for figure, by_input in self.table.items()
        }


def sensitivities(
    scene: AnyContact,
    plan: Plan | None = None,
    solution: Solution | None = None,
    *,
    accuracy: WithUnit = 0.02,
    effects: Names = "auto",
    inputs: Sequence[str] | None = None,
) -> Sensitivities:
    """Sensitivities of a steady contact to its inputs, by one linear solve for each output quantity.

    Args:
        scene: The contact.
        plan: Its plan, by `pyworm.plan`; by default it is made with the accuracy and effects.
        solution: Its solution, from which the film on the grid of the sensitivities starts; by default it is
            solved first.
        accuracy, effects: As of `pyworm.plan`.
        inputs: Names of inputs; by default all that the effects of the plan take.

    Returns:
        d ln J/d ln z, exact on its grid at a fixed rupture line, with the numerical uncertainty by a grid of
        twice the spacing. A temperature's is relative to its value in K.

    Raises:
        ValueError: A name that the contact has not, or as of `pyworm.plan`.
        NoAdjointError: No sensitivities: a limited supply of oil, or no film on the grid.
    """
    plan = make_plan(scene, accuracy, effects) if plan is None else plan
    solution = solve(scene, plan) if solution is None else solution
    numbers = inputs_of(scene, heated=plan.model.heated, rough=plan.model.rough)
    chosen = numbers if inputs is None else {name: _number(scene, name) for name in inputs}
    fine = adjoint_of(scene, plan, solution)
    sides = Inputs(scene, plan, chosen)
    found = sides.relative_changes(fine)
    try:
        coarse = adjoint_of(scene, plan, grid=fine.level.grid.coarser(), finer=fine)
        before = sides.relative_changes(coarse)
    except (NoAdjointError, KernelError):
        before = {}
    share = HEATED_SHARE if plan.model.heated else 1.0
    missed = {
        figure: _missed(value, getattr(solution.figures, figure, None))
        for figure, value in fine.figures.items()
    }
    table = {
        figure: {
            name: Sensitivity(
                value, share * _error(value, before.get(figure, {}).get(name), missed[figure])
            )
            for name, value in by_input.items()
        }
        for figure, by_input in found.items()
    }
    return Sensitivities(scene.name, fine.figures, chosen, table, fine)


def _number(scene: AnyContact, name: str) -> float:
    numbers = inputs_of(scene)
    if name not in numbers:
        raise ValueError(
            f"inputs = {name}: {scene.name} has no such number other than zero; it has "
            f"{', '.join(numbers)}"
        )
    return numbers[name]


def _missed(value: float, solved: Estimate | None) -> float:
    """How far an output quantity on the grid of the sensitivities is from the solution's, d ln J."""
    if solved is None or not solved.value * value > 0:
        return 0.0
    return abs(log(value / solved.value))


def _error(value: float, coarse: float | None, missed: float) -> float:
    """Change from a grid of twice the spacing, and what a grid and window that miss the quantity may do."""
    return inf if coarse is None else abs(value - coarse) + missed


@dataclass(frozen=True)
class Displaced:
    """A contact with more and with less of an input, without the effects that are off."""

    step: float
    """Relative change of the input to each side."""
    more: AnyContact
    """The contact with more."""
    less: AnyContact
    """The contact with less."""


class Inputs:
    """Contacts that differ by one input each, for the adjoints on all grids."""

    def __init__(self, scene: AnyContact, plan: Plan, inputs: Mapping[str, float]):
        self._scene, self._plan, self._values = scene, plan, dict(inputs)
        step = WARM_STEP if plan.model.heated else STEP
        self._near = {name: self._displaced(name, step) for name in inputs}

    def _displaced(self, name: str, step: float) -> Displaced:
        """The contact with a relative step more and less of an input."""
        more, less = (
            self._plan.simplified(
                with_input(self._scene, name, self._values[name] * (1 + side * step))
            )
            for side in (1, -1)
        )
        return Displaced(step, more, less)

    def relative_changes(self, adjoint: Adjoint) -> dict[str, dict[str, float]]:
        """d ln J/d ln z of the output quantities by the inputs, on the grid of an adjoint."""
        changes = {name: self._change(adjoint, name) for name in self._near}
        return {
            figure: {name: float(change[number]) / value for name, change in changes.items()}
            for number, (figure, value) in enumerate(adjoint.figures.items())
            if value
        }

    def _change(self, adjoint: Adjoint, name: str) -> Array:
        """Change of the figures by an input over its relative change."""
        near = self._near[name]
        change = adjoint.change_but_spread(near.more, near.less) / (2 * near.step)
        if adjoint.spreads_alike(near.more):
            return change
        short, long = (
            adjoint.change_by_spread(each.more, each.less) / (2 * each.step)
            for each in (self._displaced(name, step) for step in BODY_STEPS)
        )
        return change + (4 * short - long) / 3
