"""Numbers of a module or a table, and what becomes of its formulas if one of them is misprinted."""

import ast
import copy
import re
import sys
import tomllib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf
from pathlib import Path
from types import ModuleType
from typing import Any, Protocol

LADDER = (1.02, 1.1, 1.25, 2.0, 10.0)
"""Factors by which a number is changed, up and down; the last is a decimal point in the wrong place."""

_BOUNDS = {"within", "positive", "one_of", "round", "range", "replace", "isfinite", "linspace"}
"""Calls whose numbers are ranges of input or sizes of arrays, not constants of a formula."""

_UNITS = re.compile(r"1e[-+]?[3469]$")
"""Powers of ten that convert units, as they are written."""

_PLAIN = (0, 1, 2, True, False)


@dataclass(frozen=True)
class Number:
    """A number of a subject: its table or function, its key there, and its value."""

    place: str
    key: str
    value: float


class Subject(Protocol):
    """What numbers are read from and written into."""

    numbers: Sequence[Number]

    def with_number(self, index: int, value: float) -> Any:
        """What checks look at, with one number changed."""

    def as_printed(self) -> Any:
        """What checks look at, unchanged."""


@dataclass(frozen=True)
class Check:
    """A statement about formulas that does not repeat their numbers."""

    words: str
    holds: Callable[[Any], bool]

    def sees(self, changed: Any) -> bool:
        """Whether it fails, or cannot be computed, with a changed number."""
        try:
            return not self.holds(changed)
        except (ArithmeticError, AttributeError, LookupError, StopIteration, TypeError, ValueError):
            return True


# ------------------------------------------------------------------------------------ modules


class _Collector(ast.NodeTransformer):
    """Replaces every number of the formulas by an element of a list."""

    def __init__(self, source: str) -> None:
        self.lines = source.splitlines()
        self.numbers: list[Number] = []
        self.place, self.key = "", ""

    def visit_Call(self, node: ast.Call) -> ast.AST:
        name = getattr(node.func, "id", getattr(node.func, "attr", ""))
        return node if name in _BOUNDS else self.generic_visit(node)

    def visit_JoinedStr(self, node: ast.JoinedStr) -> ast.AST:
        return node

    def visit_Subscript(self, node: ast.Subscript) -> ast.AST:
        node.value = self.visit(node.value)
        return node

    def visit_arguments(self, node: ast.arguments) -> ast.AST:
        node.defaults = [self.visit(value) for value in node.defaults]
        return node  # annotations hold no numbers

    def visit_Dict(self, node: ast.Dict) -> ast.AST:
        above = self.key
        for index, key in enumerate(node.keys):
            self.key = " ".join(filter(None, (above, _words(key))))
            node.values[index] = self.visit(node.values[index])
        self.key = above
        return node

    def visit_Constant(self, node: ast.Constant) -> ast.AST:
        if not isinstance(node.value, int | float) or node.value in _PLAIN:
            return node
        line = self.lines[node.lineno - 1].encode()
        if _UNITS.match(line[node.col_offset : node.end_col_offset].decode()):
            return node
        self.numbers.append(Number(self.place, self.key, node.value))
        element = ast.parse(f"__numbers__[{len(self.numbers) - 1}]", mode="eval").body
        return ast.copy_location(element, node)


def _words(key: ast.expr | None) -> str:
    return "" if key is None else re.sub(r"[\"'()]", "", ast.unparse(key))


class ModuleNumbers:
    """Numbers of a module of `pyworm`, except ranges of input and conversions of units."""

    def __init__(self, name: str, only: tuple[str, ...] = ()) -> None:
        module = sys.modules.get(name) or __import__(name, fromlist=["_"])
        path = Path(str(module.__file__))
        source = path.read_text()
        tree = ast.parse(source)
        collector = _Collector(source)
        for node in tree.body:
            for place, part in _definitions(node):
                if not only or place in only:
                    collector.place = place
                    collector.visit(part)
        ast.fix_missing_locations(tree)
        self.name, self.numbers = name, collector.numbers
        self._code = compile(tree, str(path), "exec")

    def with_number(self, index: int, value: float) -> ModuleType:
        """The module with one number changed."""
        values = [number.value for number in self.numbers]
        values[index] = value
        try:
            return self._module(values)
        except (ArithmeticError, TypeError, ValueError) as refused:  # a constructor that checks
            return _Refused(self.name, refused)

    def as_printed(self) -> ModuleType:
        """The module as it is."""
        return self._module([number.value for number in self.numbers])

    def _module(self, values: list[float]) -> ModuleType:
        module = ModuleType(self.name)
        module.__dict__["__numbers__"] = values
        exec(self._code, module.__dict__)
        return module


