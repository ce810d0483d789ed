"""The film of a point contact on the grids of its nested iteration.

Each grid has half the spacing of the one before and covers the same window or a smaller one. Pressure outside
its window is that of the grid before: it deflects the bodies, carries its share of the load and is the
boundary condition on the outline.
"""

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array, Flags
from pyworm.materials.body import reduced_modulus
from pyworm.planning.grid import Grid
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.point import Scene
from pyworm.scene.scales import Scales
from pyworm.scene.waves import opening
from pyworm.solver.level import (
    MIN_MOBILITY_FILM,
    START_PRESSURE_RATIO,
    InitialGuess,
    Level,
    TransientTerm,
)
from pyworm.solver.point.far_field import far_field

MENISCUS_RISE = 4.0
"""Rise, with the supply over the flooded film, of the gap over the layer up to which a film may be full."""

DRY_TOLERANCE = 1e-5
"""Film left in the dry contact, over the approach."""


@dataclass(frozen=True)
class PointLevel(Level):
    """A film of a point contact on one grid."""

    forcing: ClassVar[float] = 0.1

    film: kernel.PointFilm
    far: Array | float
    """Deflection by pressure beyond the grid [m]."""
    load: float
    """Load that pressure on the grid carries [N]."""
    coarser: InitialGuess | None = None
    """Final state of the film on the grid before, if it covered the same window."""

    def contact_is_cut(self) -> bool:
        """Whether the contact goes on to the outline of the window, beside which pressure is given."""
        inner = np.zeros(self.grid.shape, dtype=bool)
        inner[2:-2, 2:-2] = True
        return bool((self.contact() & ~inner).any())

    def conduction_errors(self) -> dict[str, float]:
        """Relative error of the temperatures by the models of the bodies' conduction."""
        if not self.film.heated:
            return {}
        body_1, body_2 = (float(error) for error in self.film.conduction_errors)
        return dict(zip(HEAT_FIGURES, (body_1, body_2, max(body_1, body_2)), strict=True))


def dry_contact(
    scene: Scene, grid: Grid, gap: Array, covered: Flags, guess: Array, load: float | None = None
) -> kernel.DryContact:
    """The scene's dry contact on a grid, from a first pressure; under a `load` [N] other than its own.

    A light contact whose point lies beyond an edge has no Hertz pressure where both surfaces exist: then it
    is sought everywhere there.
    """
    if not np.any(guess[covered] > 0):
        guess = np.ones(grid.shape)
    return kernel.dry_contact(
        gap,
        covered,
        grid.dx,
        grid.dy,
        reduced_modulus(*scene.bodies),
        scene.load if load is None else load,
        guess,
        DRY_TOLERANCE,
        tuple(body.layer for body in scene.bodies),
    )


def first_level(
    scene: Scene, far: Scene, size: Scales, grid: Grid, term: TransientTerm | None = None
) -> PointLevel:
    """The outermost grid of a scene, whose far field is that of `far`, from the lifted dry contact."""
    x, y = grid.mesh()
    gap, covered = opening(scene, x, y)
    dry = dry_contact(scene, grid, gap, covered, size.hertz.pressure(x, y))
    rigid_film = size.film - dry.approach
    beyond = far_field(far, grid, gap + rigid_film, covered)
    level = _level(scene, size, grid, 0.0, scene.load - beyond.load, term)
    everywhere = _with_trace(dry.pressure, covered)
    level.film.start(np.where(beyond.outline, beyond.pressure, everywhere), rigid_film)
    if level.film.fed:
        _set_back(level, size)
    return level


def _set_back(level: PointLevel, size: Scales) -> None:
    """Start a starved film again, with pressure only where its inlet meniscus may stand.

    One that starts too far out is found in fewer steps than one too near, which moves out by a node a step.
    Pressure turns back the more oil, the more is supplied: at ratios of 0.15, 0.4, 0.9 and 3.5 the meniscus
    was where the gap is up to 1, 1, 2 and 3 layers high.
    """
    height = (1 + MENISCUS_RISE * size.supply_ratio) * level.scene.supply_at(*level.grid.mesh())
    pressure = level.film.pressure
    near = (level.film.thickness() <= height) | (
        pressure > 2 * START_PRESSURE_RATIO * pressure.max()
    )
    level.film.start(np.asfortranarray(np.where(near, pressure, 0.0)), level.film.rigid_film)


def lone_level(
    scene: Scene, size: Scales, grid: Grid, guess: InitialGuess, term: TransientTerm | None
) -> PointLevel:
    """A grid with the film of an initial guess, not started, without shear, heat and pressure around it."""
    level = _level(scene, size, grid, 0.0, scene.load, term)
    pressure = np.zeros(grid.shape, order="F")
    pressure[1:-1, 1:-1] = np.where(level.covered, guess.pressure, 0.0)[1:-1, 1:-1]
    level.film.place(pressure, guess.rigid_film)
    return level


def _with_trace(pressure: Array, covered: Flags) -> Array:
    """A dry pressure with a small pressure wherever both surfaces exist (`START_PRESSURE_RATIO`)."""
    return pressure + np.where(covered, START_PRESSURE_RATIO * pressure.max(), 0.0)


def guess_on(level: PointLevel, grid: Grid) -> InitialGuess:
    """Initial guess of the film on a grid of half the spacing within the present one."""
    here = level.state()
    if level.coarser is not None and _same_window(level, grid):
        return here.beyond(level.coarser.finer()).finer()
    return here.finer(level.grid.window_of(grid))


