"""Viscosity and density of liquids against pressure and temperature: free volume, glass transition, fits."""

from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Values
from pyworm.io import units
from pyworm.io.plain_values import Number, PositiveNumber


@dataclass(frozen=True)
class Tait:
    """Tait's equation of state, V/VR = [1 - ln(1 + p (1 + K0')/K0)/(1 + K0')] [1 + aV (T - TR)].

    K0 = `bulk_modulus` exp[-`bulk_decay` (T - TR)] (Fakhreddine and Zoller 1990, as Bair uses it).
    """

    reference_temperature: units.Temperature
    """Reference temperature TR [K]."""
    rho0: units.OilDensity
    """Density at TR and ambient pressure [kg/m3]."""
    bulk_modulus: units.Modulus
    """Isothermal bulk modulus at TR and ambient pressure [Pa]."""
    bulk_decay: units.TemperatureCoefficientOrZero
    """Decay of the bulk modulus with temperature [1/K]."""
    bulk_rate: PositiveNumber
    """K0', its rise with pressure [-]."""
    expansivity: units.TemperatureCoefficientOrZero = 0.0
    """aV [1/K]."""

    def relative_volume(self, pressure: Values, temperature: Values) -> Values:
        """Volume over that at TR and ambient pressure [-], at pressures [Pa] and temperatures [K]."""
        warmth = temperature - self.reference_temperature
        modulus = self.bulk_modulus * np.exp(-self.bulk_decay * warmth)
        squeezed = np.log1p(pressure * (1 + self.bulk_rate) / modulus) / (1 + self.bulk_rate)
        return (1 - squeezed) * (1 + self.expansivity * warmth)

    def __call__(self, pressure: Values, temperature: Values) -> Values:
        """Density [kg/m3] at pressures [Pa] and temperatures [K]."""
        return self.rho0 / self.relative_volume(pressure, temperature)


@dataclass(frozen=True)
class Doolittle:
    """Doolittle's free volume, eta = etaR exp{B R0 [q/(V/VR - R0 q) - 1/(1 - R0)]}, q = 1 + eps (T - TR)."""

    volume: Tait
    """V/VR and TR."""
    viscosity: float
    """etaR, at TR and ambient pressure [Pa s]."""
    parameter: float
    """B [-]."""
    occupied: float
    """R0, occupied over whole volume at TR and ambient pressure [-]."""
    occupied_expansivity: float = 0.0
    """eps [1/K]."""

    def __call__(self, pressure: Values, temperature: Values) -> Values:
        """Viscosity [Pa s] at pressures [Pa] and temperatures [K]."""
        swollen = 1 + self.occupied_expansivity * (temperature - self.volume.reference_temperature)
        volume = self.volume.relative_volume(pressure, temperature)
        free = volume - self.occupied * swollen
        spread = swollen / free - 1 / (1 - self.occupied)
        return self.viscosity * np.exp(self.parameter * self.occupied * spread)


@dataclass(frozen=True)
class Yasutomi:
    """Yasutomi's law, eta = etag exp[-2.303 C1 (T - Tg) F/(C2 + (T - Tg) F)] (Yasutomi, Bair and Winer 1984).

    Tg = `glass` + A1 ln(1 + A2 p), F = 1 - B1 ln(1 + B2 p).
    """

    glass_viscosity: float
    """etag, viscosity at the glass transition [Pa s]."""
    glass: float
    """Glass transition at ambient pressure [K]."""
    a1: float
    """A1 of Tg [K]."""
    a2: float
    """A2 of Tg [1/Pa]."""
    b1: float
    """B1 of F [-]."""
    b2: float
    """B2 of F [1/Pa]."""
    c1: float
    """C1 [-]."""
    c2: float
    """C2 [K]."""

    def __call__(self, pressure: Values, temperature: Values) -> Values:
        """Viscosity [Pa s] at pressures [Pa] and temperatures [K]."""
        above = temperature - self.glass - self.a1 * np.log1p(self.a2 * pressure)
        above = above * (1 - self.b1 * np.log1p(self.b2 * pressure))
        found: Values = self.glass_viscosity * np.exp(
            -np.log(10) * self.c1 * above / (self.c2 + above)
        )
        return found


@dataclass(frozen=True)
class RoelandsFit:
    """Roelands' law whose constants follow temperature, in Larsson's form (Larsson et al. 2000).

    lg eta0 = -4.2 + G0 (1 + t/135)^-S0, z = Dz + Cz lg(1 + t/135), t in degrees Celsius, and
    eta = eta0 exp{(ln eta0 + 9.67) [(1 + 5.1e-9 p)^z - 1]}.
    """

    g0: PositiveNumber
    """G0 [-]."""
    s0: PositiveNumber
    """S0 [-]."""
    dz: Number
    """Dz [-]."""
    cz: Number
    """Cz [-]."""

    def __call__(self, pressure: Values, temperature: Values) -> Values:
        """Viscosity [Pa s] at pressures [Pa] and temperatures [K]."""
        warmth = 1 + (temperature - 273.15) / 135
        ambient = 10 ** (-4.2 + self.g0 * warmth**-self.s0)
        z = self.dz + self.cz * np.log10(warmth)
        rise = (np.log(ambient) + 9.67) * ((1 + 5.1e-9 * pressure) ** z - 1)
        return ambient * np.exp(rise)
