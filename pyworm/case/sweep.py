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

from pyworm.case.case_file import ChosenEffects
from pyworm.case.draws import METHODS, Method, fractions, spread
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
    """Values drawn between two ends, spread evenly or, on a logarithmic scale, evenly in their logarithm.

    Random ones: each key has its own sequence, by the sweep's seed: more draws continue the same first
    ones, and another key beside it changes none. Keys of one table with the same design fill their ranges
    together (`draws`).
    """

    draw: Literal["uniform", "log-uniform", "sobol", "latin-hypercube"]
    low: Value
    high: Value
    scale: Literal["linear", "log"] | None = None

    def flaws(self) -> Iterator[str]:
        """A scale without effect, and ends between which nothing can be drawn."""
        if self.design is None and self.scale is not None:
            yield f'scale has no effect with draw = "{self.draw}"; omit it'
        yield from self._without_range(self.low, self.high, "low, high", self.logarithmic)

    @property
    def design(self) -> Method | None:
        """The design of which it is a part; None of random values."""
        return next((method for method in METHODS if method == self.draw), None)

    @property
    def logarithmic(self) -> bool:
        """Whether logarithms are spread evenly."""
        return self.draw == "log-uniform" or self.scale == "log"

    def values(self, key: str, seed: int | None) -> list[Value]:
        """Random values of a key of its own, as a case file has them."""
        sequence = int.from_bytes(sha256(key.encode()).digest()[:8])
        generator = np.random.Generator(np.random.PCG64([present(seed, "seed"), sequence]))
        return self.at(generator.random(self.count))

    def at(self, fraction: np.ndarray) -> list[Value]:
        """The values at fractions of the range, as a case file has them."""
        low, high, unit = self._ends(self.low, self.high)
        return self._written(list(spread(low, high, fraction, self.logarithmic)), unit, whole=False)


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
    effects: ChosenEffects | None = None
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
            | self._designed(table)
            for table in self.vary
        ]

    def _designed(self, table: dict[str, Values]) -> dict[str, list[Value]]:
        """The values of those keys of one table that fill their ranges together."""
        designs: dict[tuple[Method, int], dict[str, DrawTable]] = {}
        for key, values in table.items():
            if isinstance(values, DrawTable) and values.design is not None:
                designs.setdefault((values.design, values.count), {})[key] = values
        return {
            key: drawn.at(fraction)
            for (design, count), keys in designs.items()
            for (key, drawn), fraction in zip(
                keys.items(),
                fractions(design, count, len(keys), present(self.seed, "seed")).T,
                strict=True,
            )
        }
