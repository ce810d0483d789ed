"""Design file: a case, its variables, an objective, constraints."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Discriminator, Field, Tag

from pyworm.case.case import Case, case_without_contacts, checked
from pyworm.case.case_file import ChosenEffects
from pyworm.case.dotted_keys import value_at, with_values
from pyworm.case.fitted_values import with_fitted
from pyworm.case.numeric_keys import NumericKey, numeric_key
from pyworm.case.table import Table
from pyworm.io import units
from pyworm.io.input_error import CaseError, toml
from pyworm.io.number_with_unit import parse_in
from pyworm.io.plain_values import Count, Number, Text
from pyworm.io.quantities import quantity_of
from pyworm.io.quantity_text import percent
from pyworm.io.toml import read_toml

Value = Any
"""What a case file may have after a key."""


class BoundsTable(Table):
    """Bounds of a variable: `{low = "0.4 mm", high = "3 mm"}`."""

    low: Value
    high: Value


class LimitTable(Table):
    """Limits of a figure, at least one."""

    low: Value = None
    high: Value = None

    def flaws(self) -> Iterator[str]:
        """No limit at all."""
        if not self.given("low", "high"):
            yield "give low, high or both"


class FollowTable(Table):
    """A number that follows a variable: offset + factor times the variable."""

    variable: Text
    factor: Number = 1.0
    offset: Value = 0.0


def _weights(given: Any) -> Any:
    return {given: 1.0} if isinstance(given, str) else given


Weights = Annotated[
    dict[str, Annotated[float, Field(strict=True, gt=0, le=1e6)]],
    Field(min_length=1),
    BeforeValidator(_weights),
]
"""Name of a figure, or names with weights of their sum, each over its value in the case as it is."""


class ObjectiveTable(Table):
    """What is minimised or maximised."""

    minimise: Weights | None = None
    maximise: Weights | None = None

    def flaws(self) -> Iterator[str]:
        """Nothing to optimise."""
        if not self.given("minimise", "maximise"):
            yield "give minimise, maximise or both"

    @property
    def weights(self) -> dict[str, float]:
        """Name -> weight in a sum that is minimised, negative for those maximised; sizes add up to 1.

        Violations of limits weigh beside that sum: a common factor of the weights changes no design.
        """
        more = {name: -weight for name, weight in (self.maximise or {}).items()}
        given = (self.minimise or {}) | more
        whole = sum(map(abs, given.values()))
        return {name: weight / whole for name, weight in given.items()}


class FrontTable(ObjectiveTable):
    """`[front]`: the second objective of a Pareto front, and how many designs are on it."""

    designs: Annotated[Count, Field(ge=3, le=50)] = 5


def _form(values: Any) -> str:
    return "list" if isinstance(values, list) else "bounds"


Varied = Annotated[
    Annotated[list[Value], Field(min_length=2), Tag("list")]
    | Annotated[BoundsTable, Tag("bounds")],
    Discriminator(_form),
]
"""The values of a discrete variable, or the bounds of a continuous one."""


class DesignTable(Table):
    """A design file; `variables` are keys of the case with bounds, or lists of their values."""

    title: Text
    case: Text
    figures: Literal["simulation", "formula"] = "simulation"
    accuracy: units.Share = 0.1
    effects: ChosenEffects | None = None
    solves: Count = 10
    fixed: dict[str, Value] = Field(default_factory=dict)
    variables: Annotated[dict[str, Varied], Field(min_length=1)]
    follow: dict[str, FollowTable] = Field(default_factory=dict)
    objective: ObjectiveTable
    constraints: dict[str, LimitTable] = Field(default_factory=dict)
    errors: dict[str, Value] = Field(default_factory=dict)
    front: FrontTable | None = None

    @property
    def choices(self) -> dict[str, tuple[Value, ...]]:
        """Key -> values of discrete variables, as a case file has them."""
        return {
            key: tuple(values)
            for key, values in self.variables.items()
            if not isinstance(values, BoundsTable)
        }

    def flaws(self) -> Iterator[str]:
        """A key with two meanings, values that are lists, and what follows no variable."""
        named = [*self.fixed, *self.variables, *self.follow]
        for key in named:
            if named.count(key) > 1:
                yield f"{key} is given twice, among fixed, variables and follow"
        for key, values in self.choices.items():
            if any(isinstance(value, list | dict) for value in values):
                yield f"variables.{key}: its values must be numbers or texts, not lists or tables"
        for key, table in self.follow.items():
            if not isinstance(self.variables.get(table.variable), BoundsTable):
                yield f'follow.{key}: "{table.variable}" is no variable with bounds'
        if not any(isinstance(each, BoundsTable) for each in self.variables.values()):
            yield "variables: give at least one with bounds; pyworm sweep crosses lists of values"
        if self.front is not None and self.front.weights == self.objective.weights:
            yield "front: its objective is the first one, too"


@dataclass(frozen=True)
class Variable:
    """A continuous variable of a design."""

    number: NumericKey
    """The number of the case."""
    low: float
    """Lower bound [SI]."""
    high: float
    """Upper bound [SI]."""

    def at(self, fraction: float) -> float:
        """Its value at a fraction of the way between the bounds [SI]."""
        return self.low + fraction * (self.high - self.low)

    @property
    def start(self) -> float:
        """The fraction at which the case has it, within the bounds."""
        fraction = (self.number.value - self.low) / (self.high - self.low)
        return min(max(fraction, 0.0), 1.0)


@dataclass(frozen=True)
class Followed:
    """A number that follows a variable."""

    number: NumericKey
    """The number of the case."""
    variable: str
    """Key of the variable."""
    factor: float
    """Its change over that of the variable, both in SI."""
    offset: float
    """Its value where the variable is 0 [SI]."""

    def at(self, value: float) -> float:
        """Its value for one of the variable, both in SI."""
        return self.offset + self.factor * value


@dataclass(frozen=True)
class Limit:
    """A limit of a figure."""

    name: str
    """Name of the figure."""
    bound: float
    """The limit [SI, or by the unit at the end of the name]."""
    upper: bool
    """Whether the figure must not be above it; else not below."""

    @property
    def words(self) -> str:
        """The limit as it is written: "film_min >= 0.3 µm"."""
        return f"{self.name} {'<=' if self.upper else '>='} {figure_text(self.name, self.bound)}"


@dataclass(frozen=True)
class AssemblyError:
    """An error of the assembly of any design: a number of its case is off by an amount."""

    key: str
    """Dotted key of the number."""
    size: float
    """What is added to it [SI]."""

    def applied(self, case: Case) -> Case:
        """A case with the error; CaseError of one that there cannot be."""
        number = numeric_key(case, self.key)
        content = with_values(case.content, {self.key: number.written(number.value + self.size)})
        return case_without_contacts(content, case.name, case.directory)


@dataclass(frozen=True)
class DesignTask:
    """A design file, checked against its case."""

    name: str
    """File name without its ending."""
    tables: DesignTable
    """The file."""
    case: Case
    """The case with the values that are fixed."""
    variables: tuple[Variable, ...]
    """Continuous variables."""
    followed: tuple[Followed, ...]
    """Numbers that follow a variable."""
    limits: tuple[Limit, ...]
    """Constraints."""
    errors: tuple[AssemblyError, ...]
    """Errors of the assembly, each to both sides."""

    def values(self, fractions: tuple[float, ...], chosen: dict[str, Value]) -> dict[str, Value]:
        """Values of a case at fractions of the continuous variables, with chosen discrete ones."""
        numbers = {
            variable.number.key: variable.at(fraction)
            for variable, fraction in zip(self.variables, fractions, strict=True)
        }
        written = {
            variable.number.key: variable.number.written(numbers[variable.number.key])
            for variable in self.variables
        }
        following = {
            each.number.key: each.number.written(each.at(numbers[each.variable]))
            for each in self.followed
        }
        return written | following | chosen

    @property
    def effects(self) -> tuple[str, ...]:
        """Effects to simulate, as an argument of `pyworm.plan`."""
        given = self.tables.effects
        return self.case.effects if given is None else given

    @property
    def names(self) -> tuple[str, ...]:
        """Figures that decide: of objectives and of constraints."""
        front = {} if self.tables.front is None else self.tables.front.weights
        named = [*self.tables.objective.weights, *front, *(limit.name for limit in self.limits)]
        return tuple(dict.fromkeys(named))


def figure_text(name: str, value: float) -> str:
    """A figure with its unit."""
    try:
        return quantity_of(name).text(value)
    except KeyError:  # of ratings
        return f"{value:.4g}"


def is_temperature(name: str) -> bool:
    """Whether a figure is a temperature, whose changes are kelvins and not parts of it."""
    try:
        return quantity_of(name).unit == "K"
    except KeyError:  # of ratings
        return False


def change_text(name: str, change: float) -> str:
    """A change of a figure: relative ones in per cent, of temperatures in kelvins."""
    return f"{change:.3g} K" if is_temperature(name) else percent(change, 3)


def load_design(path: str | Path) -> DesignTask:
    """Read a design file and check it against its case; CaseError, one line, for whatever is wrong first."""
    path = Path(path)
    data = read_toml(path)
    try:
        tables = checked(DesignTable, data)
        base = path.parent / tables.case
        content = with_values(with_fitted(read_toml(base), base.parent).content, tables.fixed)
        case = case_without_contacts(content, base.stem, base.parent)
        return _task(path.stem, tables, case)
    except CaseError as error:
        raise CaseError(f"{path}: {error}") from error


def _task(name: str, tables: DesignTable, case: Case) -> DesignTask:
    variables = tuple(
        _variable(case, key, bounds)
        for key, bounds in tables.variables.items()
        if isinstance(bounds, BoundsTable)
    )
    for key in tables.choices:
        value_at(case.content, key)
    limits = tuple(
        Limit(figure, _limit(figure, bound), upper)
        for figure, table in tables.constraints.items()
        for bound, upper in ((table.low, False), (table.high, True))
        if bound is not None
    )
    followed = tuple(_followed(case, key, table) for key, table in tables.follow.items())
    errors = tuple(
        AssemblyError(key, side * size)
        for key, text in tables.errors.items()
        for number in [numeric_key(case, key)]
        for size in [_number(f"errors.{key}", text, number)]
        for side in (-1.0, 1.0)
    )
    return DesignTask(name, tables, case, variables, followed, limits, errors)


def _variable(case: Case, key: str, bounds: BoundsTable) -> Variable:
    number = numeric_key(case, key)
    low, high = (
        _number(f"variables.{key}.{side}", getattr(bounds, side), number)
        for side in ("low", "high")
    )
    if not low < high:
        raise CaseError(f"variables.{key}: low must be below high")
    return Variable(number, low, high)


def _followed(case: Case, key: str, table: FollowTable) -> Followed:
    number = numeric_key(case, key)
    offset = 0.0 if table.offset == 0 else _number(f"follow.{key}.offset", table.offset, number)
    return Followed(number, table.variable, table.factor, offset)


def _number(where: str, given: Value, number: NumericKey) -> float:
    """A value of a design file in SI, of the kind of a number of the case."""
    try:
        found = float(given) if not number.si_unit else parse_in(given, number.si_unit)[0]
    except (TypeError, ValueError):
        example = f"{number.shown(number.value):.6g} {number.unit}".rstrip()
        raise CaseError(
            f"{where} = {toml(given)}: must be a number like that of the case, {example}"
        ) from None
    if not isfinite(found):
        raise CaseError(f"{where} = {toml(given)}: must be finite")
    return found


def _limit(name: str, given: Value) -> float:
    """A limit of a figure: with its unit, or a plain number in the unit at the end of the name."""
    plain = isinstance(given, int | float) and not isinstance(given, bool)
    try:
        quantity = quantity_of(name)
    except KeyError:  # of ratings
        if not plain:
            raise CaseError(
                f"constraints.{name} = {toml(given)}: must be a plain number, in the unit at the end of the "
                "name"
            ) from None
        return float(given)
    unit = "" if quantity.unit == "1" else quantity.unit
    if plain and not unit:
        return float(given)
    try:
        return parse_in(given, unit)[0]
    except (TypeError, ValueError):
        example = f'with its unit, such as "1 {quantity.shown}"' if unit else "without unit"
        raise CaseError(f"constraints.{name} = {toml(given)}: must be a number {example}") from None
