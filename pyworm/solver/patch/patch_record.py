"""Figures of a rough patch, at each time and as means."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.planning.grid import Grid
from pyworm.solver.patch.heat import PatchHeat
from pyworm.solver.patch.smooth_film import PatchFrame, SmoothFilm
from pyworm.solver.patch.stepping import PatchState

CENTRAL = 0.5
"""Radius within which the mean film is taken, in half-axes of Hertz's contact."""

COUNTED_PRESSURE = 0.01
"""Pressure over the maximum above which friction counts, as everywhere."""

TOUCHING = 1e-9
"""Film below which surfaces count as touching [m]: about one molecule of oil."""

SUMMARY = {
    "film_mean_m": "film_mean",
    "film_min_m": "film_min",
    "asperity_load_fraction": "touching_load",
    "friction_coefficient": "friction",
    "pressure_max_Pa": "pressure_max",
}
"""Key of the summary -> figure of a record."""


@dataclass(frozen=True)
class PatchRecord:
    """Figures of a patch at one time."""

    time: float
    """Time [s]."""
    film_mean: float
    """Mean film within half the half-axes [m]."""
    film_central: float
    """Film at the node nearest to the contact point [m]."""
    film_min: float
    """Minimum film in the contact [m], zero where the residual leaves an overlap."""
    touching_load: float
    """Share of the load where films are below 1 nm [-]."""
    friction: float
    """Friction coefficient [-]."""
    temperatures: tuple[float, float, float]
    """Maximum temperature of both surfaces and of the mean across the film [K]; without heat the inlet's."""
    pressure_max: float
    """Maximum pressure [Pa]."""
    residual: float
    """Summed mass error over the summed wedge flow of the smooth film."""
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


@dataclass(frozen=True, repr=False)
class RoughPatch:
    """Rough surfaces that moved through a contact; see `rough_patch`."""

    grid: Grid
    """Nodes: x along the entrainment, the contact point at the origin."""
    smooth: PatchRecord
    """Figures of the smooth film on the same nodes."""
    records: tuple[PatchRecord, ...]
    """Figures after each step."""
    last: PatchState
    """Fields at the end."""
    smooth_film: Array
    """Film of smooth surfaces at the nodes [m]."""
    smooth_pressure: Array
    """Pressure between smooth surfaces at the nodes [Pa]."""
    taken_from: float
    """Time from which means are taken [s]."""
    step: float
    """Time step [s]."""
    shortest_wave: float
    """Wavelength below which a twentieth of the variance of the heights lies, over the spacing [-]."""
    converged: bool
    """Whether all time steps converged."""
    seconds: float
    """Wall time of the time steps [s]."""
    cpu_seconds: float
    """CPU time of the time steps [s]."""

    def mean(self, name: str) -> tuple[float, float]:
        """Mean over time of a figure of `PatchRecord`, and its standard deviation."""
        values = [getattr(known, name) for known in self.records if known.time >= self.taken_from]
        return float(np.mean(values)), float(np.std(values))

    def summary(self) -> dict[str, Any]:
        """Means over time as one object, units in the keys, with their standard deviations."""
        means = {key: self.mean(name) for key, name in SUMMARY.items()}
        first, second, film = self.mean_temperatures()
        return {
            **{key: mean for key, (mean, _) in means.items()},
            "temperature_max_body_1_C": first - ZERO_CELSIUS,
            "temperature_max_body_2_C": second - ZERO_CELSIUS,
            "temperature_mean_max_film_C": film - ZERO_CELSIUS,
            "deviation": {key: deviation for key, (_, deviation) in means.items()},
            "smooth_film_mean_m": self.smooth.film_mean,
            "smooth_friction_coefficient": self.smooth.friction,
            "mass_error": max(known.residual for known in self.records),
            "load_error": max(abs(known.load_error) for known in self.records),
            "mass_added": max(known.added for known in self.records),
            "converged": self.converged,
            "nodes": list(self.grid.shape),
            "time_steps": len(self.records),
            "time_step_s": self.step,
            "seconds": self.seconds,
        }

    def mean_temperatures(self) -> tuple[float, float, float]:
        """Means over time of the maximum temperatures [K]."""
        values = [known.temperatures for known in self.records if known.time >= self.taken_from]
        first, second, film = (float(value) for value in np.mean(values, axis=0))
        return first, second, film


class PatchReader:
    """Reads the figures of a patch."""

    def __init__(self, frame: PatchFrame, grid: Grid, smooth: SmoothFilm):
        self._frame, self._grid, self._smooth = frame, grid, smooth
        x, y = frame.places(grid)
        hertz = frame.size.hertz
        radius = np.hypot(x / hertz.semi_axis_x, y / hertz.semi_axis_y)
        nearest = np.unravel_index(np.argmin(radius), radius.shape)
        self._middle = int(nearest[0]), int(nearest[1])
        self._central, self._inside = radius < CENTRAL, radius < 1
        self._inlet = frame.scene.oil.heat.inlet_temperature if frame.scene.oil.heat else 0.0

    def smooth(self, heat: PatchHeat) -> PatchRecord:
        """Figures of the smooth film."""
        film = self._smooth.film
        state = PatchState(
            0.0, film.thickness(), film.pressure, np.zeros(self._grid.shape), heat.present,
            self._smooth.residual, film.balance.load_error, 0.0, 1, 0, 0,
        )  # fmt: skip
        return self(state)

    def __call__(self, state: PatchState) -> PatchRecord:
        """Figures of a state."""
        pressure, load, cell = state.pressure, self._frame.scene.load, self._grid.cell
        counted = pressure > COUNTED_PRESSURE * pressure.max()
        touching = self._inside & (state.film < TOUCHING)
        sliding = self._frame.sliding > 0
        rises = *state.shear.walls, state.shear.rise
        first, second, film = (
            self._inlet + float(np.max(np.where(self._inside, rise, -np.inf))) for rise in rises
        )
        return PatchRecord(
            state.time,
            float(state.film[self._central].mean()),
            float(state.film[self._middle]),
            max(float(state.film[self._inside].min()), 0.0),
            float(pressure[touching].sum() * cell / load),
            float(state.shear.stress[counted].sum() * cell / load) if sliding else 0.0,
            (first, second, film),
            float(pressure.max()),
            state.residual,
            state.load_error,
            state.added,
            state.parts,
            state.newton,
            state.krylov,
        )
