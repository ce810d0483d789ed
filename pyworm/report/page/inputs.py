"""The inputs of a case in workshop units, a table for each of its parts."""

from typing import Any

from pydantic import BaseModel

from pyworm.case.case import Case
from pyworm.case.workshop_units import shown
from pyworm.report.page.content import Section
from pyworm.report.table import Table

_ELSEWHERE = {"title", "source", "published", "assumed", "accuracy", "effects", "quantities"}
"""Keys of case files that other sections of the report show."""

_FIRST = ("operation", "drive", "contact", "motion", "surfaces", "bodies", "oil")
"""Tables that come first, in this order."""


def inputs_section(case: Case) -> Section:
    """Every value of the case but its names and comparisons, defaults included."""
    tables = []
    fields = type(case.tables).model_fields
    for name in dict.fromkeys([*(name for name in _FIRST if name in fields), *fields]):
        field = fields[name]
        part = getattr(case.tables, name)
        if name not in _ELSEWHERE and part is not None:
            tables += _tables(name, part, field)
    return Section("Inputs", tuple(tables))


def _tables(name: str, part: Any, field: Any = None) -> list[Table]:
    """A table of the values at hand, and one for each table inside."""
    if isinstance(part, dict):
        return [table for key, one in part.items() for table in _tables(f"{name}.{key}", one)]
    if not isinstance(part, BaseModel):
        return [Table(("", ""), ((_label(name), shown(part, field)),))]
    rows, inner = [], []
    for key, one in type(part).model_fields.items():
        value = getattr(part, key)
        if isinstance(value, BaseModel | dict):
            inner += _tables(f"{name}.{key}", value)
        elif value is not None:
            rows.append((_label(key), shown(value, one)))
    own = [Table(("", ""), tuple(rows), title=_label(name.replace(".", ": ")))] if rows else []
    return own + inner


def _label(key: str) -> str:
    words = key.replace("_", " ").replace("youngs", "Young's").replace("poisson", "Poisson's")
    return words[0].upper() + words[1:]
