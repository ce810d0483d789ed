"""Base stocks of the oil library: their typical properties and how these vary with temperature."""

from dataclasses import dataclass, field, fields
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self, get_args

from pydantic import BaseModel, ConfigDict, Field, model_validator

from pyworm.formulas import oil_properties
from pyworm.formulas.gear_oil import ISO_GRADES
from pyworm.formulas.unit_factors import DEGREES_40, SQUARE_MILLIMETRE
from pyworm.io import units
from pyworm.io.input_error import CaseError
from pyworm.io.plain_values import Fraction
from pyworm.io.toml import read_toml
from pyworm.materials.oil import BOUNDARY_FRICTION
from pyworm.materials.thermal_properties import HeatCourse

Base = Literal["mineral", "PAO", "ester", "PAG"]

BASES: tuple[Base, ...] = get_args(Base)
"""Base stocks in the table."""

GRADE_TOLERANCE = 0.11
"""Largest deviation of a table's oil from its grade; ISO 3448 has 0.1, which one measured oil misses."""


_TABLE = Path(__file__).with_name("oils.toml")


_AgmaFactor = Annotated[float, units.Quantity("a pressure coefficient", "1/Pa", "0.0105 mm^2/N")]
Positive = Annotated[float, Field(strict=True, gt=0, allow_inf_nan=False)]


@dataclass(frozen=True, kw_only=True)
class StockProperties:
    """Properties of the oils of one base stock, which an oil file may replace."""

    density_15: units.OilDensity
    """Density at 15 degC [kg/m3]."""
    density_coefficient: units.TemperatureCoefficient
    """Relative fall of the density with temperature [1/K]."""
    specific_heat: units.SpecificHeat
    """Specific heat [J/(kg K)]."""
    gold_s: Positive
    """Constant s of Gold's law of the pressure-viscosity coefficient (`oil_laws.gold_alpha`)."""
    gold_t: Fraction
    """Constant t of Gold's law of that coefficient."""
    alpha_spread: Annotated[float, Field(strict=True, ge=0, lt=1)] = 0.0
    """Relative uncertainty of that coefficient [-]."""
    density_d1: units.PressureCoefficientOrZero = 0.6e-9
    """d1 of the rise of the density with pressure [1/Pa] (`pyworm.materials.viscosity_density.Density`)."""
    density_d2: units.PressureCoefficientOrZero = 1.7e-9
    """d2 of the rise of the density with pressure [1/Pa]."""
    conductivity: units.OilConductivity | None = None
    """Thermal conductivity [W/(m K)]; None where Cragoe's formula gives it."""
    agma_k: _AgmaFactor | None = None
    """Constant k of AGMA's law, in mm2/N (`oil_laws.agma_alpha`); None where it has none."""
    agma_s: Fraction | None = None
    """Constant s of AGMA's law; None where it has none."""
    limiting_coefficient: Fraction | None = None
    """Limiting stress over pressure [-], which gives Eyring's, too; None where stresses are given."""
    eyring_stress: units.Stress | None = None
    """Constant Eyring stress [Pa]; None where the coefficient gives it."""
    limiting_stress: units.Stress | None = None
    """Constant limiting stress [Pa]; None where the coefficient gives it."""
    boundary_friction: Annotated[float, Field(strict=True, gt=0, le=1)] = BOUNDARY_FRICTION
    """Friction coefficient of asperities of steel on steel or tin bronze [-]."""


@dataclass(frozen=True, kw_only=True)
class BaseStock(StockProperties):
    """A base stock of the list with its oils."""

    name: Base
    """Base stock."""
    heat: dict[str, float] = field(default_factory=dict)
    """Further constants of `pyworm.materials.thermal_properties.OilHeat`."""
    grades: dict[int, tuple[float, float]] = field(default_factory=dict)
    """ISO viscosity grade -> Walther's m and n."""
    sources: dict[str, str] = field(default_factory=dict)
    """Where the numbers come from."""


def base_stock(name: str) -> BaseStock:
    """The base stock of a name in `BASES`, in any case of letters; ValueError for no such base stock."""
    for base, stock in _stocks().items():
        if base.lower() == name.lower():
            return stock
    raise ValueError(f'base "{name}": must be one of {", ".join(BASES)}')


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class HeatCourseTable(_Table, HeatCourse):
    """Keys of `OilHeat` for the dependence of thermal constants on pressure and temperature."""


class StockTable(_Table):
    """Base of tables of files that are derived from `StockProperties`, too."""

    heat: HeatCourseTable = HeatCourseTable()

    if TYPE_CHECKING:
        limiting_coefficient: float | None
        eyring_stress: float | None
        limiting_stress: float | None

    @model_validator(mode="after")
    def _stresses_in_pairs(self) -> Self:
        if (self.eyring_stress is None) != (self.limiting_stress is None):
            raise ValueError("give eyring_stress and limiting_stress together")
        if self.eyring_stress is not None and self.limiting_coefficient is not None:
            raise ValueError("give either limiting_coefficient or the two stresses")
        return self

    def own(self) -> dict[str, Any]:
        """The given properties under the names of `BaseStock`."""
        names = {part.name for part in fields(StockProperties)}
        given = self.model_dump(exclude_unset=True, include={"heat", *names})
        if {"gold_s", "gold_t"} & given.keys():
            given.setdefault("alpha_spread", 0.0)  # measured by whoever gives it
        if "agma_k" in given:
            given["agma_k"] *= 1e6  # AGMA's law is written in mm2/N
        if "eyring_stress" in given:
            given["limiting_coefficient"] = None
        elif "limiting_coefficient" in given:
            given["eyring_stress"] = given["limiting_stress"] = None
        return given


class _BaseStockTable(StockTable, StockProperties):
    """One base stock of the table: all properties, each with its source."""

    alpha_spread: Annotated[float, Field(strict=True, gt=0, lt=1)]
    grades: dict[int, tuple[Positive, Positive]]
    sources: dict[str, str]

    @model_validator(mode="after")
    def _one_way_to_flow(self) -> Self:
        if self.limiting_coefficient is None and self.eyring_stress is None:
            raise ValueError("give limiting_coefficient or the two stresses")
        return self


@cache
def _stocks() -> dict[Base, BaseStock]:
    """The checked table: the viscosity of every oil is within its grade."""
    data = read_toml(_TABLE)
    stocks = {}
    for base in BASES:
        table = _BaseStockTable.model_validate(data[base])
        stock = BaseStock(name=base, **table.own(), grades=table.grades, sources=table.sources)
        for grade, (m, n) in stock.grades.items():
            nu = oil_properties.walther_viscosity(m, n, DEGREES_40) / SQUARE_MILLIMETRE
            if grade not in ISO_GRADES or abs(float(nu) / grade - 1) > GRADE_TOLERANCE:
                raise CaseError(f"{_TABLE}: {base} VG {grade}: has {nu:.1f} mm2/s at 40 degC")
        stocks[base] = stock
    return stocks
