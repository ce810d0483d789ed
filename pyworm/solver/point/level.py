"""A film on its way up a nest of grids, one rung a grid.

Each rung has half the spacing of the one before and covers the same window or a smaller one. Pressure
outside its window is that of the rung before: it bends the bodies, carries its share of the load and stands
on the window's sides.
"""

from dataclasses import dataclass
from math import hypot
from typing import ClassVar

import numpy as np

from pyworm import kernel
from pyworm.materials.oil import NEWTONIAN, Barus, Roelands
from pyworm.planning.grid import Grid
from pyworm.planning.model import Model
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.point import Motion, Scene
from pyworm.scene.scales import Scales
from pyworm.solver import figures
from pyworm.solver.error_estimate import Peak, Reading
from pyworm.solver.level import CONTACT_PRESSURE, FLOOR_SHARE, TRACE, Storage
from pyworm.solver.newtonian_shear import newtonian_shear
from pyworm.solver.point.far_field import far_field

DRY_TOLERANCE = 1e-5
"""Film left in the dry contact, over the approach."""

LOST = 1e-2
"""Residual or load error beyond which a grid's film is no start for a finer grid: Newton's iteration
led nowhere on it, as happens where a grid is far too coarse for the film, and from there it leads nowhere
on finer ones either."""


@dataclass(frozen=True)
class Start:
    """Where a film begins, or ended.

    Attributes
    ----------
    pressure : numpy.ndarray
        Pressure [Pa], shape (nx, ny).
    rigid_film : float
        Rigid film [m].
    rise : numpy.ndarray or None
        Temperature above the inlet's at the levels of a heated film [K], shape (nx, ny, levels).
    """

    pressure: np.ndarray
    rigid_film: float
    rise: np.ndarray | None = None

    def finer(self, window=np.s_[:, :]) -> "Start":
        """The same on nodes of half the spacing within a window."""
        return Start(
            np.maximum(kernel.prolong(self.pressure[window]), 0.0),
            self.rigid_film,
            None if self.rise is None else kernel.prolong_levels(self.rise[window]),
        )

    def onward(self, before: "Start", share: float) -> "Start":
        """What a share of the way from the one before leads to, if it goes on."""
        moved = self.pressure + share * np.where(
            self.pressure > 0, self.pressure - before.pressure, 0.0
        )
        return Start(
            np.maximum(moved, 0.0),
            self.rigid_film + share * (self.rigid_film - before.rigid_film),
            None if self.rise is None else self.rise + share * (self.rise - before.rise),
        )

    def beyond(self, coarser: "Start") -> "Start":
        """What half the spacing leads to at second order, where twice the spacing led to `coarser`."""
        pressure = (
            self.pressure + np.where(self.pressure > 0, self.pressure - coarser.pressure, 0.0) / 4
        )
        rise = self.rise
        if rise is not None and coarser.rise is not None:
            rise = rise + (rise - coarser.rise) / 4
        return Start(
            np.maximum(pressure, 0.0),
            self.rigid_film + (self.rigid_film - coarser.rigid_film) / 4,
            rise,
        )


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
    far : numpy.ndarray or float
        Deflection by pressure beyond the grid [m].
    load, whole_load : float
        Load that pressure on the grid carries, and that of the contact [N].
    sliding : tuple of float
        Velocity of body 1 relative to body 2 at the contact point [m/s].
    film : kernels.PointFilm
        The kernel's film, in its present state.
    coarser : Start or None
        Where the rung before ended, if it covered the same window.
    newtonian : tuple or None
        Viscosity against pressure and sliding velocities against place, by which a film without levels is
        sheared; None where the oil's flow law is not known.
    storage : Storage or None
        What the film stores as it changes; None of a steady one.
    """

    forcing: ClassVar[float] = 0.1

    grid: Grid
    gap: np.ndarray
    covered: np.ndarray
    far: np.ndarray | float
    load: float
    whole_load: float
    sliding: tuple[float, float]
    film: kernel.PointFilm
    coarser: Start | None = None
    newtonian: tuple[Barus | Roelands, Motion] | None = None
    storage: Storage | None = None

    def read(self) -> Reading:
        """The film's figures in its present state."""
        film = self.film.thickness()
        pressure = self.film.pressure
        film_min, at = figures.film_minimum(self.grid, film, pressure > 0, self.covered)
        pressure_max = figures.maximum(pressure, self.covered)
        temperatures, peaks = self._temperatures()
        return Reading(
            film_min,
            figures.value_at_origin(self.grid, film),
            pressure_max,
            at,
            {"pressure_max": figures.peak(pressure, self.covered, pressure_max)} | peaks,
            self._shear_figures() | temperatures,
        )

    def contact(self) -> np.ndarray:
        """Nodes where pressure makes the contact, of which friction and the film's temperature are read."""
        return self.covered & (self.film.pressure > CONTACT_PRESSURE * self.film.pressure.max())

    def end(self) -> Start:
        """Its present state."""
        film = self.film
        return Start(film.pressure, film.rigid_film, film.rise() if film.heated else None)

    def model_errors(self) -> dict[str, float]:
        """Error of the temperatures by the bodies' models of conduction."""
        if not self.film.heated:
            return {}
        body_1, body_2 = (float(error) for error in self.film.conduction_errors)
        return dict(zip(HEAT_FIGURES, (body_1, body_2, max(body_1, body_2)), strict=True))

    def _shear(self) -> tuple[tuple[np.ndarray, np.ndarray], np.ndarray, np.ndarray] | None:
        """Stresses on body 1 [Pa], heat of shearing [W/m2] and shear rate [1/s]; None of an unknown law."""
        if self.film.levels:
            shear = self.film.heat_fields() if self.film.heated else self.film.shear_fields()
            return (shear.stress_x, shear.stress_y), shear.friction, shear.rate
        if self.newtonian is None:
            return None
        viscosity, sliding = self.newtonian
        pressure = self.film.pressure
        shear = newtonian_shear(
            viscosity(pressure),
            self.film.thickness(),
            sliding(*self.grid.mesh()),
            np.gradient(pressure, *self.grid.spacing),
        )
        return shear.stress, shear.friction, shear.rate

    def _shear_figures(self) -> dict[str, float]:
        shear = self._shear()
        if shear is None:
            return {}
        stresses, friction_power, rate = shear
        within = self.contact()
        force = [float(stress[within].sum()) * self.grid.cell for stress in stresses]
        # along the sliding at the contact point; without any friction has no direction, and no size
        speed = hypot(*self.sliding)
        friction = -float(np.dot(force, self.sliding)) / speed if speed > 0 else 0.0
        return {
            "friction_coefficient": friction / self.whole_load,
            "power_loss": float(friction_power[within].sum()) * self.grid.cell,
            "shear_rate_max": float(rate[within].max()),
        }

    def _temperatures(self) -> tuple[dict[str, float], dict[str, Peak]]:
        """Largest temperatures above the inlet's [K], and how well the grid resolves them."""
        if not self.film.heated:
            return {}, {}
        rise = self.film.rise()
        fields = dict(
            zip(HEAT_FIGURES, (rise[:, :, 0], rise[:, :, -1], rise.max(axis=2)), strict=True)
        )
        counted = dict(zip(HEAT_FIGURES, (True, True, self.contact()), strict=True))
        largest = {name: figures.maximum(field, counted[name]) for name, field in fields.items()}
        largest["temperature_max_film"] = figures.maximum_across(
            rise, kernel.level_positions(self.film.levels), self.contact()
        )
        return largest, {
            name: figures.peak(field, counted[name], largest[name])
            for name, field in fields.items()
        }


