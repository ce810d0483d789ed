"""`[oil]` with a name and a temperature: the tables of a named oil.

They are written as a case file has them, so that what the file gives beside goes in place of it, and all is
checked alike.
"""

from dataclasses import asdict
from typing import Annotated, Any

from pydantic import AfterValidator, ConfigDict, ValidationInfo, field_validator

from pyworm.case.table import Table
from pyworm.io import units
from pyworm.io.given import quantities
from pyworm.materials.flow_laws import LimitingStress, ThinningStress
from pyworm.materials.library import NamedOil, named_oil
from pyworm.materials.thermal_properties import OilHeat
from pyworm.materials.viscosity_density import Density, Roelands

_LAWS: tuple[type, ...] = (Roelands, Density, ThinningStress, LimitingStress, OilHeat)

_UNITS = {name: kind.unit for law in _LAWS for name, (kind, _) in quantities(law).items()}
_UNITS |= {"alpha": "1/Pa", "beta": "1/K"}
"""Key of a constant -> its SI unit; a key that is not here is a plain number."""

_INSTEAD = {"z": "alpha", "s0": "beta"}
"""Key that a file may give -> key of the named oil with the same meaning."""


def _known(name: str) -> str:
    try:
        return named_oil(name).name
    except ValueError as error:
        raise ValueError(str(error).removeprefix(f'oil "{name}": ')) from None


class _ByName(Table):
    """The keys that select the oil; the rest of `[oil]` is ignored."""

    model_config = ConfigDict(extra="ignore")

    name: Annotated[str, AfterValidator(_known)]
    temperature: units.Temperature

    @field_validator("temperature")
    @classmethod
    def _within_what_is_known(cls, kelvin: float, info: ValidationInfo) -> float:
        if "name" in info.data:
            try:
                named_oil(info.data["name"]).oil(kelvin)
            except ValueError as error:
                raise ValueError(
                    f'too far from what is known of {info.data["name"]}, give one such as "60 degC" ({error})'
                ) from None
        return kelvin


def spelled_out(table: dict[str, Any]) -> dict[str, Any]:
    """`[oil]` of a name and a temperature, completed with all its tables.

    A table that gives its law stands as it is. Keys of others go in place of the named oil's. ValidationError
    if there is no such oil, or none at this temperature; ValueError if the temperature of the oil is given
    twice.
    """
    asked = _ByName.model_validate(table)
    heat = table.get("heat")
    if isinstance(heat, dict) and "inlet_temperature" in heat:
        raise ValueError(
            "give either temperature or heat.inlet_temperature: a named oil enters at its temperature"
        )
    named = named_oil(asked.name)
    whole = {"boundary_friction": named.stock.boundary_friction, **table, "name": named.name}
    if not _gives_alpha(table.get("viscosity")):
        whole.setdefault("alpha_spread", named.stock.alpha_spread)
    for key, named_table in _tables(named, asked.temperature).items():
        given = table.get(key, {})
        if isinstance(given, dict) and "law" not in given:
            replaced = {_INSTEAD[key] for key in given if key in _INSTEAD}
            kept = {entry: value for entry, value in named_table.items() if entry not in replaced}
            whole[key] = kept | given
    return whole


def _gives_alpha(viscosity: Any) -> bool:
    """Whether `[oil.viscosity]` has its own rise with pressure, by a constant or by a law."""
    return isinstance(viscosity, dict) and not viscosity.keys().isdisjoint({"law", "alpha", "z"})


def _tables(named: NamedOil, temperature: float) -> dict[str, dict[str, Any]]:
    """A named oil at a temperature [K] as `[oil.viscosity]`, `density`, `shear` and `heat`."""
    oil = named.oil(temperature)
    viscosity = {"eta0": oil.viscosity.eta0, "alpha": float(named.alpha(temperature))}
    flow = {key: getattr(oil.flow, key) for key in ("stress", "limit", "limit_pressure")}
    heat = asdict(oil.thermal) | {"beta": float(named.viscosity_slope(temperature))}
    del heat["viscosity_exponent"], heat["supply_temperature"]
    return {
        "viscosity": {"law": "roelands", **_written(viscosity)},
        "density": {"law": "general", **_written(asdict(oil.density))},
        "shear": {"law": oil.sheared.law, **_written(flow)},
        "heat": _written(heat),
    }


def _written(constants: dict[str, float]) -> dict[str, str | float]:
    """Constants with their units, in full precision."""
    return {
        key: f"{value!r} {_UNITS[key]}" if key in _UNITS else value
        for key, value in constants.items()
    }
