"""A point contact solved by nested iteration: a nest of windows, then finer grids in the innermost."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, ClassVar

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.kernel import DryContact
from pyworm.materials.body import Body
from pyworm.planning.discretisation import NEAR_MENISCUS
from pyworm.planning.expected_work import Kind
from pyworm.planning.grid import Grid
from pyworm.planning.plan import Plan
from pyworm.planning.target import FIGURES, HEAT_FIGURES, ROUGH_FIGURES, SHEAR_FIGURES
from pyworm.scene.entrainment_continuation import FRACTIONS_LEFT, with_auxiliary_entrainment
from pyworm.scene.point import Scene
from pyworm.scene.scales import Scales, scales
from pyworm.solver import figures
from pyworm.solver.contact import COARSE_TOLERANCE, FED_FALLS, ContactSolver
from pyworm.solver.error_estimate import Convergence, Left, Reading
from pyworm.solver.level import InitialGuess, Level, TransientTerm
from pyworm.solver.newton import NewtonStep, iterate
from pyworm.solver.oil_supply import mostly_full
from pyworm.solver.point.level import (
    PointLevel,
    dry_contact,
    dry_guess,
    first_level,
    guess_around,
    guess_on,
    held_level,
    lone_level,
    next_level,
    restart,
    same_grid,
    unsolved_level,
)
from pyworm.solver.point.local_grids import resolved
from pyworm.solver.solution import DryFigures

AUXILIARY_TOLERANCE = 1e-2
"""Residual at which the continuation of auxiliary entrainment takes its next step."""

WIDENING_STEPS = 6
"""Largest number of Newton steps in the wider window before its figures are settled: where local slip or heat
slows the last ones, the figures of both windows differ by far less than the residual."""

ALL = (*FIGURES, *SHEAR_FIGURES, *ROUGH_FIGURES, *HEAT_FIGURES)

ORDERS = dict.fromkeys(ALL, 2.0)

# Shares that about 95 of 100 errors stay below, in the limit of two grids and of three
# (`benchmarks/accuracy/two_grids.py`). A minimum film may move to and fro, as those of contacts entrained
# obliquely do; on three grids, where its changes fell regularly, its limit was off by 0.06 of the last one in
# the median of 24 isothermal contacts, 0.12 at 95 of 100, and 0.17 and 0.18 in two side lobes at M > 400. The
# largest pressure, where it is no spike, is of second order too, but keeps its value; that of the shear rate
# promises no limit.
TWO_GRID_ERRORS = {
    "film_min": Left(0.25, 0.125, limit=0.7, least=0.18),
    "film_central": Left(0.1, 0.05, limit=0.5),
    "friction_coefficient": Left(0.17, 0.085, limit=0.7),
    "power_loss": Left(0.25, 0.125),
    **dict.fromkeys(ROUGH_FIGURES, Left(0.25, 0.125)),
    **dict.fromkeys(HEAT_FIGURES, Left(0.3, 0.15)),
}
PRESSURE_ERRORS = {"pressure_max": Left(0.5, 0.05)}

# A window's error falls with the power -3/2 of its reach: 1 / (1 - 2^-1.5) = 1.55, and 1.6 to 1.8 were
# measured against a reach 15 times larger, under light loads (M 0.5 to 2) up to 2.1. Oil warms long before
# the contact: of the temperatures' error 0.4 to 0.6 are left when the reach is doubled (against a reach 8
# times larger), most where they rise by little.
CONVERGENCE = Convergence(
    ORDERS,
    TWO_GRID_ERRORS,
    window=dict.fromkeys(ALL, (1.3, 2.1)) | dict.fromkeys(HEAT_FIGURES, (1.6, 2.5)),
    kept=PRESSURE_ERRORS,
)

# Oil that comes in a layer is transported upwind to the meniscus, at first order; the film behind it is of
# second. Shares left are those of full films, of the largest pressure twice as much.
FED_CONVERGENCE = replace(CONVERGENCE, kept={"pressure_max": Left(1.0, 0.1)}, falls=FED_FALLS)

LIFTS = (1.0, 4.0)
"""Films by which the dry contact is lifted further on the outermost grid where no film is found from it.

