"""Text of a case file from its tables."""

from collections.abc import Iterator
from typing import Any

from pyworm.io.input_error import toml


def case_text(tables: dict[str, Any]) -> str:
    """The case file that holds these tables."""
    return "\n".join(_lines(tables)) + "\n"


def _lines(tables: dict[str, Any], above: str = "") -> Iterator[str]:
    plain = {key: value for key, value in tables.items() if not isinstance(value, dict)}
    if above and plain:
        yield f"\n[{above}]"
    for key, value in plain.items():
        yield f"{key} = {toml(value)}"
    for key, value in tables.items():
        if isinstance(value, dict):
            yield from _lines(value, f"{above}.{key}" if above else key)
