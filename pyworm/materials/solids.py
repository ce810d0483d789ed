"""Materials by name: constants of gear steels, bronzes, irons and plastics, and usual roughness."""

from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from pyworm.io import units
from pyworm.io.toml import read_toml

_TABLE = Path(__file__).with_name("solids.toml")


class SolidTable(BaseModel):
    """One material of the table, as written there, each constant with its unit.

    Plastics have a modulus over temperature in place of one, and a temperature that they bear for long.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    aliases: tuple[str, ...]
    youngs_modulus: units.Modulus | None = None
    modulus_by_temperature: tuple[tuple[units.MaterialTemperature, units.Modulus], ...] = ()
    temperature_limit: units.MaterialTemperature | None = None
    poisson_ratio: Annotated[float, Field(strict=True, ge=0, lt=0.5)]
    density: units.MassDensity
    conductivity: units.Conductivity
    specific_heat: units.SpecificHeat
    thermal_expansion: units.ThermalExpansion
    hardness: units.Hardness
    boundary_friction_factor: Annotated[float, Field(strict=True, ge=0.2, le=5)] = 1.0
    source: str

    @model_validator(mode="after")
    def _one_modulus(self) -> Self:
        if (self.youngs_modulus is None) == (not self.modulus_by_temperature):
            raise ValueError("give either youngs_modulus or modulus_by_temperature, one of the two")
        return self


@cache
def _tables() -> dict[str, dict[str, Any]]:
    """The checked table, its values as they are written."""
    data = read_toml(_TABLE)
    for name, table in data.items():
        if name != "finishes":
            SolidTable.model_validate(table)
    return data


def materials() -> tuple[str, ...]:
    """Names of all materials."""
    return tuple(name for name in _tables() if name != "finishes")


def finishes() -> tuple[str, ...]:
    """Ways of making flanks whose usual roughness is known."""
    return tuple(_tables()["finishes"])


def named_material(text: str) -> str:
    """The name in the table of a material, by any of its names; ValueError if there is none such."""
    known = {
        _plain(alias): name for name in materials() for alias in (name, *_tables()[name]["aliases"])
    }
    if _plain(text) in known:
        return known[_plain(text)]
    near = get_close_matches(_plain(text), known, n=1)
    meant = f'; did you mean "{known[near[0]]}"?' if near else ""
    raise ValueError(f"must be one of {', '.join(materials())}{meant}")


def alloy(name: str) -> str:
    """The alloy of a material of the table, without how it is cast."""
    return name.removesuffix("-GZ").removesuffix("-GC")


def is_named(text: object) -> bool:
    """Whether a text is the name of a material of the table."""
    try:
        return isinstance(text, str) and bool(named_material(text))
    except ValueError:
        return False


def _plain(name: str) -> str:
    """A name without what is written in different ways: capitals, blanks, the C of castings."""
    return name.lower().replace(" ", "").replace("-c-", "-")


def constants(name: str) -> dict[str, Any]:
    """Constants of a material as a case file writes them, its modulus that at room temperature."""
    table = {
        key: value for key, value in _tables()[name].items() if key not in ("aliases", "source")
    }
    if "modulus_by_temperature" in table:
        table["youngs_modulus"] = table["modulus_by_temperature"][0][1]
    return table


def source(name: str) -> str:
    """What the constants of a material of the table rest on."""
    return str(_tables()[name]["source"])


def usual_roughness(finish: str) -> str:
    """Arithmetic mean Ra of flanks made in a way, as a case file writes it."""
    return str(_tables()["finishes"][finish])
