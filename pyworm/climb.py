"""A film on its way up a nest of grids, one rung a grid.

Each rung has half the spacing of the one before and covers the same window or a smaller one. Pressure
outside its window is that of the rung before: it bends the bodies, carries its share of the load and stands
on the window's sides.
"""

from dataclasses import dataclass

import numpy as np

from pyworm import kernels
from pyworm.accuracy import FIGURES, JUDGED, Reading, algebra_errors
from pyworm.far_field import far_field
from pyworm.grid import Grid
from pyworm.reading import film_minimum, pressure_maximum, value_at_origin
from pyworm.scales import Scales
from pyworm.scene import Scene

MOST_STEPS = 30
"""Newton steps on one grid before it is given up."""

FORCING = 0.03
"""Share of the residual to which each Newton step solves its linear system."""

FLOOR_SHARE = 1e-3
"""Film, as a share of the expected central film, below which mobility falls no further."""

TRACE = 1e-6
"""Pressure that a film starts with outside its dry contact, over the largest dry pressure."""

DRY_TOLERANCE = 1e-4
"""Film left in the dry contact, over the approach."""


@dataclass(frozen=True)
class Rung:
    """A film on one grid.

    Attributes
    ----------
    grid : Grid
        The grid.
    gap : numpy.ndarray
        Undeformed gap [m], shape (nx, ny).
    covered : numpy.ndarray
        Where both surfaces exist.
    entrainment, sliding : tuple of numpy.ndarray
        Components (u, v) of the mean velocity and of body 1 relative to body 2 [m/s].
    far : numpy.ndarray or float
        Deflection by pressure beyond the grid [m].
    load : float
        Load that pressure on the grid carries [N].
    film : kernels.PointFilm
        The kernel's film, in its present state.
    """

    grid: Grid
    gap: np.ndarray
    covered: np.ndarray
    entrainment: tuple[np.ndarray, np.ndarray]
    sliding: tuple[np.ndarray, np.ndarray]
    far: np.ndarray | float
    load: float
    film: kernels.PointFilm


@dataclass(frozen=True)
class Stride:
    """One Newton step: grid points, balance reached, GMRES iterations."""

    points_x: int
    points_y: int
    residual: float
    load_error: float
    krylov: int


def dry_contact(scene: Scene, grid: Grid, gap, covered, guess) -> kernels.DryContact:
    """The scene's dry contact on a grid, from a first pressure."""
    return kernels.dry_contact(
        gap,
        covered,
        grid.dx,
        grid.dy,
        scene.reduced_modulus,
        scene.load,
        guess,
        DRY_TOLERANCE,
    )


def first_rung(scene: Scene, size: Scales, grid: Grid) -> Rung:
    """The outermost grid, entered from the dry contact lifted by the expected film."""
    x, y = grid.mesh()
    gap, covered = scene.gap(x, y)
    dry = dry_contact(scene, grid, gap, covered, size.hertz.pressure(x, y))
    rigid_film = size.film - dry.approach
    beyond = far_field(scene, grid, gap + rigid_film, covered)
    rung = _rung(scene, size, grid, 0.0, scene.load - beyond.load)
    # Some pressure everywhere: a rupture line that starts too far out is found in a few Newton steps, one
    # that starts too near moves by a cell a step.
    everywhere = np.where(covered, TRACE * dry.pressure.max(), 0.0)
    rung.film.start(
        np.where(beyond.outline, beyond.pressure, dry.pressure + everywhere), rigid_film
    )
    return rung


def next_rung(scene: Scene, size: Scales, rung: Rung, grid: Grid) -> Rung:
    """A grid of half the spacing within the present one, entered from the present film."""
    window = rung.grid.window_of(grid)
    pressure = rung.film.pressure
    far, load = rung.far, rung.load
    outside = pressure.copy(order="F")
    outside[window] = 0.0
    if outside.any():
        far = far + kernels.elastic_deflection(
            outside, rung.grid.dx, rung.grid.dy, scene.reduced_modulus
        )
        load = load - outside.sum() * rung.grid.dx * rung.grid.dy
    if np.ndim(far):
        far = kernels.prolong(far[window])
    finer = _rung(scene, size, grid, far, load)
    finer.film.start(
        np.where(finer.covered, np.maximum(kernels.prolong(pressure[window]), 0.0), 0.0),
        rung.film.rigid_film,
    )
    return finer


def _rung(scene: Scene, size: Scales, grid: Grid, far, load: float) -> Rung:
    x, y = grid.mesh()
    gap, covered = scene.gap(x, y)
    (u1, v1), (u2, v2) = (motion(x, y) for motion in scene.motions)
    entrainment, sliding = ((u1 + u2) / 2, (v1 + v2) / 2), (u1 - u2, v1 - v2)
    film = kernels.PointFilm(
        gap + far,
        covered,
        entrainment,
        np.zeros_like(gap),
        grid.dx,
        grid.dy,
        scene.reduced_modulus,
        load,
        scene.oil,
        FLOOR_SHARE * size.film,
    )
    return Rung(grid, gap, covered, entrainment, sliding, far, load, film)


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


def settle(rung: Rung, tolerance: float, algebra_wanted: float = np.inf) -> Settled:
    """Newton steps until the film is settled, or no step helps any more.

    Parameters
    ----------
    rung : Rung
        The film.
    tolerance : float
        Residual and load error wanted.
    algebra_wanted : float
        Relative error of both films wanted; it takes at least one step to see it.
    """
    strides: list[Stride] = []
    reading = read(rung)
    algebra = dict.fromkeys(FIGURES, np.inf)
    while len(strides) < MOST_STEPS and (
        rung.film.balance.worst > tolerance
        or max(algebra[name] for name in JUDGED) > algebra_wanted
    ):
        before = rung.film.balance.worst
        try:
            step = rung.film.step(FORCING)
        except kernels.KernelError as error:
            if error.status != kernels.NO_DESCENT:
                raise
            break
        last, reading = reading, read(rung)
        algebra = algebra_errors(last, reading, step.balance.worst / before)
        strides.append(
            Stride(
                rung.grid.nx,
                rung.grid.ny,
                step.balance.residual,
                step.balance.load_error,
                step.krylov,
            )
        )
    return Settled(tuple(strides), reading, algebra)


def read(rung: Rung) -> Reading:
    """The film's figures in its present state."""
    film, _, _ = rung.film.fields()
    film_min, at = film_minimum(rung.grid, film, rung.film.pressure > 0)
    return Reading(
        film_min,
        value_at_origin(rung.grid, film),
        pressure_maximum(rung.film.pressure),
        at,
    )
