"""Values of a case that are fitted to measurements: their keys, kinds, starts and bounds."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any

from pydantic import BaseModel

from pyworm.case.case import Case
from pyworm.case.workshop_units import kind_of
from pyworm.io.input_error import CaseError
from pyworm.io.number_with_unit import converted, number_and_unit, unit_of
from pyworm.io.quantity import Kind, parse
from pyworm.materials.roughness import RUN_IN_SLOPE

SHORT_NAMES = {
    "boundary_friction": ("oil.boundary_friction",),
    "limiting_stress": ("oil.shear.limit_pressure",),
    "eyring_stress": ("oil.shear.stress",),
    "alpha": ("oil.viscosity.alpha",),
    "z": ("oil.viscosity.z",),
    "roughness_slope": ("bodies.{0}.roughness_slope", "bodies.{1}.roughness_slope"),
    "conductance": ("cooling.conductance",),
}
"""Name of a parameter -> its keys; "{0}" and "{1}" stand for the bodies, which then have one value."""

DEFAULTS = {"boundary_friction": None, "roughness_slope": RUN_IN_SLOPE}
"""Last part of a key -> its value where a case does not give it, if it is known here."""

MAX_VALUES = {"boundary_friction": 1.0}
"""Last part of a key -> its largest possible value."""

RANGE = 5.0
"""Factor to both sides of the start by which a parameter may change unless bounds are given."""

_BOUNDS = re.compile(r"(.+?)\s+to\s+(.+)")


@dataclass(frozen=True)
class Parameter:
    """A value of a case that is fitted."""

    name: str
    """How it is called."""
    keys: tuple[str, ...]
    """Dotted keys of the case that have it."""
    unit: str
    """Unit in which it is shown, empty without one."""
    si_unit: str
    """SI unit in which it is calculated with."""
    start: float
    """Value of the case [SI]."""
    low: float
    """Lower bound [SI]."""
    high: float
    """Upper bound [SI]."""

    def written(self, value: float) -> str | float:
        """A value in SI as a case file has it, to the last digit."""
        return f"{value!r} {self.si_unit}" if self.si_unit else value

    def shown(self, value: float) -> float:
        """A value in SI in the unit in which it is shown."""
        return converted(value, self.si_unit, self.unit) if self.unit else value

    def values(self, value: float) -> dict[str, str | float]:
        """What a case has at each key for a value in SI."""
        return dict.fromkeys(self.keys, self.written(value))


def parameters(case: Case, wanted: Sequence[str]) -> tuple[Parameter, ...]:
    """The parameters of a case to be fitted.

    Args:
        wanted: Names of `SHORT_NAMES` or dotted keys, each with bounds or without:
            "boundary_friction", "alpha = 8 1/GPa to 25 1/GPa".

    Raises:
        CaseError: No such parameter in the case, one that is asked for twice, or bounds that do not hold its
            value.
    """
    if not wanted:
        raise CaseError(f"nothing to fit: name parameters such as {', '.join(SHORT_NAMES)}")
    found = tuple(_parameter(case, *_split(text)) for text in wanted)
    keys = [key for parameter in found for key in parameter.keys]
    for key in keys:
        if keys.count(key) > 1:
            raise CaseError(f"{key} is to be fitted twice; name it once")
    return found


def _split(text: str) -> tuple[str, str]:
    name, _, bounds = text.partition("=")
    return name.strip(), bounds.strip()


def _parameter(case: Case, name: str, bounds: str) -> Parameter:
    bodies = tuple(type(case.tables.bodies).model_fields)
    keys = tuple(key.format(*bodies) for key in SHORT_NAMES.get(name, (name,)))
    values = {key: _value_and_kind(case, name, key) for key in keys}
    start, kind = values[keys[0]]
    si_unit = "" if kind is None else kind.unit
    example = None if kind is None else number_and_unit(kind.example)
    low, high = (
        start / RANGE,
        min(start * RANGE, MAX_VALUES.get(keys[0].rpartition(".")[2], float("inf"))),
    )
    if bounds:
        low, high = _bounds(name, bounds, kind)
        if not low <= start <= high:
            raise CaseError(
                f"{name} = {bounds}: must hold the value of the case, {start:.4g} {si_unit}".rstrip()
            )
    unit = "" if example is None else example[1]
    # a scale with a zero of its own has no uncertainties
    unit = si_unit if unit and unit_of(unit).zero else unit
    return Parameter(name, keys, unit, si_unit, start, low, high)


def _bounds(name: str, text: str, kind: Kind | None) -> tuple[float, float]:
    match = _BOUNDS.fullmatch(text)
    if match is None:
        raise CaseError(f'{name} = {text}: must be two bounds, such as "{name} = LOW to HIGH"')
    try:
        low, high = (_number(end, kind) for end in match.groups())
    except ValueError as error:
        raise CaseError(f"{name} = {text}: {error}") from None
    if not 0 < low < high:
        raise CaseError(f"{name} = {text}: must be from a smaller to a larger value above zero")
    return low, high


def _number(text: str, kind: Kind | None) -> float:
    if kind is not None:
        return parse(text, kind)
    number = float(text) if re.fullmatch(r"[+-]?[\d.]+(e[+-]?\d+)?", text, re.IGNORECASE) else None
    if number is None or not isfinite(number):
        raise ValueError("must be numbers without unit")
    return number


def _value_and_kind(case: Case, name: str, key: str) -> tuple[float, Kind | None]:
    """Value of a case at a key [SI], and its kind; CaseError where there is no number above zero."""
    value: Any = case.tables
    kind: Kind | None = None
    for step in key.split("."):
        table = type(value).model_fields if isinstance(value, BaseModel) else {}
        if step not in table:
            raise CaseError(f"{name}: the case has no {key}; {_others(case.tables)}")
        value, kind = getattr(value, step), kind_of(table[step])
    if value is None:
        value = DEFAULTS.get(key.rpartition(".")[2])
    if isinstance(value, bool) or not isinstance(value, float | int):
        raise CaseError(f"{name}: the case gives no number for {key}; {_others(case.tables)}")
    if value <= 0:
        raise CaseError(
            f"{name}: {key} is {value:g} in the case, and is fitted from a value above zero"
        )
    return float(value), kind


def _others(tables: Any) -> str:
    """The numbers of a case's oil that can be fitted, in words."""
    numbers = sorted(_numbers(tables.oil, "oil"))
    return f"its oil has {', '.join(numbers)}"


def _numbers(table: BaseModel, above: str) -> Iterator[str]:
    for name, value in table:
        if isinstance(value, BaseModel):
            yield from _numbers(value, f"{above}.{name}")
        elif isinstance(value, float) and value > 0:
            yield f"{above}.{name}"


def with_parameters(
    parameters: Sequence[Parameter], values: Sequence[float]
) -> Mapping[str, str | float]:
    """What a case has at the keys of all parameters for their values in SI."""
    return {
        key: written
        for parameter, value in zip(parameters, values, strict=True)
        for key, written in parameter.values(float(value)).items()
    }
