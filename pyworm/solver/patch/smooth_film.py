"""The steady film between smooth surfaces at the nodes of a patch, from which the rough one departs."""

from dataclasses import dataclass
from math import cos, hypot, sin

import numpy as np
import scipy

from pyworm import kernel
from pyworm.formulas.arrays import Array, Flags
from pyworm.planning.grid import Grid
from pyworm.scene.point import Scene
from pyworm.scene.scales import Scales, scales
from pyworm.solver.level import MIN_MOBILITY_FILM, START_PRESSURE_RATIO
from pyworm.solver.patch.sheared_oil import ShearedOil
from pyworm.solver.solution import Solution

INLET, EXIT, HALF_WIDTH = 3.1, 1.4, 2.0
"""Ends of a patch before, behind and beside the contact point, in half-lengths of Hertz's contact.

The film of `cases/traction_steel.toml` lacks 1.3 %; with an inlet of 2.2 and a half-width of 1.6 4 %.
"""

MIN_NODES = 33
"""Least number of nodes along each side of the first grid."""

TOLERANCE = 1e-7
"""Residual of the smooth film, well below that of rough ones."""

MAX_STEPS = 40
"""Largest number of Newton steps of a smooth film on a grid."""


@dataclass(frozen=True)
class PatchFrame:
    """Axes of a patch: x along the entrainment, with both surfaces' speeds along it."""

    scene: Scene
    """The contact."""
    size: Scales
    """Its scales."""
    angle: float
    """Direction of the entrainment from the scene's x axis [rad]."""
    speeds: tuple[float, float]
    """Speeds of body 1 and 2 along the entrainment at the contact point [m/s]."""
    sliding: float
    """Speed of body 1 relative to body 2 at the contact point [m/s]."""
    across: float
    """Part of the sliding across the entrainment, over the entrainment [-]."""

    @classmethod
    def of(cls, scene: Scene) -> "PatchFrame":
        """Axes of a contact; ValueError of one that entrains no oil."""
        size = scales(scene)
        here = np.zeros(())
        (u1, v1), (u2, v2) = (
            tuple(map(float, velocity)) for velocity in scene.velocities_at(here, here)
        )
        mean = (u1 + u2) / 2, (v1 + v2) / 2
        angle = float(np.arctan2(mean[1], mean[0]))
        c, s = cos(angle), sin(angle)
        across = (c * (v1 - v2) - s * (u1 - u2)) / hypot(*mean)
        return cls(
            scene, size, angle, (c * u1 + s * v1, c * u2 + s * v2), hypot(u1 - u2, v1 - v2), across
        )

    @property
    def entrainment(self) -> float:
        """Speed of entrainment [m/s]."""
        return sum(self.speeds) / 2

    @property
    def half_lengths(self) -> tuple[float, float]:
        """Half-lengths of Hertz's contact along the patch's axes [m]."""
        a, b = self.size.hertz.semi_axis_x, self.size.hertz.semi_axis_y
        c, s = cos(self.angle), sin(self.angle)
        return hypot(a * c, b * s), hypot(a * s, b * c)

    def grid(self, nodes: int) -> Grid:
        """The patch with a number of nodes along each side."""
        a, b = self.half_lengths
        dx, dy = (INLET + EXIT) * a / (nodes - 1), 2 * HALF_WIDTH * b / (nodes - 1)
        return Grid(-INLET * a, -HALF_WIDTH * b, dx, dy, nodes, nodes)

    def places(self, grid: Grid) -> tuple[Array, Array]:
        """Places of the nodes in the axes of the scene [m]."""
        x, y = grid.mesh()
        c, s = cos(self.angle), sin(self.angle)
        return c * x - s * y, s * x + c * y

    def gap(self, grid: Grid) -> tuple[Array, Flags]:
        """Undeformed gap [m] and where both surfaces exist, at the nodes."""
        return self.scene.gap(*self.places(grid))

    def film(self, grid: Grid) -> kernel.PointFilm:
        """A film of the contact on a grid of its patch, entrained along x."""
        gap, covered = self.gap(grid)
        entrained = np.full(grid.shape, self.entrainment), np.zeros(grid.shape)
        return kernel.PointFilm(
            gap,
            covered,
            entrained,
            grid.dx,
            grid.dy,
            self.scene.bending_modulus,
            self.scene.load,
            self.scene.oil,
            MIN_MOBILITY_FILM * self.size.film,
            self.scene.layers,
        )