Where the flank of a soft wheel ends under load (PEEK, a = 100 mm, 60 N m, phase 0.5) up to 30 Newton steps
from the expected film lead to one or none, by rounding; from a film two to five times as thick 4 or 5 do."""


class PointContactSolver(ContactSolver[Scene, PointLevel]):
    """Films of a point contact; parameters and attributes as of `pyworm.solver.contact.ContactSolver`."""

    kind: ClassVar[Kind] = "point"
    level_type: ClassVar[type[Level]] = PointLevel
    shear_tolerance: ClassVar[float] = 1e-3
    convergence = CONVERGENCE
    _size: Scales

    def __init__(self, scene: Scene, plan: Plan, transient_term: TransientTerm | None = None):
        super().__init__(scene, plan, transient_term)
        self._assisted = with_auxiliary_entrainment(scene) if self._model.heated else scene
        self._size = scales(self._assisted)
        if scene.oil.supply is not None:
            self.convergence = FED_CONVERGENCE

    def begin(self, grids: Sequence[Grid]) -> tuple[PointLevel, list[NewtonStep]]:
        """Solve the windows by nested iteration to the first grid of the figures."""
        level, steps = self._begun(grids)
        return level, steps + self._add_shear_and_heat(level)

    def in_wider_window(
        self, grids: Sequence[Grid], narrow: PointLevel
    ) -> tuple[PointLevel, list[NewtonStep]]:
        """Solve wider windows to the spacing of a level, from its film within them."""
        if not self._model.levels or self._assisted is not self._scene:
            return super().in_wider_window(grids, narrow)
        level, steps = self._begun(grids)
        for _ in range(self._refinements_between(level, narrow)):
            steps += iterate(level, COARSE_TOLERANCE)
            grid = level.grid.finer()
            level = next_level(self._scene, self._size, level, grid, guess_on(level, grid))
        steps += iterate(level, COARSE_TOLERANCE)
        guess = guess_around(narrow, level)
        level.film.start(guess.pressure, guess.rigid_film)
        self._shear_and_warm(level, guess)
        # what the windows differ by is of the order of the tolerance
        steps += iterate(level, self._plan.tolerance / 10, most=WIDENING_STEPS)
        if not level.diverged():
            return level, steps
        level, further = super().in_wider_window(grids, narrow)
        return level, steps + further

    def _resolved(self, level: PointLevel, reading: Reading) -> Reading:
        """That of a film whose outline is that of the dry contact, with the minimum by `local_grids`."""
        if not level.film.fed or self._size.supply_ratio > NEAR_MENISCUS:
            return reading
        if self._transient_term is not None:
            return reading
        return resolved(level, reading, self._within, self._plan.tolerance)

    def _within(
        self, level: PointLevel, grid: Grid, deflection: Array, guess: InitialGuess
    ) -> PointLevel:
        """The film on a finer grid within a level's, under the pressure around it."""
        finer = held_level(self._scene, self._size, level, grid, deflection, guess)
        self._shear_and_warm(finer, guess)
        if finer.film.heated:
            finer.film.hold_rise()
        return finer

    def cut_off(self, narrow: PointLevel, wider: PointLevel) -> dict[str, float]:
        """Parts of friction and loss in a wider window that a narrower one cuts off."""
        if not narrow.contact_is_cut() or wider.contact_is_cut():
            return {}
        beyond = np.ones(wider.grid.shape, dtype=bool)
        beyond[wider.grid.nodes_of(narrow.grid)] = False
        whole = wider.read().figures
        return {
            name: value / abs(whole[name]) for name, value in wider.rubbed(beyond).items() if value
        }

    def _begun(self, grids: Sequence[Grid]) -> tuple[PointLevel, list[NewtonStep]]:
        """Solve the windows for a Newtonian oil of one temperature; the last of them is not solved yet."""
        steps: list[NewtonStep] = []
        scene, size = self._scene, self._size
        level = first_level(self._assisted, scene, size, grids[0], self._transient_term)
        begun = level.film.pressure.copy(order="F"), level.film.rigid_film
        for grid in grids[1:]:
            steps += iterate(level, COARSE_TOLERANCE)
            if level.grid is grids[0]:
                steps += self._lifted_off(level, begun)
            diverged = level.diverged()
            if diverged:  # what it bears beyond the next window may exceed the load
                restart(scene, size, level)
            guess = guess_on(level, grid)
            if level.film.fed:
                guess = mostly_full(guess, level, level.grid.window_of(grid))
            level = next_level(scene, size, level, grid, guess)
            if diverged:
                restart(scene, size, level)
        return level, steps

    def _lifted_off(self, level: PointLevel, begun: tuple[Array, float]) -> list[NewtonStep]:
        """Newton steps from thicker films on the outermost grid, where none was found; else it stays."""
        if level.film.fed or self._found(level):
            return []
        (pressure, rigid_film), first, steps = begun, level.state(), []
        for lift in LIFTS:
            level.film.start(pressure, rigid_film + lift * self._size.film)
            steps += iterate(level, COARSE_TOLERANCE)
            if self._found(level):
                return steps
        level.film.start(first.pressure, first.rigid_film)
        return steps

    @staticmethod
    def _found(level: PointLevel) -> bool:
        """Whether the film of an outer grid is found."""
        return level.film.balance.worst <= COARSE_TOLERANCE

    def on_grid(self, grid: Grid, guess: InitialGuess) -> PointLevel:
        """The film on a grid from an initial guess, with shear and heat, without pressure around it."""
        level = lone_level(self._scene, self._size, grid, guess, self._transient_term)
        self._shear_and_warm(level, guess)
        if not self._model.levels:
            level.film.restart()
        return level

    def isolated(self, grid: Grid, guess: InitialGuess) -> PointLevel:
        """The film on a grid from an initial guess, which bears the whole load."""
        return self.on_grid(grid, guess)

    def unsolved(self, level: PointLevel) -> PointLevel:
        """This contact on the grid of an isolated film, not started, without shear and heat."""
        return unsolved_level(self._scene, self._size, level)

    def with_rate(self, level: PointLevel) -> PointLevel:
        """The film of a level with this solver's transient term, on the same grid."""
        again = same_grid(self._scene, self._size, level, self._transient_term)
        self._shear_and_warm(again, level.state())
        return again

    def from_dry(self, level: PointLevel) -> PointLevel | None:
        """The film between rough surfaces on the grid of a level, begun with the dry contact; else None."""
        if not level.film.rough:
            return None
        again = same_grid(self._scene, self._size, level, self._transient_term)
        (guess,) = self.dry_guesses(level)
        again.film.start(guess.pressure, guess.rigid_film)
        self._shear_and_warm(again, guess)
        return again

    def warm_started(self, level: PointLevel) -> tuple[PointLevel, list[NewtonStep]]:
        """Start the film from that of a level on the same grid."""
        again = same_grid(self._assisted, self._size, level, self._transient_term)
        return again, self._add_shear_and_heat(again)

    def _guesses(self, level: PointLevel) -> Iterator[InitialGuess]:
        if not level.diverged():
            yield guess_on(level, level.grid.finer())
            yield level.state().finer()

    def _continued(self, level: PointLevel, guess: InitialGuess) -> PointLevel:
        if level.film.fed:
            guess = mostly_full(guess, level)
        finer = next_level(self._scene, self._size, level, level.grid.finer(), guess)
        self._shear_and_warm(finer, guess)
        return finer

    def begun_again(self, level: PointLevel) -> tuple[PointLevel, list[NewtonStep]]:
        """The level of half the spacing in the same window, started from the dry contact."""
        scene, size = self._assisted, self._size
        finer = next_level(scene, size, level, level.grid.finer(), level.state().finer())
        restart(scene, size, finer)
        return finer, self._add_shear_and_heat(finer)

    def dry_guesses(self, level: PointLevel) -> list[InitialGuess]:
        """The dry contact's pressure, lifted by the expected film until asperities bear no more."""
        return [self._lifted(dry_guess(self._scene, self._size, level), self._size.film)]

    def _warm(
        self, level: PointLevel, rise: Array | None, bodies: tuple[Body, Body] | None = None
    ) -> None:
        hertz = self._size.hertz
        level.film.heat(
            self._scene.oil,
            bodies or self._scene.bodies,
            self._scene.velocities_at(*level.grid.mesh()),
            (hertz.semi_axis_x, hertz.semi_axis_y),
            rise,
        )

    def _to_own_entrainment(self, level: PointLevel) -> list[NewtonStep]:
        steps: list[NewtonStep] = []
        if self._assisted is self._scene:
            return steps
        for fraction in FRACTIONS_LEFT:
            steps += iterate(level, AUXILIARY_TOLERANCE)
            assisted = with_auxiliary_entrainment(self._scene, fraction)
            level.film.entrain(assisted.entrainment(*level.grid.mesh()))
            level.film.restart()
        return steps

    def _dry(self, level: PointLevel) -> DryContact:
        return dry_contact(self._scene, level.grid, level.gap, level.covered, level.film.pressure)

    def _mass_error(self, level: PointLevel) -> float:
        film, density, imbalance = level.film.fields()
        density = level.film.fraction() * density
        u, v = self._assisted.entrainment(*level.grid.mesh())
        return figures.outline_imbalance(
            level.grid, (density * film * u, density * film * v), imbalance, level.flowing()
        )

    def _dry_figures(self, level: PointLevel, dry: DryContact) -> dict[str, Any]:
        angle = self._size.angle
        exit_min, exit_min_at = figures.exit_minimum(level.grid, level.film.thickness(), angle)
        extents = figures.contact_extent(level.grid, dry.pressure)
        return {
            "film_min_kind": figures.minimum_kind(
                level.read().film_min_at, angle, (extents[0] / 2, extents[1] / 2)
            ),
            "film_exit_min": exit_min,
            "film_exit_min_at": exit_min_at,
            "lift": level.film.rigid_film + dry.approach,
            "dry": DryFigures(
                figures.maximum(dry.pressure, level.covered),
                max(extents),
                min(extents),
                dry.approach,
            ),
        }

    @property
    def _attributes(self) -> dict[str, float]:
        return {
            "radius_x_m": self._scene.radii[0],
            "radius_y_m": self._scene.radii[1],
            "load_N": self._scene.load,
            "reduced_modulus_Pa": self._scene.reduced_modulus,
        }
