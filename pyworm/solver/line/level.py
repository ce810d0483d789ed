"""The film of a line contact on its way up grids of halving spacing, one rung a grid."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from pyworm.kernel.interpolation import level_positions
from pyworm.kernel.line_film import LineFilm
from pyworm.materials.oil import NEWTONIAN, Barus, Roelands
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.model import Model
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.contact import Array
from pyworm.scene.line import LineScene
from pyworm.scene.scales import LineScales
from pyworm.solver.error_estimate import Peak, Reading
from pyworm.solver.extremum import line_minimum
from pyworm.solver.figures import line_maximum, maximum_across, peak
from pyworm.solver.level import CONTACT_PRESSURE, Storage
from pyworm.solver.line.far_field import line_far_field
from pyworm.solver.newtonian_shear import newtonian_shear

FLOOR_SHARE = 1e-3
"""Film, as a share of the expected one, below which mobility falls no further."""

SMOOTHINGS = 2
"""Times that Hertz's pressure is averaged over neighbouring nodes before a film starts from it.

From its ends, where it rises as a root, Newton's iteration went astray in 1 of 50 random scenes."""

TRACE = 1e-6
"""Pressure that a film starts with outside its dry contact, over the largest dry pressure.

A rupture line that starts too far out is found in a few steps; from too near it moves by a cell a step."""


@dataclass(frozen=True)
class LineRung:
    """A film on one grid.

    Attributes
    ----------
    grid : LineGrid
        The grid.
    gap : numpy.ndarray
        Undeformed gap [m].
    covered : numpy.ndarray
        Where both surfaces exist.
    sliding : float
        Velocity of body 1 relative to body 2 [m/s].
    load : float
        Load for each length, what pressure beyond the grid carries included [N/m].
    film : kernels.LineFilm
        The kernel's film, in its present state.
    newtonian : Barus, Roelands or None
        Viscosity by which a film without levels is sheared; None where the oil's flow law is not known.
    storage : Storage or None
        What the film stores as it changes; None of a steady one.
    """

    forcing: ClassVar[float] = 1e-3

    grid: LineGrid
    gap: Array
    covered: Array
    sliding: float
    load: float
    film: LineFilm
    newtonian: Barus | Roelands | None = None
    storage: Storage | None = None

    def model_errors(self) -> dict[str, float]:
        """None: Jaeger's line of heat is exact for a body of one velocity."""
        return {}

    def read(self) -> Reading:
        """The film's figures in its present state."""
        film, _, _ = self.film.fields()
        pressure = self.film.pressure
        film_min, at = line_minimum(film, pressure > 0, self.covered)
        pressure_max = line_maximum(pressure, self.covered)
        temperatures, peaks = self._temperatures()
        return Reading(
            film_min,
            float(film[-self.grid.first]),
            pressure_max,
            (self.grid.dx * (self.grid.first + at),),
            {"pressure_max": peak(pressure, self.covered, pressure_max)} | peaks,
            self._shear_figures() | temperatures,
        )

    def contact(self) -> Array:
        """Nodes where pressure makes the contact, of which friction and the film's temperature are read."""
        return self.covered & (self.film.pressure > CONTACT_PRESSURE * self.film.pressure.max())

    def _shear(self) -> tuple[Array, Array, Array] | None:
        """Stress on body 1 [Pa], heat of shearing [W/m2] and shear rate [1/s]; None of an unknown law."""
        if self.film.levels:
            shear = self.film.shear_fields()
            return shear.stress, shear.friction, shear.rate
        if self.newtonian is None:
            return None
        pressure = self.film.pressure
        shear = newtonian_shear(
            self.newtonian(pressure),
            self.film.fields()[0],
            (np.full(self.grid.nodes, self.sliding),),
            (np.gradient(pressure, self.grid.dx),),
        )
        return shear.stress[0], shear.friction, shear.rate

    def _shear_figures(self) -> dict[str, float]:
        shear = self._shear()
        if shear is None:
            return {}
        stress, friction_power, rate = shear
        within = self.contact()
        # against the sliding; without any, friction has no direction, and no size
        force = -np.sign(self.sliding) * float(stress[within].sum()) * self.grid.dx
        return {
            "friction_coefficient": force / self.load if self.sliding else 0.0,
            "power_loss": float(friction_power[within].sum()) * self.grid.dx,
            "shear_rate_max": float(rate[within].max()),
        }

    def _temperatures(self) -> tuple[dict[str, float], dict[str, Peak]]:
        """Largest temperatures above the inlet's [K], and how well the grid resolves them."""
        if not self.film.heated:
            return {}, {}
        rise = self.film.rise()
        fields = dict(zip(HEAT_FIGURES, (rise[:, 0], rise[:, -1], rise.max(axis=1)), strict=True))
        counted = dict(zip(HEAT_FIGURES, (True, True, self.contact()), strict=True))
        largest = {name: line_maximum(field, counted[name]) for name, field in fields.items()}
        largest["temperature_max_film"] = maximum_across(
            rise, level_positions(self.film.levels), self.contact()
        )
        return largest, {
            name: peak(field, counted[name], largest[name]) for name, field in fields.items()
        }


