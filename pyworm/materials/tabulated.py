"""Viscosity and density of one's own: functions or measurements over pressure and temperature as tables.

The kernel evaluates a bicubic spline of the logarithm of the viscosity, and of the density, in cells of equal
size; both and their slopes are continuous. Beyond the last pressure the spline continues linearly, beyond the
last temperatures it stays.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from hashlib import sha256
from typing import TYPE_CHECKING, Any, ClassVar, Self

import numpy as np
import scipy

from pyworm.formulas.arrays import Array, Values
from pyworm.formulas.ranges import positive, scalar
from pyworm.io import units
from pyworm.io.given import Given, WithUnit, in_si, kind_of, number
from pyworm.io.quantity_text import as_text

Law = Callable[[Array, Array], Values]
"""Pressures [Pa], temperatures [K] -> values."""

PRESSURE_CELLS, WARMTH_CELLS = 192, 32
"""Cells of the kernel's table along pressure and temperature."""

LARGEST_PRESSURE = 3e9
"""Pressure to which a function is tabulated where nothing else is said [Pa]."""

COLDER, WARMER = 60.0, 240.0
"""Temperatures about the inlet's between which a function is tabulated where nothing else is said [K]."""


@dataclass(frozen=True)
class KernelTable:
    """A table as the kernel takes it (`fortran/oil/property_table.f90`)."""

    coefficient: Array
    """Coefficients of powers of pressure and temperature in each cell, shape (4, 4, cells, cells)."""
    cold: Array
    """Coefficients at the reference temperature, shape (4, cells)."""
    per_pressure: float
    """Cells for each pascal."""
    per_rise: float
    """Cells for each kelvin."""
    first_rise: float
    """Least temperature above the reference [K]."""


