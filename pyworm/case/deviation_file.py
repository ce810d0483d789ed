"""Files of deviations of the flanks of worm and wheel: CSV with places, radii and deviations in columns."""

import csv
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.io.input_error import CaseError

PLACES = {"wheel": "face_mm", "worm": "axial_mm"}
"""Whose flank -> first column of its files: places along the wheel's face, along the worm's axis."""

UNITS = 1e-3, 1e-3, 1e-6
"""Units of the columns in metres: places, radius_mm, deviation_um."""

MOST_PLACES = 10_000
"""Places of the largest file that is read; measurements have some hundred."""


def with_deviations(data: dict[str, Any], directory: Path) -> dict[str, Any]:
    """The content of a case file with that of the files that `deviations` of worm and wheel name.

    CaseError if a file cannot be read, or holds no deviations over a grid.
    """
    drive = data.get("drive")
    if not isinstance(drive, dict):
        return data
    read: dict[str, Any] = {}
    for part, places in PLACES.items():
        table = drive.get(part)
        if isinstance(table, dict) and "deviations" in table:
            held = _held(part, places, table["deviations"], directory)
            read[part] = table | {"deviations": held}
    return data | {"drive": drive | read} if read else data


def _held(part: str, places: str, file: Any, directory: Path) -> dict[str, Any]:
    """What the file of a part of the drive holds, with its name."""
    if not isinstance(file, str):
        raise CaseError(f'drive.{part}.deviations must be the name of a file, such as "flank.csv"')
    try:
        return {"file": file, **read_deviations(directory / file, places)}
    except ValueError as error:
        raise CaseError(f'drive.{part}.deviations = "{file}": {error}') from None


def read_deviations(path: Path, places: str) -> dict[str, Any]:
    """Places, radii and the deviations over them [m] of a file whose first column is `places`, of `PLACES`.

    ValueError: no such file, other columns, no numbers, or places that are no whole grid.
    """
    if not path.is_file():
        raise ValueError("no such file")
    rows = np.array(_rows(path, [places, "radius_mm", "deviation_um"])) * UNITS
    along, radius = np.unique(rows[:, 0]), np.unique(rows[:, 1])
    for name, side in ((places, along), ("radius_mm", radius)):
        if side.size < 2:
            raise ValueError(
                f"{name} is the same in all rows; a grid has two places or more each way"
            )
    if rows.shape[0] != along.size * radius.size or len(np.unique(rows[:, :2], axis=0)) != len(
        rows
    ):
        raise ValueError(
            f"its {rows.shape[0]} places are no grid: {along.size} of {places} and {radius.size} of "
            f"radius_mm ask for each of {along.size * radius.size} pairs once"
        )
    order = np.lexsort((rows[:, 1], rows[:, 0]))
    deviation = rows[order, 2].reshape(along.size, radius.size)
    return {"along": along.tolist(), "radius": radius.tolist(), "deviation": deviation.tolist()}


def _rows(path: Path, columns: list[str]) -> list[list[float]]:
    """Numbers of a file of some columns, a row for each place."""
    with path.open(newline="", encoding="utf-8-sig", errors="replace") as file:
        lines = csv.reader(file)
        head = [name.strip() for name in next(lines, [])]
        if head != columns:
            raise ValueError(
                f"its first line is {', '.join(head)[:60] or 'empty'}; it must be {','.join(columns)}"
            )
        rows = []
        for line in lines:
            if not line:
                continue
            rows.append(_numbers(line, lines.line_num))
            if len(rows) > MOST_PLACES:
                raise ValueError(f"it has more than {MOST_PLACES} places")
    if not rows:
        raise ValueError("it has no places")
    return rows


def _numbers(line: list[str], number: int) -> list[float]:
    """Three finite numbers of a line."""
    try:
        values = [float(cell) for cell in line]
    except ValueError:
        values = []
    if len(values) != len(UNITS) or not np.isfinite(values).all():
        raise ValueError(
            f"line {number} is {','.join(line)[:60]}; three numbers with points and commas between are needed"
        )
    return values
