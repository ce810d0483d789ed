"""A work-precision study: all models and numerical parameters of a contact, within a budget."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from math import inf, isfinite
from statistics import mean
from time import perf_counter

from pyworm.io.progress import Progress
from pyworm.io.quantity_text import duration
from pyworm.kernel.core import KernelError
from pyworm.planning.model import PARABOLA
from pyworm.planning.prediction import predicted
from pyworm.precision.closed_forms import closed_forms
from pyworm.precision.extrapolation import Limit, limit
from pyworm.precision.grid_series import (
    Point,
    converged_row,
    grid_sequence,
    on_grid,
    step_of,
    tightened,
)
from pyworm.precision.models import Fidelity, fidelities
from pyworm.precision.study import Curve, Reference, Study
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.cost.expected_time import expectation
from pyworm.solver.kinds import SOLVERS

FINE_ENOUGH = 1e-4
"""Discretisation error of all figures below which a model is not refined further."""

COMPLETE_FRACTION, WINDOW_FRACTION, MODELS_FRACTION, PARAMETERS_FRACTION = 0.4, 0.2, 0.3, 0.1
"""Fractions of the budget for the most complete model, its wider window, all other models and parameters;
unused time passes to the next."""

PARAMETER_VALUES = 8
"""Approximate number of parameter values that need a solve from the start."""

TOLERANCES = (1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5)

LEVELS = (5, 7, 9)
"""Levels across the film, beside the parabola's three and the model's own."""

REFERENCE_ACCURACY = 2e-4
"""Accuracy of solves that end on about the same grids."""

LEAST_GRIDS = 3
"""Smallest number of grids of the most complete model for a reference."""


class BudgetError(ValueError):
    """A budget too small for a reference; the message names a sufficient one."""


class NoReferenceError(RuntimeError):
    """The most complete model converges on too few grids for an extrapolation."""


def expected_seconds(scene: Scene | LineScene, quantities: tuple[str, ...] | None = None) -> float:
    """Expected processor time of a study without a budget [s]; arguments as of `study`.

    All models and, about as expensive as the most complete one, its window and its numerical parameters.
    """
    models, _ = fidelities(scene, quantities, REFERENCE_ACCURACY)
    seconds = [expectation(model.scene, model.plan).seconds for model in models]
    return sum(seconds) + seconds[-1]


def study(
    scene: Scene | LineScene,
    quantities: tuple[str, ...] | None = None,
    budget: float = inf,
    progress: Progress | None = None,
    complete_only: bool = False,
    clock: Callable[[], float] = perf_counter,
) -> Study:
    """Measure error against time for a contact, as steady.

    The budget limits the time of the clock [s], by default elapsed time, and is exceeded only where a grid
    takes longer than expected. With `complete_only` the most complete model and its wider window alone are
    solved, as for a reference.

    BudgetError if the budget ends before the most complete model has three grids, NoReferenceError if fewer
    than two of them converge, KernelError if that model fails, ValueError as of `pyworm.plan`.
    """
    scene = replace(scene, past=None)
    making = _Study(scene, quantities, budget, progress or (lambda message, fraction: None), clock)
    return making.result(complete_only)


class _Study:
    """A study in progress."""

    def __init__(
        self,
        scene: Scene | LineScene,
        quantities: Sequence[str] | None,
        budget: float,
        progress: Progress,
        clock: Callable[[], float],
    ) -> None:
        self._scene = scene
        self._models, lacking = fidelities(scene, quantities)
        self._complete = self._models[-1]
        self._figures = self._complete.plan.target.figures
        self._budget = budget
        self._progress = progress
        self._omitted = [f"{name}: {reason}" for name, reason in lacking.items()]
        self._clock = clock
        self._started = clock()

    @property
    def _spent(self) -> float:
        return self._clock() - self._started

    def result(self, complete_only: bool) -> Study:
        """The study; its models are refined first."""
        complete = self._refined(self._complete, COMPLETE_FRACTION * self._budget)
        if len(complete.points) < LEAST_GRIDS:
            raise BudgetError(
                f"{LEAST_GRIDS} grids of the most complete model are needed, "
                f"that is some {duration(self._wanted(complete))}"
            )
        if len(converged_row(complete.points)) < 2:
            raise NoReferenceError(f"{complete.name}: the film converges on too few grids")
        window = self._window(complete)
        references = self._references(complete, window)
        others = [] if complete_only else self._others()
        parameters = [] if complete_only else self._parameters(complete)
        heat = self._scene.oil.heat
        return Study(
            self._scene.name,
            None if heat is None else heat.inlet_temperature,
            references,
            tuple(
                [
                    *(
                        Curve(name, "formula", (point,), {})
                        for name, point in closed_forms(self._scene).items()
                    ),
                    *others,
                    complete,
                    window,
                    *(curve for curve in parameters if curve.points),
                ]
            ),
            tuple(self._omitted),
            self._spent,
        )

    def _wanted(self, curve: Curve) -> float:
        """Budget needed for the smallest number of grids of a model [s]."""
        more = LEAST_GRIDS - len(curve.points)
        return (
            1.5
            * curve.points[-1].seconds
            * step_of(self._complete.plan) ** more
            / COMPLETE_FRACTION
        )

    def _refined(self, model: Fidelity, until: float, wide: bool = False) -> Curve:
        """Solve the grids of a model until they are fine enough or the next would end after `until` [s]."""
        name = f"{model.name}, domain twice as wide" if wide else model.name
        points = self._taken(name, grid_sequence(model, wide), until, model)
        return Curve(
            name, "parameter" if wide else "model", points, {} if wide else _limits(points)
        )

    def _taken(
        self, name: str, series: Iterator[Point], until: float, model: Fidelity
    ) -> tuple[Point, ...]:
        taken: list[Point] = []
        started = self._spent
        try:
            for point in series:
                taken.append(point)
                self._report(f"{name}: {point.label}")
                if _fine_enough(taken, model.plan.target.figures):
                    break
                if len(taken) > LEAST_GRIDS and not (taken[-2].converged or point.converged):
                    self._omitted.append(
                        f"{name}: grids beyond {point.label} (it does not converge)"
                    )
                    break
                last = taken[-2].seconds if len(taken) > 1 else 0.0
                growth = step_of(model.plan)
                further = growth * (point.seconds - last) if last else (growth - 1) * point.seconds
                further *= max(1.0, (self._spent - started) / point.seconds)  # of a busy machine
                nodes = model.plan.largest_grid
                if 0.9 * growth * point.nodes > nodes:
                    self._omitted.append(f"{name}: grids beyond {point.label} (too many nodes)")
                    break
                if self._spent + further > until:
                    self._omitted.append(
                        f"{name}: grids beyond {point.label} (the next takes some {further:.0f} s)"
                    )
                    break
        except KernelError as error:
            if not taken:
                raise
            self._omitted.append(f"{name}: grids beyond {taken[-1].label} ({error})")
        return tuple(taken)

    def _report(self, message: str) -> None:
        fraction = self._spent / self._budget if isfinite(self._budget) else 0.0
        self._progress(message, min(fraction, 1.0))

    def _window(self, complete: Curve) -> Curve:
        """The most complete model in a window of twice the reach."""
        until = self._spent + WINDOW_FRACTION * self._budget
        return self._refined(self._complete, until, wide=True)

    def _references(self, complete: Curve, window: Curve) -> dict[str, Reference]:
        """The limits of the most complete model, corrected for the error of the window.

        That is a known multiple of the change in a window of twice the reach; half of it is taken as its
        uncertainty.
        """
        model = self._complete
        multiples = SOLVERS[type(model.scene)](model.scene, model.plan).convergence.window
        common = min(len(complete.points), len(window.points))  # either ends where time does
        pairs = [
            (here, wider)
            for here, wider in zip(complete.points[:common], window.points[:common], strict=True)
            if here.converged and wider.converged
        ]
        if not pairs:
            self._omitted.append("the error by the domain, also from the band")
        beta = predicted(self._scene).inlet_beta
        references = {}
        for figure in self._figures_shown(complete):
            by_window = 0.0
            if pairs:
                here, wider = pairs[-1]
                by_window = mean(multiples[figure]) * (wider.figures[figure] - here.figures[figure])
            value = complete.limits[figure].value + by_window
            size = abs(value)
            if figure == "temperature_max_film" and beta > 0:
                size = max(size, 1 / beta)
            error = complete.limits[figure].error + abs(by_window) / 2
            references[figure] = Reference(value, size, error / size)
        return references

    def _figures_shown(self, complete: Curve) -> list[str]:
        return [figure for figure in complete.limits if figure in self._figures]

    def _others(self) -> list[Curve]:
        """All models except the most complete one."""
        curves = []
        start, others = self._spent, self._models[:-1]
        room = max(MODELS_FRACTION * self._budget, (1 - PARAMETERS_FRACTION) * self._budget - start)
        for number, model in enumerate(others):
            until = start + room * (number + 1) / len(others)
            if self._spent > until:
                self._omitted.append(f"{model.name}: no time")
                continue
            try:
                curves.append(self._refined(model, until))
            except KernelError as error:
                self._omitted.append(f"{model.name}: {error}")
        return curves

    def _parameters(self, complete: Curve) -> list[Curve]:
        """Tolerance and levels of the most complete model, on the finest affordable grid."""
        affordable = [
            number
            for number, point in enumerate(complete.points)
            if point.seconds <= PARAMETERS_FRACTION / PARAMETER_VALUES * self._budget
            and number < len(complete.points) - 1
        ]
        halvings = min(max(affordable, default=0), len(complete.points) // 2)
        model = self._complete
        label = complete.points[halvings].label
        curves = [
            self._parameter(f"tolerance, on {label}", tightened(model, halvings, TOLERANCES)),
        ]
        if model.plan.model.levels:
            curves.append(self._parameter(f"film levels, on {label}", self._levels(halvings)))
        return curves

    def _levels(self, halvings: int) -> Iterator[Point]:
        plan = self._complete.plan
        least = (PARABOLA,) if plan.model.heated else ()
        for levels in (*least, *(entry for entry in LEVELS if entry <= plan.model.levels)):
            other = replace(plan, model=replace(plan.model, levels=levels))
            yield on_grid(replace(self._complete, plan=other), halvings, f"{levels} levels")

    def _parameter(self, name: str, points: Iterator[Point]) -> Curve:
        taken: list[Point] = []
        while self._spent < self._budget:
            point = next(points, None)
            if point is None:
                return Curve(name, "parameter", tuple(taken), {})
            taken.append(point)
            self._report(f"{name}: {point.label}")
        self._omitted.append(f"{name}: beyond {taken[-1].label}" if taken else f"{name}: no time")
        return Curve(name, "parameter", tuple(taken), {})


def _limits(points: Sequence[Point]) -> dict[str, Limit]:
    """Limits of all figures, extrapolated from points."""
    row = converged_row(points)
    names = row[-1].figures if row else ()
    return {name: limit([point.figures[name] for point in row]) for name in names}


def _fine_enough(points: list[Point], figures: tuple[str, ...]) -> bool:
    if len(points) < LEAST_GRIDS + 1 or not points[-1].converged:
        return False
    limits = _limits(points)
    last = points[-1].figures
    return all(
        abs(limits[name].value - last[name]) <= FINE_ENOUGH * abs(last[name])
        for name in figures
        if name in last
    )
