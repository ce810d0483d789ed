"""Oils by name: "PAG VG 460" and a temperature become the oil that a contact sees.

The numbers are those of `pyworm/data/oils.toml`, where each has its source. An oil of one's own is made
from two viscosities, from a viscosity index, or from a file.
"""

import re
from dataclasses import dataclass, replace
from difflib import get_close_matches
from math import log
from typing import Any, Self

import numpy as np

from pyworm.formulas import oil_properties
from pyworm.formulas.gear_oil import ISO_GRADES
from pyworm.formulas.unit_factors import DEGREES_40, DEGREES_100, SQUARE_MILLIMETRE, ZERO_CELSIUS
from pyworm.io import units
from pyworm.io.given import Given, WithUnit, in_si, kind_of, number, row, text
from pyworm.io.present import present
from pyworm.io.quantity_text import percent
from pyworm.io.shown import Shown
from pyworm.materials.base_stock import BASES, BaseStock, base_stock
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Density, Roelands

MAX_WALTHER_DEVIATION = 0.1
"""Largest deviation of a measured viscosity from Walther's law: oils keep to it within a few per cent (ASTM
D341), slips of units do not."""

DEGREES_15 = ZERO_CELSIUS + 15
"""Temperature at which data sheets give the density [K]."""

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

    @classmethod
    def from_datasheet(
        cls,
        *,
        nu40: WithUnit,
        nu100: WithUnit | None = None,
        viscosity_index: float | None = None,
        density15: WithUnit | None = None,
        base: str = "mineral",
        alpha: WithUnit | None = None,
        alpha_at: WithUnit = DEGREES_40,
        name: str = "oil of a data sheet",
    ) -> Self:
        """An oil by its data sheet; what is not given is that of the base stock.

        Args:
            nu40: Kinematic viscosity at 40 degC [m2/s], such as "220 mm^2/s".
            nu100: Kinematic viscosity at 100 degC [m2/s]; this or the viscosity index.
            viscosity_index: Viscosity index [-] (ASTM D2270).
            density15: Density at 15 degC [kg/m3].
            base: Base stock, "mineral", "PAO", "ester" or "PAG".
            alpha: Measured pressure-viscosity coefficient [1/Pa], which varies with the viscosity by Gold's
                law of the base stock.
            alpha_at: Temperature at which it was measured [K].
            name: What it is called.

        Raises:
            ValueError: Both or neither of `nu100` and `viscosity_index`, no such base stock, or values that
                no oil has.
        """
        viscosity_40 = number("nu40", nu40, kind_of(units.KinematicViscosity))
        if (nu100 is None) == (viscosity_index is None):
            raise ValueError("give either nu100 or viscosity_index, one of the two")
        if viscosity_index is not None:
            viscosity_100 = oil_properties.viscosity_100_of_index(viscosity_40, viscosity_index)
        else:
            viscosity_100 = number("nu100", nu100, kind_of(units.KinematicViscosity))
        m, n = oil_properties.walther_constants(
            viscosity_40, DEGREES_40, viscosity_100, DEGREES_100
        )
        stock = base_stock(text("base", base))
        if density15 is not None:
            given = number("density15", density15, kind_of(units.OilDensity))
            stock = replace(stock, density_15=given)
        return cls(name, stock, m, n, "data sheet")._with_alpha(alpha, alpha_at)

    @classmethod
    def from_table(
        cls,
        temperatures: Given,
        *,
        nu: Given | None = None,
        eta: Given | None = None,
        density: Given | None = None,
        base: str = "mineral",
        alpha: WithUnit | None = None,
        alpha_at: WithUnit = DEGREES_40,
        name: str = "measured oil",
    ) -> Self:
        """An oil by measurements over temperature at ambient pressure; its pressure behaviour by base stock.

        Walther's law and a density that falls linearly are fitted by least squares.

        Args:
            temperatures: Temperatures [K], two or more.
            nu: Kinematic viscosity at each of them [m2/s]; this or `eta`.
            eta: Dynamic viscosity at each of them [Pa s].
            density: Density at each of them [kg/m3]; by default that of the base stock.
            base, alpha, alpha_at, name: As of `from_datasheet`.

        Raises:
            ValueError: Values of another number, both or neither viscosity, or one more than 10 % off
                Walther's law, as by a slip of units.
        """
        warmths = np.asarray(
            in_si("temperatures", row("temperatures", temperatures), units.Temperature)
        )
        stock = base_stock(text("base", base))
        if density is not None:
            stock = _stock_of_density(
                stock, warmths, _measured("density", density, units.OilDensity, warmths)
            )
        if nu is not None and eta is None:
            viscosities = _measured("nu", nu, units.KinematicViscosity, warmths)
        elif nu is not None or eta is None:
            raise ValueError("give either nu or eta, one of the two")
        else:
            dynamic = _measured("eta", eta, units.Viscosity, warmths)
            viscosities = dynamic / oil_properties.density(
                stock.density_15, stock.density_coefficient, warmths
            )
        m, n = _walther_fit(warmths, viscosities)
        return cls(name, stock, m, n, "measured over temperature")._with_alpha(alpha, alpha_at)

    def _with_alpha(self, alpha: WithUnit | None, temperature: WithUnit) -> Self:
        """The oil with a pressure-viscosity coefficient [1/Pa] measured at a temperature [K]."""
        if alpha is None:
            return self
        measured = number("alpha", alpha, kind_of(units.PressureViscosity))
        measured_at = number("alpha_at", temperature, kind_of(units.Temperature))
        factor = measured / float(self.alpha(measured_at))
        stock = replace(self.stock, gold_s=factor * self.stock.gold_s, alpha_spread=0.0)
        return replace(self, stock=stock)

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


def _measured(name: str, given: Given, kind: Any, temperatures: np.ndarray) -> np.ndarray:
    """Measurements in SI, one for each temperature."""
    values = np.asarray(in_si(name, row(name, given), kind), dtype=float)
    if values.shape != temperatures.shape:
        raise ValueError(
            f"{name} has {values.size} values and temperatures {temperatures.size}; give one for each"
        )
    return values


def _stock_of_density(
    stock: BaseStock, temperatures: np.ndarray, densities: np.ndarray
) -> BaseStock:
    """A base stock with the density that measurements give at 15 degC, and its fall with temperature."""
    fall, at_15 = np.polyfit(temperatures - DEGREES_15, densities, 1)
    return replace(stock, density_15=float(at_15), density_coefficient=float(-fall / at_15))


def _walther_fit(temperatures: np.ndarray, viscosities: np.ndarray) -> tuple[float, float]:
    """m and n of Walther's law through measurements of kinematic viscosity [m2/s], by least squares."""
    if temperatures.size < 2:
        raise ValueError("temperatures: give two or more, so that the viscosity has a slope")
    ends = np.argsort(temperatures)[[0, -1]]
    oil_properties.walther_constants(
        *(float(value) for end in ends for value in (viscosities[end], temperatures[end]))
    )
    slope, m = np.polyfit(np.log10(temperatures), oil_properties.double_log(viscosities), 1)
    off = oil_properties.walther_viscosity(m, -slope, temperatures) / viscosities - 1
    worst = int(np.argmax(np.abs(off)))
    if abs(off[worst]) > MAX_WALTHER_DEVIATION:
        raise ValueError(
            f"viscosity at {temperatures[worst]:g} K: lies {percent(abs(off[worst]))} off Walther's law "
            "through all of them; check its unit"
        )
    return float(m), float(-slope)


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
