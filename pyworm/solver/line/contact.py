"""A line contact solved by nested iteration."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import ClassVar

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.materials.body import Body
from pyworm.planning.expected_work import Kind
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.plan import Plan
from pyworm.planning.target import HEAT_FIGURES, ROUGH_FIGURES
from pyworm.scene.line import LineScene
from pyworm.scene.scales import LineScales, line_scales
from pyworm.solver.contact import COARSE_TOLERANCE, FED_FALLS, ContactSolver
from pyworm.solver.error_estimate import Convergence, Left
from pyworm.solver.level import InitialGuess, Level, TransientTerm
from pyworm.solver.line.level import (
    LineLevel,
    first_level,
    isolated_level,
    lone_level,
    next_level,
    unsolved_level,
)
from pyworm.solver.newton import NewtonStep, iterate
from pyworm.solver.oil_supply import mostly_full

SUPPLIES = 2
"""Number of times that the far field before the inlet is computed from a film on the first grid.

After one its error hid the window error; a third had no visible effect."""

SPEED_FRACTIONS = tuple(1.5**-power for power in range(7, -1, -1))
"""Successive fractions of the velocities where Newton's iteration with heat does not converge at once.

Fast films need them: at 50 m/s heat reduces the film by two thirds, and under the pressure of the isothermal
film the temperature would diverge. Temperature is carried over from grid to grid and from speed to speed."""

LIFTS = (1.0, 1.5, 2.25)
"""Initial films over the expected one, tried in order until Newton's iteration converges.

