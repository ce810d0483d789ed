"""Numbers of a case file by dotted key: their values, units, and steps for differences."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, get_args

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from pyworm.case.case import Case, case_without_contacts
from pyworm.case.dotted_keys import value_at
from pyworm.case.workshop_units import kind_of
from pyworm.io.input_error import CaseError
from pyworm.io.number_with_unit import converted, number_and_unit, unit_of
from pyworm.io.quantity import Kind

MACHINE_TABLES = "drive", "operation", "surfaces", "contact", "motion"
"""Tables of a case whose numbers change its contacts, those that the file leaves at zero too."""

MATERIAL_TABLES = "bodies", "oil", "lubrication", "cooling"
"""Tables of which only numbers count that the file gives: a library has the others."""

NOT_VARIED = ("phases", "stations", "slide_roll_ratios", "lifts")
"""Keys of them that say which contacts are solved, or what a solution finds."""

RELATIVE_STEP = 2e-5
"""Step of a difference over the value: with larger ones the convection of heat turns from one node upstream
to another, and with it the equations of a heated film."""

LARGEST_STEPS = {"m": 4e-8, "rad": 7e-7, "K": 2e-3, "delta_degC": 2e-3}
"""SI unit -> largest step: of gears a few parts in a million of what separates their flanks."""

SMALL_PART = 1e-4
"""Largest step over a value that is above zero."""

USUAL_CHANGES = {"a relief": (1e-5, "0.01 mm"), "a root mean square height": (1e-7, "0.1 µm")}
"""Noun of a kind -> change in SI that tables show, in words."""

USUAL_CHANGES_BY_UNIT = {
    "m": (1e-4, "0.1 mm"),
    "rad": (1.7453292519943296e-3, "0.1°"),
    "K": (1.0, "1 K"),
    "delta_degC": (1.0, "1 K"),
}
"""SI unit -> likewise, of tables about parts."""

RELATIVE_CHANGE = 0.01
"""Change of other numbers that tables show, over the number."""


@dataclass(frozen=True)
class NumericKey:
    """A number of a case file."""

    key: str
    """Dotted key."""
    value: float
    """Its value [SI]."""
    kind: Kind | None
    """Kind of quantity; None of plain numbers."""

    @property
    def si_unit(self) -> str:
        """SI unit, empty without one."""
        return "" if self.kind is None else self.kind.unit

    @property
    def unit(self) -> str:
        """Unit in which it is shown; SI where that has a zero of its own."""
        parts = None if self.kind is None else number_and_unit(self.kind.example)
        unit = "" if parts is None else parts[1]
        return self.si_unit if unit and unit_of(unit).zero else unit

    def written(self, value: float) -> str | float:
        """A value in SI as a case file has it, to the last digit."""
        return float(value) if self.kind is None else f"{float(value)!r} {self.si_unit}".rstrip()

    def shown(self, value: float) -> float:
        """A value in SI in the unit in which it is shown."""
        return converted(value, self.si_unit, self.unit) if self.unit else value

    @property
    def step(self) -> float:
        """Step of a difference of geometry and closed forms [SI]."""
        size = abs(self.value)
        largest = LARGEST_STEPS.get(self.si_unit)
        if largest is None:
            return RELATIVE_STEP * (size or 1.0)
        above_zero = self.kind is not None and self.kind.sign != "any"
        return min(largest, SMALL_PART * size) if above_zero and size else largest

    @property
    def usual_change(self) -> tuple[float, str]:
        """Change that tables show: in SI, and in words."""
        noun = "" if self.kind is None else self.kind.noun
        found = USUAL_CHANGES.get(noun) or USUAL_CHANGES_BY_UNIT.get(self.si_unit)
        if found is not None and (noun != "a radius"):
            return found
        words = f"{RELATIVE_CHANGE:.0%}" if self.value else f"{RELATIVE_CHANGE:g}"
        return RELATIVE_CHANGE * (abs(self.value) or 1.0), words


def numeric_keys(case: Case) -> tuple[NumericKey, ...]:
    """The numbers of a case that change its contacts, in the order of its tables.

    Without zeros that have no natural step, such as constants of a law that the oil does without, and without
    what a run finds by iteration.
    """
    found = [
        number
        for number in _all_numbers(case)
        if number.key.partition(".")[0] in MACHINE_TABLES or _is_given(case, number.key)
    ]
    unknown = {number.key for number in found_keys(case)}
    return tuple(
        number
        for number in found
        if number.key not in unknown and (number.value or number.si_unit in LARGEST_STEPS)
    )


def found_keys(case: Case) -> tuple[NumericKey, ...]:
    """The numbers of a case that its file leaves open and its run has found; none of a case not run."""
    if not case.content:
        return ()
    written = case_without_contacts(case.content, case.name, case.directory)
    open_ = {f"{table}.{key}" for table, keys in written.left_open.items() for key in keys}
    return tuple(number for number in _all_numbers(case) if number.key in open_)


def _all_numbers(case: Case) -> Iterator[NumericKey]:
    for name in (*MACHINE_TABLES, *MATERIAL_TABLES):
        if isinstance(table := getattr(case.tables, name, None), BaseModel):
            yield from _numbers(table, name)


def _is_given(case: Case, key: str) -> bool:
    try:
        return value_at(case.content, key) is not None
    except CaseError:
        return False


def numeric_key(case: Case, key: str) -> NumericKey:
    """The number of a case at a dotted key; CaseError with those that there are without one."""
    known = {number.key: number for number in numeric_keys(case)}
    if key not in known:
        table = key.rpartition(".")[0]
        near = [name for name in known if name.startswith(f"{table}.")] or list(known)
        raise CaseError(f'"{key}": the case gives no such number; it has {", ".join(near)}')
    return known[key]


def _numbers(table: BaseModel, above: str) -> Iterator[NumericKey]:
    for name, field in type(table).model_fields.items():
        value, key = getattr(table, name), f"{above}.{name}"
        if name in NOT_VARIED:
            continue
        if isinstance(value, BaseModel):
            yield from _numbers(value, key)
        elif isinstance(value, tuple | list):
            yield from _in_list(value, key, field)
        elif _is_number(value) and not _is_whole(field):
            yield NumericKey(key, float(value), kind_of(field))


def _in_list(values: Any, key: str, field: FieldInfo) -> Iterator[NumericKey]:
    """Numbers of a list that has nothing else."""
    if all(map(_is_number, values)):
        for place, value in enumerate(values):
            yield NumericKey(f"{key}[{place}]", float(value), kind_of(field))


def _is_number(value: Any) -> bool:
    return isinstance(value, float | int) and not isinstance(value, bool)


def _is_whole(field: FieldInfo) -> bool:
    """Whether a field takes whole numbers, such as teeth."""
    hint = field.annotation
    return hint is int or int in get_args(hint)