def dry_contact(
    scene: Scene, grid: Grid, gap, covered, guess, load: float | None = None
) -> kernel.DryContact:
    """The scene's dry contact on a grid, from a first pressure; under a `load` [N] other than its own."""
    return kernel.dry_contact(
        gap,
        covered,
        grid.dx,
        grid.dy,
        scene.reduced_modulus,
        scene.load if load is None else load,
        guess,
        DRY_TOLERANCE,
    )


def first_rung(
    scene: Scene, far: Scene, size: Scales, grid: Grid, storage: Storage | None = None
) -> Rung:
    """The outermost grid, entered from the dry contact lifted by the expected film.

    `far` is the scene that the oil beyond the grid belongs to.
    """
    x, y = grid.mesh()
    gap, covered = scene.gap(x, y)
    dry = dry_contact(scene, grid, gap, covered, size.hertz.pressure(x, y))
    rigid_film = size.film - dry.approach
    beyond = far_field(far, grid, gap + rigid_film, covered)
    rung = _rung(scene, size, grid, 0.0, scene.load - beyond.load, storage)
    everywhere = _with_trace(dry.pressure, covered)
    rung.film.start(np.where(beyond.outline, beyond.pressure, everywhere), rigid_film)
    return rung


def _with_trace(pressure: np.ndarray, covered: np.ndarray) -> np.ndarray:
    """A dry pressure with some of it everywhere.

    A rupture line that starts too far out is found in a few Newton steps, one that starts too near moves by a
    cell a step.
    """
    return pressure + np.where(covered, TRACE * pressure.max(), 0.0)


