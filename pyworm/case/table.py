"""What every table of a case file keeps to, and the plain numbers in it."""

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

LARGEST = 1e6
"""Largest plain number: exponents, ratios and shares are far smaller."""

Number = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-LARGEST, le=LARGEST)]
PositiveNumber = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=LARGEST)]
NumberOrZero = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=LARGEST)]
Count = Annotated[int, Field(strict=True, gt=0)]
Phase = Annotated[float, Field(strict=True, ge=0, le=1)]
Text = Annotated[str, Field(min_length=1)]


class Table(BaseModel):
    """A table of a case file: no key beyond its own, nothing changed after reading."""

    model_config = ConfigDict(extra="forbid", frozen=True)
