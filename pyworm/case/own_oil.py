"""Laws of `[oil]` beyond the usual ones: free volume, fits and measurements over pressure and temperature."""

from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field

from pyworm.case.table import Table, plain
from pyworm.formulas.liquids import Doolittle, RoelandsFit, Tait
from pyworm.io import units
from pyworm.io.plain_values import AboveZeroToOne, Fraction, PositiveNumber
from pyworm.io.toml import read_toml
from pyworm.materials.flow_laws import Branch, LimitingStress, ThinningStress
from pyworm.materials.tabulated import TabulatedDensity, TabulatedViscosity

_LIQUIDS = Path(units.__file__).parents[1] / "materials/liquids.toml"


@cache
def liquids() -> dict[str, dict[str, Any]]:
    """Tables of liquids of the literature by name, as a case file has them."""
    return read_toml(_LIQUIDS)


class TaitTable(Table, Tait):
    """`[oil.density]`, law = "tait": Tait's equation of state (`formulas.liquids.Tait`)."""

    law: Literal["tait"]
    bulk_decay: units.TemperatureCoefficientOrZero = 0.0

    def density(self, inlet: float) -> TabulatedDensity:
        """The law of an oil that enters at a temperature [K]."""
        return TabulatedDensity.of(plain(self, Tait), inlet)


class DoolittleTable(Table):
    """`[oil.viscosity]`, law = "tait-doolittle": free volume of Tait's density (`Doolittle`)."""

    law: Literal["tait-doolittle"]
    eta0: units.Viscosity
    parameter: PositiveNumber
    occupied: Fraction
    occupied_expansivity: units.TemperatureCoefficientAnySign = 0.0

    def viscosity(self, inlet: float, density: Any) -> TabulatedViscosity:
        """The law of an oil that enters at a temperature [K]."""
        if not isinstance(density, TaitTable):
            raise ValueError(
                'viscosity.law = "tait-doolittle" needs density.law = "tait" for its volume'
            )
        law = Doolittle(
            plain(density, Tait),
            self.eta0,
            self.parameter,
            self.occupied,
            self.occupied_expansivity,
        )
        return TabulatedViscosity.of(law, inlet)


class RoelandsFitTable(Table, RoelandsFit):
    """`[oil.viscosity]`, law = "roelands-fit": Roelands' law fitted over temperature (`RoelandsFit`)."""

    law: Literal["roelands-fit"]

    def viscosity(self, inlet: float, density: Any) -> TabulatedViscosity:
        """The law of an oil that enters at a temperature [K]."""
        return TabulatedViscosity.of(plain(self, RoelandsFit), inlet)


class MeasuredTable(Table):
    """`[oil.viscosity]`, law = "tabulated": measurements, a list of viscosities for each pressure."""

    law: Literal["tabulated"]
    pressure: Annotated[list[units.PressureCoordinate], Field(min_length=4)]
    temperature: Annotated[list[units.Temperature], Field(min_length=1)]
    viscosity_at: list[list[units.Viscosity]]

    def viscosity(self, inlet: float, density: Any) -> TabulatedViscosity:
        """The law of an oil that enters at a temperature [K]."""
        table = np.array(self.viscosity_at)
        return TabulatedViscosity(np.array(self.pressure), np.array(self.temperature), table, inlet)


OwnViscosityTable = DoolittleTable | RoelandsFitTable | MeasuredTable
"""Laws of viscosity over pressure and temperature, in which no exponent of temperature is missing."""


class BranchTable(Table, Branch):
    """One of `[[oil.shear.branches]]`."""


class CarreauYasudaTable(Table, ThinningStress, LimitingStress):
    """`[oil.shear]`, law = "carreau-yasuda", of one branch or several, with or without a limiting stress."""

    law: Literal["carreau-yasuda"]
    exponent: AboveZeroToOne = 1.0
    yasuda: PositiveNumber = 2.0
    branches: list[BranchTable] = Field(default_factory=list)

    def flaws(self) -> Iterator[str]:
        """Branches that are no whole."""
        total = sum(branch.fraction for branch in self.branches)
        if self.branches and abs(total - 1) > 1e-6:
            yield f"the fractions of branches add up to {total:g}, and must to 1"

    @property
    def constants(self) -> dict[str, Any]:
        """Constants of the flow law."""
        given = dict(self)
        return given | {"branches": tuple(plain(branch, Branch) for branch in self.branches)}
