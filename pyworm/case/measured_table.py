"""Measurements of one's own: a CSV with a row for each, conditions by the keys of a case and results by name.

    operation.worm_speed [rpm], oil.temperature [degC], efficiency [%], u(efficiency) [%]
    500, 60, 81.2, 0.6

A condition is a dotted key of the case, or a place in the mesh or on a traction curve. A measured quantity
has a column of its standard uncertainty, u(NAME); several may stand in a row, and empty cells were not
measured.
"""

import csv
import difflib
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import Any

from pyworm.io import units
from pyworm.io.given import kind_of
from pyworm.io.input_error import CaseError, shortened
from pyworm.io.quantity import Kind, parse
from pyworm.scene.index import INDEX_NAMES

MEASURED: dict[str, Any] = {
    "film_central": units.Film,
    "film_min": units.Film,
    "friction_coefficient": units.Share,
    "power_loss": units.Power,
    "efficiency": units.Share,
    "unit_efficiency": units.Share,
    "sump_temperature": units.Temperature,
    "temperature_max_body_1": units.Temperature,
    "temperature_max_body_2": units.Temperature,
    "temperature_max_film": units.Temperature,
}
"""Quantity that may be measured -> its type of `pyworm.io.units`; of gears friction, loss and efficiency are
those of the teeth, and `unit_efficiency` holds the losses of `[cooling]` too."""

MAX_ROWS = 10_000
"""Rows of the longest file that is read."""

_HEAD = re.compile(r"([^\[\]]+(?:\[\d+\][^\[\]]*)?)(?:\[(?!\d+\])([^\[\]]*)\])?")
"""A name, which may hold a place in a list, and its unit."""

_UNCERTAINTY = re.compile(r"u\s*\(\s*(.+?)\s*\)")


@dataclass(frozen=True)
class Measurement:
    """One measured value."""

    line: int
    """Line of the file."""
    quantity: str
    """What was measured, of `MEASURED`."""
    value: float
    """Its value [SI]."""
    standard: float
    """Its standard uncertainty [SI]."""
    conditions: Mapping[str, Any]
    """Dotted key -> value as a case file has it."""
    place: Mapping[str, Any]
    """Place of the contact, by the names of `ContactIndex`."""


@dataclass(frozen=True)
class _Column:
    name: str
    unit: str


def read_measured(path: str | Path) -> tuple[Measurement, ...]:
    """Read measurements.

    Raises:
        CaseError: The first error found, as one line.
    """
    path = Path(path)
    if not path.is_file():
        raise CaseError(f"{path}: no such file")
    try:
        text = path.read_text(encoding="utf-8-sig")
        return _measurements(text)
    except UnicodeDecodeError:
        raise CaseError(f"{path}: is not in UTF-8; save it as UTF-8") from None
    except ValueError as error:
        raise CaseError(f"{path}: {error}") from None


