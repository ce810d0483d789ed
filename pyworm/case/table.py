"""Base of all tables of a case file, types of plain numbers and dotted keys."""

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar

from pydantic import BaseModel, ConfigDict, Field

from pyworm.io.bounded_number import LARGEST_INTEGER

LARGEST = 1e6
"""Largest plain number: exponents, ratios and fractions are far smaller."""

Number = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-LARGEST, le=LARGEST)]
PositiveNumber = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=LARGEST)]
NumberOrZero = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=LARGEST)]
MOST_COUNTED = 10_000
"""Largest number of teeth, threads, rollers, jets or values: the largest gears have some hundred teeth."""

Count = Annotated[int, Field(strict=True, gt=0, le=MOST_COUNTED)]
Seed = Annotated[int, Field(strict=True, ge=0, le=LARGEST_INTEGER)]
Phase = Annotated[float, Field(strict=True, ge=0, le=1)]
Text = Annotated[str, Field(min_length=1)]


class Table(BaseModel):
    """A table of a case file: unknown keys are refused, values are frozen."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    also_called: ClassVar[Mapping[str, str]] = {}
    """What a key is called elsewhere -> the key, with its table where it stands in another one."""


def by_dotted_key(table: dict[str, Any], above: str = "") -> dict[str, Any]:
    """Values of a table and of those within it: "bodies.worm.roughness" -> value."""
    flat: dict[str, Any] = {}
    for key, value in table.items():
        name = f"{above}.{key}" if above else key
        flat |= by_dotted_key(value, name) if isinstance(value, dict) else {name: value}
    return flat
