"""Oils by name: "PAG VG 460" and a temperature become the oil that a contact sees.

The numbers are those of `pyworm/data/oils.toml`, where each has its source. An oil of one's own is made
from two viscosities, from a viscosity index, or from a file.
"""

import re
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from functools import cache
from math import log
from pathlib import Path
from typing import Annotated, Any, Literal, get_args

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from pyworm import units
from pyworm.case_error import CaseError, sentence
from pyworm.formulas import oil_laws
from pyworm.formulas.gear_oil import ISO_GRADES
from pyworm.formulas.ranges import Values
from pyworm.oils import Density, FlowLaw, Oil, OilHeat, Roelands
from pyworm.toml_file import read_toml

Base = Literal["mineral", "PAO", "ester", "PAG"]

BASES: tuple[Base, ...] = get_args(Base)
"""Base stocks in the table."""

GRADE_TOLERANCE = 0.11
"""Largest deviation of a table's oil from its grade; ISO 3448 has 0.1, which one measured oil misses."""

DEGREES_40, DEGREES_100 = 313.15, 373.15
"""Temperatures [K] at which oils are told by two viscosities."""

MILLIMETRE_SQUARED = 1e-6
"""1 mm2/s [m2/s]."""

_NAME = re.compile(rf"({'|'.join(BASES)})\s+(?:ISO\s+)?VG\s*(\d+)", re.IGNORECASE)

_TABLE = Path(__file__).with_name("data") / "oils.toml"


