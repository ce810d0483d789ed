"""Base of all tables of a case file, those of dataclasses, and dotted keys."""

from collections.abc import Iterator, Mapping
from dataclasses import fields
from typing import Any, ClassVar, Self, TypeVar

from pydantic import BaseModel, ConfigDict, model_validator


class Table(BaseModel):
    """A table of a case file: unknown keys are refused, values are frozen."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    also_called: ClassVar[Mapping[str, str]] = {}
    """What a key is called elsewhere -> the key, with its table where it stands in another one."""

    @model_validator(mode="after")
    def _sound(self) -> Self:
        for flaw in self.flaws():
            raise ValueError(flaw)
        return self

    def flaws(self) -> Iterator[str]:
        """Sentences on values that do not go together, of which the first refuses the table."""
        yield from ()

    def given(self, *keys: str) -> list[str]:
        """Those of some keys that the table gives."""
        return [key for key in keys if getattr(self, key) is not None]

    def unless_one(self, *keys: str) -> Iterator[str]:
        """A sentence where not one of some keys is given."""
        given = self.given(*keys)
        if len(given) != 1:
            but = f", not {' and '.join(given)}" if given else ""
            yield f"give one of {', '.join(keys)}{but}"

    def unless_either(self, first: str, other: str, needed: bool = True) -> Iterator[str]:
        """A sentence where two keys are given, or none of them and one is needed."""
        if len(self.given(first, other)) not in ((1,) if needed else (0, 1)):
            yield f"give either {first} or {other}, one of the two"

    def unless_together(self, *keys: str) -> Iterator[str]:
        """A sentence where some of keys are given without the others."""
        if 0 < len(self.given(*keys)) < len(keys):
            yield f"give {', '.join(keys[:-1])} and {keys[-1]} together"


TableT = TypeVar("TableT")


def plain(table: TableT, kind: type[TableT]) -> TableT:
    """The values of a table as the dataclass that it is read for; tables inside it become dataclasses, too.

    Such a table is derived from both, `class CrownTable(Table, Crown)`: it has the dataclass's fields with
    their types of `pyworm.io.units` and their defaults, and states itself only what differs in a file. No
    table is derived from it in turn: pydantic would forget these types.
    """
    parts = (part.name for part in fields(kind) if part.init)  # type: ignore[arg-type]  # a dataclass
    return kind(**{name: _plain(getattr(table, name)) for name in parts})


def _plain(value: Any) -> Any:
    """A value of a table: of one inside its dataclass, if it is read for one."""
    if isinstance(value, tuple | list):
        return tuple(map(_plain, value))
    if not isinstance(value, Table):
        return value
    kinds = [kind for kind in type(value).__mro__ if "__dataclass_fields__" in vars(kind)]
    return plain(value, kinds[0]) if kinds else value


def by_dotted_key(table: dict[str, Any], above: str = "") -> dict[str, Any]:
    """Values of a table and of those within it: "bodies.worm.roughness" -> value."""
    flat: dict[str, Any] = {}
    for key, value in table.items():
        name = f"{above}.{key}" if above else key
        flat |= by_dotted_key(value, name) if isinstance(value, dict) else {name: value}
    return flat