@dataclass(frozen=True)
class SmoothFilm:
    """A steady film on a patch."""

    film: kernel.PointFilm
    """The film."""
    rise: Array | float
    """Mean temperature across the film over the inlet's [K]."""
    walls: tuple[Array | float, Array | float]
    """Temperature of both surfaces over the inlet's [K]."""
    residual: float
    """Its summed residual over the summed wedge flow."""


def smooth_film(
    frame: PatchFrame, oil: ShearedOil, solution: Solution | None, nodes: int
) -> SmoothFilm:
    """The steady film on a patch by nested iteration, at the temperatures of a solution with heat.

    RuntimeError if it does not converge.
    """
    count = nodes
    while count % 2 == 1 and count // 2 + 1 >= MIN_NODES:
        count = count // 2 + 1
    guess: tuple[Array, float] | None = None
    while True:
        grid = frame.grid(count)
        found, pressure, rigid_film = _on_grid(frame, oil, solution, grid, guess)
        if count == nodes:
            break
        finer = frame.grid(2 * count - 1)
        spline = scipy.interpolate.RectBivariateSpline(grid.x, grid.y, pressure, kx=1, ky=1)
        guess = np.maximum(spline(finer.x, finer.y), 0.0), rigid_film
        count = 2 * count - 1
    if not found.residual <= 100 * TOLERANCE:
        raise RuntimeError(
            f"the smooth film on the patch did not converge: its residual is {found.residual:.1e}"
        )
    return found


def _on_grid(
    frame: PatchFrame,
    oil: ShearedOil,
    solution: Solution | None,
    grid: Grid,
    guess: tuple[Array, float] | None,
) -> tuple[SmoothFilm, Array, float]:
    film = frame.film(grid)
    rise, walls = _temperatures(frame, solution, grid)
    if guess is None:
        pressure = _hertz(frame, grid)
        film.start(pressure, 0.0)
        middle = tuple(int(np.argmin(np.abs(axis))) for axis in (grid.x, grid.y))
        guess = pressure, frame.size.film - float(film.thickness()[middle])
    film.start(*guess)
    floor = MIN_MOBILITY_FILM * frame.size.film
    changes = solution is not None or oil.sliding > 0
    for _ in range(MAX_STEPS):
        if changes:
            film_now = np.maximum(film.thickness(), floor)
            set_fluidity(film, oil, rise, film_now)
            film.restart()
        if film.balance.worst <= TOLERANCE:
            break
        film.step(0.1)
    return (
        SmoothFilm(film, rise, walls, film.balance.worst),
        film.pressure,
        film.rigid_film,
    )


def set_fluidity(
    film: kernel.PointFilm,
    oil: ShearedOil,
    rise: Array | float,
    thickness: Array,
    pressure: Array | None = None,
) -> None:
    """Set the mobility of the warm, sheared oil at a film's pressure, or a given one, and its slopes."""
    pressure = film.pressure if pressure is None else pressure
    fluidity = oil.fluidity(pressure, rise, thickness)
    film.set_fluidity(fluidity, *oil.fluidity_slopes(pressure, rise, thickness, fluidity))


def _hertz(frame: PatchFrame, grid: Grid) -> Array:
    pressure = frame.size.hertz.pressure(*frame.places(grid))
    pressure = pressure + START_PRESSURE_RATIO * pressure.max()
    pressure[[0, -1], :] = pressure[:, [0, -1]] = 0.0
    scaled: Array = pressure * (frame.scene.load / (pressure.sum() * grid.cell))
    return np.asfortranarray(scaled)


def _temperatures(
    frame: PatchFrame, solution: Solution | None, grid: Grid
) -> tuple[Array | float, tuple[Array | float, Array | float]]:
    """Mean temperature across the film, by Simpson's rule, and that of both surfaces over the inlet's [K]."""
    if solution is None:
        return 0.0, (0.0, 0.0)
    fields = solution.fields
    x, y = fields["x"].values, fields["y"].values
    places = frame.places(grid)
    here = np.clip(places[0], x[0], x[-1]), np.clip(places[1], y[0], y[-1])
    inlet = frame.scene.oil.thermal.inlet_temperature
    rises = []
    for name in ("temperature_body_1", "temperature_body_2", "temperature_middle"):
        known = fields[name].transpose("x", "y").values.astype(float) - inlet
        spline = scipy.interpolate.RectBivariateSpline(x, y, known, kx=1, ky=1)
        rises.append(spline.ev(*here))
    first, second, middle = rises
    return (first + 4 * middle + second) / 6, (first, second)
