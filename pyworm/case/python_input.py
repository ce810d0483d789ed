"""Tables of a case given in Python, written as a case file has them, so that all is checked alike.

Numbers in SI become texts with units where a key has a dimension, materials, oils and solids become tables.
"""

from collections.abc import Mapping
from dataclasses import fields
from typing import Any, get_args

import numpy as np
from pydantic import BaseModel

from pyworm.case.oil import ShearTable
from pyworm.case.workshop_units import kind_of
from pyworm.io.input_error import CaseError, models_of
from pyworm.io.quantity import Kind
from pyworm.materials.body import Body
from pyworm.materials.flow_laws import FlowLaw
from pyworm.materials.oil import Oil
from pyworm.materials.oil_layer import OilLayer
from pyworm.materials.tabulated import TabulatedDensity, TabulatedViscosity
from pyworm.materials.thermal_properties import HeatCourse, OilHeat
from pyworm.materials.viscosity_density import Roelands, ViscosityLaw

SOURCE = "Python script"
"""Source of the numbers of a case that names none."""

TWO_BODIES = (
    'bodies: must be two, body 1 first, each a material such as "16MnCr5", a Body or a table, or a '
    "table of both"
)


def as_file(data: Mapping[str, Any], name: str, model: type[BaseModel]) -> dict[str, Any]:
    """The content of a file, from tables given in Python.

    Args:
        data: The tables, with texts or numbers in SI; `oil` may be an `Oil`, `bodies` two of `Body` or
            materials by name.
        name: Title of the file if it has none.
        model: The tables that such a file has.

    Raises:
        CaseError: Bodies or an oil that no file can hold; the sentence begins with the key.
    """
    content: dict[str, Any] = {"title": name, "source": SOURCE, **_plain(data)}
    if "bodies" in content and "bodies" in model.model_fields:
        (bodies,) = models_of(model.model_fields["bodies"].annotation)
        content["bodies"] = _bodies(content["bodies"], tuple(bodies.model_fields))
    if isinstance(content.get("oil"), Oil):
        content["oil"] = oil_table(content["oil"])
    found: dict[str, Any] = _with_units(content, [model])
    return found


def _plain(value: Any) -> Any:
    """A value in the types that TOML has; what has none stays."""
    if isinstance(value, Mapping):
        return {str(key): _plain(part) for key, part in value.items() if part is not None}
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    return [_plain(part) for part in value] if isinstance(value, list | tuple) else value


def _with_units(value: Any, models: list[type[BaseModel]], kind: Kind | None = None) -> Any:
    """A value with its numbers of a kind as texts with the SI unit, to the last digit."""
    if isinstance(value, dict):
        parts = {}
        for key, part in value.items():
            found = [model.model_fields[key] for model in models if key in model.model_fields]
            kinds = [kind for field in found if (kind := kind_of(field)) is not None]
            tables = [table for field in found for table in models_of(field.annotation)]
            # the name of a bearing is the writer's own: its table is that of the values
            parts[key] = _with_units(part, tables or models * (not found), next(iter(kinds), kind))
        return parts
    if isinstance(value, list):
        return [_with_units(part, models, kind) for part in value]
    if kind is None or isinstance(value, bool) or not isinstance(value, float | int):
        return value
    return f"{value!r} {kind.unit}".rstrip()


def _bodies(bodies: Any, names: tuple[str, ...]) -> Any:
    """`[bodies]` of two solids in a row, or by their names."""
    if isinstance(bodies, dict):
        return {name: _body(name, body) for name, body in bodies.items()}
    if not isinstance(bodies, list) or len(bodies) != len(names):
        raise CaseError(TWO_BODIES)
    return {name: _body(name, body) for name, body in zip(names, bodies, strict=True)}


def _body(name: str, body: Any) -> Any:
    """`[bodies.NAME]` of a solid, or of a material by its name."""
    if isinstance(body, str):
        return {"material": body}
    if not isinstance(body, Body):
        return body
    if body.topography is not None or body.long_waves is not None:
        raise CaseError(
            f"bodies.{name}: a measured surface is given by its file, {{'surface': {{'file': ...}}}}"
        )
    given = {
        part.name: getattr(body, part.name)
        for part in fields(body)
        if getattr(body, part.name) != part.default
    }
    if body.modulus_by_temperature:
        del given["youngs_modulus"]
    return _plain(given)


def oil_table(oil: Oil) -> dict[str, Any]:
    """`[oil]` of an oil, with numbers in SI.

    Raises:
        CaseError: A density or a flow law by a table, which no case file can hold.
    """
    if isinstance(oil.density, TabulatedDensity):
        raise CaseError("oil.density is a table: gear sets take Density, or tables of a case file")
    found = {
        "name": "oil of the script",
        "viscosity": _viscosity(oil.viscosity),
        "density": {"law": "general", **vars(oil.density)},
        "shear": None if oil.flow is None else _shear(oil.flow),
        "heat": None if oil.heat is None else _heat(oil.heat, oil.viscosity),
        "supply": vars(oil.supply) if isinstance(oil.supply, OilLayer) else oil.supply,
        "boundary_friction": oil.boundary_friction,
        "alpha_spread": oil.alpha_spread,
    }
    plain: dict[str, Any] = _plain(found)
    return plain


def _viscosity(law: ViscosityLaw | TabulatedViscosity) -> dict[str, Any]:
    if isinstance(law, TabulatedViscosity):
        return {
            "law": "tabulated",
            "pressure": law.pressures,
            "temperature": law.temperatures,
            "viscosity_at": law.values,
        }
    constants = {part.name: getattr(law, part.name) for part in fields(law)}
    if isinstance(law, Roelands):
        constants["pole_pressure"] = constants.pop("p0")
    return {"law": law.CASE_NAME, **constants}


def _shear(flow: FlowLaw) -> dict[str, Any]:
    """`[oil.shear]` with the constants that its law reads."""
    for table in get_args(ShearTable):
        if flow.law in get_args(table.model_fields["law"].annotation):
            constants = {name: getattr(flow, name) for name in table.model_fields}
            if constants.get("branches"):
                constants["branches"] = [vars(branch) for branch in constants["branches"]]
            return constants
    raise CaseError(f"oil.flow has the law {flow.law}: gear sets take one of a case file")


def _heat(heat: OilHeat, law: ViscosityLaw | TabulatedViscosity) -> dict[str, Any]:
    constants = {part.name: getattr(heat, part.name) for part in fields(HeatCourse)}
    for name in ("inlet_temperature", "conductivity", "specific_heat", "expansivity"):
        constants[name] = getattr(heat, name)
    if isinstance(law, Roelands):
        constants["s0"] = heat.viscosity_exponent
    elif not isinstance(law, TabulatedViscosity):
        exponent, inlet = heat.viscosity_exponent, heat.inlet_temperature
        constants["beta"] = law.THINNING.beta(law, exponent, inlet)
    return constants
