"""A rating: figures of one object by closed forms, in columns beside other values of them."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from pyworm.formulas.ranges import apart
from pyworm.formulas.unit_factors import RPM
from pyworm.io.quantities import QUANTITIES
from pyworm.io.quantity_text import bars, short
from pyworm.solver.neglected_effects import NeglectedEffects

Value = float | int | str | None

NOT_RATED = "not rated"
"""Cell of a figure that has no value, and a reason."""

SCALES = {
    **{"kN m": 1e-3, "kW": 1e-3, "MPa": 1e-6, "GPa": 1e-9, "mm": 1e3, "µm": 1e6, "mm²/s": 1e6},
    **{"l/min": 6e4, "%": 100.0, "Mrev": 1e-6, "ms": 1e3, "rpm": RPM},
}
"""Unit shown -> its number over that in SI, or in revolutions."""

DIGITS = 4
"""Of values shown, and more where they would else look like the bound that they miss."""

SIMULATION = "simulation"
"""Column of simulated figures."""

FILM_COLUMNS = {"central film": "film_central", "minimum film": "film_min"}
"""Column of films, a key of JSON objects -> its quantity."""


@dataclass(frozen=True)
class RatedFigure:
    """One figure of a rating."""

    key: str
    """Its name where programs read it, unit at the end, SI but for temperatures in degC."""
    label: str
    """Its name for people."""
    values: tuple[Value, ...]
    """One for each column of the rating, in the unit of the key; None where a column has none."""
    unit: str = ""
    """Unit shown."""
    bars: tuple[tuple[float, float | None] | None, ...] = ()
    """Numerical and model error bars of each column, in the unit of the key; None where a column has none."""
    why: str = ""
    """Why it has no value, a clause; empty where it has."""

    @property
    def scale(self) -> float:
        """From the unit of the key to the one shown."""
        return SCALES.get(self.unit, 1.0)

    def shown(self, column: int) -> str:
        """The value of a column as text."""
        value = self.values[column] if column < len(self.values) else None
        if value is None:
            return NOT_RATED if column == 0 and self.why else ""
        if isinstance(value, str):
            return value
        known = self.bars[column] if column < len(self.bars) else None
        text = f"{short(value * self.scale)} {self.unit}".rstrip()
        return text if known is None else f"{text} {bars(*known, self.scale, '')}"

    def named(self, column: int) -> dict[str, Value]:
        """The value of a column with its error bars, by name; empty where it has none."""
        if column >= len(self.values) or self.values[column] is None:
            return {}
        found = {self.key: self.values[column]}
        known = self.bars[column] if column < len(self.bars) else None
        if known is not None:
            found |= {f"{self.key}_error": known[0], f"{self.key}_model_error": known[1]}
        return found


def without_value(figures: Iterable[RatedFigure]) -> dict[str, str]:
    """Reason why figures have no value -> their labels, together where it is the same."""
    labels: dict[str, list[str]] = {}
    for figure in figures:
        if figure.why:
            labels.setdefault(figure.why.rstrip("."), []).append(figure.label)
    return {why: ", ".join(names) for why, names in labels.items()}


@dataclass(frozen=True)
class Safety:
    """A safety of a standard, with the least it requires."""

    symbol: str
    """Its name in the standard: "S_H"."""
    label: str
    """Its name for people: "pitting of the wheel flanks"."""
    minimum: float
    """Least value that the standard requires [-]."""
    value: float | None = None
    """What it comes to [-]; None where it cannot be rated."""
    why: str = ""
    """Why it cannot be rated; empty where it is."""
    inputs: dict[str, Value] = field(default_factory=dict)
    """What it was made of, by symbol and unit."""
    doubts: tuple[str, ...] = ()
    """What was assumed, and constants whose value or sign is not certain; a sentence each."""
    error: float | None = None
    """Relative numerical error bar of a simulated one [-]; None of closed forms."""
    model: float | None = None
    """Relative error bar of the model of a simulated one [-]; None of closed forms."""
    clause: str = ""
    """Where the standard has it."""

    @property
    def verdict(self) -> str:
        """Either "sufficient", "not sufficient" or "cannot be rated"."""
        if self.value is None:
            return "cannot be rated"
        return "sufficient" if self.value >= self.minimum else "not sufficient"

    @property
    def shown(self) -> str:
        """The value as text, with its error bars."""
        if self.value is None:
            return ""
        if self.error is not None:
            return f"{apart(self.value, self.minimum, 3)} {bars(self.error, self.model)}"
        text = short(self.value)
        return text if float(text) != self.minimum else apart(self.value, self.minimum, DIGITS)

    @property
    def failure(self) -> str:
        """That it is not sufficient, in a sentence; empty where it is, or is not rated."""
        if self.value is None or self.value >= self.minimum:
            return ""
        return f"{self.symbol} = {self.shown} against {self.label} is below {self.minimum:g}."

    @property
    def open(self) -> bool:
        """Whether the verdict would turn within the error bars."""
        if self.value is None or self.error is None:
            return False
        return abs(self.minimum / self.value - 1) < self.error + (self.model or 0.0)

    @property
    def inputs_as_text(self) -> str:
        """Its inputs, or why there are none, in a line."""
        if self.value is None:
            return self.why
        return ", ".join(
            f"{key} {value if value is None or isinstance(value, str) else short(value)}"
            for key, value in self.inputs.items()
        )

    def summary(self) -> dict[str, Any]:
        """The safety as an object for JSON."""
        return {
            "label": self.label,
            "value": self.value,
            "minimum": self.minimum,
            "error": self.error,
            "model_error": self.model,
            "clause": self.clause,
            "verdict": self.verdict,
            "within_error_bars": self.open,
            "why": self.why,
            "inputs": self.inputs,
            "doubts": list(self.doubts),
        }


@dataclass(frozen=True)
class Rating:
    """Rating of one object."""

    key: str
    """Its name for programs."""
    title: str
    """Its name for people."""
    source: str
    """Where its formulas come from."""
    columns: tuple[str, ...]
    """Where the values come from: "computed", "printed", "standard", `SIMULATION`."""
    figures: tuple[RatedFigure, ...]
    """The figures."""
    safeties: tuple[Safety, ...] = ()
    """Safeties of the standard; none of methods that have none."""
    words: tuple[str, ...] = ()
    """What they mean, and what was assumed."""
    failed: tuple[str, ...] = ()
    """Why it fails, a sentence each; none where nothing of what is rated does."""
    not_rated: tuple[str, ...] = ()
    """What is not rated, each with the reason."""
    neglected_effects: NeglectedEffects = field(default_factory=NeglectedEffects)
    """What its simulated figures do not hold; nothing without any."""
    basis: tuple[str, ...] = ()
    """Standard and edition of its safeties, what was not read or is outside their scope, in sentences."""
    differs: tuple[str, ...] = ()
    """What simulation and rating of the drive do not share, a sentence each."""

    @property
    def titled(self) -> str:
        """The title, with the effects left out of the simulated figures, and what these do not share."""
        return "\n".join((self.neglected_effects.titled(self.title), *self.differs))

    @property
    def headings(self) -> tuple[str, ...]:
        """Headings of the columns."""
        titles = [
            QUANTITIES[FILM_COLUMNS[column]].title()
            if column in FILM_COLUMNS
            else column.capitalize()
            for column in self.columns
        ]
        return tuple(
            self.neglected_effects.qualified(title) if column == SIMULATION else title
            for column, title in zip(self.columns, titles, strict=True)
        )

    def summary(self) -> dict[str, Any]:
        """The rating as one object, column by column."""
        return {
            "rating": self.key,
            "title": self.title,
            "source": self.source,
            **{
                column: {
                    name: value
                    for figure in self.figures
                    for name, value in figure.named(number).items()
                }
                for number, column in enumerate(self.columns)
            },
            **(
                {"safeties": {safety.symbol: safety.summary() for safety in self.safeties}}
                if self.safeties
                else {}
            ),
            **({"basis": list(self.basis)} if self.basis else {}),
            "words": list(self.words),
            "failed": list(self.failed),
            "not_rated": list(self.not_rated),
            **({"differs": list(self.differs)} if self.differs else {}),
        }