def first_rung(
    scene: LineScene, size: LineScales, grid: LineGrid, lift: float, storage: Storage | None = None
) -> LineRung:
    """The coarsest grid, entered from the dry contact lifted by a film [m]; no oil lies before its inlet."""
    rung = _rung(scene, size, grid, scene.load, storage)
    dry = size.hertz.pressure(grid.x)
    for _ in range(SMOOTHINGS):
        dry[1:-1] = (dry[:-2] + 2 * dry[1:-1] + dry[2:]) / 4
    dry *= scene.load / (dry.sum() * grid.dx)
    rung.film.start(dry, 0.0)
    deflected, _, _ = rung.film.fields()
    pressure = np.where(rung.covered, dry + TRACE * dry.max(), 0.0)
    rung.film.start(pressure, lift - float(deflected[-grid.first]))
    return rung


def supplied(
    scene: LineScene, size: LineScales, rung: LineRung, storage: Storage | None
) -> LineRung:
    """The same grid and film, with oil before its inlet as the film lets it come."""
    return _entered(scene, size, rung.grid, rung.film.pressure, rung, storage)


def next_rung(scene: LineScene, size: LineScales, rung: LineRung) -> LineRung:
    """The grid of half the spacing, entered from the present film."""
    pressure = np.maximum(_prolonged(rung.film.pressure), 0.0)
    return _entered(scene, size, rung.grid.finer(), pressure, rung, rung.storage)


def with_shear(scene: LineScene, model: Model, rung: LineRung) -> None:
    """Lets the film of a rung flow by the oil's law, from its present pressure."""
    film = rung.film
    film.shear(scene.oil.flow or NEWTONIAN, model.levels, np.full(rung.grid.nodes, scene.sliding))
    film.restart()


def with_heat(scene: LineScene, rung: LineRung, before: LineRung | None = None) -> None:
    """Lets the sheared film of a rung warm, from its present pressure.

    It starts at the temperature of the rung before, on the same grid or on that of twice the spacing.
    """
    film = rung.film
    rise = None if before is None else before.film.rise()
    if rise is not None and before.grid != rung.grid:
        rise = np.stack([_prolonged(level) for level in rise.T], axis=1)
    film.heat(scene.oil, scene.bodies, scene.velocities, rise)
    film.restart()


def _entered(
    scene: LineScene,
    size: LineScales,
    grid: LineGrid,
    pressure: Array,
    before: LineRung,
    storage: Storage | None,
) -> LineRung:
    """A grid entered from a pressure on it; oil comes to its inlet as the rung before lets it."""
    film, _, _ = before.film.fields()
    beyond = line_far_field(scene, before.grid, before.film.pressure, film)
    # of the strip about the inlet node, half lies beyond the grid but counts with its pressure
    load = scene.load - beyond.load + beyond.pressure * grid.dx / 2
    rung = _rung(scene, size, grid, load, storage)
    started = np.where(rung.covered, pressure, 0.0)
    started[[0, -1]] = (beyond.pressure, 0.0) if scene.entrainment > 0 else (0.0, beyond.pressure)
    rung.film.start(started, before.film.rigid_film)
    return rung


def _rung(
    scene: LineScene, size: LineScales, grid: LineGrid, load: float, storage: Storage | None
) -> LineRung:
    gap, covered = scene.gap(grid.x)
    film = LineFilm(
        gap,
        covered,
        np.full(grid.nodes, scene.entrainment),
        grid.dx,
        scene.bending_modulus,
        load,
        scene.oil,
        FLOOR_SHARE * size.film,
    )
    if storage is not None:
        film.store(*storage.on(grid))
    newtonian = scene.oil.viscosity if scene.oil.flow == NEWTONIAN else None
    return LineRung(grid, gap, covered, scene.sliding, scene.load, film, newtonian, storage)


def _prolonged(field: Array) -> Array:
    """A field on the grid of half the spacing, by cubic interpolation."""
    p = field
    fine = np.empty(2 * p.size - 1)
    fine[::2] = p
    fine[3:-3:2] = (9 * (p[1:-2] + p[2:-1]) - p[:-3] - p[3:]) / 16
    for side, (a, b, c, d) in ((1, p[:4]), (-2, p[:-5:-1])):
        fine[side] = (5 * a + 15 * b - 5 * c + d) / 16
    return fine