def _measurements(text: str) -> tuple[Measurement, ...]:
    lines = [
        (number, line)
        for number, line in enumerate(text.splitlines(), 1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    if len(lines) < 2:
        raise ValueError("holds no measurements: a line of headings, then a line for each")
    if len(lines) > MAX_ROWS:
        raise ValueError(f"has {len(lines)} lines, {MAX_ROWS} at most are read")
    head, *rows = (_cells(line) for _, line in lines)
    if len(head) == 1 and re.search(r"[;\t]", head[0]):
        raise ValueError("columns are separated by commas, not by semicolons or tabs")
    columns = [_column(cell.strip()) for cell in head]
    _check_columns(columns)
    found: list[Measurement] = []
    for (number, _), row in zip(lines[1:], rows, strict=True):
        if len(row) != len(columns):
            hint = "; decimals follow a point, not a comma" if len(row) > len(columns) else ""
            raise ValueError(
                f"line {number}: has {len(row)} cells, the heading has {len(columns)}{hint}"
            )
        cells = [cell.strip() for cell in row]
        try:
            found += _of_row(number, dict(zip(columns, cells, strict=True)))
        except ValueError as error:
            raise ValueError(f"line {number}: {error}") from None
    if not found:
        raise ValueError("holds no measurements: all cells of measured quantities are empty")
    return tuple(found)


def _cells(line: str) -> list[str]:
    """Cells of one line; a quoted one ends with it."""
    try:
        return next(csv.reader([line], skipinitialspace=True))
    except csv.Error as error:
        raise ValueError(f'"{shortened(line)}": {error}') from None


def _column(cell: str) -> _Column:
    """Name and unit of a heading: "u(efficiency) [%]"; of keys "motion.velocity_1[0] [m/s]"."""
    match = _HEAD.fullmatch(cell)
    if match is None:
        raise ValueError(f'heading "{cell}": must be a name and its unit, such as "film_min [um]"')
    return _Column(match[1].strip(), (match[2] or "").strip())


def _check_columns(columns: Sequence[_Column]) -> None:
    """Refuse columns twice, unknown ones, and measured ones without their uncertainty or none at all."""
    names = [column.name for column in columns]
    measured = [name for name in names if name in MEASURED]
    for name in names:
        quantity = _quantity_of(name)
        if names.count(name) > 1:
            raise ValueError(f"column {name} is there twice")
        if quantity is not None and quantity not in MEASURED:
            raise ValueError(f"column {name}: no such quantity; {_meant(quantity)}")
        if quantity is not None and quantity not in names:
            raise ValueError(f"column {quantity} is missing, whose uncertainty is given")
        if quantity is None and name not in (*MEASURED, *INDEX_NAMES) and "." not in name:
            raise ValueError(
                f"column {name}: neither a key of the case, such as operation.worm_speed, nor a measured "
                f"quantity; {_meant(name)}"
            )
    if not measured:
        raise ValueError(f"no column of a measured quantity; it is one of {', '.join(MEASURED)}")
    for name in measured:
        if not any(_quantity_of(other) == name for other in names):
            raise ValueError(f"column u({name}) is missing, the standard uncertainty of {name}")


def _quantity_of(name: str) -> str | None:
    """The quantity whose uncertainty a column has; None of another column."""
    match = _UNCERTAINTY.fullmatch(name)
    return None if match is None else match[1]


def _meant(name: str) -> str:
    close = difflib.get_close_matches(name, MEASURED, n=1)
    return f"did you mean {close[0]}?" if close else f"measured are {', '.join(MEASURED)}"


def _of_row(line: int, row: Mapping[_Column, str]) -> list[Measurement]:
    """The measurements of one row."""
    conditions, place = {}, {}
    for column, cell in row.items():
        if column.name in INDEX_NAMES:
            place[column.name] = cell if column.name == "section" else _number(column.name, cell)
        elif "." in column.name:
            conditions[column.name] = _written(column, cell)
    uncertainties = {_quantity_of(column.name): (column, cell) for column, cell in row.items()}
    found = []
    for column, cell in row.items():
        if column.name not in MEASURED or not cell:
            continue
        kind = kind_of(MEASURED[column.name])
        value = _in_kind(column.name, cell, column.unit, kind)
        beside, text = uncertainties[column.name]
        if kind.unit == "K":
            kind = kind_of(units.TemperatureRise)
        standard = _number(beside.name, text) and _in_kind(beside.name, text, beside.unit, kind)
        if standard <= 0:
            raise ValueError(f"{beside.name} = {text}: must be a standard uncertainty above zero")
        found.append(Measurement(line, column.name, value, standard, conditions, place))
    return found


def _number(name: str, cell: str) -> float:
    try:
        number = float(cell)
    except ValueError:
        number = float("nan")
    if not isfinite(number):
        raise ValueError(f"{name} = {shortened(cell)}: must be a number")
    return number


def _written(column: _Column, cell: str) -> Any:
    """A condition as a case file has it: a quantity, a plain number, or a text such as an oil's name."""
    if column.unit:
        return f"{_number(column.name, cell):.12g} {column.unit}"
    try:
        number = float(cell)
    except ValueError:
        return cell
    if not isfinite(number):
        raise ValueError(f"{column.name} = {cell}: must be a number")
    return int(number) if number.is_integer() else number


def _in_kind(name: str, cell: str, unit: str, kind: Kind) -> float:
    """A cell in SI; ValueError of what is no number, or has a unit of another kind."""
    number = _number(name, cell)
    if number == 0 and not kind.unit:  # the efficiency of a gear set that locks itself
        return 0.0
    try:
        return parse(f"{number!r} {unit}".rstrip(), kind)
    except ValueError as error:
        raise ValueError(f"{name} = {cell} {unit}".rstrip() + f": {error}") from None
