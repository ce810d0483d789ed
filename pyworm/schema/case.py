"""What all case files say."""

from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field, model_validator

from pyworm import units
from pyworm.schema.oil import OilTable
from pyworm.schema.table import Table, Text

Quantity = Literal["film", "friction", "temperature"]
"""What a case asks of its contacts."""


def _effects(text: str) -> str:
    from pyworm.effects.choice import words

    words(text)
    return text


class PublishedValue(Table):
    """A number that the source prints."""

    text: str
    value: float
    unit: str


def _published(value: Any) -> PublishedValue:
    if isinstance(value, float | int) and not isinstance(value, bool):
        return PublishedValue(text=f"{value:g}", value=value, unit="")
    number, unit = units.parse_any(value)
    return PublishedValue(text=value, value=number, unit=unit)


Published = dict[str, Annotated[PublishedValue, BeforeValidator(_published)]]
"""`[published]`: free names; those that a result has too are shown beside it."""


class CaseTable(Table):
    """What all case files say; each kind has its own `bodies` besides."""

    title: Text
    source: Text
    accuracy: units.Share = 0.01
    effects: Annotated[str, AfterValidator(_effects)] = "auto"
    quantities: Annotated[tuple[Quantity, ...], Field(min_length=1)] | None = None
    oil: OilTable
    published: Published = Field(default_factory=dict)

    @model_validator(mode="after")
    def _bodies_take_heat_with_the_oil(self):
        named = "" if self.oil.temperature is None else f" of {self.oil.name}"
        for name, body in self.bodies:
            for key in ("density", "conductivity", "specific_heat"):
                if self.oil.heat is not None and getattr(body, key) is None:
                    raise ValueError(
                        f"bodies.{name}.{key} is missing; [oil.heat]{named} asks for it"
                    )
            if self.oil.heat is None and body.bulk_temperature is not None:
                raise ValueError(f"bodies.{name}.bulk_temperature means nothing without [oil.heat]")
        return self
