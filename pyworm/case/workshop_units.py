"""Values of case files as people write them, in workshop units."""

from typing import Any, get_args

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from pyworm.case.case_file import FileTable
from pyworm.io import quantity_text
from pyworm.io.quantity import Kind


def as_text(value: Any, field: FieldInfo | None = None) -> str:
    """A value, or a list of values, in the unit that its field is measured in."""
    kind = None if field is None else kind_of(field)
    if isinstance(value, tuple | list):
        return ", ".join(_plain(part, kind) for part in value)
    return _plain(value, kind)


def assumptions(file: FileTable) -> dict[str, str]:
    """Assumptions of a file: "drive.module = 5.08 mm" -> reason; whole tables without a value."""
    reasons = {}
    for key, reason in file.assumed.items():
        *tables, last = key.split(".")
        value, table = file.at(key), file.at(".".join(tables)) if tables else file
        field = type(table).model_fields[last] if isinstance(table, BaseModel) else None
        whole = isinstance(value, BaseModel | dict)
        reasons[key if whole else f"{key} = {as_text(value, field)}"] = reason
    return reasons


def _plain(value: Any, kind: Kind | None) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, tuple | list):
        return f"({', '.join(_plain(part, None) for part in value)})"
    if isinstance(value, float | int):
        return f"{value:.6g}" if kind is None else quantity_text.as_text(value, kind)
    return str(value)


def kind_of(field: FieldInfo) -> Kind | None:
    """Kind of quantity of a field; None for plain numbers and texts."""
    return _kind([*field.metadata, field.annotation])


def _kind(hints: list[Any]) -> Kind | None:
    """Kind of quantity of a field, anywhere in its annotation."""
    for hint in hints:
        if isinstance(hint, Kind):
            return hint
        found = _kind([*get_args(hint), *getattr(hint, "__metadata__", ())])
        if found is not None:
            return found
    return None