The first fails in 1 of 400 random scenes (M 0.01 to 3000, L 0 to 25), in which the second converges."""


# The scheme's order is 2. The smallest film lies behind the pressure spike, and as long as the grid does not
# resolve that, its observed order is 1.2 to 1.8. The largest pressure may be the spike's own tip.
ORDERS = {
    "film_central": 2.0,
    "film_min": 1.25,
    "pressure_max": 1.0,
    "friction_coefficient": 2.0,
    "power_loss": 2.0,
    "shear_rate_max": 1.25,
    **dict.fromkeys(ROUGH_FIGURES, 2.0),
    **dict.fromkeys(HEAT_FIGURES, 1.25),
}

# Error of figures extrapolated from two grids, over the larger of their own change and the films'. Central
# films are of second order from the first grids on, but for light loads and thick oils (M 1.4, L 19), whose
# spike lies at the centre: 0.54. Behind a spike films and temperatures are not regular.
TWO_GRID_ERRORS = dict.fromkeys(
    ("film_central", "friction_coefficient", "power_loss"), Left(0.6, 0.6)
)

# A window's error falls with the square of its reach: 1 / (1 - 2^-2) = 1.33. In 400 random scenes it was 1.1
# to 1.7 times what doubling that changes (90 % of them).
CONVERGENCE = Convergence(ORDERS, TWO_GRID_ERRORS, dict.fromkeys(ORDERS, (1.0, 1.7)))

# That of a film that warms falls with the reach itself, or up to its power 1.4: 1 / (1 - 2^-1) = 2 and 1.61.
# Temperatures rise far before the contact and are not extrapolated: of 24 lines, warm or not, up to 2.4 times
# what doubling the reach changes were left (`benchmarks/accuracy/error_bars.py`, seed 11), more where a third
# window shows it (`window_limit.with_falls`).
HEATED_CONVERGENCE = Convergence(
    ORDERS,
    TWO_GRID_ERRORS,
    dict.fromkeys(ORDERS, (1.3, 2.0)) | dict.fromkeys(HEAT_FIGURES, (1.3, 2.6)),
)


class LineContactSolver(ContactSolver[LineScene, LineLevel]):
    """Films of a line contact; parameters and attributes as of `pyworm.solver.contact.ContactSolver`."""

    kind: ClassVar[Kind] = "line"
    level_type: ClassVar[type[Level]] = LineLevel
    shear_tolerance: ClassVar[float] = COARSE_TOLERANCE
    _size: LineScales

    def __init__(self, scene: LineScene, plan: Plan, transient_term: TransientTerm | None = None):
        super().__init__(scene, plan, transient_term)
        self.convergence = HEATED_CONVERGENCE if self._model.heated else CONVERGENCE
        if scene.oil.supply is not None:
            self.convergence = replace(self.convergence, falls=FED_FALLS)
        self._size = line_scales(scene)

    def begin(self, grids: Sequence[LineGrid]) -> tuple[LineLevel, list[NewtonStep]]:
        """Solve the grids by nested iteration; the far field follows from a film on the first."""
        grid, *finer = grids
        level, steps = self._first(grid)
        if self._model.levels and not level.film.balance.worst <= COARSE_TOLERANCE:
            level, further = self._sped_up(grid)
            steps += further
        level = self._supplied(level)
        for _ in finer:
            steps += iterate(level, COARSE_TOLERANCE)
            level, further = self.refined(level)
            steps += further
        return level, steps

    def on_grid(self, grid: LineGrid, guess: InitialGuess) -> LineLevel:
        """The film on a grid from an initial guess, with shear and heat and the far field of that guess."""
        level = lone_level(self._scene, self._size, grid, guess, self._transient_term)
        self._shear_and_warm(level, guess)
        return level

    def isolated(self, grid: LineGrid, guess: InitialGuess) -> LineLevel:
        """The film on a grid from an initial guess, which bears the whole load."""
        level = isolated_level(self._scene, self._size, grid, guess, self._transient_term)
        self._shear_and_warm(level, guess)
        return level

    def unsolved(self, level: LineLevel) -> LineLevel:
        """This contact on the grid of an isolated film, not started, without shear and heat."""
        return unsolved_level(self._scene, self._size, level)

    def with_rate(self, level: LineLevel) -> LineLevel:
        """The film of a level with this solver's transient term."""
        return self._supplied(level)

    def warm_started(self, level: LineLevel) -> tuple[LineLevel, list[NewtonStep]]:
        """Start the film from that of a level on the same grid."""
        again = self._newly_supplied(level)
        steps = self._add_shear_and_heat(again) + iterate(again, COARSE_TOLERANCE)
        return self._supplied(again), steps

    def _first(self, grid: LineGrid) -> tuple[LineLevel, list[NewtonStep]]:
        """Solve the first grid in stages: isothermal Newtonian, sheared, heated.

        Newtonian stresses may be so far above the limiting stress that their heat diverges: shear comes
        first.
        """
        for lift in LIFTS:
            height = lift * self._size.film
            level = first_level(self._scene, self._size, grid, height, self._transient_term)
            steps = iterate(level, COARSE_TOLERANCE)
            if level.film.balance.worst <= COARSE_TOLERANCE:
                break
        for _ in range(SUPPLIES - 1):
            level = self._newly_supplied(level)
            steps += iterate(level, COARSE_TOLERANCE)
        if self._model.levels:
            steps += self._add_shear_and_heat(level) + iterate(level, COARSE_TOLERANCE)
        return level, steps

    def _sped_up(self, grid: LineGrid) -> tuple[LineLevel, list[NewtonStep]]:
        """Continuation in the entrainment, from `SPEED_FRACTIONS`, with shear and heat of the full speed."""
        slowest, *faster = (
            LineContactSolver(self._at(fraction), self._plan, self._transient_term)
            for fraction in SPEED_FRACTIONS
        )
        level, steps = slowest._first(grid)
        for solver in faster:
            guess = level.state()
            level = solver._newly_supplied(level)
            self._shear_and_warm(level, guess)
            steps += iterate(level, COARSE_TOLERANCE)
        return level, steps

    def _at(self, fraction: float) -> LineScene:
        first, second = self._scene.velocities
        velocities = fraction * first, fraction * second
        return replace(self._scene, velocities=velocities)

    def _newly_supplied(self, level: LineLevel) -> LineLevel:
        """A level of this grid and pressure without shear or heat, with the far field of this film."""
        guess = level.state()
        return next_level(self._scene, self._size, level, level.grid, guess, self._transient_term)

    def _supplied(self, level: LineLevel) -> LineLevel:
        """The level restarted from its film, shear and heat, with the far field of this film."""
        again = self._newly_supplied(level)
        self._shear_and_warm(again, level.state())
        return again

    def _guesses(self, level: LineLevel) -> Iterator[InitialGuess]:
        yield level.state().finer()

    def _continued(self, level: LineLevel, guess: InitialGuess) -> LineLevel:
        if level.film.fed:
            guess = mostly_full(guess, level)
        grid, term = level.grid.finer(), self._transient_term
        finer = next_level(self._scene, self._size, level, grid, guess, term)
        self._shear_and_warm(finer, guess)
        return finer

    def begun_again(self, level: LineLevel) -> tuple[LineLevel, list[NewtonStep]]:
        """The level of half the spacing in the same window, started from the dry contact."""
        return self.begin([level.grid.finer()])

    def _warm(
        self, level: LineLevel, rise: Array | None, bodies: tuple[Body, Body] | None = None
    ) -> None:
        between = bodies or self._scene.bodies
        level.film.heat(self._scene.oil, between, self._scene.velocities, rise)

    def _mass_error(self, level: LineLevel) -> float:
        """Net outflow of the pressurised film over the flow past its end, where pressure and slope vanish."""
        film, density, imbalance = level.film.fields()
        density = level.film.fraction() * density
        inside = np.flatnonzero(level.flowing())
        end = inside[-1 if self._scene.entrainment > 0 else 0]
        through = abs(self._scene.entrainment) * density[end] * film[end]
        return float(abs(imbalance[inside].sum()) * level.grid.dx / through)

    @property
    def _attributes(self) -> dict[str, float]:
        return {
            "radius_m": self._scene.radius,
            "load_per_length_N_m": self._scene.load,
            "reduced_modulus_Pa": self._scene.reduced_modulus,
        }
