"""Viscosity and density of oils against pressure.

The published variants of each law differ only in the constants that the constructors here fill in. A law of
viscosity is here and in `fortran/oil/viscosity_density.f90`, and nowhere else: by `VISCOSITY_LAWS` case files
and the kernel have it.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from math import exp, inf, log
from typing import TYPE_CHECKING, Any, ClassVar, Self

import numpy as np

from pyworm.formulas.oil_properties import ROELANDS_POLE_LOG, ROELANDS_POLE_TEMPERATURE
from pyworm.formulas.ranges import positive, within
from pyworm.io import units
from pyworm.io.given import Given, WithUnit, in_si, kind_of, number, take
from pyworm.io.shown import ShownFields

ROELANDS_PRESSURE = 1.96e8
"""Pole pressure [Pa] of Roelands' law in its usual rounding (Roelands 1966)."""

LARGEST_ALPHA = 1e-6
"""Largest pressure-viscosity coefficient [1/Pa]: a tenfold viscosity in some MPa."""

LARGEST_Z = 1e6
"""Largest exponent of Roelands' law [-]; that of oils is around 0.6."""


@dataclass(frozen=True, repr=False)
class ViscosityLaw(ShownFields, ABC):
    """Viscosity over pressure by constants, which the kernel computes itself; temperature is `Thinning`'s."""

    CASE_NAME: ClassVar[str]
    """`law` of `[oil.viscosity]`."""
    KERNEL_NUMBER: ClassVar[int]
    """Its number in `fortran/oil/viscosity_density.f90`."""
    THINNING: ClassVar["Thinning"]
    """How temperature thins it."""

    eta0: units.Viscosity
    """Viscosity at ambient pressure [Pa s]."""

    if TYPE_CHECKING:  # a field of one law, a property of another

        @property
        def alpha(self) -> float:
            """Pressure-viscosity coefficient at p = 0 [1/Pa]."""

    @property
    @abstractmethod
    def kernel_constants(self) -> tuple[float, float]:
        """The kernel's `exponent` and `pole_pressure`."""

    @abstractmethod
    def __call__(self, pressure: Given) -> Any:
        """Viscosity [Pa s] at a pressure or pressures [Pa]."""

    @abstractmethod
    def with_eta0(self, eta0: WithUnit) -> Self:
        """The law of another viscosity at ambient pressure [Pa s], alpha being kept."""

    @abstractmethod
    def with_alpha_times(self, factor: float) -> Self:
        """The law of another alpha, eta0 being kept."""


class Thinning:
    """What temperature does: eta exp(-beta (T - T0)), beta [1/K] the `viscosity_exponent` of `OilHeat`."""

    has_s0: ClassVar[bool] = False
    """Whether that constant is Roelands' s0 instead."""

    def viscosity(
        self, law: Any, pressure: float, rise: float, exponent: float, inlet: float
    ) -> float:
        """Viscosity [Pa s] at a pressure [Pa] and a temperature [K] above the inlet's [K]."""
        eta: float = law(pressure) * exp(-exponent * rise)
        return eta

    def beta(self, law: Any, exponent: float, inlet: float) -> float:
        """-d ln eta/dT [1/K] at p = 0 and the inlet's temperature [K]."""
        return exponent

    def exponent(self, law: Any, beta: float, inlet: float) -> float:
        """The constant of which that is beta."""
        return beta


class RoelandsThinning(Thinning):
    """Roelands: (1 + p/p0)^z times ((T - 138 K)/(T0 - 138 K))^-s0 (Sharif et al. 2001, equation 20)."""

    has_s0 = True

    def viscosity(
        self, law: Any, pressure: float, rise: float, exponent: float, inlet: float
    ) -> float:
        """Viscosity [Pa s] at a pressure [Pa] and a temperature [K] above the inlet's [K]."""
        span = log(law.eta0) + ROELANDS_POLE_LOG
        ratio = 1 + rise / (inlet - ROELANDS_POLE_TEMPERATURE)
        warmed = (1 + pressure / law.p0) ** law.z * ratio**-exponent
        eta: float = law.eta0 * exp(span * (warmed - 1))
        return eta

    def beta(self, law: Any, exponent: float, inlet: float) -> float:
        """-d ln eta/dT [1/K] at p = 0 and the inlet's temperature [K]."""
        span = inlet - ROELANDS_POLE_TEMPERATURE
        return exponent * ((log(law.eta0) + ROELANDS_POLE_LOG) / span)

    def exponent(self, law: Any, beta: float, inlet: float) -> float:
        """The s0 of which that is beta."""
        s0: float = law.s0(beta, inlet)
        return s0


