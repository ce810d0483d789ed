"""Heat of a rough patch: what it adds to the temperatures of the smooth film, once a time step."""

from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Array, Flags
from pyworm.planning.grid import Grid
from pyworm.solver.patch.flash_heat import HeatedSurface, wall_fluxes
from pyworm.solver.patch.sheared_oil import ShearedOil
from pyworm.solver.patch.smooth_film import PatchFrame, SmoothFilm


@dataclass(frozen=True)
class PatchShear:
    """Shear and temperatures of a patch at one time."""

    stress: Array
    """Shear stress [Pa]."""
    rise: Array | float
    """Mean temperature across the film over the inlet's [K]."""
    walls: tuple[Array | float, Array | float]
    """Temperatures of both surfaces over the inlet's [K]."""


class PatchHeat:
    """Temperatures of a rough patch as it moves on; those of the smooth film where oil is simulated cold."""

    def __init__(
        self,
        frame: PatchFrame,
        oil: ShearedOil,
        smooth: SmoothFilm,
        grid: Grid,
        step: float,
        whole: float,
        heated: bool,
    ):
        self.oil, self.smooth = oil, smooth
        pressure, film = smooth.film.pressure, smooth.film.thickness()
        self._smooth_stress = oil.stress(pressure, smooth.rise, film)
        self.present = PatchShear(self._smooth_stress, smooth.rise, smooth.walls)
        self.heated = heated and oil.sliding > 0
        if not self.heated:
            return
        self._smooth_heat = self._smooth_stress * oil.sliding
        self._smooth_resistance = film / oil.conductivity(pressure)
        self._surfaces = tuple(
            HeatedSurface(body.thermal_inertia, speed, grid.dx, step, whole, grid.shape)
            for body, speed in zip(frame.scene.bodies, frame.speeds, strict=True)
        )

    def advance(self, pressure: Array, film: Array, boundary: Flags, friction: float) -> PatchShear:
        """Shear after a time step, from the temperatures before it; then the temperatures of the step.

        `boundary` is true where surfaces touch, whose shear stress is `friction` times the pressure.
        """
        stress = self.oil.stress(pressure, self.present.rise, film)
        stress = np.where(boundary, friction * pressure, stress)
        if not self.heated:
            self.present = PatchShear(stress, self.smooth.rise, self.smooth.walls)
            return self.present
        heat = stress * self.oil.sliding
        resistance = film / self.oil.conductivity(pressure)
        first, second = self._surfaces
        history = first.history(), second.history()
        apart = self.smooth.walls[1] - self.smooth.walls[0]
        fluxes = wall_fluxes(
            heat - self._smooth_heat,
            1 / resistance,
            history,
            (first.present, second.present),
            (1 / resistance - 1 / self._smooth_resistance) * apart,
        )
        changes = []
        for surface, rise, flux in zip(self._surfaces, history, fluxes, strict=True):
            surface.absorb(flux)
            changes.append(rise + surface.present * flux)
        # heat that arises evenly across the film warms its mean by q h/(12 k) over the surfaces
        within = (heat * resistance - self._smooth_heat * self._smooth_resistance) / 12
        rise = self.smooth.rise + (changes[0] + changes[1]) / 2 + within
        walls = tuple(
            known + change for known, change in zip(self.smooth.walls, changes, strict=True)
        )
        self.present = PatchShear(stress, rise, (walls[0], walls[1]))
        return self.present
