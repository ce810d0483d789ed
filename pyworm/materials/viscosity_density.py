"""Viscosity and density of oils against pressure.

The published variants of each law differ only in the constants that the constructors here fill in.
"""

from dataclasses import dataclass
from math import exp, inf, log
from typing import Any

import numpy as np

from pyworm.formulas.oil_properties import ROELANDS_POLE_LOG, ROELANDS_POLE_TEMPERATURE
from pyworm.formulas.ranges import positive, within
from pyworm.io import units
from pyworm.io.given import Given, in_si, kind_of, number, take
from pyworm.io.shown import ShownFields

ROELANDS_PRESSURE = 1.96e8
"""Pole pressure [Pa] of Roelands' law in its usual rounding (Roelands 1966)."""

ROELANDS_PRESSURE_COEFFICIENT = 5.1e-9
"""Reciprocal pole pressure [1/Pa] in the form of Sharif et al. (2001), equation 20."""

LARGEST_ALPHA = 1e-6
"""Largest pressure-viscosity coefficient [1/Pa]: a tenfold viscosity in some MPa."""

LARGEST_Z = 1e6
"""Largest exponent of Roelands' law [-]; that of oils is around 0.6."""


@dataclass(frozen=True, repr=False)
class Barus(ShownFields):
    """Barus' law, eta = eta0 exp(alpha p); alpha = 0 is an isoviscous oil."""

    eta0: units.Viscosity
    """Viscosity at ambient pressure [Pa s]."""
    alpha: units.PressureViscosityOrZero
    """Pressure-viscosity coefficient [1/Pa]."""

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        take(self, sizes=False)  # a law that is warmed may thin beyond what an oil has
        number("alpha", self.alpha, kind_of(units.PressureViscosityOrZero))
        positive("eta0", self.eta0, "Pa s")
        within("alpha", self.alpha, 0, LARGEST_ALPHA, "1/Pa")

    def __call__(self, pressure: Given) -> Any:
        """Viscosity [Pa s] at a pressure or pressures [Pa]."""
        pressure = in_si("pressure", pressure, units.PressureCoordinate)
        return self.eta0 * np.exp(self.alpha * pressure)


@dataclass(frozen=True, repr=False)
class Roelands(ShownFields):
    """Roelands' law, eta = eta0 exp{(ln eta0 + 9.67) [(1 + p/p0)^z - 1]} (Roelands 1966)."""

    eta0: units.Viscosity
    """Viscosity at ambient pressure [Pa s]."""
    z: float
    """Pressure exponent [-]."""
    p0: units.Pressure = ROELANDS_PRESSURE
    """Pole pressure [Pa]."""

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        take(self, sizes=False)  # likewise
        positive("eta0", self.eta0, "Pa s")
        if self.eta0 <= exp(-ROELANDS_POLE_LOG):
            raise ValueError(
                f"eta0 = {self.eta0:g} Pa s: must be above {exp(-ROELANDS_POLE_LOG):.2g} Pa s, the pole of "
                "Roelands' law"
            )
        within("z", self.z, 0, LARGEST_Z, "")
        positive("p0", self.p0, "Pa")

    @classmethod
    def from_alpha(
        cls, eta0: float | str, alpha: float | str, p0: float | str = ROELANDS_PRESSURE
    ) -> "Roelands":
        """The law whose slope at p = 0 is Barus' alpha [1/Pa]: z = alpha p0 / (ln eta0 + 9.67)."""
        eta0 = number("eta0", eta0, kind_of(units.Viscosity))
        alpha = number("alpha", alpha, kind_of(units.PressureViscosityOrZero))
        p0 = number("p0", p0, kind_of(units.Pressure))
        return cls(eta0, alpha * p0 / (log(eta0) + ROELANDS_POLE_LOG), p0)

    @property
    def alpha(self) -> float:
        """Pressure-viscosity coefficient at p = 0 [1/Pa]."""
        return self.z * (log(self.eta0) + ROELANDS_POLE_LOG) / self.p0

    def s0(self, beta: float | str, temperature: float | str) -> float:
        """Exponent of temperature [-] by which -d ln eta/dT is beta [1/K] at p = 0 and a temperature [K]."""
        beta = in_si("beta", beta, units.TemperatureCoefficient)
        temperature = in_si("temperature", temperature, units.Temperature)
        return (
            beta * (temperature - ROELANDS_POLE_TEMPERATURE) / (log(self.eta0) + ROELANDS_POLE_LOG)
        )

    def __call__(self, pressure: Given) -> Any:
        """Viscosity [Pa s] at a pressure or pressures [Pa]."""
        pressure = in_si("pressure", pressure, units.PressureCoordinate)
        rise = (log(self.eta0) + ROELANDS_POLE_LOG) * ((1 + pressure / self.p0) ** self.z - 1)
        return self.eta0 * np.exp(rise)


@dataclass(frozen=True, repr=False)
class Density(ShownFields):
    """Density law rho = rho0 [1 + d1 p / (1 + d2 p)] (Dowson and Higginson 1966)."""

    rho0: units.OilDensity
    """Density at ambient pressure [kg/m3]."""
    d1: units.PressureCoefficientOrZero
    """Coefficient [1/Pa]; d1 = 0 is an incompressible oil."""
    d2: units.PressureCoefficientOrZero
    """Coefficient [1/Pa]."""

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        take(self)
        positive("rho0", self.rho0, "kg/m3")
        within("d1, d2", [self.d1, self.d2], 0, inf, "1/Pa")

    @classmethod
    def incompressible(cls, rho0: float | str) -> "Density":
        """Constant density."""
        return cls(in_si("rho0", rho0, units.OilDensity), 0.0, 0.0)

    @classmethod
    def dowson_higginson(cls, rho0: float | str) -> "Density":
        """The form 1 + 0.6e-9 p / (1 + 1.7e-9 p)."""
        return cls(in_si("rho0", rho0, units.OilDensity), 0.6e-9, 1.7e-9)

    @classmethod
    def dowson_higginson_pole(cls, rho0: float | str) -> "Density":
        """The form (5.9e8 + 1.34 p) / (5.9e8 + p): close to the other, not identical."""
        return cls(in_si("rho0", rho0, units.OilDensity), 0.34 / 5.9e8, 1 / 5.9e8)

    def __call__(self, pressure: Given) -> Any:
        """Density [kg/m3] at a pressure or pressures [Pa]."""
        pressure = in_si("pressure", pressure, units.PressureCoordinate)
        return self.rho0 * (1 + self.d1 * pressure / (1 + self.d2 * pressure))
