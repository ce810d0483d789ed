"""Newton steps on one grid until its equations are met and its figures are settled; steps as a dataset."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pyworm.io.plain_dataset import PlainDataset, described
from pyworm.kernel.core import NO_DESCENT, NOT_CONVERGED, NOT_FINITE, KernelError
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.target import AccuracyTarget
from pyworm.solver.error_estimate import Reading, algebra_errors, change
from pyworm.solver.level import Level

MOST_STEPS = 30
"""Largest number of Newton steps on a grid."""

MOST_SLOW_STEPS, SLOW_BALANCE_RATIO = 60, 6.0
"""Largest number on a grid of the figures whose balance is within `SLOW_BALANCE_RATIO` times the tolerance:
local slip slows the last steps."""

MOST_SLOW_LINE_STEPS, SLOW_LINE_BALANCE_RATIO = 120, 20.0
"""Largest number on a grid of a line, whose steps cost next to nothing, within that ratio: heat of a thick
film between spur gears settles by 6 % a step."""

UNRECOVERABLE_RESIDUAL = 1e6
"""Residual from which Newton does not recover, as of a flow law far beyond its stress."""


@dataclass(frozen=True)
class NewtonStep:
    """One Newton step."""

    points: tuple[int, ...]
    """Grid points along each direction."""
    residual: float
    """Residual after the step."""
    load_error: float
    """Load error after the step."""
    krylov: int
    """GMRES iterations."""
    work: dict[str, float]
    """Operations and processor times since the step before, or the start (`kernel.PointFilm.work`)."""


@dataclass(frozen=True)
class Iteration:
    """The end of Newton's iteration on one grid."""

    steps: tuple[NewtonStep, ...]
    """Its steps."""
    reading: Reading
    """The figures at its end."""
    algebra: dict[str, float]
    """Relative algebraic error of each figure, which further steps would reduce."""


def newton_step(level: Level, forcing: float | None = None) -> NewtonStep | None:
    """Make one Newton step and a sweep of heat, or the sweep alone; None if both fail.

    The linear system is solved to `forcing` times its right-hand side, by default as far as is economical.
    """
    if not level.film.balance.residual <= UNRECOVERABLE_RESIDUAL:
        return None
    warming = level.film.balance.warming
    krylov = 0
    try:
        krylov = level.film.step(forcing or level.forcing).krylov
    except KernelError as error:
        if error.status not in (NO_DESCENT, NOT_FINITE, NOT_CONVERGED):
            raise
        # a sweep of heat follows even where no step helps, and another film may belong to its temperatures
        if error.status != NO_DESCENT or not 0 < level.film.balance.warming <= warming / 2:
            return None
    balance = level.film.balance
    return NewtonStep(
        level.grid.shape, balance.residual, balance.load_error, krylov, level.film.work()
    )


def iterate(
    level: Level,
    tolerance: float,
    warming: float | None = None,
    most: int = MOST_STEPS,
    forcing: float | None = None,
) -> list[NewtonStep]:
    """Make Newton steps on a grid outside the figures until its equations are met within a tolerance.

    Temperatures are met within `warming`, a fraction of their largest rise, where that is given. After `most`
    steps the film is left as it is. `forcing` is that of `newton_step`.
    """
    steps: list[NewtonStep] = []
    while len(steps) < most and not level.film.balance.within(tolerance, warming):
        taken = newton_step(level, forcing)
        if taken is None:
            break
        steps.append(taken)
    return steps


def converge(
    level: Level, tolerance: float, target: AccuracyTarget, algebra_wanted: float
) -> Iteration:
    """Make Newton steps until the film's figures are settled, or no step reduces the residual.

    `tolerance` is that of residual and load error, `algebra_wanted` of the figures' relative algebraic
    errors, which need two steps to be estimated.
    """
    steps: list[NewtonStep] = []
    reading = level.read()
    changes: list[dict[str, float]] = []
    algebra = dict.fromkeys(reading.figures, np.inf)
    while len(steps) < _most_steps(level, tolerance) and (
        level.film.balance.worst > tolerance
        or not target.worst(algebra, reading.figures) <= algebra_wanted
    ):
        taken = newton_step(level)
        if taken is None:
            break
        steps.append(taken)
        last, reading = reading, level.read()
        changes.append(change(last, reading))
        if len(changes) > 1:
            algebra = algebra_errors(*changes[-2:])
    return Iteration(tuple(steps), replace(reading, peaks=level.peaks(reading)), algebra)


def _most_steps(level: Level, tolerance: float) -> int:
    most, ratio = MOST_SLOW_STEPS, SLOW_BALANCE_RATIO
    if isinstance(level.grid, LineGrid):
        most, ratio = MOST_SLOW_LINE_STEPS, SLOW_LINE_BALANCE_RATIO
    return most if level.film.balance.worst <= ratio * tolerance else MOST_STEPS


def convergence_history(steps: Sequence[NewtonStep], grid: Grid | LineGrid) -> PlainDataset:
    """Over iteration: grid points along each direction of a grid, balances, GMRES iterations and work."""
    columns: dict[str, list[Any]] = {
        f"points_{axis}": [step.points[number] for step in steps]
        for number, axis in enumerate("xy"[: len(grid.shape)])
    }
    for name in ("residual", "load_error", "krylov"):
        columns[name] = [getattr(step, name) for step in steps]
    for name in steps[0].work if steps else ():
        columns[name] = [step.work[name] for step in steps]
    return described(
        {name: (("iteration",), np.array(values)) for name, values in columns.items()},
        {"iteration": (("iteration",), np.arange(len(steps)))},
    )
