"""Tables of a sweep file: a case, and its values that vary.

Ranges and draws are made in the unit that they are written in and rounded to 12 digits, so that tables show
round numbers and a value is the same on every machine.
"""

import math
from collections.abc import Iterator, Sequence
from hashlib import sha256
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Discriminator, Field, Tag

from pyworm.case.table import Table
from pyworm.io.number_with_unit import parse_in
from pyworm.io.plain_values import Count, Seed, Text
from pyworm.io.present import present

Value = Any
"""What a case file may have after a key."""


class _Interval(Table):
    """Two ends, both plain numbers or both quantities of one kind."""

    count: Count

    def _ends(self, low: Value, high: Value) -> tuple[float, float, str | None]:
        """Both in the unit of the first; None for plain numbers."""
        if all(isinstance(end, int | float) and not isinstance(end, bool) for end in (low, high)):
            return low, high, None
        first, unit = parse_in(low)
        return first, parse_in(high, unit)[0], unit

    def _without_range(
        self, low: Value, high: Value, names: str, logarithmic: bool
    ) -> Iterator[str]:
        try:
            first, last, _ = self._ends(low, high)
        except ValueError as error:
            yield f"{names} = {low}, {high}: {error}"
            return
        if not (math.isfinite(first) and math.isfinite(last)):
            yield f"{names} must be finite"
        if logarithmic and min(first, last) <= 0:
            yield f"{names} must be greater than zero on a logarithmic scale"

    def _written(self, numbers: Sequence[float], unit: str | None, whole: bool) -> list[Value]:
        """Numbers as a case file has them."""
        rounded = [float(f"{number:.12g}") for number in numbers]
        if unit is not None:
            return [f"{number:.12g} {unit}".rstrip() for number in rounded]
        if whole and all(number.is_integer() for number in rounded):
            return [int(number) for number in rounded]
        return rounded


class RangeTable(_Interval):
    """Values from start to stop, both included, evenly spaced or, on a logarithmic scale, in even ratio."""

    start: Value
    stop: Value
    scale: Literal["linear", "log"] = "linear"

    def flaws(self) -> Iterator[str]:
        """Ends of which no range can be made."""
        return self._without_range(self.start, self.stop, "start, stop", self.scale == "log")

    def values(self, key: str, seed: int | None) -> list[Value]:
        """The values, as a case file has them."""
        start, stop, unit = self._ends(self.start, self.stop)
        spaced = np.geomspace if self.scale == "log" else np.linspace
        whole = isinstance(self.start, int) and isinstance(self.stop, int)
        return self._written(list(spaced(start, stop, self.count)), unit, whole)


class DrawTable(_Interval):
    """Random values between two ends, spread evenly or, "log-uniform", evenly in their logarithm.

    Each key has its own random sequence, by the sweep's seed: more draws continue the same first
    ones, and another key beside it changes none.
    """

    draw: Literal["uniform", "log-uniform"]
    low: Value
    high: Value

    def flaws(self) -> Iterator[str]:
        """Ends between which nothing can be drawn."""
        return self._without_range(self.low, self.high, "low, high", self.draw == "log-uniform")

    def values(self, key: str, seed: int | None) -> list[Value]:
        """The values, as a case file has them."""
        low, high, unit = self._ends(self.low, self.high)
        sequence = int.from_bytes(sha256(key.encode()).digest()[:8])
        fraction = np.random.Generator(np.random.PCG64([present(seed, "seed"), sequence])).random(
            self.count
        )
        if self.draw == "log-uniform":
            drawn = low * (high / low) ** fraction
        else:
            drawn = low + (high - low) * fraction
        return self._written(list(drawn), unit, whole=False)


def _form(values: Any) -> str:
    if isinstance(values, dict):
        return "draw" if "draw" in values else "range"
    return "list"


Values = Annotated[
    Annotated[list[Value], Field(min_length=1), Tag("list")]
    | Annotated[RangeTable, Tag("range")]
    | Annotated[DrawTable, Tag("draw")],
    Discriminator(_form),
]
"""The values of one key: written out, a range, or drawn."""


class SweepTable(Table):
    """A sweep file.

    Keys are those of the case, dotted, with places in lists in brackets: "motion.velocity_1[0]". The tables
    of `vary` are crossed with each other; the keys of one of them go together.
    """

    title: Text
    case: Text
    effects: Text | None = None
    seed: Seed | None = None
    fixed: dict[str, Value] = Field(default_factory=dict)
    vary: Annotated[list[Annotated[dict[str, Values], Field(min_length=1)]], Field(min_length=1)]

    def flaws(self) -> Iterator[str]:
        """Draws without a seed, keys given twice, and keys that do not go together."""
        varied = [(key, values) for table in self.vary for key, values in table.items()]
        for key, values in varied:
            if isinstance(values, DrawTable) and self.seed is None:
                yield f"seed is missing; {key} is drawn, give one such as seed = 1"
        keys = [*self.fixed, *(key for key, _ in varied)]
        for key in keys:
            if keys.count(key) > 1:
                yield f"{key} is given twice, in vary and fixed or in two tables of vary"
        for number, axis in enumerate(self.axes()):
            counts = {key: len(values) for key, values in axis.items()}
            if len(set(counts.values())) > 1:
                listed = ", ".join(f"{key} has {count} values" for key, count in counts.items())
                yield (
                    f"vary[{number}]: {listed}; the keys of one table go together, "
                    "give the same number or a [[vary]] of its own"
                )

    def axes(self) -> list[dict[str, list[Value]]]:
        """The values of each key, by table of `vary`."""
        return [
            {
                key: values if isinstance(values, list) else values.values(key, self.seed)
                for key, values in table.items()
            }
            for table in self.vary
        ]
