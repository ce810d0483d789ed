"""Newton's method for the film of a time step, by parts of the step's change where the whole is too large."""

from dataclasses import dataclass

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.kernel.core import KernelError
from pyworm.solver.patch.sheared_oil import ShearedOil
from pyworm.solver.patch.smooth_film import set_fluidity

FORCING = 0.05
"""Residual to which the linear system of a Newton step is solved, over its right-hand side."""

MAX_NEWTON_STEPS = 30
"""Largest number of Newton steps of a film."""

MAX_RESIDUAL_RATIO = 30.0
"""Residual over the tolerance above which a film did not converge."""

LOST_RATIO = 100.0
"""Residual over the tolerance above which a film is of no use, at the end of a part of a step too."""

MIN_PART = 1 / 128
"""Least part of a time step's change that is made at once."""


@dataclass(frozen=True)
class Balances:
    """What the film of a time step must meet: its undeformed gap, and mass that arrives at its nodes."""

    gap: Array
    """Undeformed gap with roughness [m]."""
    rate: float
    """Mass that leaves in a second, over that at the node [1/s]."""
    given: Array
    """Mass that arrives, as film at ambient density [m/s]."""

    def after(self, part: float, before: "Balances") -> "Balances":
        """Balances after a part of the change from others."""
        return Balances(
            before.gap + part * (self.gap - before.gap),
            self.rate,
            before.given + part * (self.given - before.given),
        )


@dataclass(frozen=True)
class FoundFilm:
    """Film that meets its balances, and what it took."""

    pressure: Array
    """Pressure [Pa]."""
    rigid_film: float
    """Approach of the bodies [m]."""
    residual: float
    """Summed residual over the summed wedge flow of the smooth film."""
    parts: int
    """Parts in which the time step's change was made."""
    newton: int
    """Newton steps."""
    krylov: int
    """GMRES iterations."""


class PatchNewton:
    """Newton's method for films of a patch.

    The start is the pressure of the step before: one moved on with the oil is nearer inside the contact, but
    far off at the pressure spike, which stays. Where that is too far, as when summits meet, the change of gap
    and mass is made in parts: one that does not converge is halved, and doubled after one that does. The film
    at the end meets the whole step's balances whatever the parts. One that still misses them by more than
    `MAX_RESIDUAL_RATIO` times the tolerance, but no more than `LOST_RATIO`, is returned: it did not converge.
    """

    def __init__(
        self,
        film: kernel.PointFilm,
        oil: ShearedOil,
        tolerance: float,
        touching: float,
        scale: float,
    ):
        self._film, self._oil = film, oil
        self._tolerance, self._touching, self._scale = tolerance, touching, scale

    def solve(
        self, wanted: Balances, gap: Array, start: tuple[Array, float], rise: Array | float
    ) -> FoundFilm:
        """Film that meets balances, from pressure and rigid film over another gap; RuntimeError if not found.

        `rise` is the mean temperature across the film over the inlet's [K].
        """
        done, part, parts, newton, krylov = 0.0, 1.0, 0, 0, 0
        before: Balances | None = None
        while True:
            partial = wanted
            if part < 1.0:
                if before is None:
                    before = self._balances_of(wanted, gap, start, rise)
                partial = wanted if done + part >= 1.0 else wanted.after(done + part, before)
            residual, taken = self._newton(partial, start, rise)
            newton, krylov = newton + taken[0], krylov + taken[1]
            ratio = MAX_RESIDUAL_RATIO if partial is wanted and part >= MIN_PART else LOST_RATIO
            if residual <= ratio * self._tolerance:
                parts += 1
                start = self._film.pressure.copy(order="F"), self._film.rigid_film
                if partial is wanted:
                    return FoundFilm(*start, residual, parts, newton, krylov)
                done, part = done + part, 2 * part
            else:
                part /= 2
            if part < MIN_PART / 2:
                raise RuntimeError(
                    f"a step of the patch did not converge, its residual is {residual:.1e}: give more nodes, "
                    "or surfaces less rough"
                )

    def _balances_of(
        self, wanted: Balances, gap: Array, start: tuple[Array, float], rise: Array | float
    ) -> Balances:
        """Balances that the film at the start meets, over its own gap."""
        self._film.set_gap(gap)
        self._film.set_transient_term(wanted.rate, np.zeros(gap.shape))
        self._film.start(*start)
        self._shear_again(rise)
        outflow = self._film.fields()[2]
        ruptured = np.minimum(outflow, wanted.given)
        return Balances(gap, wanted.rate, np.where(start[0] > 0, outflow, ruptured))

    def _newton(
        self, partial: Balances, start: tuple[Array, float], rise: Array | float
    ) -> tuple[float, tuple[int, int]]:
        """Least residual or load error of Newton steps, and the numbers of them and of GMRES iterations."""
        self._film.set_gap(partial.gap)
        self._film.set_transient_term(partial.rate, -partial.given)
        self._film.start(*start)
        krylov, error, least, best = 0, np.inf, np.inf, start
        for newton in range(MAX_NEWTON_STEPS + 1):
            self._shear_again(rise)
            error = max(self._residual(), abs(self._film.balance.load_error))
            if error < least:
                least, best = error, (self._film.pressure.copy(order="F"), self._film.rigid_film)
            if error <= self._tolerance or newton == MAX_NEWTON_STEPS:
                break
            try:
                krylov += self._film.step(FORCING).krylov
            except KernelError:  # the residual decides whether the state is good enough
                break
        if error > least:
            self._film.start(*best)
            self._shear_again(rise)
        return least, (newton, krylov)

    def _shear_again(self, rise: Array | float) -> None:
        """Set the mobility of the sheared oil at the present pressure and film, and last temperatures."""
        if self._oil.sliding > 0:
            film = np.maximum(self._film.thickness(), self._touching)
            set_fluidity(self._film, self._oil, rise, film)
            self._film.restart()

    def _residual(self) -> float:
        outflow, pressure = self._film.fields()[2], self._film.pressure
        free = ((pressure > 0) | (outflow < 0))[1:-1, 1:-1]
        return float(np.abs(outflow[1:-1, 1:-1])[free].sum() / self._scale)
