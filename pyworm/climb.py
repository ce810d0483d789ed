"""A film on its way up a nest of grids, one rung a grid.

Each rung has half the spacing of the one before and covers the same window or a smaller one. Pressure
outside its window is that of the rung before: it bends the bodies, carries its share of the load and stands
on the window's sides.
"""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from pyworm import kernels, reading
from pyworm.accuracy import Reading
from pyworm.effects import Model
from pyworm.far_field import far_field
from pyworm.grid import Grid
from pyworm.oils import NEWTONIAN
from pyworm.scales import Scales
from pyworm.scene import Scene

FLOOR_SHARE = 1e-3
"""Film, as a share of the expected central film, below which mobility falls no further."""

TRACE = 1e-6
"""Pressure that a film starts with outside its dry contact, over the largest dry pressure."""

DRY_TOLERANCE = 1e-5
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

    forcing: ClassVar[float] = 0.03

    grid: Grid
    gap: np.ndarray
    covered: np.ndarray
    entrainment: tuple[np.ndarray, np.ndarray]
    sliding: tuple[np.ndarray, np.ndarray]
    far: np.ndarray | float
    load: float
    film: kernels.PointFilm

    def read(self) -> Reading:
        """The film's figures in its present state."""
        film, _, _ = self.film.fields()
        film_min, at = reading.film_minimum(self.grid, film, self.film.pressure > 0)
        return Reading(
            film_min,
            reading.value_at_origin(self.grid, film),
            reading.maximum(self.film.pressure),
            at,
            self._shear_figures() | self._heat_figures(),
        )

    def _shear_figures(self) -> dict[str, float]:
        if not self.film.levels:
            return {}
        shear = self.film.shear_fields()
        within = self.covered & (self.film.pressure > 0)
        sliding = self.sliding[0], self.sliding[1]
        force = [
            float(stress[within].sum()) * self.grid.cell
            for stress in (shear.stress_x, shear.stress_y)
        ]
        # friction acts along the sliding at the contact point; without any it has no direction, and no size
        along = [reading.value_at_origin(self.grid, component) for component in sliding]
        speed = float(np.hypot(*along))
        friction = abs(float(np.dot(force, along))) / speed if speed > 0 else 0.0
        return {
            "friction_coefficient": friction / self.load,
            "power_loss": float(shear.friction[within].sum()) * self.grid.cell,
            "shear_rate_max": float(shear.rate[within].max()),
        }

    def _heat_figures(self) -> dict[str, float]:
        if not self.film.heated:
            return {}
        rise = self.film.rise()
        return {
            "temperature_max_body_1": reading.maximum(rise[:, :, 0]),
            "temperature_max_body_2": reading.maximum(rise[:, :, -1]),
            "temperature_max_film": reading.maximum(rise.max(axis=2)),
        }


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


def with_shear(
    scene: Scene, size: Scales, model: Model, rung: Rung, coarser: Rung | None = None
) -> None:
    """Lets the film of a rung flow by the oil's law, and warm, from its present pressure.

    It starts at the temperature of a coarser rung over the same window, if there is one.
    """
    film = rung.film
    film.shear(scene.oil.flow or NEWTONIAN, model.levels, rung.sliding)
    if model.heated:
        (u, v), (us, vs) = rung.entrainment, rung.sliding
        rise = None
        if coarser is not None:
            levels = np.moveaxis(coarser.film.rise(), 2, 0)
            rise = np.stack([kernels.prolong(level) for level in levels], axis=2)
        film.heat(
            scene.oil,
            scene.bodies,
            ((u + us / 2, v + vs / 2), (u - us / 2, v - vs / 2)),
            (size.hertz.semi_axis_x, size.hertz.semi_axis_y),
            rise,
        )
    film.start(film.pressure, film.rigid_film)


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