@dataclass(frozen=True)
class BaseStock:
    """What oils of one base stock have in common.

    Attributes
    ----------
    name : str
        Base stock.
    density_15, density_coefficient : float
        Density at 15 degC [kg/m3] and its relative fall with temperature [1/K].
    specific_heat : float
        [J/(kg K)].
    gold_s, gold_t : float
        Constants of Gold's law of the pressure-viscosity coefficient (`oil_laws.gold_alpha`).
    density_d1, density_d2 : float
        Rise of the density with pressure [1/Pa] (`pyworm.oils.Density`).
    conductivity : float or None
        Thermal conductivity [W/(m K)]; None where Cragoe's formula gives it.
    agma_k, agma_s : float or None
        Constants of AGMA's law, k in mm2/N (`oil_laws.agma_alpha`); None where it has none.
    limiting_coefficient : float or None
        Limiting stress over pressure [-], which also gives the Eyring stress; None where stresses are given.
    eyring_stress, limiting_stress : float or None
        Constant stresses [Pa]; None where the coefficient gives them.
    heat : dict of str to float
        Further constants of `pyworm.oils.OilHeat`.
    grades : dict of int to tuple of float
        ISO viscosity grade -> Walther's m and n.
    sources : dict of str to str
        Where the numbers come from.
    """

    name: Base
    density_15: float
    density_coefficient: float
    specific_heat: float
    gold_s: float
    gold_t: float
    density_d1: float = 0.6e-9
    density_d2: float = 1.7e-9
    conductivity: float | None = None
    agma_k: float | None = None
    agma_s: float | None = None
    limiting_coefficient: float | None = None
    eyring_stress: float | None = None
    limiting_stress: float | None = None
    heat: dict[str, float] = field(default_factory=dict)
    grades: dict[int, tuple[float, float]] = field(default_factory=dict)
    sources: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class NamedOil:
    """An oil known over temperature.

    Attributes
    ----------
    name : str
        What it is called.
    stock : BaseStock
        What it shares with its base stock.
    walther_m, walther_n : float
        Constants of its viscosity (`oil_laws.walther_viscosity`).
    source : str
        Where its viscosity comes from.
    """

    name: str
    stock: BaseStock
    walther_m: float
    walther_n: float
    source: str

    @property
    def viscosity_index(self) -> float:
        """Viscosity index [-] (ASTM D2270)."""
        return oil_laws.viscosity_index(
            self.kinematic_viscosity(DEGREES_40), self.kinematic_viscosity(DEGREES_100)
        )

    def kinematic_viscosity(self, temperature: Values) -> Values:
        """Kinematic viscosity [m2/s] at a temperature [K]."""
        return oil_laws.walther_viscosity(self.walther_m, self.walther_n, temperature)

    def density(self, temperature: Values) -> Values:
        """Density [kg/m3] at a temperature [K] and ambient pressure."""
        return oil_laws.density(self.stock.density_15, self.stock.density_coefficient, temperature)

    def viscosity(self, temperature: Values) -> Values:
        """Dynamic viscosity [Pa s] at a temperature [K] and ambient pressure."""
        return oil_laws.dynamic_viscosity(
            self.kinematic_viscosity(temperature), self.density(temperature)
        )

    def alpha(self, temperature: Values) -> Values:
        """Pressure-viscosity coefficient [1/Pa] at a temperature [K], by Gold's law."""
        nu = self.kinematic_viscosity(temperature)
        return oil_laws.gold_alpha(nu, self.stock.gold_s, self.stock.gold_t)

    def agma_alpha(self, temperature: Values) -> Values:
        """The same by AGMA's law.

        Raises
        ------
        ValueError
            AGMA has no constants for the base stock.
        """
        if self.stock.agma_k is None or self.stock.agma_s is None:
            raise ValueError(
                f"{self.name}: AGMA 925 has no pressure-viscosity law of {self.stock.name} oils"
            )
        return oil_laws.agma_alpha(
            self.viscosity(temperature), self.stock.agma_k, self.stock.agma_s
        )

    def expansivity(self, temperature: Values) -> Values:
        """-d ln rho / dT [1/K] at a temperature [K]."""
        coefficient = self.stock.density_coefficient
        return coefficient * self.stock.density_15 / self.density(temperature)

    def viscosity_slope(self, temperature: Values) -> Values:
        """-d ln eta / dT [1/K] of the dynamic viscosity at a temperature [K]."""
        nu = self.kinematic_viscosity(temperature)
        slope = oil_laws.walther_slope(self.walther_n, nu, temperature)
        return slope + self.expansivity(temperature)

    def conductivity(self, temperature: Values) -> Values:
        """Thermal conductivity [W/(m K)] at a temperature [K]."""
        if self.stock.conductivity is not None:
            return self.stock.conductivity
        return oil_laws.conductivity(self.stock.density_15, temperature)

    def flow(self, temperature: float) -> FlowLaw:
        """How the oil shears: Eyring's law up to a limiting stress.

        Both stresses are constants of the base stock, or follow from its limiting traction coefficient and
        alpha at the temperature [K]. The limit then grows with pressure from the Eyring stress: from zero it
        would let the oil slip in the inlet, where it does not even thin.
        """
        stock = self.stock
        share = stock.limiting_coefficient
        if share is None:
            return FlowLaw(
                "eyring-limited", stress=stock.eyring_stress, limit=stock.limiting_stress
            )
        stress = float(oil_laws.eyring_stress(self.alpha(temperature), share))
        return FlowLaw("eyring-limited", stress=stress, limit=stress, limit_pressure=share)

    def oil(self, temperature: float) -> Oil:
        """The oil of a contact whose inlet has a temperature [K].

        Roelands' exponents are those by which viscosity, alpha and the slope of viscosity with
        temperature at the inlet are the oil's own; away from the inlet temperature Roelands' law and
        Walther's part slowly.

        Raises
        ------
        ValueError
            A temperature at which the laws of the oil do not hold.
        """
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
        )


def base_stock(name: str) -> BaseStock:
    """The base stock of a name in `BASES`, in any case of letters.

    Raises
    ------
    ValueError
        No such base stock.
    """
    for base, stock in _stocks().items():
        if base.lower() == name.lower():
            return stock
    raise ValueError(f'base "{name}": must be one of {", ".join(BASES)}')


def names() -> list[str]:
    """Names of all oils that `named_oil` knows."""
    return [f"{base} VG {grade}" for base in BASES for grade in ISO_GRADES]


