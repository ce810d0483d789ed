"""Time steps of a rough patch along the path of the oil.

Reynolds' equation between surfaces of equal entrainment u is, along paths x - u t = const,

    D(rho h)/Dt - div(rho h^3 / (12 eta) grad p) = 0.                                              (1)

With the steady film between smooth surfaces, rho_s h_s, for which u d(rho_s h_s)/dx = s is known, what is
followed is q = rho h - rho_s h_s, by the backward differences of second order

    (3/2 q(x, t) - 2 q(x - u dt, t - dt) + 1/2 q(x - 2 u dt, t - 2 dt))/dt + s - div(...) = 0.     (2)

A step is u dt = `stride` nodes: nothing is interpolated, so waves cross the contact without numerical damping
where viscous oil only carries them, and smooth surfaces keep their steady film exactly.
"""

from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.planning.grid import Grid
from pyworm.solver.patch.heat import PatchHeat, PatchShear
from pyworm.solver.patch.moving_heights import MovingHeights
from pyworm.solver.patch.newton import Balances, PatchNewton
from pyworm.solver.patch.sheared_oil import ShearedOil
from pyworm.solver.patch.smooth_film import PatchFrame, SmoothFilm, set_fluidity


@dataclass(frozen=True)
class PatchState:
    """A rough patch at one time."""

    time: float
    """Time [s]."""
    film: Array
    """Film thickness [m]."""
    pressure: Array
    """Pressure [Pa]."""
    roughness: Array
    """Heights of both surfaces together [m]."""
    shear: PatchShear
    """Shear and temperatures."""
    residual: float
    """Summed residual over the summed wedge flow of the smooth film."""
    load_error: float
    """Missing load over the load."""
    added: float
    """Mass added where none arrived, over that in the contact."""
    parts: int
    """Parts in which the change of the step was made."""
    newton: int
    """Newton steps."""
    krylov: int
    """GMRES iterations."""


class PatchStepping:
    """A rough patch that is moved step by step."""

    def __init__(
        self,
        frame: PatchFrame,
        oil: ShearedOil,
        smooth: SmoothFilm,
        grid: Grid,
        surfaces: tuple[MovingHeights | None, MovingHeights | None],
        heat: PatchHeat,
        stride: int,
        tolerance: float,
        touching: float,
    ):
        self._frame, self._oil, self._smooth, self._grid = frame, oil, smooth, grid
        self._surfaces, self._heat, self._stride = surfaces, heat, stride
        self._touching = touching
        self.step = stride * grid.dx / frame.entrainment
        self._gap, _ = frame.gap(grid)
        film, density, imbalance = smooth.film.fields()
        self._mass = film * density
        self._film = frame.film(grid)
        self._film.transport()
        set_fluidity(self._film, oil, smooth.rise, smooth.film.thickness(), smooth.film.pressure)
        self._film.set_transient_term(0.0, np.zeros(grid.shape))
        self._film.start(smooth.film.pressure, smooth.film.rigid_film)
        self._wedge = imbalance - self._film.fields()[2]
        scale = float(np.abs(self._wedge).sum())
        self._newton = PatchNewton(self._film, oil, tolerance, touching, scale)
        self._contact = smooth.film.pressure > 0
        self.time = 0.0
        self._rough = self._heights(0.0)
        self._before = -self._rough, 0.0
        self._earlier: tuple[Array, float] | None = None
        self._pressure = smooth.film.pressure
        self._rigid_film = smooth.film.rigid_film

    def _heights(self, time: float, west: int = 0) -> Array:
        """Heights of both surfaces together [m] at the nodes, or at a number of places before the patch."""
        x = self._grid.x
        if west:
            x = x[0] + self._grid.dx * np.arange(-west, 0)
        shown = np.zeros((len(x), self._grid.ny))
        for surface in self._surfaces:
            if surface is not None:
                shown += surface.at(x, time, self._grid.dx)
        return shown

    def _followed(self, change: Array, time: float, nodes: int) -> Array:
        """Change of mass at a time where the oil at each node was then: some nodes before it."""
        followed = np.empty_like(change)
        followed[nodes:] = change[:-nodes]
        # before the patch oil without pressure: the heights and the deflection at its first nodes
        lifted = change[0] + self._heights(time)[0]
        followed[:nodes] = lifted - self._heights(time, west=nodes)
        return followed

    def advance(self) -> PatchState:
        """Make a time step; RuntimeError if its film is not found."""
        step, stride = self.step, self._stride
        self.time += step
        change, time = self._before
        if self._earlier is None:
            rate, arrived = 1 / step, self._followed(change, time, stride) / step
        else:
            earlier = self._followed(*self._earlier, 2 * stride)
            rate = 1.5 / step
            arrived = (2 * self._followed(change, time, stride) - 0.5 * earlier) / step
        given = rate * self._mass + arrived - self._wedge
        least = rate * LEAST_MASS * self._touching
        added = np.where(self._contact & (given < least), least - given, 0.0)
        given += added
        rough = self._heights(self.time)
        found = self._newton.solve(
            Balances(self._gap - rough, rate, given),
            self._gap - self._rough,
            (self._pressure, self._rigid_film),
            self._heat.present.rise,
        )
        self._rough = rough
        film, density, _ = self._film.fields()
        self._earlier = self._before
        self._before = _without_noise(film * density - self._mass), self.time
        self._pressure, self._rigid_film = found.pressure, found.rigid_film
        boundary = self._contact & (film < self._touching) & (self._pressure > 0)
        open_film = np.maximum(film, self._touching)
        shear = self._heat.advance(
            self._pressure, open_film, boundary, self._frame.scene.oil.boundary_friction
        )
        return PatchState(
            self.time,
            film,
            self._pressure,
            rough,
            shear,
            found.residual,
            self._film.balance.load_error,
            float(added.sum() / (rate * self._mass[self._contact].sum())),
            found.parts,
            found.newton,
            found.krylov,
        )


def _without_noise(change: Array) -> Array:
    """A field without waves of two nodes, which oil carries undamped: of n nodes 1 - sin(pi/n)^8 is left."""
    for axis in (0, 1):
        noise = change
        for _ in range(NOISE_ORDER // 2):
            inner = [slice(1, -1) if other == axis else slice(None) for other in (0, 1)]
            second = np.zeros_like(noise)
            second[tuple(inner)] = np.diff(noise, 2, axis=axis) / 4
            noise = second
        change = change - noise
    return change


NOISE_ORDER = 8
"""Order of the differences that count as noise: waves of eight nodes keep 0.9995 in a step."""

LEAST_MASS = 0.1
"""Least mass that arrives at a node over the film at which surfaces count as touching: extrapolation in time
may leave none."""
