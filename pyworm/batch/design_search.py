"""Search for the best design on figures that are cheap: a design of experiments, then SLSQP from the best.

Sequential quadratic programming (D. Kraft, DFVLR-FB 88-28, 1988; `scipy.optimize`) with central differences
of two widths: the wider one sees across the kinks that extremes over a mesh cycle have, the narrower one ends
close to them. Where no design meets all constraints the one that violates them least is found.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np
import scipy

from pyworm.batch.design_model import (
    Correction,
    Design,
    Figure,
    Figures,
    Incomplete,
    LaidOut,
    Refused,
    balanced_loss,
    estimated,
    laid_out,
)
from pyworm.case.design import DesignTask, Limit
from pyworm.case.draws import fractions as drawn
from pyworm.formulas.arrays import Array

WIDTHS = 1e-2, 1e-3, 1e-4
"""Half widths of differences, fractions of the way between the bounds."""

ITERATIONS = 20
"""Maximum number of iterations of each run of SLSQP."""

DESIGNS_DRAWN = 8
"""Designs drawn for each variable before the search, a power of two."""

VIOLATED = 1e-4
"""Relative violation of a limit that counts as none."""

PENALTY = 10.0
"""Weight of the violations of limits, each relative to its limit, in the merit of a design."""

WORST = 1e3
"""Merit of a design that there cannot be."""


@dataclass(frozen=True)
class Goal:
    """What is minimised, and within which limits."""

    weights: dict[str, float]
    """Name of a figure -> its weight, negative of one that is maximised."""
    limits: tuple[Limit, ...]
    """Constraints."""
    scales: dict[str, float]
    """Name of a figure -> its size in the case as it is."""
    ceiling: tuple[dict[str, float], float] | None = None
    """Weights of another sum, and what it must not exceed; None without another."""

    def with_ceiling(self, other: "Goal", cost: float) -> "Goal":
        """The goal with a limit to the cost of another."""
        return replace(self, ceiling=(other.weights, cost))

    def cost(self, figures: Figures) -> float:
        """The weighted sum, each figure at its worst over the errors of assembly and over its size [-]."""
        return self._sum(self.weights, figures)

    def _sum(self, weights: dict[str, float], figures: Figures) -> float:
        return sum(
            weight * worst(figures[name], weight > 0) / self.scales[name]
            for name, weight in weights.items()
        )

    def margins(self, figures: Figures) -> Array:
        """What is left to each limit, over its size; negative of one that is violated."""
        margins = [margin(limit, figures, self.scales) for limit in self.limits]
        if self.ceiling is not None:
            weights, cost = self.ceiling
            margins.append(cost - self._sum(weights, figures))
        return np.array(margins)

    @property
    def count(self) -> int:
        """Number of margins."""
        return len(self.limits) + (self.ceiling is not None)

    def violation(self, figures: Figures) -> float:
        """Sum of the violations of all limits, each over its size."""
        return float(np.maximum(-self.margins(figures) - VIOLATED, 0.0).sum())

    def merit(self, figures: Figures | Refused) -> float:
        """Cost with violations; the least is the best."""
        if isinstance(figures, Refused):
            return WORST
        return self.cost(figures) + PENALTY * self.violation(figures)


def worst(figure: Figure, upper: bool) -> float:
    """A figure at its worst over the errors of assembly: the largest if it should be small."""
    return figure.high if upper else figure.low


def margin(limit: Limit, figures: Figures, scales: dict[str, float]) -> float:
    """What is left to a limit over its size, or over that of the figure where it is zero."""
    found = worst(figures[limit.name], limit.upper)
    left = limit.bound - found if limit.upper else found - limit.bound
    return left / size_of(limit, scales)


def size_of(limit: Limit, scales: dict[str, float]) -> float:
    """Size of a limit, of its figure where it is zero."""
    return abs(limit.bound) if limit.bound else scales[limit.name]


@dataclass
class Estimates:
    """Figures of designs by one correction, each computed once."""

    task: DesignTask
    """The design file."""
    correction: Correction | None = None
    """What solved contacts have over closed forms; None without any."""
    executor: Executor | None = None
    """Processes that compute; by default this one."""
    laid: dict[Design, tuple[LaidOut, ...] | Refused] = field(default_factory=dict)
    """Contacts of designs by closed forms, whatever the correction."""
    known: dict[Design, Figures | Refused] = field(default_factory=dict)
    """Designs computed so far."""

    def corrected(self, correction: Correction) -> "Estimates":
        """Figures by another correction."""
        return replace(self, correction=correction, known={})

    def many(self, designs: Sequence[Design]) -> list[Figures | Refused]:
        """Figures of some designs."""
        new = list(dict.fromkeys(each for each in designs if each not in self.laid))
        spread = self.executor.map if self.executor is not None and len(new) > 1 else map
        self.laid.update(zip(new, spread(partial(laid_out, self.task), new), strict=True))
        for design in designs:
            if design not in self.known:
                self.known[design] = self._figures(design)
        return [self.known[each] for each in designs]

    def _figures(self, design: Design) -> Figures | Refused:
        laid = self.laid[design]
        if isinstance(laid, Refused):
            return laid
        figures = estimated(self.task, design, laid, self.correction)
        if isinstance(figures, Refused):
            return figures
        missing = tuple(name for name in self.task.names if name not in figures)
        return Incomplete(f"has no {missing[0]}", missing) if missing else figures

    def one(self, design: Design) -> Figures | Refused:
        """Figures of a design."""
        return self.many([design])[0]

    def contacts(self, design: Design) -> LaidOut:
        """Contacts of a design without error of its assembly; ValueError of one that there cannot be."""
        self.one(design)
        laid = self.laid[design]
        if isinstance(laid, Refused):
            raise ValueError(laid.reason)
        return laid[0]

    def loss(self, design: Design) -> float | None:
        """Loss between the teeth that warms a design [W]; None where none does. Errors as of `contacts`."""
        return balanced_loss(design, self.contacts(design), self.correction)


def best_of(estimates: Estimates, goal: Goal, start: Design, reach: float = 1.0) -> Design:
    """The best design found from a start.

    Args:
        estimates: What computes figures.
        goal: What is minimised.
        start: Where the search begins; at least as good a design is returned.
        reach: Largest change of a variable, a fraction of the way between its bounds; designs are drawn only
            where it is 1.
    """
    before = np.array(start.fractions)
    low, high = np.maximum(before - reach, 0.0), np.minimum(before + reach, 1.0)
    if reach >= 1:
        points = drawn("sobol", DESIGNS_DRAWN * _power(len(before)), len(before), 1)
        estimates.many([start, *(start.moved(point.tolist()) for point in points)])
    best = _best_within(estimates, goal, start, low, high)
    for width in WIDTHS:
        _descend(estimates, goal, best, (low, high), width)
        best = _best_within(estimates, goal, best, low, high)
        figures = estimates.one(best)
        if not isinstance(figures, Refused) and goal.violation(figures) > 0:
            _approach(estimates, goal, best, (low, high), width)
            best = _best_within(estimates, goal, best, low, high)
    return best


def _power(count: int) -> int:
    """The smallest power of two that is not below a number."""
    return 1 << (count - 1).bit_length()


def _best_within(
    estimates: Estimates, goal: Goal, start: Design, low: Array, high: Array
) -> Design:
    """The best design computed so far between bounds."""
    estimates.one(start)
    inside = [
        design
        for design in estimates.known
        if design.chosen == start.chosen
        and np.all(np.array(design.fractions) >= low - 1e-12)
        and np.all(np.array(design.fractions) <= high + 1e-12)
    ]
    return min(inside, key=lambda design: goal.merit(estimates.known[design]))


Bounds = tuple[Array, Array]


def _descend(estimates: Estimates, goal: Goal, start: Design, bounds: Bounds, width: float) -> None:
    """Minimise the cost within the limits from a start."""
    around = _Differences(estimates, start, bounds, width)
    limits = {
        "type": "ineq",
        "fun": lambda x: around.value(x, goal.margins, -np.ones(goal.count)),
        "jac": lambda x: around.slope(x, goal.margins, goal.count),
    }
    _run(
        around,
        lambda x: float(around.value(x, goal.cost, WORST)),
        lambda x: around.slope(x, goal.cost),
        (limits,) if goal.count else (),
    )


def _approach(
    estimates: Estimates, goal: Goal, start: Design, bounds: Bounds, width: float
) -> None:
    """Minimise the violations of the limits from a start."""

    def squares(figures: Figures) -> float:
        return float((np.minimum(goal.margins(figures) - VIOLATED, 0.0) ** 2).sum())

    around = _Differences(estimates, start, bounds, width)
    _run(
        around,
        lambda x: float(around.value(x, squares, WORST)),
        lambda x: around.slope(x, squares),
        (),
    )


def _run(
    around: "_Differences",
    value: Callable[[Array], float],
    slope: Callable[[Array], Array],
    limits: tuple[dict, ...],
) -> None:
    scipy.optimize.minimize(
        value,
        np.array(around.start.fractions),
        jac=slope,
        bounds=list(zip(*around.bounds, strict=True)),
        constraints=limits,
        method="SLSQP",
        options={"maxiter": ITERATIONS, "ftol": 1e-7},
    )


@dataclass(frozen=True)
class _Differences:
    """Values and differences of functions of the figures of designs."""

    estimates: Estimates
    start: Design
    bounds: Bounds
    width: float

    def value(
        self, x: Array, function: Callable[[Figures], float | Array], refused: float | Array
    ) -> float | Array:
        figures = self.estimates.one(self._design(x))
        return refused if isinstance(figures, Refused) else function(figures)

    def slope(
        self, x: Array, function: Callable[[Figures], float | Array], count: int | None = None
    ) -> Array:
        """Derivatives with respect to the fractions; 0 where no neighbour can be."""
        sides = [
            (np.clip(x - step, *self.bounds), np.clip(x + step, *self.bounds))
            for step in self.width * np.eye(len(x))
        ]
        points = [self._design(each) for pair in sides for each in pair]
        found = self.estimates.many([*points, self._design(x)])
        here, shape = found.pop(), () if count is None else (count,)
        columns = []
        for number, (low, high) in enumerate(sides):
            less, more = found[2 * number : 2 * number + 2]
            before, after = low[number], high[number]
            if isinstance(less, Refused):
                less, before = here, x[number]
            if isinstance(more, Refused):
                more, after = here, x[number]
            if isinstance(less, Refused) or isinstance(more, Refused) or not after > before:
                columns.append(np.zeros(shape))
                continue
            columns.append((np.asarray(function(more)) - function(less)) / (after - before))
        return np.stack(columns, axis=-1)

    def _design(self, x: Array) -> Design:
        return self.start.moved(np.clip(x, *self.bounds).tolist())
