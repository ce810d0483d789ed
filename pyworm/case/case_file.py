"""Tables and keys that all case files share."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import BeforeValidator, Field, ValidationInfo, model_validator

from pyworm.case.bodies import Bodies, taken_by_name
from pyworm.case.oil import OilTable
from pyworm.case.table import Table, by_dotted_key
from pyworm.io import units
from pyworm.io.given import as_names
from pyworm.io.number_with_unit import parse_any
from pyworm.io.plain_values import RequestedQuantity, Text


def _effects(given: Any) -> tuple[str, ...]:
    """A choice of effects, one name or a list of them; ValueError for what is none."""
    from pyworm.planning.effects.selection import EXAMPLE, require_known

    names = as_names(given, EXAMPLE)
    require_known(names)
    return names


ChosenEffects = Annotated[tuple[Text, ...], BeforeValidator(_effects)]
"""`effects` of a file: one name, or a list of them."""


class PublishedValue(Table):
    """A value printed by the source."""

    text: str
    value: float
    unit: str


def _published(value: Any, info: ValidationInfo) -> PublishedValue:
    if info.context == units.SI:
        return PublishedValue.model_validate(value)
    if isinstance(value, float | int) and not isinstance(value, bool):
        return PublishedValue(text=f"{value:g}", value=value, unit="")
    number, unit = parse_any(value)
    return PublishedValue(text=value, value=number, unit=unit)


Published = dict[str, Annotated[PublishedValue, BeforeValidator(_published)]]
"""`[published]`: free names; those that a result has too are shown beside it."""


def _by_key(reasons: Any) -> Any:
    """Reasons of tables within tables, each by its dotted key; what is no table is refused later."""
    return by_dotted_key(reasons) if isinstance(reasons, dict) else reasons


class FileTable(Table):
    """Keys that all files share.

    `[assumed]` has the keys of values that the source does not give, and why they are what they are.
    """

    title: Text
    source: Text
    published: Published = Field(default_factory=dict)
    assumed: Annotated[dict[str, Text], BeforeValidator(_by_key)] = Field(default_factory=dict)

    def flaws(self) -> Iterator[str]:
        """What is assumed and not given."""
        for key in self.assumed:
            if self.at(key) is None:
                yield f"assumed.{key} means nothing: the file does not give {key}"

    def at(self, key: str) -> Any:
        """The value at a dotted key; None where it is not given."""
        value: Any = self
        for part in key.split("."):
            value = dict(value).get(part) if isinstance(value, Table | dict) else None
        return value


class CaseTable(FileTable):
    """Keys that all case files share; each kind adds its own `bodies`."""

    @model_validator(mode="before")
    @classmethod
    def _names_are_assumptions(cls, given: Any, info: ValidationInfo) -> Any:
        """The file with what its names of materials stand for in `[assumed]`; a stored one has it."""
        if info.context == units.SI or not isinstance(given, dict):
            return given
        taken, assumed = taken_by_name(given.get("bodies")), given.get("assumed", {})
        if not taken or not isinstance(assumed, dict):
            return given
        return given | {"assumed": taken | by_dotted_key(assumed)}

    if TYPE_CHECKING:
        bodies: Bodies  # each kind has its own

    accuracy: units.Share = 0.01
    effects: ChosenEffects = ("auto",)
    quantities: Annotated[tuple[RequestedQuantity, ...], Field(min_length=1)] | None = None
    oil: OilTable

    def flaws(self) -> Iterator[str]:
        """Bodies that do not take heat with the oil."""
        yield from super().flaws()
        named = "" if self.oil.temperature is None else f" of {self.oil.name}"
        for name, body in self.bodies:
            for key in ("density", "conductivity", "specific_heat"):
                if self.oil.heat is not None and getattr(body, key) is None:
                    yield f"bodies.{name}.{key} is missing; [oil.heat]{named} asks for it"
            if self.oil.heat is None and body.bulk_temperature is not None:
                yield f"bodies.{name}.bulk_temperature has no effect without [oil.heat]"
