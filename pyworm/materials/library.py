"""Oils by name: "PAG VG 460" and a temperature become the oil that a contact sees.

The numbers are those of `pyworm/data/oils.toml`, where each has its source. An oil of one's own is made
from two viscosities, from a viscosity index, or from a file.
"""

import re
from dataclasses import dataclass, replace
from difflib import get_close_matches
from math import log
from typing import Any

from pyworm.formulas import oil_properties
from pyworm.formulas.gear_oil import ISO_GRADES
from pyworm.formulas.unit_factors import DEGREES_40, DEGREES_100, SQUARE_MILLIMETRE
from pyworm.io import units
from pyworm.io.given import Given, WithUnit, in_si, kind_of, number, text
from pyworm.io.present import present
from pyworm.io.shown import Shown
from pyworm.materials.base_stock import BASES, BaseStock, base_stock
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Density, Roelands

_NAME = re.compile(rf"({'|'.join(BASES)})\s+(?:ISO\s+)?VG\s*(\d+)", re.IGNORECASE)


@dataclass(frozen=True, repr=False)
class NamedOil(Shown):
    """An oil whose properties are known over temperature."""

    name: str
    """What it is called."""
    stock: BaseStock
    """What it shares with its base stock."""
    walther_m: float
    """Constant m of its viscosity (`oil_laws.walther_viscosity`)."""
    walther_n: float
    """Constant n of its viscosity (`oil_laws.walther_viscosity`)."""
    source: str
    """Where its viscosity comes from."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the oil in words."""
        millimetres = (
            1e6 * float(self.kinematic_viscosity(temperature))
            for temperature in (DEGREES_40, DEGREES_100)
        )
        viscosities = zip(("40 °C", "100 °C"), millimetres, strict=True)
        return f"NamedOil {self.name}", {
            **{f"at {degrees}": f"{nu:.4g} mm²/s" for degrees, nu in viscosities},
            "density": f"{self.stock.density_15:.4g} kg/m³ at 15 °C",
        }

    @property
    def viscosity_index(self) -> float:
        """Viscosity index [-] (ASTM D2270)."""
        return oil_properties.viscosity_index(
            float(self.kinematic_viscosity(DEGREES_40)),
            float(self.kinematic_viscosity(DEGREES_100)),
        )

    def kinematic_viscosity(self, temperature: Given) -> Any:
        """Kinematic viscosity [m2/s] at a temperature [K]."""
        temperature = in_si("temperature", temperature, units.Temperature)
        return oil_properties.walther_viscosity(self.walther_m, self.walther_n, temperature)

    def density(self, temperature: Given) -> Any:
        """Density [kg/m3] at a temperature [K] and ambient pressure."""
        temperature = in_si("temperature", temperature, units.Temperature)
        return oil_properties.density(
            self.stock.density_15, self.stock.density_coefficient, temperature
        )

    def viscosity(self, temperature: Given) -> Any:
        """Dynamic viscosity [Pa s] at a temperature [K] and ambient pressure."""
        temperature = in_si("temperature", temperature, units.Temperature)
        return oil_properties.dynamic_viscosity(
            self.kinematic_viscosity(temperature), self.density(temperature)
        )

    def alpha(self, temperature: Given) -> Any:
        """Pressure-viscosity coefficient [1/Pa] at a temperature [K], by Gold's law."""
        temperature = in_si("temperature", temperature, units.Temperature)
        nu = self.kinematic_viscosity(temperature)
        return oil_properties.gold_alpha(nu, self.stock.gold_s, self.stock.gold_t)

    def agma_alpha(self, temperature: Given) -> Any:
        """Pressure-viscosity coefficient [1/Pa] at a temperature [K], by AGMA's law.

        Raises:
            ValueError: AGMA has no constants for the base stock.
        """
        temperature = in_si("temperature", temperature, units.Temperature)
        if self.stock.agma_k is None or self.stock.agma_s is None:
            raise ValueError(
                f"{self.name}: AGMA 925 has no pressure-viscosity law of {self.stock.name} oils"
            )
        return oil_properties.agma_alpha(
            self.viscosity(temperature), self.stock.agma_k, self.stock.agma_s
        )

    def expansivity(self, temperature: Given) -> Any:
        """-d ln rho / dT [1/K] at a temperature [K]."""
        temperature = in_si("temperature", temperature, units.Temperature)
        coefficient = self.stock.density_coefficient
        return coefficient * self.stock.density_15 / self.density(temperature)

    def viscosity_slope(self, temperature: Given) -> Any:
        """-d ln eta / dT [1/K] of the dynamic viscosity at a temperature [K]."""
        temperature = in_si("temperature", temperature, units.Temperature)
        nu = self.kinematic_viscosity(temperature)
        slope = oil_properties.walther_slope(self.walther_n, nu, temperature)
        return slope + self.expansivity(temperature)

    def conductivity(self, temperature: Given) -> Any:
        """Thermal conductivity [W/(m K)] at a temperature [K]."""
        temperature = in_si("temperature", temperature, units.Temperature)
        if self.stock.conductivity is not None:
            return self.stock.conductivity
        return oil_properties.conductivity(self.stock.density_15, temperature)

    def flow(self, temperature: WithUnit) -> FlowLaw:
        """Flow law: Eyring's up to a limiting stress.

        Both stresses are constants of the base stock, or follow from its limiting traction coefficient and
        alpha at the temperature [K]. The limit then grows with pressure from the Eyring stress: from zero it
        would let the oil slip in the inlet, where it does not even thin.
        """
        stock = self.stock
        coefficient = stock.limiting_coefficient
        if coefficient is None:
            return FlowLaw(
                "eyring-limited",
                stress=present(stock.eyring_stress, "eyring_stress"),
                limit=present(stock.limiting_stress, "limiting_stress"),
            )
        stress = float(oil_properties.eyring_stress(self.alpha(temperature), coefficient))
        return FlowLaw("eyring-limited", stress=stress, limit=stress, limit_pressure=coefficient)

    def oil(self, temperature: WithUnit) -> Oil:
        """The oil of a contact whose inlet has a temperature [K].

        Roelands' exponents are those by which viscosity, alpha and the slope of viscosity with
        temperature at the inlet are the oil's own; away from the inlet temperature Roelands' law and
        Walther's part slowly.

        Raises:
            ValueError: A temperature at which the laws of the oil do not hold.
        """
        temperature = number("temperature", temperature, kind_of(units.Temperature))
        viscosity = Roelands.from_alpha(
            float(self.viscosity(temperature)), float(self.alpha(temperature))
        )
        slope = float(self.viscosity_slope(temperature))
        stock = self.stock
        return Oil(
            viscosity=viscosity,
            density=Density(float(self.density(temperature)), stock.density_d1, stock.density_d2),
            flow=self.flow(temperature),
            heat=OilHeat(
                inlet_temperature=temperature,
                viscosity_exponent=viscosity.s0(slope, temperature),
                conductivity=float(self.conductivity(temperature)),
                specific_heat=stock.specific_heat,
                expansivity=float(self.expansivity(temperature)),
                **stock.heat,
            ),
            boundary_friction=stock.boundary_friction,
            alpha_spread=stock.alpha_spread,
        )


