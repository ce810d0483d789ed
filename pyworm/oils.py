"""Oils: how viscosity and density follow pressure.

Two viscosity laws and one density law cover what the kernel simulates; the published variants of each
differ only in the constants that the constructors here fill in.
"""

from dataclasses import dataclass
from math import exp, log

ROELANDS_PRESSURE = 1.96e8
"""Pole pressure [Pa] of Roelands' law in its usual rounding (Roelands 1966)."""

ROELANDS_PRESSURE_COEFFICIENT = 5.1e-9
"""Reciprocal pole pressure [1/Pa] in the form of Sharif et al. (2001), equation 20."""

ROELANDS_POLE_LOG = 9.67
"""-ln of the viscosity [Pa s] at which Roelands' isotherms meet."""


@dataclass(frozen=True)
class Barus:
    """Barus' law, eta = eta0 exp(alpha p); alpha = 0 is an isoviscous oil.

    Attributes
    ----------
    eta0 : float
        Viscosity at ambient pressure [Pa s].
    alpha : float
        Pressure-viscosity coefficient [1/Pa].
    """

    eta0: float
    alpha: float

    def __call__(self, pressure: float) -> float:
        """Viscosity [Pa s] at a pressure [Pa]."""
        return self.eta0 * exp(self.alpha * pressure)


@dataclass(frozen=True)
class Roelands:
    """Roelands' law, eta = eta0 exp{(ln eta0 + 9.67) [(1 + p/p0)^z - 1]} (Roelands 1966).

    Attributes
    ----------
    eta0 : float
        Viscosity at ambient pressure [Pa s].
    z : float
        Pressure exponent [-].
    p0 : float
        Pole pressure [Pa].
    """

    eta0: float
    z: float
    p0: float = ROELANDS_PRESSURE

    @classmethod
    def from_alpha(cls, eta0: float, alpha: float, p0: float = ROELANDS_PRESSURE) -> "Roelands":
        """The law whose slope at p = 0 is Barus' alpha [1/Pa]: z = alpha p0 / (ln eta0 + 9.67)."""
        return cls(eta0, alpha * p0 / (log(eta0) + ROELANDS_POLE_LOG), p0)

    @property
    def alpha(self) -> float:
        """Pressure-viscosity coefficient at p = 0 [1/Pa]."""
        return self.z * (log(self.eta0) + ROELANDS_POLE_LOG) / self.p0

    def __call__(self, pressure: float) -> float:
        """Viscosity [Pa s] at a pressure [Pa]."""
        rise = (log(self.eta0) + ROELANDS_POLE_LOG) * ((1 + pressure / self.p0) ** self.z - 1)
        return self.eta0 * exp(rise)


@dataclass(frozen=True)
class Density:
    """Density law rho = rho0 [1 + d1 p / (1 + d2 p)] (Dowson and Higginson 1966).

    Attributes
    ----------
    rho0 : float
        Density at ambient pressure [kg/m3].
    d1, d2 : float
        Coefficients [1/Pa]; d1 = 0 is an incompressible oil.
    """

    rho0: float
    d1: float
    d2: float

    @classmethod
    def incompressible(cls, rho0: float) -> "Density":
        """Constant density."""
        return cls(rho0, 0.0, 0.0)

    @classmethod
    def dowson_higginson(cls, rho0: float) -> "Density":
        """The form 1 + 0.6e-9 p / (1 + 1.7e-9 p)."""
        return cls(rho0, 0.6e-9, 1.7e-9)

    @classmethod
    def dowson_higginson_pole(cls, rho0: float) -> "Density":
        """The form (5.9e8 + 1.34 p) / (5.9e8 + p): close to the other, not identical."""
        return cls(rho0, 0.34 / 5.9e8, 1 / 5.9e8)

    def __call__(self, pressure: float) -> float:
        """Density [kg/m3] at a pressure [Pa]."""
        return self.rho0 * (1 + self.d1 * pressure / (1 + self.d2 * pressure))


@dataclass(frozen=True)
class Oil:
    """An oil as the kernel sees it.

    Attributes
    ----------
    viscosity : Barus or Roelands
        Viscosity against pressure at the inlet temperature.
    density : Density
        Density against pressure at the inlet temperature.
    """

    viscosity: Barus | Roelands
    density: Density