def named_oil(name: str) -> NamedOil:
    """An oil of the table, such as "PAG VG 460".

    A grade that the table lacks has the viscosity index of the table's nearest grade of the same base stock,
    nearest by ratio.

    Raises
    ------
    ValueError
        No such base stock or grade.
    """
    match = _NAME.fullmatch(name.strip())
    if match is None or int(match[2]) not in ISO_GRADES:
        near = get_close_matches(name, names(), n=3)
        listed = " or ".join(f'"{one}"' for one in near)
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
    made = oil_from_index(called, stock.name, grade * MILLIMETRE_SQUARED, like.viscosity_index)
    return replace(
        made,
        source=f"viscosity index {like.viscosity_index:.0f}, that of {stock.name} VG {nearest}",
    )


def oil_from_viscosities(
    name: str, base: str, viscosity_40: float, viscosity_100: float, source: str = "two viscosities"
) -> NamedOil:
    """An oil from its kinematic viscosities [m2/s] at 40 and 100 degC; the rest is its base stock's.

    Raises
    ------
    ValueError
        Not viscosities of one oil, or no such base stock.
    """
    m, n = oil_laws.walther_constants(viscosity_40, DEGREES_40, viscosity_100, DEGREES_100)
    return NamedOil(name, base_stock(base), m, n, source)


def oil_from_index(name: str, base: str, viscosity_40: float, index: float) -> NamedOil:
    """An oil from its kinematic viscosity [m2/s] at 40 degC and its viscosity index.

    Raises
    ------
    ValueError
        No such oil, or no such base stock.
    """
    viscosity_100 = oil_laws.viscosity_100_of_index(viscosity_40, index)
    return oil_from_viscosities(
        name, base, viscosity_40, viscosity_100, f"viscosity index {index:.0f}"
    )


def read_oil(path: str | Path) -> NamedOil:
    """An oil from a TOML file of one's own.

    It gives `name`, `base`, `source`, `viscosity_40` with `viscosity_100` or `viscosity_index`, and
    whatever else of its base stock is to be replaced: the keys of a base stock in
    `pyworm/data/oils.toml` except the grades.

        name = "Shop oil 12"
        source = "data sheet of 2024"
        base = "PAO"
        viscosity_40 = "225 mm^2/s"
        viscosity_100 = "27 mm^2/s"
        density_15 = "861 kg/m^3"

    Raises
    ------
    CaseError
        Whatever is wrong first, in one sentence.
    """
    data = read_toml(Path(path))
    try:
        table = _OilTable.model_validate(data)
        if table.viscosity_100 is not None:
            made = oil_from_viscosities(
                table.name, table.base, table.viscosity_40, table.viscosity_100, table.source
            )
        else:
            made = oil_from_index(table.name, table.base, table.viscosity_40, table.viscosity_index)
    except ValidationError as error:
        raise CaseError(f"{path}: {sentence(error, _OilTable, data)}") from None
    except ValueError as error:
        raise CaseError(f"{path}: {error}") from None
    own = table.own()
    sources = {**made.stock.sources, **dict.fromkeys(own, table.source)}
    return replace(made, source=table.source, stock=replace(made.stock, **own, sources=sources))


# -------------------------------------------------------------------------------------------- files

_AgmaFactor = units.quantity("a pressure coefficient", "1/Pa", "0.0105 mm^2/N")
_Fraction = Annotated[float, Field(strict=True, gt=0, lt=1)]
_Positive = Annotated[float, Field(strict=True, gt=0, allow_inf_nan=False)]


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class HeatCourseTable(_Table):
    """Keys of `OilHeat` that say how heat constants follow pressure and temperature."""

    expansivity_decay: units.PressureCoefficientOrZero = 0.0
    conductivity_c1: units.PressureCoefficientOrZero = 0.0
    conductivity_c2: units.PressureCoefficientOrZero = 0.0
    heat_capacity_b0: units.TemperatureCoefficientAnySign = 0.0
    heat_capacity_b1: units.PressureCoefficientAnySign = 0.0
    heat_capacity_b2: units.SquaredPressureCoefficient = 0.0
    heat_capacity_k1: units.PressureCoefficientOrZero = 0.0
    heat_capacity_k2: units.PressureCoefficientOrZero = 0.0


