"""Newton steps on one grid until its equations are met and its figures are settled."""

from dataclasses import dataclass

import numpy as np

from pyworm.kernel.core import NO_DESCENT, NOT_CONVERGED, NOT_FINITE, KernelError
from pyworm.planning.target import Aim
from pyworm.solver.error_estimate import Reading, algebra_errors, change
from pyworm.solver.level import Level

MOST_STEPS = 30
"""Newton steps on a grid before it is given up."""

MOST_SLOW_STEPS, NEAR = 60, 6.0
"""The same on a grid of the figures whose balance is within so many times the tolerance: oil that slips in
places slows the last steps."""

HOPELESS = 1e6
"""Residual from which no step leads back: stresses and flows far beyond sense, as where a flow law is
evaluated for what its oil cannot bear."""


ALGEBRA_FRACTION = 0.1
"""Error of the figures by unfinished algebra that is left on a grid, as a fraction of the accuracy."""


@dataclass(frozen=True)
class NewtonStep:
    """One Newton step.

    Attributes
    ----------
    points : tuple of int
        Grid points along each direction.
    residual, load_error : float
        Balance reached.
    krylov : int
        GMRES iterations.
    work : dict
        What was done on the grid since the step before, or since the film was made
        (`kernel.PointFilm.work`).
    """

    points: tuple[int, ...]
    residual: float
    load_error: float
    krylov: int
    work: dict[str, float]


@dataclass(frozen=True)
class Settled:
    """Where Newton's iteration on one grid ended.

    Attributes
    ----------
    steps : tuple of NewtonStep
        Its steps.
    reading : Reading
        The figures at its end.
    algebra : dict
        Relative error of each figure that further steps would mend.
    """

    steps: tuple[NewtonStep, ...]
    reading: Reading
    algebra: dict[str, float]


def newton_step(level: Level) -> NewtonStep | None:
    """One Newton step and a sweep of heat, or the sweep alone; None if neither helps."""
    if not level.film.balance.residual <= HOPELESS:
        return None
    warming = level.film.balance.warming
    krylov = 0
    try:
        krylov = level.film.step(level.forcing).krylov
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


def lead(level: Level, tolerance: float, warming: float | None = None) -> list[NewtonStep]:
    """Newton steps on a grid that only leads to others, until its equations are met within a tolerance.

    Its temperatures may still change by another fraction, `warming`, of their largest rise.
    """
    steps: list[NewtonStep] = []
    while len(steps) < MOST_STEPS and not level.film.balance.within(tolerance, warming):
        taken = newton_step(level)
        if taken is None:
            break
        steps.append(taken)
    return steps


def settle(level: Level, tolerance: float, aim: Aim, algebra_wanted: float) -> Settled:
    """Newton steps until the film's figures are settled, or no step helps any more.

    Parameters
    ----------
    level : Level
        The film.
    tolerance : float
        Residual and load error wanted.
    aim : Aim
        The figures.
    algebra_wanted : float
        Relative error of them wanted; it takes at least two steps to see it.
    """
    steps: list[NewtonStep] = []
    reading = level.read()
    changes: list[dict[str, float]] = []
    algebra = dict.fromkeys(reading.figures, np.inf)
    while len(steps) < _most_steps(level, tolerance) and (
        level.film.balance.worst > tolerance
        or not aim.worst(algebra, reading.figures) <= algebra_wanted
    ):
        taken = newton_step(level)
        if taken is None:
            break
        steps.append(taken)
        last, reading = reading, level.read()
        changes.append(change(last, reading))
        if len(changes) > 1:
            algebra = algebra_errors(*changes[-2:])
    return Settled(tuple(steps), reading, algebra)


def _most_steps(level: Level, tolerance: float) -> int:
    """Newton steps before a grid of the figures is given up."""
    return MOST_SLOW_STEPS if level.film.balance.worst <= NEAR * tolerance else MOST_STEPS