def names() -> list[str]:
    """Names of all oils that `named_oil` knows."""
    return [f"{base} VG {grade}" for base in BASES for grade in ISO_GRADES]


def named_oil(name: str) -> NamedOil:
    """An oil of the table, over temperature: `named_oil("PAG VG 460").oil(333.15)` is that of a contact.

    A grade that the table lacks has the viscosity index of the table's nearest grade of the same base stock,
    nearest by ratio.

    Args:
        name: Base stock and grade, such as "PAG VG 460".

    Raises:
        ValueError: No such base stock or grade.
    """
    name = text("oil", name)
    match = _NAME.fullmatch(name.strip())
    if match is None or int(match[2]) not in ISO_GRADES:
        near = get_close_matches(name, names(), n=3)
        listed = " or ".join(f'"{name_of_oil}"' for name_of_oil in near)
        meant = f"; did you mean {listed}?" if near else ""
        raise ValueError(
            f'oil "{name}": must be a base stock ({", ".join(BASES)}) and a grade '
            f'(VG {", ".join(map(str, ISO_GRADES))}), such as "PAG VG 460"{meant}'
        )
    stock, grade = base_stock(match[1]), int(match[2])
    called = f"{stock.name} VG {grade}"
    if grade in stock.grades:
        return NamedOil(called, stock, *stock.grades[grade], stock.sources["grades"])
    nearest = min(stock.grades, key=lambda other: abs(log(other / grade)))
    like = NamedOil("", stock, *stock.grades[nearest], "")
    oil = oil_from_index(called, stock.name, grade * SQUARE_MILLIMETRE, like.viscosity_index)
    return replace(
        oil, source=f"viscosity index {like.viscosity_index:.0f}, that of {stock.name} VG {nearest}"
    )


def oil_from_viscosities(
    name: str, base: str, viscosity_40: float, viscosity_100: float, source: str = "two viscosities"
) -> NamedOil:
    """An oil from its kinematic viscosities [m2/s] at 40 and 100 degC; the rest is its base stock's.

    ValueError for not viscosities of one oil, or no such base stock.
    """
    m, n = oil_properties.walther_constants(viscosity_40, DEGREES_40, viscosity_100, DEGREES_100)
    return NamedOil(name, base_stock(base), m, n, source)


def oil_from_index(name: str, base: str, viscosity_40: float, index: float) -> NamedOil:
    """An oil from its kinematic viscosity [m2/s] at 40 degC and its viscosity index.

    ValueError for no such oil, or no such base stock.
    """
    viscosity_100 = oil_properties.viscosity_100_of_index(viscosity_40, index)
    return oil_from_viscosities(
        name, base, viscosity_40, viscosity_100, f"viscosity index {index:.0f}"
    )