@dataclass(frozen=True, eq=False, repr=False)
class Tabulated(ABC):
    """A property at places of pressure and temperature."""

    pressures: Array
    """Increasing, the first of them ambient, which counts as zero [Pa]."""
    temperatures: Array
    """Increasing [K]; one of them is a property without a dependence on temperature."""
    values: Array
    """The property, shape (pressures, temperatures)."""
    reference: units.Temperature
    """Temperature at which the oil enters [K]."""

    KIND: ClassVar[Any]
    """Type of the property in `pyworm.io.units`."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI

        def __init__(
            self, pressures: Given, temperatures: Given, values: Given, reference: WithUnit
        ) -> None: ...

    def __post_init__(self) -> None:
        """Refuse what is no table."""
        kinds = {
            "pressures": units.PressureCoordinate,
            "temperatures": units.Temperature,
            "values": self.KIND,
        }
        for name, kind in kinds.items():
            given = in_si(name, getattr(self, name), kind)
            object.__setattr__(self, name, np.array(given, dtype=float))
        reference = in_si("reference", self.reference, units.Temperature)
        object.__setattr__(self, "reference", scalar("reference", reference))
        shape = self.pressures.size, self.temperatures.size
        if self.values.shape != shape:
            raise ValueError(
                f"values have the shape {self.values.shape}, but there are {shape[0]} pressures and "
                f"{shape[1]} temperatures"
            )
        for name, least in (("pressures", 4), ("temperatures", 1)):
            axis = getattr(self, name)
            increases = axis.ndim == 1 and np.isfinite(axis).all() and (np.diff(axis) > 0).all()
            if axis.size < least or not increases:
                raise ValueError(f"{name}: must be {least} or more numbers that increase")
        if not 0 <= self.pressures[0] <= AMBIENT:
            raise ValueError(
                f"pressures begin with {self.pressures[0]:g} Pa: must begin with ambient, 0 Pa"
            )
        positive("values", self.values, "")
        positive("reference", self.reference, "K")
        if shape[1] > 1 and not self.temperatures[0] <= self.reference <= self.temperatures[-1]:
            raise ValueError(
                f"reference = {self.reference:g} K: lies outside the temperatures, "
                f"{self.temperatures[0]:g} to {self.temperatures[-1]:g} K"
            )

    @abstractmethod
    def _write(self, values: Array) -> Array:
        """The property as it is written in the table."""

    @abstractmethod
    def _read(self, written: Array) -> Array:
        """The property of what is written."""

    @abstractmethod
    def _relative(self, written: Array) -> Array:
        """What is written, over that of the reference at ambient pressure."""

    @classmethod
    def of(
        cls,
        function: Law,
        reference: WithUnit,
        largest_pressure: WithUnit = LARGEST_PRESSURE,
        temperatures: Sequence[WithUnit] | None = None,
    ) -> Self:
        """The table of a function of pressure [Pa] and temperature [K], of arrays as of numbers.

        Oil enters at a `reference` temperature; beyond the largest pressure of the contact the table has
        none. ValueError for a value that is not finite and above zero.
        """
        reference = in_si("reference", reference, units.Temperature)
        largest_pressure = in_si("largest_pressure", largest_pressure, units.Pressure)
        if temperatures is None:
            temperatures = (reference - COLDER, reference + WARMER)
        low, high = in_si("temperatures", temperatures, units.Temperature)
        pressures = np.linspace(0.0, largest_pressure, PRESSURE_CELLS + 1)
        warmths = np.linspace(low, high, WARMTH_CELLS + 1)
        values = np.broadcast_to(
            function(pressures[:, np.newaxis], warmths[np.newaxis, :]),
            (pressures.size, warmths.size),
        )
        return cls(pressures, warmths, values, reference)

    def at(self, temperature: WithUnit) -> Self:
        """The property of an oil that enters at another temperature [K]."""
        return replace(self, reference=in_si("temperature", temperature, units.Temperature))

    def __call__(self, pressure: Given, rise: Given = 0.0) -> Any:
        """The property at pressures [Pa] and temperatures above the reference [K], as the kernel has it."""
        pressure = in_si("pressure", pressure, units.PressureCoordinate)
        rise = in_si("rise", rise, units.TemperatureRise)
        pressure, rise = np.broadcast_arrays(np.asarray(pressure, float), np.asarray(rise, float))
        last = self.pressures[-1]
        warm = np.clip(self.reference + rise, self.temperatures[0], self.temperatures[-1])
        warm = np.full(rise.shape, self.temperatures[0]) if self.temperatures.size == 1 else warm
        inside = np.clip(pressure, 0.0, last)
        written = self._spline.ev(inside, warm) + self._spline.ev(inside, warm, dx=1) * (
            pressure - inside
        )
        found = self._read(written)
        return found if found.ndim else float(found)

    @cached_property
    def _spline(self) -> "scipy.interpolate.RectBivariateSpline":
        """Spline of the property as it is written, over pressure and temperature."""
        pressures = self.pressures - self.pressures[0]
        warmths, values = self.temperatures, self._write(self.values)
        if warmths.size == 1:  # constant along temperature
            warmths = warmths[0] + np.array([0.0, 1.0])
            values = np.repeat(values, 2, axis=1)
        orders = min(3, pressures.size - 1), min(3, warmths.size - 1)
        return scipy.interpolate.RectBivariateSpline(
            pressures, warmths, values, kx=orders[0], ky=orders[1]
        )

    @cached_property
    def kernel_table(self) -> KernelTable:
        """The table for the kernel, over the same pressures and temperatures in equal cells."""
        single = self.temperatures.size == 1
        warmth_cells = 1 if single else WARMTH_CELLS
        low = self.reference if single else self.temperatures[0]
        high = low + 1.0 if single else self.temperatures[-1]
        step_p, step_t = self.pressures[-1] / PRESSURE_CELLS, (high - low) / warmth_cells
        pressures = step_p * np.arange(PRESSURE_CELLS + 1, dtype=np.float64)
        warmths = low + step_t * np.arange(warmth_cells + 1, dtype=np.float64)
        written = self._written(pressures[:, np.newaxis], warmths[np.newaxis, :])
        # a spline along pressure whose coefficients are splines along temperature, powers rising
        along_p = scipy.interpolate.CubicSpline(np.arange(pressures.size), written).c[::-1]
        if single:
            both = np.zeros((4, 1, 4, PRESSURE_CELLS))
            both[0, 0] = along_p[:, :, 0]
        else:
            both = scipy.interpolate.CubicSpline(np.arange(warmths.size), along_p, axis=2).c[::-1]
        place = (self.reference - low) / step_t
        cell = min(int(place), warmth_cells - 1)
        powers = (place - cell) ** np.arange(4)
        return KernelTable(
            np.asfortranarray(both.transpose(2, 0, 3, 1)),
            np.asfortranarray(np.tensordot(powers, both[:, cell], 1)),
            1 / step_p,
            1 / step_t,
            low - self.reference,
        )

    def _written(self, pressures: Array, warmths: Array) -> Array:
        """The property as it is written at places of the table, over that of the reference."""
        pressures, warmths = np.broadcast_arrays(pressures, warmths)
        if self.temperatures.size == 1:
            warmths = np.full(warmths.shape, self.temperatures[0])
        return self._relative(self._spline.ev(pressures, warmths))

    @property
    def _ambient(self) -> float:
        """The property at ambient pressure and the reference, as it is written."""
        temperature = self.temperatures[0] if self.temperatures.size == 1 else self.reference
        return float(self._spline.ev(0.0, temperature))

    @cached_property
    def digest(self) -> str:
        """Digest of the table."""
        digest = sha256(repr((type(self).__name__, self.reference)).encode())
        for array in (self.pressures, self.temperatures, self.values):
            digest.update(np.ascontiguousarray(array).tobytes())
        return digest.hexdigest()

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self.digest == other.digest

    def __hash__(self) -> int:
        return hash(self.digest)

    def __repr__(self) -> str:
        return (
            f"<{type(self).__name__} of {self.pressures.size} pressures to "
            f"{self.pressures[-1] / 1e9:.3g} GPa and "
            f"{self.temperatures.size} temperatures, {as_text(self(0.0), kind_of(self.KIND))} at "
            f"{as_text(self.reference, kind_of(units.Temperature))}>"
        )


AMBIENT = 1e6
"""Largest pressure that counts as ambient [Pa]: viscosity changes by a few per cent in 1 MPa."""


class TabulatedViscosity(Tabulated):
    """Viscosity [Pa s] by a function or by measurements, `TabulatedViscosity.of(function, inlet)`."""

    KIND = units.Viscosity

    @property
    def eta0(self) -> float:
        """Viscosity at ambient pressure and the reference [Pa s]."""
        return float(np.exp(self._ambient))

    @property
    def alpha(self) -> float:
        """Pressure-viscosity coefficient at ambient pressure and the reference [1/Pa]."""
        temperature = self.temperatures[0] if self.temperatures.size == 1 else self.reference
        return float(self._spline.ev(0.0, temperature, dx=1))

    def with_eta0(self, eta0: WithUnit) -> Self:
        """The property of another viscosity at ambient pressure and the reference [Pa s], of one alpha."""
        given = number("eta0", eta0, kind_of(units.Viscosity))
        return replace(self, values=self.values * (given / self.eta0))

    def with_alpha_times(self, factor: float) -> Self:
        """The property whose logarithm rises some times as steeply with pressure, eta0 being kept."""
        ambient = self.values[:1]
        return replace(self, values=ambient * (self.values / ambient) ** factor)

    def _write(self, values: Array) -> Array:
        return np.log(values)

    def _read(self, written: Array) -> Array:
        read: Array = np.exp(written)
        return read

    def _relative(self, written: Array) -> Array:
        return written - self._ambient


class TabulatedDensity(Tabulated):
    """Density [kg/m3] by a function or by measurements, `TabulatedDensity.of(function, inlet)`."""

    KIND = units.OilDensity

    @property
    def rho0(self) -> float:
        """Density at ambient pressure and the reference [kg/m3]."""
        return self._ambient

    def with_rho0(self, rho0: WithUnit) -> Self:
        """The property of another density at ambient pressure and the reference [kg/m3]."""
        given = number("rho0", rho0, kind_of(units.OilDensity))
        return replace(self, values=self.values * (given / self.rho0))

    @property
    def d1(self) -> float:
        """Compressibility at ambient pressure [1/Pa]."""
        temperature = self.temperatures[0] if self.temperatures.size == 1 else self.reference
        return float(self._spline.ev(0.0, temperature, dx=1)) / self._ambient

    def _write(self, values: Array) -> Array:
        return values

    def _read(self, written: Array) -> Array:
        return written

    def _relative(self, written: Array) -> Array:
        return written / self._ambient
