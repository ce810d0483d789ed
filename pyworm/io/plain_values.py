"""Types of the keys of case files that have no unit: numbers, counts and texts."""

from typing import Annotated, Literal

from pydantic import Field

from pyworm.io.bounded_number import LARGEST_INTEGER

MAX_NUMBER = 1e6
"""Largest plain number: exponents, ratios and fractions are far smaller."""

Number = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-MAX_NUMBER, le=MAX_NUMBER)]
PositiveNumber = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=MAX_NUMBER)]
NumberOrZero = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=MAX_NUMBER)]
MOST_COUNTED = 10_000
"""Largest number of teeth, threads, rollers, jets or values: the largest gears have some hundred teeth."""

AboveZeroToOne = Annotated[float, Field(strict=True, gt=0, le=1)]
Fraction = Annotated[float, Field(strict=True, gt=0, lt=1)]
Count = Annotated[int, Field(strict=True, gt=0, le=MOST_COUNTED)]
Seed = Annotated[int, Field(strict=True, ge=0, le=LARGEST_INTEGER)]
Phase = Annotated[float, Field(strict=True, ge=0, le=1)]
Text = Annotated[str, Field(min_length=1)]
RequestedQuantity = Literal["film", "friction", "temperature"]
