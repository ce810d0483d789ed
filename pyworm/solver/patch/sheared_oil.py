"""Viscosity and shear stress of an oil at many nodes at once, from tables of its laws."""

from dataclasses import dataclass
from math import log

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.materials.oil import Oil

MAX_PRESSURE, PRESSURES = 4e9, 161
"""Largest pressure of the tables [Pa] and number of pressures: summits of steel yield before it."""

COLDEST, HOTTEST, RISES = -20.0, 400.0, 85
"""Range of the rise over the inlet's temperature [K], and number of rises."""

STRESSES = (1e2, 1e20, 361)
"""Least and largest Newtonian stress, viscosity times shear rate [Pa], and their number."""

MIN_SLOPE = 0.05
"""Least slope of the logarithm of stress by that of shear rate, which vanishes at a limiting stress.

An Eyring oil has less only where the Newtonian stress is 1e8 times its own.
"""

PRESSURE_STEP, FILM_STEP = 1e6, 1e-3
"""Steps of pressure [Pa] and film over the film by which slopes are found."""


@dataclass(frozen=True)
class Table:
    """A function of two arguments by bilinear interpolation, constant beyond its ends."""

    values: Array
    """Values, the first argument along the first axis."""
    first: tuple[float, float]
    """First value of each argument."""
    step: tuple[float, float]
    """Steps of both."""

    def __call__(self, a: Array, b: Array) -> Array:
        """Values at arguments of the same shape."""
        (n, m), flat = self.values.shape, self.values.ravel()
        i, part_a = _places(a, self.first[0], self.step[0], n)
        j, part_b = _places(b, self.first[1], self.step[1], m)
        k = i * m + j
        low = flat[k] * (1 - part_b) + flat[k + 1] * part_b
        high = flat[k + m] * (1 - part_b) + flat[k + m + 1] * part_b
        found: Array = low * (1 - part_a) + high * part_a
        return found


def _places(x: Array, first: float, step: float, count: int) -> tuple[Array, Array]:
    place = np.clip((x - first) / step, 0.0, count - 1.0)
    whole = np.minimum(place.astype(np.int32), count - 2)
    return whole, place - whole


class ShearedOil:
    """An oil at nodes of given pressure [Pa], rise over the inlet's temperature [K] and film [m].

    ValueError of an oil whose flow law's stress follows the temperature.
    """

    def __init__(self, oil: Oil, sliding: float):
        self.oil, self.sliding = oil, abs(sliding)
        pressures = np.linspace(0.0, MAX_PRESSURE, PRESSURES)
        rises = np.linspace(COLDEST, HOTTEST, RISES) if oil.heat else np.array([0.0, 1.0])
        step = pressures[1], float(rises[1] - rises[0])
        log_eta = [
            [log(oil.eta(p, rise if oil.heat else 0.0)) for rise in rises] for p in pressures
        ]
        self._log_eta = Table(np.array(log_eta), (0.0, float(rises[0])), step)
        self._log_thinning: Table | None = None
        self._log_slope: Table | None = None
        if self.sliding > 0 and oil.flow is not None and oil.flow.thins:
            if oil.flow.stress_temperature:
                raise ValueError(
                    "stress_temperature: a resolved patch takes no stress that follows temperature"
                )
            newtonian = np.geomspace(*STRESSES)
            log_ratio = [
                [log(oil.flow.stress_at(s, p) / s) for s in newtonian] for p in pressures[::4]
            ]
            first = 0.0, log(newtonian[0])
            steps = float(pressures[4]), float(np.diff(np.log(newtonian[:2]))[0])
            self._log_thinning = Table(np.array(log_ratio), first, steps)
            slope = 1 + np.gradient(np.array(log_ratio), steps[1], axis=1)
            self._log_slope = Table(np.log(np.maximum(slope, MIN_SLOPE)), first, steps)

    def log_viscosity(self, pressure: Array, rise: Array | float) -> Array:
        """Logarithm of the viscosity [Pa s] at rest."""
        rises = np.broadcast_to(np.asarray(rise, dtype=float), pressure.shape)
        return self._log_eta(pressure, rises)

    def stress(self, pressure: Array, rise: Array | float, film: Array) -> Array:
        """Shear stress [Pa]."""
        newtonian = np.exp(self.log_viscosity(pressure, rise)) * (self.sliding / film)
        if self._log_thinning is None:
            return newtonian
        place = np.log(np.maximum(newtonian, STRESSES[0]))
        stress: Array = newtonian * np.exp(self._log_ratio(pressure, place))
        return stress

    def _log_ratio(self, pressure: Array, newtonian: Array) -> Array:
        """Logarithm of the stress over that of a Newtonian oil, of which the logarithm is given."""
        assert self._log_thinning is not None
        # beyond the table, where summits meet, the stress of its end
        beyond = np.maximum(newtonian - log(STRESSES[1]), 0.0)
        found: Array = self._log_thinning(pressure, newtonian) - beyond
        return found

    def fluidity(self, pressure: Array, rise: Array | float, film: Array) -> Array:
        """Mobility along the sliding over that of the oil at its inlet's temperature at rest [-].

        Pressure along the sliding meets the viscosity d(stress)/d(rate) (Hooke 2000), less than stress/rate.
        """
        cold = self.log_viscosity(pressure, 0.0)
        warm = self.log_viscosity(pressure, rise)
        if self._log_slope is None:
            return np.exp(cold - warm)
        newtonian = warm + np.log(self.sliding / film)
        thinned = self._log_ratio(pressure, newtonian) + self._log_slope(pressure, newtonian)
        fluidity: Array = np.exp(cold - warm - thinned)
        return fluidity

    def fluidity_slopes(
        self, pressure: Array, rise: Array | float, film: Array, fluidity: Array
    ) -> tuple[Array, Array]:
        """Slopes of the logarithm of the fluidity by pressure [1/Pa] and film [1/m], by differences."""
        here = np.log(fluidity)
        by_pressure = np.log(self.fluidity(pressure + PRESSURE_STEP, rise, film)) - here
        by_film = np.log(self.fluidity(pressure, rise, film * (1 + FILM_STEP))) - here
        return by_pressure / PRESSURE_STEP, by_film / (FILM_STEP * film)

    def conductivity(self, pressure: Array) -> Array:
        """Thermal conductivity [W/(m K)]; that of an oil with heat."""
        heat = self.oil.thermal
        growth = heat.conductivity_c1 * pressure / (1 + heat.conductivity_c2 * pressure)
        conductivity: Array = heat.conductivity * (1 + growth)
        return conductivity
