"""Warnings about possible but unusual values of a file."""

from collections.abc import Iterator
from typing import Any

from pydantic import BaseModel

from pyworm.case.workshop_units import kind_of
from pyworm.io.input_error import toml
from pyworm.io.quantity import Kind, doubt


def unusual(file: BaseModel, data: dict[str, Any]) -> tuple[str, ...]:
    """A sentence for each unusual value that is written in a file, keys with the same one together.

    Values that the table as written does not give, such as the numbers of a named oil, are not judged.
    """
    keys: dict[tuple[str, str], list[str]] = {}
    for key, text, kind in _written(file, data):
        warning = doubt(text, kind)
        if warning is not None:
            keys.setdefault((text, warning), []).append(key)
    return tuple(
        f"{' and '.join(named)} = {toml(text)}: {warning}"
        for (text, warning), named in keys.items()
    )


def _written(table: BaseModel, data: dict[str, Any], above: str = "") -> Iterator[tuple]:
    """Key, text and kind of every quantity that is written in a table."""
    for name, field in type(table).model_fields.items():
        if name in data:
            yield from _quantities(
                getattr(table, name), data[name], kind_of(field), f"{above}{name}"
            )


def _quantities(value: Any, written: Any, kind: Kind | None, key: str) -> Iterator[tuple]:
    if isinstance(value, BaseModel) and isinstance(written, dict):
        yield from _written(value, written, f"{key}.")
    elif isinstance(value, dict) and isinstance(written, dict):
        for name in value.keys() & written.keys():
            yield from _quantities(value[name], written[name], kind, f"{key}.{name}")
    elif isinstance(written, list):
        for place, (part, entry) in enumerate(zip(value, written, strict=True)):
            yield from _quantities(part, entry, kind, f"{key}[{place}]")
    elif isinstance(written, str) and kind is not None:
        yield key, written, kind
