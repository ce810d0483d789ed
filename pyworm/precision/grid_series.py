"""Figures and cost of a model on a series of grids."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import count, islice, takewhile
from time import process_time

from pyworm.planning import error_budget
from pyworm.planning.plan import Plan
from pyworm.precision.models import Fidelity
from pyworm.solver.grid_limit import second_order_limit
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import Level
from pyworm.solver.newton import converge, iterate
from pyworm.solver.timing import convolution_seconds

FIGURES = ("film_min", "film_central", "friction_coefficient", "temperature_max_film")
"""The figures whose errors are shown; temperatures count from the inlet's."""

FIRST_ERROR = 0.02
"""Algebraic accuracy of the first grid: about its discretisation error, so that limits can be
extrapolated."""

ACCURACY_FALL = 4.0
"""Factor by which that accuracy falls from grid to grid."""

LEAST_ERROR = 5e-4
"""Least algebraic accuracy of a grid; where heat and film are iterated in turn, rounding is near."""


@dataclass(frozen=True)
class Point:
    """One grid of a model, or one value of a numerical parameter."""

    shape: tuple[int, ...]
    """Grid points along each direction; none of a formula."""
    seconds: float
    """Processor time up to this point, coarser grids included [s]."""
    unit: float
    """Processor time of one convolution on the grid [s]; 0 of a formula."""
    figures: dict[str, float] = field(default_factory=dict)
    """The simulated `FIGURES` [m, m, -, K]."""
    converged: bool = True
    """Whether the equations are met."""
    setting: str = ""
    """Value of the numerical parameter, where it is not the grid."""
    limits: dict[str, float] = field(default_factory=dict)
    """Figures extrapolated from this grid and the one before, as those of a solve are
    (`pyworm.solver.grid_limit`)."""

    @property
    def nodes(self) -> int:
        """Number of grid points."""
        nodes = 1
        for points in self.shape:
            nodes *= points
        return nodes

    @property
    def convolutions(self) -> float:
        """The cost in convolutions on the grid; 0 for a formula."""
        return self.seconds / self.unit if self.unit else 0.0

    @property
    def label(self) -> str:
        """Label of the point in tables and pictures."""
        return self.setting or " x ".join(str(points) for points in self.shape)


class _Stopwatch:
    """Processor time of a grid series, without the work between its points."""

    def __init__(self) -> None:
        self.seconds = 0.0
        self._since = process_time()

    def stop(self) -> float:
        """Accumulated processor time [s]."""
        self.seconds += process_time() - self._since
        return self.seconds

    def go(self) -> None:
        self._since = process_time()


def _wanted(number: int) -> float:
    """Error to which the algebra of a grid is converged."""
    return max(FIRST_ERROR / ACCURACY_FALL**number, LEAST_ERROR)


def grid_sequence(fidelity: Fidelity, wide: bool = False) -> Iterator[Point]:
    """Solve a model on grids of halving spacing, one after another on demand; `wide` doubles the window.

    KernelError if the kernel gives a grid up, or there is no memory for it.
    """
    plan = fidelity.plan
    watch = _Stopwatch()
    solver = SOLVERS[type(fidelity.scene)](fidelity.scene, plan)
    level, _ = solver.begin(plan.wider_grids if wide else plan.grids)
    before: dict[str, float] = {}
    for number in count():
        error = _wanted(number)
        tolerance = plan.tolerance / plan.accuracy * error
        converge(level, tolerance, plan.target, error_budget.ALGEBRA * error)
        figures = read(level)
        seconds = watch.stop()
        yield Point(
            tuple(level.grid.shape),
            seconds,
            convolution_seconds(level.film),
            figures,
            level.film.balance.worst <= tolerance and figures["film_min"] > 0,
            limits={
                name: second_order_limit(before[name], figures[name])
                for name in solver.convergence.left
                if name in before
            },
        )
        before = figures
        watch.go()
        level, _ = solver.refined(level)


def tightened(fidelity: Fidelity, halvings: int, tolerances: tuple[float, ...]) -> Iterator[Point]:
    """Solve the grid after some halvings of the first one to falling residuals."""
    plan = fidelity.plan
    watch = _Stopwatch()
    solver = SOLVERS[type(fidelity.scene)](fidelity.scene, plan)
    level, _ = solver.begin(plan.grids)
    for number in range(halvings):
        error = _wanted(number)
        converge(
            level, plan.tolerance / plan.accuracy * error, plan.target, error_budget.ALGEBRA * error
        )
        level, _ = solver.refined(level)
    for tolerance in tolerances:
        iterate(level, tolerance)
        figures = read(level)
        seconds = watch.stop()
        converged = level.film.balance.worst <= tolerance
        unit = convolution_seconds(level.film)
        yield Point(tuple(level.grid.shape), seconds, unit, figures, converged, f"{tolerance:.0e}")
        watch.go()


def on_grid(fidelity: Fidelity, halvings: int, setting: str) -> Point:
    """The point of one of a model's grids, under another name."""
    point = next(islice(grid_sequence(fidelity), halvings, None))
    return replace(point, setting=setting)


def converged_row(points: Sequence[Point]) -> list[Point]:
    """The finest consecutive grids whose equations converged."""
    converged = [point.converged for point in points]
    if not any(converged):
        return []
    last = len(points) - converged[::-1].index(True)
    row = takewhile(lambda point: point.converged, reversed(points[:last]))
    return list(row)[::-1]


def read(level: Level) -> dict[str, float]:
    """The figures on a grid; an isothermal film has the inlet's temperature."""
    found = {"temperature_max_film": 0.0} | level.read().figures
    return {name: float(found[name]) for name in FIGURES if name in found}


def step_of(plan: Plan) -> float:
    """Cost of the next grid over that of all previous ones, by the number of directions refined."""
    return 4.5 if len(plan.grids[-1].shape) == 2 else 2.2
