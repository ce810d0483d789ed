"""Oils described in TOML files of the user."""

from dataclasses import replace
from pathlib import Path
from typing import Annotated, Self

from pydantic import Field, ValidationError, model_validator

from pyworm.io import units
from pyworm.io.input_error import CaseError, sentence
from pyworm.io.plain_values import Fraction
from pyworm.io.present import present
from pyworm.io.toml import read_toml
from pyworm.materials.base_stock import Base, Positive, StockProperties, StockTable
from pyworm.materials.library import NamedOil, named_oil, oil_from_index, oil_from_viscosities


def read_oil(path: str | Path) -> NamedOil:
    """Read an oil from the user's TOML file.

    It gives `name`, `base`, `source`, `viscosity_40` with `viscosity_100` or `viscosity_index`, and
    whatever else of its base stock is to be replaced: the keys of a base stock in
    `pyworm/data/oils.toml` except the grades.

        name = "Shop oil 12"
        source = "data sheet of 2024"
        base = "PAO"
        viscosity_40 = "225 mm^2/s"
        viscosity_100 = "27 mm^2/s"
        density_15 = "861 kg/m^3"

    Args:
        path (str or Path): The file.

    Raises:
        CaseError: The first error found, as one line.
    """
    data = read_toml(Path(path))
    try:
        table = _OilTable.model_validate(data)
        if table.viscosity_100 is not None:
            oil = oil_from_viscosities(
                table.name, table.base, table.viscosity_40, table.viscosity_100, table.source
            )
        else:
            index = present(table.viscosity_index, "viscosity_index")
            oil = oil_from_index(table.name, table.base, table.viscosity_40, index)
    except ValidationError as error:
        raise CaseError(f"{path}: {sentence(error, _OilTable, data)}") from None
    except ValueError as error:
        raise CaseError(f"{path}: {error}") from None
    given = table.own()
    sources = {**oil.stock.sources, **dict.fromkeys(given, table.source)}
    return replace(oil, source=table.source, stock=replace(oil.stock, **given, sources=sources))


class _OilTable(StockTable, StockProperties):
    """Table of a user's oil; what it does not give is its base stock's."""

    density_15: units.OilDensity | None = None  # type: ignore[assignment]  # may be left out here
    density_coefficient: units.TemperatureCoefficient | None = None  # type: ignore[assignment]  # so
    specific_heat: units.SpecificHeat | None = None  # type: ignore[assignment]  # so
    gold_s: Positive | None = None  # type: ignore[assignment]  # so
    gold_t: Fraction | None = None  # type: ignore[assignment]  # so
    name: Annotated[str, Field(min_length=1)]
    source: Annotated[str, Field(min_length=1)]
    base: Base
    viscosity_40: units.KinematicViscosity
    viscosity_100: units.KinematicViscosity | None = None
    viscosity_index: Positive | None = None

    @model_validator(mode="after")
    def _one_way_to_warm(self) -> Self:
        if (self.viscosity_100 is None) == (self.viscosity_index is None):
            raise ValueError("give either viscosity_100 or viscosity_index, one of the two")
        return self


def oil_called(name: str, directory: Path) -> NamedOil:
    """The oil of a name ("PAG VG 460"), or of a .toml file relative to a directory; CaseError without."""
    if name.endswith(".toml"):
        return read_oil(directory / name)
    try:
        return named_oil(name)
    except ValueError as error:
        raise CaseError(str(error)) from error
