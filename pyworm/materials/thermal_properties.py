"""Heat of oils: conduction, heat capacity, expansion, and the fall of viscosity with temperature."""

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from pyworm.formulas.ranges import positive, within
from pyworm.io import units
from pyworm.io.given import WithUnit, kind_of, number, take
from pyworm.io.shown import ShownFields


@dataclass(frozen=True, kw_only=True)
class HeatCourse:
    """How thermal constants of an oil depend on pressure and temperature (`OilHeat` has the laws)."""

    expansivity_decay: units.PressureCoefficientOrZero = 0.0
    """lambda [1/Pa] of the expansivity."""
    conductivity_c1: units.PressureCoefficientOrZero = 0.0
    """c1 [1/Pa] of the conductivity."""
    conductivity_c2: units.PressureCoefficientOrZero = 0.0
    """c2 [1/Pa] of the conductivity."""
    heat_capacity_b0: units.TemperatureCoefficientAnySign = 0.0
    """b0 of rho c [1/K]."""
    heat_capacity_b1: units.PressureCoefficientAnySign = 0.0
    """b1 of rho c [1/Pa]."""
    heat_capacity_b2: units.SquaredPressureCoefficient = 0.0
    """b2 of rho c [1/Pa2]."""
    heat_capacity_k1: units.PressureCoefficientOrZero = 0.0
    """k1 of rho c [1/Pa]."""
    heat_capacity_k2: units.PressureCoefficientOrZero = 0.0
    """k2 of rho c [1/Pa]."""


@dataclass(frozen=True, repr=False)
class OilHeat(ShownFields, HeatCourse):
    """Thermal laws of an oil, those of the Appendix of Sharif et al. (2001).

    T0 is the inlet temperature, at which oil enters a contact, rho0 and eta0 are density and viscosity there
    at ambient pressure. Viscosity
    falls by Roelands' law, eta = eta0 exp{(ln eta0 + 9.67) [(1 + p/p0)^z ((T - 138 K)/(T0 - 138 K))^-s0 - 1]}
    (equation 20), or by Barus' law with eta0 exp(alpha p - beta (T - T0)).
    """

    inlet_temperature: units.Temperature
    """Inlet temperature T0 [K]."""
    viscosity_exponent: units.TemperatureCoefficientOrZero
    """s0 [-], which has no unit, of an oil with Roelands' law, beta [1/K] of one with Barus'."""
    conductivity: units.OilConductivity
    """k0 [W/(m K)] of the conductivity k = k0 [1 + c1 p / (1 + c2 p)]."""
    specific_heat: units.SpecificHeat
    """c0 [J/(kg K)] of rho c = rho0 c0 {1 + b0 (1 + b1 p + b2 p^2) (T - T0)} {1 + k1 p / (1 + k2 p)}."""
    expansivity: units.TemperatureCoefficientOrZero = 0.0
    """eps0 [1/K] of eps = eps0 exp(-lambda p), by which the density is rho(p) [1 - eps (T - T0)]."""
    supply_temperature: units.Temperature | None = None
    """Temperature of the oil before it met bodies of another one [K]; None where the inlet's."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI
        # fmt: off
        def __init__(
            self, inlet_temperature: WithUnit, viscosity_exponent: WithUnit, conductivity: WithUnit,
            specific_heat: WithUnit, expansivity: WithUnit = ..., supply_temperature: WithUnit | None = ...,
            *, expansivity_decay: WithUnit = ..., conductivity_c1: WithUnit = ...,
            conductivity_c2: WithUnit = ..., heat_capacity_b0: WithUnit = ...,
            heat_capacity_b1: WithUnit = ..., heat_capacity_b2: WithUnit = ...,
            heat_capacity_k1: WithUnit = ..., heat_capacity_k2: WithUnit = ...
        ) -> None: ...
        # fmt: on

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows in words; the unit of the viscosity's exponent is that of the oil's law."""
        heading, rows = super().shown()
        return heading, rows | {"viscosity_exponent": f"{self.viscosity_exponent:.4g}"}

    def __post_init__(self) -> None:
        """Refuse impossible constants of an oil."""
        take(self, sizes=False)  # a conductivity without end stands for an oil that stays cold
        number("inlet_temperature", self.inlet_temperature, kind_of(units.Temperature))
        positive("inlet_temperature", self.inlet_temperature, "K")
        positive("conductivity", self.conductivity, "W/(m K)")
        positive("specific_heat", self.specific_heat, "J/(kg K)")
        within("viscosity_exponent", self.viscosity_exponent, 0, inf, "")
        within("expansivity", self.expansivity, 0, inf, "1/K")