def guess_around(narrow: PointLevel, wide: PointLevel) -> InitialGuess:
    """Initial guess on a wider grid of the same spacing: the film of a level, and its own around that.

    Temperatures around it are those of its outline: where bodies are warmer than the oil, a sweep of heat
    moves others by one node only where oil flows back. Where teeth end, the wider grid may end some nodes
    before the narrow one.
    """
    here, within = wide.state(), narrow.state()
    covered, shared = wide.grid.nodes_of(narrow.grid), narrow.grid.nodes_of(wide.grid)
    pressure = here.pressure.copy(order="F")
    pressure[covered] = within.pressure[shared]
    rise = None
    if within.rise is not None:
        nearest = (
            np.clip(np.arange(nodes) + source.start - target.start, 0, most - 1)
            for nodes, most, target, source in zip(
                wide.grid.shape, narrow.grid.shape, covered, shared, strict=True
            )
        )
        rise = np.asfortranarray(within.rise[np.ix_(*nearest)])
    oil = None
    if within.oil is not None and here.oil is not None:
        oil = here.oil.copy()
        oil[covered] = within.oil[shared]
    return InitialGuess(pressure, within.rigid_film, rise, oil)


def next_level(
    scene: Scene, size: Scales, level: PointLevel, grid: Grid, guess: InitialGuess
) -> PointLevel:
    """A grid of half the spacing within the present one, with the film of an initial guess, without heat.

    Of a starved film nothing lies beyond it: pressure of the present grid there is of a meniscus that has not
    come in yet. Kept on the outline it would press in oil that is not supplied.
    """
    window = level.grid.window_of(grid)
    far, load = level.far, level.load
    outside = level.film.pressure.copy(order="F")
    outside[window] = 0.0
    if level.film.fed:
        outside[:] = 0.0
        guess = replace(guess, pressure=_without_outline(guess.pressure))
    if outside.any():
        far = far + kernel.elastic_deflection(
            outside, level.grid.dx, level.grid.dy, scene.bending_modulus, scene.layers
        )
        load = load - outside.sum() * level.grid.dx * level.grid.dy
    if isinstance(far, np.ndarray) and far.ndim:
        far = kernel.prolong(far[window])
    coarser = level.state() if _same_window(level, grid) else None
    finer = _level(scene, size, grid, far, load, level.transient_term, coarser)
    finer.film.start(np.where(finer.covered, guess.pressure, 0.0), guess.rigid_film)
    return finer


def held_level(
    scene: Scene,
    size: Scales,
    level: PointLevel,
    grid: Grid,
    deflection: Array,
    guess: InitialGuess,
) -> PointLevel:
    """A grid of half the spacing within the present one, under a deflection [m] by all pressure beyond it.

    Its rigid film and the pressure on its outline stay those of the guess.
    """
    finer = _level(scene, size, grid, deflection, level.load, None)
    finer.film.hold()
    finer.film.start(np.where(finer.covered, guess.pressure, 0.0), guess.rigid_film)
    return finer


def _without_outline(pressure: Array) -> Array:
    """A pressure that is zero on the outline."""
    inner = np.zeros(pressure.shape, order="F")
    inner[1:-1, 1:-1] = pressure[1:-1, 1:-1]
    return inner


def restart(scene: Scene, size: Scales, level: PointLevel) -> None:
    """Restart a film from its dry contact lifted by the expected film (`dry_guess`)."""
    guess = dry_guess(scene, size, level)
    level.film.start(guess.pressure, guess.rigid_film)


def dry_guess(scene: Scene, size: Scales, level: PointLevel) -> InitialGuess:
    """Initial guess: the dry contact lifted by the expected film, pressure on the outline unchanged."""
    dry = dry_contact(
        scene,
        level.grid,
        level.gap + level.far,
        level.covered,
        size.hertz.pressure(*level.grid.mesh()),
        level.load,
    )
    pressure = level.film.pressure.copy(order="F")
    pressure[1:-1, 1:-1] = _with_trace(dry.pressure, level.covered)[1:-1, 1:-1]
    return InitialGuess(pressure, size.film - dry.approach)


def same_grid(
    scene: Scene, size: Scales, level: PointLevel, term: TransientTerm | None
) -> PointLevel:
    """A scene on the grid of a level, started from its film."""
    ratio = scene.load / level.scene.load  # what lies beyond the grid goes with the load
    again = _level(scene, size, level.grid, level.far * ratio, level.load * ratio, term)
    again.film.start(np.where(again.covered, level.film.pressure, 0.0), level.film.rigid_film)
    return again


def unsolved_level(scene: Scene, size: Scales, level: PointLevel) -> PointLevel:
    """A scene on the grid of an isolated film, not started."""
    return _level(scene, size, level.grid, 0.0, scene.load, None)


def _same_window(level: PointLevel, grid: Grid) -> bool:
    """Whether a grid of half the spacing covers all of a level's window."""
    return bool(grid.shape == level.grid.finer().shape)


def _level(
    scene: Scene,
    size: Scales,
    grid: Grid,
    far: Array | float,
    load: float,
    term: TransientTerm | None,
    coarser: InitialGuess | None = None,
) -> PointLevel:
    gap, covered = opening(scene, *grid.mesh())
    film = kernel.PointFilm(
        gap + far,
        covered,
        scene.entrainment(*grid.mesh()),
        grid.dx,
        grid.dy,
        scene.bending_modulus,
        load,
        scene.oil,
        MIN_MOBILITY_FILM * size.film,
        scene.layers,
    )
    if scene.separation is not None:
        film.hold()
    if scene.oil.supply is not None:
        film.feed(scene.supply_at(*grid.mesh()))
    if term is not None:
        film.set_transient_term(*term.on(grid))
    return PointLevel(scene, grid, gap, covered, film, term, far, load, coarser)