class _StockTable(_Table):
    """What of a base stock an oil may have of its own."""

    density_15: units.OilDensity | None = None
    density_coefficient: units.TemperatureCoefficient | None = None
    density_d1: units.PressureCoefficientOrZero = 0.6e-9
    density_d2: units.PressureCoefficientOrZero = 1.7e-9
    specific_heat: units.SpecificHeat | None = None
    conductivity: units.OilConductivity | None = None
    gold_s: _Positive | None = None
    gold_t: _Fraction | None = None
    agma_k: _AgmaFactor | None = None
    agma_s: _Fraction | None = None
    limiting_coefficient: _Fraction | None = None
    eyring_stress: units.Stress | None = None
    limiting_stress: units.Stress | None = None
    heat: HeatCourseTable = HeatCourseTable()

    @model_validator(mode="after")
    def _stresses_in_pairs(self):
        if (self.eyring_stress is None) != (self.limiting_stress is None):
            raise ValueError("give eyring_stress and limiting_stress together")
        if self.eyring_stress is not None and self.limiting_coefficient is not None:
            raise ValueError("give either limiting_coefficient or the two stresses")
        return self

    def own(self) -> dict[str, Any]:
        """What the file says, as `BaseStock` has it."""
        own = self.model_dump(exclude_unset=True, include=set(_StockTable.model_fields))
        if "agma_k" in own:
            own["agma_k"] *= 1e6  # AGMA's law is written in mm2/N
        if "eyring_stress" in own:
            own["limiting_coefficient"] = None
        elif "limiting_coefficient" in own:
            own["eyring_stress"] = own["limiting_stress"] = None
        return own


class _BaseStockTable(_StockTable):
    """One base stock of the table: everything said, each with its source."""

    density_15: units.OilDensity
    density_coefficient: units.TemperatureCoefficient
    specific_heat: units.SpecificHeat
    gold_s: _Positive
    gold_t: _Fraction
    grades: dict[int, tuple[_Positive, _Positive]]
    sources: dict[str, str]

    @model_validator(mode="after")
    def _one_way_to_flow(self):
        if self.limiting_coefficient is None and self.eyring_stress is None:
            raise ValueError("give limiting_coefficient or the two stresses")
        return self


class _OilTable(_StockTable):
    """An oil of one's own."""

    name: Annotated[str, Field(min_length=1)]
    source: Annotated[str, Field(min_length=1)]
    base: Base
    viscosity_40: units.KinematicViscosity
    viscosity_100: units.KinematicViscosity | None = None
    viscosity_index: _Positive | None = None

    @model_validator(mode="after")
    def _one_way_to_warm(self):
        if (self.viscosity_100 is None) == (self.viscosity_index is None):
            raise ValueError("give either viscosity_100 or viscosity_index, one of the two")
        return self


@cache
def _stocks() -> dict[Base, BaseStock]:
    """The table, checked: every oil of it has the viscosity that its grade says."""
    data = read_toml(_TABLE)
    stocks = {}
    for base in BASES:
        table = _BaseStockTable.model_validate(data[base])
        stock = BaseStock(base, **table.own(), grades=table.grades, sources=table.sources)
        for grade, (m, n) in stock.grades.items():
            nu = oil_laws.walther_viscosity(m, n, DEGREES_40) / MILLIMETRE_SQUARED
            if grade not in ISO_GRADES or abs(nu / grade - 1) > GRADE_TOLERANCE:
                raise CaseError(f"{_TABLE}: {base} VG {grade}: has {nu:.1f} mm2/s at 40 degC")
        stocks[base] = stock
    return stocks
