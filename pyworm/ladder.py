"""What all kinds of contact share on their way up the grids: rungs, Newton steps, what the top shows."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Protocol

import numpy as np
import xarray as xr

from pyworm.accuracy import Aim, Convergence, Reading, algebra_errors, change
from pyworm.kernels import NO_DESCENT, NOT_CONVERGED, NOT_FINITE, KernelError, LineFilm, PointFilm

Array = np.ndarray

MOST_STEPS = 30
"""Newton steps on one grid before it is given up."""

HOPELESS = 1e6
"""Residual from which no step leads back: stresses and flows far beyond sense, as where a flow law was asked
for what its oil cannot bear."""


ALGEBRA_SHARE = 0.1
"""Error of the figures by unfinished algebra that is left on a grid, as a share of the accuracy."""


class Storage(Protocol):
    """How the oil that a film stores changes."""

    def on(self, grid: Any) -> tuple[float, Array]:
        """Renewal [1/s] and squeeze [m/s] at nodes of a grid, as `kernels.PointFilm.store` takes them."""


class Rung(Protocol):
    """A film on one grid.

    Attributes
    ----------
    grid : object
        The grid, with its `shape`, its number of `nodes` and the `finer()` one of half its spacing.
    film : kernels.PointFilm or kernels.LineFilm
        The kernel's film, in its present state.
    forcing : float
        Share of the residual to which each Newton step solves its linear system.
    """

    grid: Any
    film: PointFilm | LineFilm
    forcing: ClassVar[float]

    def read(self) -> Reading:
        """The film's figures in its present state."""

    def model_errors(self) -> dict[str, float]:
        """Relative error of figures by the models that they come from, as far as it is known."""


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
    while len(strides) < MOST_STEPS and not rung.film.balance.within(tolerance, warming):
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


@dataclass(frozen=True)
class Outcome:
    """What a kind of contact shows on its last rung.

    Attributes
    ----------
    figures : dict
        The `solution.Figures` that only this kind knows how to come by.
    fields : xarray.Dataset
        Fields over the grid.
    flaw : str or None
        Why they are not to be trusted, whatever the film says.
    profile : xarray.Dataset or None
        Temperature and velocity across the film at its hottest point, where heat is simulated.
    """

    figures: dict[str, Any]
    fields: xr.Dataset
    flaw: str | None = None
    profile: xr.Dataset | None = None


class Ladder(Protocol):
    """A kind of contact as `pyworm.solver` sees it; made from its scene and plan.

    Attributes
    ----------
    kind : str
        What results call it.
    rungs : type
        What its rungs are.
    convergence : Convergence
        How its figures come near the truth.
    origins : dict
        What figures count from, where their readings count from something else.
    """

    kind: ClassVar[str]
    rungs: ClassVar[type]
    convergence: Convergence
    origins: dict[str, float]

    def enter(self, grids: Sequence[Any]) -> tuple[Rung, list[Stride]]:
        """Up the plan's grids to the last of them, not yet settled there."""

    def follow(self, earlier: Sequence[Rung], share: float) -> Rung:
        """The contact on the grid of its rungs at earlier times, the latest first, from where they lead.

        `share` is the time since the latest over that between it and the one before.
        """

    def resume(self, rung: Rung) -> tuple[Rung, list[Stride]]:
        """The grid of a rung, from its film, on which the contact was solved with fewer effects."""

    def higher(self, rung: Rung) -> tuple[Rung, list[Stride]]:
        """Half the spacing over the same window, entered from the present film if that is any good."""

    def outcome(self, rung: Rung) -> Outcome:
        """What the last rung shows."""