@dataclass(frozen=True, repr=False)
class Barus(ViscosityLaw):
    """Barus' law, eta = eta0 exp(alpha p); alpha = 0 is an isoviscous oil."""

    CASE_NAME = "barus"
    KERNEL_NUMBER = 1
    THINNING = Thinning()

    alpha: units.PressureViscosityOrZero
    """Pressure-viscosity coefficient [1/Pa]."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI

        def __init__(self, eta0: WithUnit, alpha: WithUnit) -> None: ...

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

    @property
    def kernel_constants(self) -> tuple[float, float]:
        """alpha, and no pole."""
        return self.alpha, 1.0

    def with_eta0(self, eta0: WithUnit) -> Self:
        """The law of another viscosity at ambient pressure [Pa s]."""
        return replace(self, eta0=number("eta0", eta0, kind_of(units.Viscosity), sizes=False))

    def with_alpha_times(self, factor: float) -> Self:
        """The law of another alpha."""
        return replace(self, alpha=factor * self.alpha)


@dataclass(frozen=True, repr=False)
class Roelands(ViscosityLaw):
    """Roelands' law, eta = eta0 exp{(ln eta0 + 9.67) [(1 + p/p0)^z - 1]} (Roelands 1966)."""

    CASE_NAME = "roelands"
    KERNEL_NUMBER = 2
    THINNING = RoelandsThinning()

    z: float
    """Pressure exponent [-]."""
    p0: units.Pressure = ROELANDS_PRESSURE
    """Pole pressure [Pa]."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI

        def __init__(self, eta0: WithUnit, z: float, p0: WithUnit = ...) -> None: ...

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        take(self, sizes=False)  # a law that is warmed may thin beyond what an oil has
        positive("eta0", self.eta0, "Pa s")
        if self.eta0 <= exp(-ROELANDS_POLE_LOG):
            raise ValueError(
                f"eta0 = {self.eta0:g} Pa s: must be above {exp(-ROELANDS_POLE_LOG):.2g} Pa s, the pole of "
                "Roelands' law"
            )
        within("z", self.z, 0, LARGEST_Z, "")
        positive("p0", self.p0, "Pa")

    @classmethod
    def from_alpha(cls, eta0: WithUnit, alpha: WithUnit, p0: WithUnit = ROELANDS_PRESSURE) -> Self:
        """The law whose slope at p = 0 is Barus' alpha [1/Pa]: z = alpha p0 / (ln eta0 + 9.67)."""
        eta0 = number("eta0", eta0, kind_of(units.Viscosity))
        alpha = number("alpha", alpha, kind_of(units.PressureViscosityOrZero))
        p0 = number("p0", p0, kind_of(units.Pressure))
        return cls(eta0, alpha * p0 / (log(eta0) + ROELANDS_POLE_LOG), p0)

    @property
    def alpha(self) -> float:
        """Pressure-viscosity coefficient at p = 0 [1/Pa]."""
        return self.z * (log(self.eta0) + ROELANDS_POLE_LOG) / self.p0

    @property
    def kernel_constants(self) -> tuple[float, float]:
        """z and the pole."""
        return self.z, self.p0

    def with_eta0(self, eta0: WithUnit) -> Self:
        """The law of another viscosity at ambient pressure [Pa s], with the z of the same alpha."""
        return self.from_alpha(eta0, self.alpha, self.p0)

    def with_alpha_times(self, factor: float) -> Self:
        """The law of another alpha, and so another z."""
        return replace(self, z=factor * self.z)

    def s0(self, beta: WithUnit, temperature: WithUnit) -> float:
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


VISCOSITY_LAWS: tuple[type[ViscosityLaw], ...] = (Barus, Roelands)
"""Laws of viscosity that the kernel computes; case files have a table of each one's fields."""


@dataclass(frozen=True, repr=False)
class Density(ShownFields):
    """Density law rho = rho0 [1 + d1 p / (1 + d2 p)] (Dowson and Higginson 1966)."""

    rho0: units.OilDensity
    """Density at ambient pressure [kg/m3]."""
    d1: units.PressureCoefficientOrZero
    """Coefficient [1/Pa]; d1 = 0 is an incompressible oil."""
    d2: units.PressureCoefficientOrZero
    """Coefficient [1/Pa]."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI

        def __init__(self, rho0: WithUnit, d1: WithUnit, d2: WithUnit) -> None: ...

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        take(self)
        positive("rho0", self.rho0, "kg/m3")
        within("d1, d2", [self.d1, self.d2], 0, inf, "1/Pa")

    @classmethod
    def incompressible(cls, rho0: WithUnit) -> "Density":
        """Constant density."""
        return cls(in_si("rho0", rho0, units.OilDensity), 0.0, 0.0)

    @classmethod
    def dowson_higginson(cls, rho0: WithUnit) -> "Density":
        """The form 1 + 0.6e-9 p / (1 + 1.7e-9 p)."""
        return cls(in_si("rho0", rho0, units.OilDensity), 0.6e-9, 1.7e-9)

    @classmethod
    def dowson_higginson_pole(cls, rho0: WithUnit) -> "Density":
        """The form (5.9e8 + 1.34 p) / (5.9e8 + p): close to the other, not identical."""
        return cls(in_si("rho0", rho0, units.OilDensity), 0.34 / 5.9e8, 1 / 5.9e8)

    def with_rho0(self, rho0: WithUnit) -> "Density":
        """The law of another density at ambient pressure [kg/m3]."""
        return replace(self, rho0=number("rho0", rho0, kind_of(units.OilDensity)))

    def __call__(self, pressure: Given) -> Any:
        """Density [kg/m3] at a pressure or pressures [Pa]."""
        pressure = in_si("pressure", pressure, units.PressureCoordinate)
        return self.rho0 * (1 + self.d1 * pressure / (1 + self.d2 * pressure))
