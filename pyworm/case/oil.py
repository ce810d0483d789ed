"""`[oil]`: the lubricant of a case."""

from collections.abc import Iterator
from math import exp
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self, TypeAlias, TypeVar, Union

from pydantic import (
    Discriminator,
    Field,
    Tag,
    create_model,
    field_validator,
    model_validator,
)

from pyworm.case.named_oil import spelled_out
from pyworm.case.own_oil import (
    CarreauYasudaTable,
    MeasuredTable,
    OwnViscosityTable,
    TaitTable,
    liquids,
)
from pyworm.case.table import Table, plain
from pyworm.formulas.oil_properties import ROELANDS_POLE_LOG
from pyworm.formulas.unit_factors import DEGREES_40
from pyworm.io import units
from pyworm.io.given import WithUnit, kind_of, number, text
from pyworm.io.plain_values import AboveZeroToOne, PositiveNumber, Text
from pyworm.io.present import present
from pyworm.materials.base_stock import Base
from pyworm.materials.flow_laws import FlowLaw, LimitingStress, ThinningStress
from pyworm.materials.library import named_oil, names
from pyworm.materials.oil import BOUNDARY_FRICTION, Oil
from pyworm.materials.oil_layer import OilLayer
from pyworm.materials.tabulated import TabulatedDensity, TabulatedViscosity
from pyworm.materials.thermal_properties import HeatCourse, OilHeat
from pyworm.materials.viscosity_density import (
    ROELANDS_PRESSURE,
    VISCOSITY_LAWS,
    Density,
    Roelands,
    ViscosityLaw,
)

LimitT = TypeVar("LimitT", bound=LimitingStress)

POLE_VISCOSITY = exp(-ROELANDS_POLE_LOG)
"""Viscosity of the pole of Roelands' law [Pa s]; oils have more."""


class ViscosityTable(Table):
    """`[oil.viscosity]` of a law that the kernel computes, with the law's fields unless a file says more."""

    LAW: ClassVar[type[ViscosityLaw]]
    """The law."""

    def viscosity(self, inlet: float, density: Any) -> ViscosityLaw:
        """The law."""
        fields: Any = self  # its class is derived from the law, too
        return plain(fields, self.LAW)


class RoelandsTable(ViscosityTable):
    """`[oil.viscosity]`, law = "roelands".

    The exponent is given as `z` or by the slope `alpha`; the pole as a pressure (1.96e8 Pa in its usual
    rounding, which is the default) or as its reciprocal (5.1e-9 1/Pa).
    """

    LAW = Roelands

    law: Literal["roelands"]
    eta0: units.Viscosity
    z: PositiveNumber | None = None
    alpha: units.PressureViscosity | None = None
    pole_pressure: units.Pressure | None = None
    pole_coefficient: units.PressureCoefficient | None = None

    @field_validator("eta0")
    @classmethod
    def _above_the_pole(cls, viscosity: float) -> float:
        if viscosity <= POLE_VISCOSITY:
            raise ValueError(
                f"must be above {POLE_VISCOSITY:.2g} Pa s, the pole of Roelands' law, such as "
                '"0.04 Pa s"; law = "barus" has none'
            )
        return viscosity

    def flaws(self) -> Iterator[str]:
        """Not one exponent, or two poles."""
        yield from self.unless_either("z", "alpha")
        yield from self.unless_either("pole_pressure", "pole_coefficient", needed=False)

    def viscosity(self, inlet: float, density: Any) -> Roelands:
        """The law."""
        if self.pole_coefficient is not None:
            pole = 1 / self.pole_coefficient
        else:
            pole = self.pole_pressure or ROELANDS_PRESSURE
        if self.z is not None:
            return Roelands(self.eta0, self.z, pole)
        return Roelands.from_alpha(self.eta0, present(self.alpha, "alpha"), pole)


def _viscosity_table(law: type[ViscosityLaw]) -> type[ViscosityTable]:
    """The table with the fields of a law."""
    about = f'`[oil.viscosity]`, law = "{law.CASE_NAME}".'
    fields: Any = {"law": (Literal[law.CASE_NAME], ...)}
    new_model: Any = create_model
    table: type[ViscosityTable] = new_model(
        f"{law.__name__}Table",
        __base__=(ViscosityTable, law),
        __module__=__name__,
        __doc__=about,
        **fields,
    )
    table.LAW = law
    return table


AnyViscosityTable: TypeAlias = ViscosityTable | OwnViscosityTable
"""`[oil.viscosity]`: a table for each of `VISCOSITY_LAWS`, or a law of one's own."""