class _Refused(ModuleType):
    """A module that a changed number keeps from being made."""

    def __init__(self, name: str, reason: Exception) -> None:
        super().__init__(name)
        self.reason = reason

    def __getattr__(self, name: str) -> Any:
        raise ValueError(f"{self.reason}")


def _definitions(node: ast.stmt) -> Iterator[tuple[str, ast.stmt]]:
    """Names that a statement defines at the top of a module or in its classes."""
    if isinstance(node, ast.FunctionDef):
        yield node.name, node
    elif isinstance(node, ast.ClassDef):
        for part in node.body:
            if isinstance(part, ast.FunctionDef) and part.name != "__post_init__":
                yield f"{node.name}.{part.name}", part
    elif isinstance(node, ast.Assign):
        names = [ast.unparse(target).strip("()") for target in node.targets]
        yield ", ".join(names), node
    elif isinstance(node, ast.AnnAssign) and node.value is not None:
        yield ast.unparse(node.target), node


# ------------------------------------------------------------------------------------- tables


class TableNumbers:
    """Numbers of a TOML file, or of some of its tables, with or without a unit; checks look at the tables."""

    def __init__(self, path: Path, only: tuple[str, ...] = ()) -> None:
        tables = tomllib.loads(path.read_text())
        self._tables = {name: of for name, of in tables.items() if not only or name in only}
        self._paths = list(_numbers_of(self._tables))
        self.numbers = [
            Number(str(keys[0]), " ".join(str(key) for key in keys[1 : 2 + (len(keys) > 3)]), value)
            for keys, value in self._paths
        ]

    def with_number(self, index: int, value: float) -> dict[str, Any]:
        """The tables with one number changed."""
        tables = copy.deepcopy(self._plain)
        keys, _ = self._paths[index]
        inner: Any = tables
        for key in keys[:-1]:
            inner = inner[key]
        inner[keys[-1]] = value
        return tables

    def as_printed(self) -> dict[str, Any]:
        """The tables, numbers without their units."""
        return self._plain

    @cached_property
    def _plain(self) -> dict[str, Any]:
        tables = copy.deepcopy(self._tables)
        for keys, value in self._paths:
            inner: Any = tables
            for key in keys[:-1]:
                inner = inner[key]
            inner[keys[-1]] = value
        return tables


def _numbers_of(value: Any, keys: tuple = ()) -> Iterator[tuple[tuple, float]]:
    if isinstance(value, dict):
        for key, inner in value.items():
            if key != "sources":
                yield from _numbers_of(inner, (*keys, key))
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from _numbers_of(inner, (*keys, index))
    elif isinstance(value, int | float):
        yield keys, value
    elif isinstance(value, str) and (match := re.match(r"(-?\d[\d.e+-]*) ", value)):
        yield keys, float(match[1])


# -------------------------------------------------------------------------------------- slips


@dataclass(frozen=True)
class Seen:
    """Smallest factor of the ladder that is seen up and down, and checks that see it.

    Where even the last is not seen both ways, `factor` is None and `moved` the largest factor by which a
    tenfold slip that is not seen changes a result.
    """

    factor: float | None
    checks: tuple[int, ...]
    moved: float = 1.0


def smallest_slip(
    subject: Subject,
    index: int,
    checks: Sequence[Check],
    results: Callable[[Any], Sequence[float]],
) -> Seen:
    """How small a change of a number the checks see."""
    value = subject.numbers[index].value
    for factor in LADDER:
        slips = value * factor, value / factor
        seen = [_first_that_sees(subject, index, slip, checks) for slip in slips]
        if None not in seen:
            return Seen(factor, tuple(sorted({of for of in seen if of is not None})))
    before = results(subject.as_printed())
    moved = 1.0
    for slip, found in zip(slips, seen, strict=True):
        if found is None:
            after = results(subject.with_number(index, slip))
            ratios = [b / a for a, b in zip(before, after, strict=True) if a]
            moved = max([moved, *(max(abs(r), 1 / abs(r)) if r else inf for r in ratios)])
    return Seen(None, tuple(of for of in seen if of is not None), moved)


def _first_that_sees(
    subject: Subject, index: int, value: float, checks: Sequence[Check]
) -> int | None:
    changed = subject.with_number(index, value)
    return next((of for of, check in enumerate(checks) if check.sees(changed)), None)