def lost(rung: Rung) -> bool:
    """Whether a rung's film is no start for a finer grid."""
    balance = rung.film.balance
    return not max(balance.residual, abs(balance.load_error)) <= LOST


def entry(rung: Rung, grid: Grid) -> Start:
    """Where a grid of half the spacing within the present one is entered."""
    here = rung.end()
    if rung.coarser is not None and _same_window(rung, grid):
        return here.beyond(rung.coarser.finer()).finer()
    return here.finer(rung.grid.window_of(grid))


def next_rung(scene: Scene, size: Scales, rung: Rung, grid: Grid, start: Start) -> Rung:
    """A grid of half the spacing within the present one, with the film of `start` but no heat as yet."""
    window = rung.grid.window_of(grid)
    far, load = rung.far, rung.load
    outside = rung.film.pressure.copy(order="F")
    outside[window] = 0.0
    if outside.any():
        far = far + kernel.elastic_deflection(
            outside, rung.grid.dx, rung.grid.dy, scene.bending_modulus
        )
        load = load - outside.sum() * rung.grid.dx * rung.grid.dy
    if np.ndim(far):
        far = kernel.prolong(far[window])
    coarser = rung.end() if _same_window(rung, grid) else None
    finer = _rung(scene, size, grid, far, load, rung.storage, coarser)
    finer.film.start(np.where(finer.covered, start.pressure, 0.0), start.rigid_film)
    return finer


def anew(scene: Scene, size: Scales, rung: Rung) -> None:
    """Starts a rung's film from its own dry contact lifted by the expected film.

    On its outline, and beyond it, pressure stays what it was.
    """
    dry = dry_contact(
        scene,
        rung.grid,
        rung.gap + rung.far,
        rung.covered,
        size.hertz.pressure(*rung.grid.mesh()),
        rung.load,
    )
    pressure = rung.film.pressure.copy(order="F")
    pressure[1:-1, 1:-1] = _with_trace(dry.pressure, rung.covered)[1:-1, 1:-1]
    rung.film.start(pressure, size.film - dry.approach)


def like(scene: Scene, size: Scales, rung: Rung, storage: Storage | None) -> Rung:
    """A scene on the grid of a rung, entered from its film."""
    share = scene.load / rung.whole_load  # what lies beyond the grid goes with the load
    again = _rung(scene, size, rung.grid, rung.far * share, rung.load * share, storage)
    again.film.start(np.where(again.covered, rung.film.pressure, 0.0), rung.film.rigid_film)
    return again


def _same_window(rung: Rung, grid: Grid) -> bool:
    """Whether a grid of half the spacing covers all of a rung's window."""
    return grid.shape == rung.grid.finer().shape


def with_shear(scene: Scene, model: Model, rung: Rung, firmness: float = 1.0) -> None:
    """Lets the film of a rung flow by the oil's law; it is to be restarted before it steps.

    The law's stresses are taken as `firmness` times as large.
    """
    body_1, body_2 = (motion(*rung.grid.mesh()) for motion in scene.motions)
    sliding = tuple(one - other for one, other in zip(body_1, body_2, strict=True))
    law = (scene.oil.flow or NEWTONIAN).firmer(firmness)
    rung.film.shear(law, model.levels, sliding)


def with_heat(scene: Scene, size: Scales, rung: Rung, rise: np.ndarray | None = None) -> None:
    """Lets the sheared film of a rung, and the bodies, warm; it is to be restarted before it steps.

    `rise` is the temperature above the inlet's to begin with [K], on the rung's grid.
    """
    rung.film.heat(
        scene.oil,
        scene.bodies,
        tuple(motion(*rung.grid.mesh()) for motion in scene.motions),
        (size.hertz.semi_axis_x, size.hertz.semi_axis_y),
        rise,
    )


def _rung(
    scene: Scene,
    size: Scales,
    grid: Grid,
    far,
    load: float,
    storage: Storage | None,
    coarser: Start | None = None,
) -> Rung:
    gap, covered = scene.gap(*grid.mesh())
    film = kernel.PointFilm(
        gap + far,
        covered,
        scene.entrainment(*grid.mesh()),
        grid.dx,
        grid.dy,
        scene.bending_modulus,
        load,
        scene.oil,
        FLOOR_SHARE * size.film,
    )
    if storage is not None:
        film.store(*storage.on(grid))
    sliding = tuple(float(component) for component in scene.sliding(np.array(0.0), np.array(0.0)))
    newtonian = (scene.oil.viscosity, scene.sliding) if scene.oil.flow == NEWTONIAN else None
    return Rung(
        grid, gap, covered, far, load, scene.load, sliding, film, coarser, newtonian, storage
    )