if not TYPE_CHECKING:
    of_fields = (_viscosity_table(law) for law in VISCOSITY_LAWS if law is not Roelands)
    AnyViscosityTable = Union[*of_fields, RoelandsTable, OwnViscosityTable]


class DensityTable(Table):
    """`[oil.density]` with a published set of coefficients."""

    law: Literal["dowson-higginson", "dowson-higginson-pole", "incompressible"]
    rho0: units.OilDensity

    def density(self) -> Density:
        """The law."""
        makers = {
            "dowson-higginson": Density.dowson_higginson,
            "dowson-higginson-pole": Density.dowson_higginson_pole,
            "incompressible": Density.incompressible,
        }
        return makers[self.law](self.rho0)


class GeneralDensityTable(Table, Density):
    """`[oil.density]`, law = "general": rho0 [1 + d1 p / (1 + d2 p)] with its own coefficients."""

    law: Literal["general"]

    def density(self) -> Density:
        """The law."""
        return plain(self, Density)


class NewtonianTable(Table):
    """`[oil.shear]`, law = "newtonian": the stress grows with the shear rate without end."""

    law: Literal["newtonian"]


def _some_limit(table: LimitT) -> LimitT:
    """A table with a limiting stress; ValueError of one without."""
    if table.limit == table.limit_pressure == 0:
        raise ValueError('give limit, such as "100 MPa", or limit_pressure, such as 0.05')
    return table


class EyringTable(Table, ThinningStress):
    """`[oil.shear]`, law = "eyring"; stress is Eyring's."""

    law: Literal["eyring"]


class BairWinerTable(Table, LimitingStress):
    """`[oil.shear]`, law = "bair-winer"."""

    law: Literal["bair-winer"]
    _limited = model_validator(mode="after")(_some_limit)


class LimitedEyringTable(Table, ThinningStress, LimitingStress):
    """`[oil.shear]`, law = "eyring-limited"; stress is Eyring's, exponent the paper's lambda."""

    law: Literal["eyring-limited"]
    exponent: PositiveNumber = 1.0
    _limited = model_validator(mode="after")(_some_limit)


class CarreauTable(Table, ThinningStress):
    """`[oil.shear]`, law = "carreau"; stress is Carreau's modulus G, exponent his n."""

    law: Literal["carreau"]
    exponent: AboveZeroToOne


ShearTable = (
    NewtonianTable
    | EyringTable
    | BairWinerTable
    | LimitedEyringTable
    | CarreauTable
    | CarreauYasudaTable
)
"""`[oil.shear]`: how the oil shears; the laws are those of `FlowLaw`."""


class HeatTable(Table, HeatCourse):
    """`[oil.heat]`: thermal constants of the oil; the laws are those of `OilHeat`.

    How viscosity falls with temperature is given by the exponent `s0` of Roelands' law or by its slope `beta`
    at the inlet; for Barus' law by `beta`. What is left out does not depend on pressure or temperature.
    """

    inlet_temperature: units.Temperature
    s0: PositiveNumber | None = None
    beta: units.TemperatureCoefficient | None = None
    conductivity: units.OilConductivity
    specific_heat: units.SpecificHeat
    expansivity: units.TemperatureCoefficientOrZero = 0.0

    def heat(self, viscosity: ViscosityLaw | TabulatedViscosity) -> OilHeat:
        """The laws of an oil of this viscosity."""
        constants = self.model_dump(exclude={"s0", "beta"})
        if isinstance(viscosity, TabulatedViscosity):
            exponent: float = 0.0  # the table has it
        elif self.s0 is not None:
            exponent = self.s0
        else:
            beta, inlet = present(self.beta, "beta"), self.inlet_temperature
            exponent = viscosity.THINNING.exponent(viscosity, beta, inlet)
        return OilHeat(viscosity_exponent=exponent, **constants)


class OilLayerTable(Table, OilLayer):
    """`[oil.supply]`: the layer that arrives, over the place across the track."""

    @model_validator(mode="after")
    def _a_profile(self) -> Self:
        self.layer()
        return self

    def layer(self) -> OilLayer:
        """The layer as the kernel sees it."""
        return plain(self, OilLayer)


def _layer_or_profile(supply: Any) -> str:
    return "profile" if isinstance(supply, dict | OilLayerTable) else "layer"


SupplyTable = Annotated[
    Annotated[units.Film, Tag("layer")] | Annotated[OilLayerTable, Tag("profile")],
    Discriminator(_layer_or_profile),
]
"""`oil.supply`: one thickness, or a table of them."""


