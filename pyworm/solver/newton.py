"""Newton steps on one grid until its equations are met and its figures are settled."""

from dataclasses import dataclass

import numpy as np

from pyworm.kernel.core import NO_DESCENT, NOT_CONVERGED, NOT_FINITE, KernelError
from pyworm.planning.target import Aim
from pyworm.solver.error_estimate import Reading, algebra_errors, change
from pyworm.solver.level import Rung

MOST_STEPS = 60
"""Newton steps on a grid of the figures before it is given up: oil that slips in places slows them."""

MOST_LEADING = 30
"""Newton steps on one that only leads to others."""

HOPELESS = 1e6
"""Residual from which no step leads back: stresses and flows far beyond sense, as where a flow law was asked
for what its oil cannot bear."""


ALGEBRA_SHARE = 0.1
"""Error of the figures by unfinished algebra that is left on a grid, as a share of the accuracy."""


@dataclass(frozen=True)
class Stride:
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
        (`kernels.PointFilm.work`).
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
    strides : tuple of Stride
        Its steps.
    reading : Reading
        The figures at its end.
    algebra : dict
        Relative error of each figure that further steps would mend.
    """

    strides: tuple[Stride, ...]
    reading: Reading
    algebra: dict[str, float]


def stride(rung: Rung) -> Stride | None:
    """One Newton step, or none but heat on its way; None if neither helps."""
    if not rung.film.balance.residual <= HOPELESS:
        return None
    warming = rung.film.balance.warming
    krylov = 0
    try:
        krylov = rung.film.step(rung.forcing).krylov
    except KernelError as error:
        if error.status not in (NO_DESCENT, NOT_FINITE, NOT_CONVERGED):
            raise
        # a sweep of heat follows even where no step helps, and another film may belong to its temperatures
        if error.status != NO_DESCENT or not 0 < rung.film.balance.warming <= warming / 2:
            return None
    balance = rung.film.balance
    return Stride(rung.grid.shape, balance.residual, balance.load_error, krylov, rung.film.work())


def lead(rung: Rung, tolerance: float, warming: float | None = None) -> list[Stride]:
    """Newton steps on a grid that only leads to others, until its equations are met within a tolerance.

    Its temperatures may be off by another share, `warming`, of their largest rise.
    """
    strides: list[Stride] = []
    while len(strides) < MOST_LEADING and not rung.film.balance.within(tolerance, warming):
        taken = stride(rung)
        if taken is None:
            break
        strides.append(taken)
    return strides


def settle(rung: Rung, tolerance: float, aim: Aim, algebra_wanted: float) -> Settled:
    """Newton steps until the film's figures are settled, or no step helps any more.

    Parameters
    ----------
    rung : Rung
        The film.
    tolerance : float
        Residual and load error wanted.
    aim : Aim
        The figures.
    algebra_wanted : float
        Relative error of them wanted; it takes at least two steps to see it.
    """
    strides: list[Stride] = []
    reading = rung.read()
    changes: list[dict[str, float]] = []
    algebra = dict.fromkeys(reading.figures, np.inf)
    while len(strides) < MOST_STEPS and (
        rung.film.balance.worst > tolerance
        or not aim.worst(algebra, reading.figures) <= algebra_wanted
    ):
        taken = stride(rung)
        if taken is None:
            break
        strides.append(taken)
        last, reading = reading, rung.read()
        changes.append(change(last, reading))
        if len(changes) > 1:
            algebra = algebra_errors(*changes[-2:])
    return Settled(tuple(strides), reading, algebra)
