"""The film of a line contact on the grids of its nested iteration."""

from dataclasses import dataclass
from math import log, pi
from typing import ClassVar

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array
from pyworm.planning.line_grid import LineGrid
from pyworm.scene.line import LineScene
from pyworm.scene.scales import LineScales
from pyworm.scene.waves import opening
from pyworm.solver.level import (
    MIN_MOBILITY_FILM,
    START_PRESSURE_RATIO,
    InitialGuess,
    Level,
    TransientTerm,
)
from pyworm.solver.line.far_field import LineFarField, line_far_field

SMOOTHINGS = 2
"""Number of times that Hertz's pressure is averaged over neighbouring nodes for an initial guess.

Without it Newton's iteration diverged in 1 of 50 random scenes, from the ends, where pressure rises as a
root."""


@dataclass(frozen=True)
class LineLevel(Level):
    """A film of a line contact on one grid; its attributes are those of `pyworm.solver.level.Level`."""

    forcing: ClassVar[float] = 1e-3

    film: kernel.LineFilm

    def conduction_errors(self) -> dict[str, float]:
        """No errors: Jaeger's line source is exact for a body of uniform velocity."""
        return {}

    def rigid_film_on(self, grid: LineGrid, pressure: Array) -> float:
        """Rigid film [m] on another grid: deflections are those relative to a grid's length away."""

        def of_datum(on: LineGrid, under: Array) -> float:
            load = float(under.sum()) * on.dx
            return 4 * load / (pi * self.scene.bending_modulus) * log((on.nodes - 1) * on.dx)

        here = self.film.rigid_film + of_datum(self.grid, self.film.pressure)
        return here - of_datum(grid, pressure)


def first_level(
    scene: LineScene,
    size: LineScales,
    grid: LineGrid,
    lift: float,
    term: TransientTerm | None = None,
) -> LineLevel:
    """The coarsest grid, started from the dry contact lifted by a film [m], without a far field."""
    level = _level(scene, size, grid, scene.load, term)
    dry = size.hertz.pressure(grid.x)
    for _ in range(SMOOTHINGS):
        dry[1:-1] = (dry[:-2] + 2 * dry[1:-1] + dry[2:]) / 4
    dry *= scene.load / (dry.sum() * grid.dx)
    level.film.start(dry, 0.0)
    deflected = level.film.thickness()
    pressure = np.where(level.covered, dry + START_PRESSURE_RATIO * dry.max(), 0.0)
    level.film.start(pressure, lift - float(deflected[-grid.first]))
    return level


def next_level(
    scene: LineScene,
    size: LineScales,
    before: LineLevel,
    grid: LineGrid,
    guess: InitialGuess,
    term: TransientTerm | None,
) -> LineLevel:
    """A grid with the film of an initial guess, without heat; its far field is that of the level before."""
    beyond = line_far_field(scene, before.grid, before.film.pressure, before.film.thickness())
    return _supplied(scene, size, grid, guess, beyond, term)


def lone_level(
    scene: LineScene,
    size: LineScales,
    grid: LineGrid,
    guess: InitialGuess,
    term: TransientTerm | None,
) -> LineLevel:
    """A grid with the film of an initial guess, without heat; its far field is that of the guess."""
    level = _level(scene, size, grid, scene.load, term)
    level.film.start(np.where(level.covered, guess.pressure, 0.0), guess.rigid_film)
    beyond = line_far_field(scene, grid, level.film.pressure, level.film.thickness())
    return _supplied(scene, size, grid, guess, beyond, term)


def isolated_level(
    scene: LineScene,
    size: LineScales,
    grid: LineGrid,
    guess: InitialGuess,
    term: TransientTerm | None,
) -> LineLevel:
    """A grid with the film of an initial guess, without heat, and without pressure beyond it."""
    level = _level(scene, size, grid, scene.load, term)
    pressure = np.where(level.covered, guess.pressure, 0.0)
    pressure[[0, -1]] = 0.0
    level.film.start(pressure, guess.rigid_film)
    return level


def unsolved_level(scene: LineScene, size: LineScales, level: LineLevel) -> LineLevel:
    """A scene on the grid of an isolated film, not started."""
    return _level(scene, size, level.grid, scene.load, None)


def _supplied(
    scene: LineScene,
    size: LineScales,
    grid: LineGrid,
    guess: InitialGuess,
    beyond: LineFarField,
    term: TransientTerm | None,
) -> LineLevel:
    # of the strip about the inlet node, half lies beyond the grid but counts with its pressure
    load = scene.load - beyond.load + beyond.pressure * grid.dx / 2
    level = _level(scene, size, grid, load, term)
    pressure = np.where(level.covered, guess.pressure, 0.0)
    pressure[[0, -1]] = (beyond.pressure, 0.0) if scene.entrainment > 0 else (0.0, beyond.pressure)
    level.film.start(pressure, guess.rigid_film)
    return level


def _level(
    scene: LineScene, size: LineScales, grid: LineGrid, load: float, term: TransientTerm | None
) -> LineLevel:
    gap, covered = opening(scene, grid.x)
    (entrainment,) = scene.entrainment_at(grid.x)
    film = kernel.LineFilm(
        gap,
        covered,
        entrainment,
        grid.dx,
        scene.bending_modulus,
        load,
        scene.oil,
        MIN_MOBILITY_FILM * size.film,
        scene.layers,
    )
    if scene.separation is not None:
        film.hold()
    if scene.oil.supply is not None:
        film.feed(scene.supply_at(grid.x))
    if term is not None:
        film.set_transient_term(*term.on(grid))
    return LineLevel(scene, grid, gap, covered, film, term)