class OilTable(Table):
    """`[oil]`: the oil at its inlet temperature, and the thickness of the layer supplied if it is limited.

    With a temperature beside it the name is that of an oil in `pyworm/data/oils.toml`, whose numbers there
    fill in the tables. A checked case holds these numbers, and has no need of the temperature any more.
    """

    name: Text
    temperature: units.Temperature | None = Field(default=None, exclude=True)
    liquid: Text | None = Field(default=None, exclude=True)
    viscosity: Annotated[AnyViscosityTable, Field(discriminator="law")]
    density: Annotated[DensityTable | GeneralDensityTable | TaitTable, Field(discriminator="law")]
    shear: Annotated[ShearTable, Field(discriminator="law")] | None = None
    heat: HeatTable | None = None
    supply: SupplyTable | None = None
    boundary_friction: Annotated[float, Field(strict=True, gt=0, le=1)] = BOUNDARY_FRICTION
    alpha_spread: Annotated[float, Field(strict=True, ge=0, le=1)] = 0.0

    @model_validator(mode="before")
    @classmethod
    def _by_name(cls, table: Any) -> Any:
        if not isinstance(table, dict):
            return table
        if "liquid" in table:
            return _of_liquid(table)
        # A known name alone lacks its temperature rather than the tables.
        bare = table.keys() == {"name"} and table["name"] in names()
        return spelled_out(table) if "temperature" in table or bare else table

    def flaws(self) -> Iterator[str]:
        """Not one exponent of temperature, or tables that make no law."""
        exponents = [] if self.heat is None else self.heat.given("s0", "beta")
        if not isinstance(self.viscosity, ViscosityTable):
            if exponents:
                yield f"heat needs neither s0 nor beta, which {self.viscosity.law} has itself"
            self.oil()  # raises where they make no law
        elif self.heat is not None:
            law = self.viscosity.LAW
            if not law.THINNING.has_s0 and exponents != ["beta"]:
                yield f"heat needs beta, and no s0, where viscosity.law is {law.CASE_NAME}"
            if len(exponents) != 1:
                yield "heat needs either s0 or beta, one of the two"

    @property
    def _inlet(self) -> float:
        """Temperature at which the oil enters [K]: that of its heat, or at which its laws are given."""
        if self.heat is not None:
            return self.heat.inlet_temperature
        if self.temperature is not None:
            return self.temperature
        if isinstance(self.density, TaitTable):
            return self.density.reference_temperature
        if isinstance(self.viscosity, MeasuredTable) and len(self.viscosity.temperature) == 1:
            return self.viscosity.temperature[0]
        return DEGREES_40

    @property
    def base(self) -> Base | None:
        """Base stock of an oil that bears a name of the list; None of any other."""
        return named_oil(self.name).stock.name if self.name in names() else None

    def oil(self) -> Oil:
        """The oil as the kernel sees it."""
        inlet, shear = self._inlet, self.shear
        constants = shear.constants if isinstance(shear, CarreauYasudaTable) else dict(shear or ())
        viscosity = self.viscosity.viscosity(inlet, self.density)
        density: Density | TabulatedDensity
        if isinstance(self.density, TaitTable):
            density = self.density.density(inlet)
        else:
            density = self.density.density()
        return Oil(
            viscosity=viscosity,
            density=density,
            flow=None if shear is None else FlowLaw(**constants),
            heat=None if self.heat is None else self.heat.heat(viscosity),
            supply=self.supply.layer() if isinstance(self.supply, OilLayerTable) else self.supply,
            boundary_friction=self.boundary_friction,
            alpha_spread=self.alpha_spread,
        )


def _of_liquid(table: dict[str, Any]) -> dict[str, Any]:
    """`[oil]` of a liquid of the literature and a temperature, with all its tables."""
    name, known = table["liquid"], liquids()
    if name not in known:
        raise ValueError(f'liquid = "{name}": must be one of {", ".join(known)}')
    if "temperature" not in table:
        raise ValueError(f"temperature is missing, at which {name} enters")
    tables = {key: part for key, part in known[name].items() if key != "source"}
    tables["heat"] = {**tables["heat"], "inlet_temperature": table["temperature"]}
    return {"name": name, **tables, **table}


def named_liquid(name: str, temperature: WithUnit) -> Oil:
    """A liquid of the literature whose laws were fitted to measurements (`pyworm/materials/liquids.toml`).

    Args:
        name: "squalane" or "PAO-B".
        temperature (float or str): At which it enters a contact [K].

    Raises:
        ValueError: No such liquid, or no temperature.
    """
    name = text("name", name)
    kelvin = number("temperature", temperature, kind_of(units.Temperature))
    table = {"liquid": name, "temperature": f"{kelvin!r} K"}
    return OilTable.model_validate(_of_liquid(table)).oil()
