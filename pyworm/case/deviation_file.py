"""Files of deviations of a wheel's flank: CSV with the columns face_mm, radius_mm and deviation_um."""

import csv
from pathlib import Path
from typing import Any

import numpy as np

from pyworm.io.input_error import CaseError

COLUMNS = {"face_mm": 1e-3, "radius_mm": 1e-3, "deviation_um": 1e-6}
"""Column -> its unit in metres."""

MOST_PLACES = 10_000
"""Places of the largest file that is read; measurements have some hundred."""


def with_deviations(data: dict[str, Any], directory: Path) -> dict[str, Any]:
    """The content of a case file with that of the file that `[drive.wheel] deviations` names.

    Raises
    ------
    CaseError
        The file cannot be read, or holds no deviations over a grid.
    """
    drive = data.get("drive")
    wheel = drive.get("wheel") if isinstance(drive, dict) else None
    if not isinstance(wheel, dict) or "deviations" not in wheel:
        return data
    file = wheel["deviations"]
    if not isinstance(file, str):
        raise CaseError('drive.wheel.deviations must be the name of a file, such as "flank.csv"')
    try:
        held = {"file": file, **read_deviations(directory / file)}
    except ValueError as error:
        raise CaseError(f'drive.wheel.deviations = "{file}": {error}') from None
    return data | {"drive": drive | {"wheel": wheel | {"deviations": held}}}


def read_deviations(path: Path) -> dict[str, Any]:
    """Places along face and radius and the deviations over them [m], as a case's `DeviationTable` has them.

    Raises
    ------
    ValueError
        No such file, other columns, no numbers, or places that are no whole grid.
    """
    if not path.is_file():
        raise ValueError("no such file")
    rows = np.array(_rows(path)) * list(COLUMNS.values())
    face, radius = np.unique(rows[:, 0]), np.unique(rows[:, 1])
    for name, side in (("face_mm", face), ("radius_mm", radius)):
        if side.size < 2:
            raise ValueError(
                f"{name} is the same in all rows; a grid has two places or more each way"
            )
    if rows.shape[0] != face.size * radius.size or len(np.unique(rows[:, :2], axis=0)) != len(rows):
        raise ValueError(
            f"its {rows.shape[0]} places are no grid: {face.size} of face_mm and {radius.size} of radius_mm "
            f"ask for each of {face.size * radius.size} pairs once"
        )
    order = np.lexsort((rows[:, 1], rows[:, 0]))
    deviation = rows[order, 2].reshape(face.size, radius.size)
    return {"face": face.tolist(), "radius": radius.tolist(), "deviation": deviation.tolist()}


def _rows(path: Path) -> list[list[float]]:
    """Numbers of the file, a row for each place."""
    with path.open(newline="", encoding="utf-8-sig", errors="replace") as file:
        lines = csv.reader(file)
        head = [name.strip() for name in next(lines, [])]
        if head != list(COLUMNS):
            raise ValueError(
                f"its first line is {', '.join(head)[:60] or 'empty'}; it must be {','.join(COLUMNS)}"
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
    if len(values) != len(COLUMNS) or not np.isfinite(values).all():
        raise ValueError(
            f"line {number} is {','.join(line)[:60]}; three numbers with points and commas between are needed"
        )
    return values
