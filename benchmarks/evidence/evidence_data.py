"""Data files of the evidence: what a command found, with the command, the commit, the machine and the date.

A file, `docs/evidence/data/NAME.csv`, begins with comments of its origin; its first row has the titles of the
columns, with their units. The pages show it in tables (`evidence_pages.py`).
"""

import csv
from dataclasses import dataclass, fields
from pathlib import Path

ROOT = Path(__file__).parents[2]
DATA = ROOT / "docs/evidence/data"


@dataclass(frozen=True)
class Origin:
    """Where data come from; an empty text is not shown."""

    command: str = ""
    """Command that wrote them."""
    commit: str = ""
    """Commit of the program."""
    machine: str = ""
    """Processor, and number of cores."""
    date: str = ""
    """Date of the run."""


@dataclass(frozen=True)
class DataFile:
    """Rows of text under the titles of their columns."""

    origin: Origin
    """Where they come from."""
    columns: tuple[str, ...]
    """Titles, with units."""
    rows: tuple[tuple[str, ...], ...]
    """One text for each column."""


def path_of(name: str) -> Path:
    """The file of some data."""
    return DATA / f"{name}.csv"


def read(name: str) -> DataFile:
    """Data by name.

    Raises:
        ValueError: If a row has not as many texts as there are columns.
    """
    lines = path_of(name).read_text().splitlines(keepends=True)
    comments = [line for line in lines if line.startswith("# ")]
    origin = dict(line[2:].rstrip("\n").partition(": ")[::2] for line in comments)
    columns, *rows = csv.reader(line for line in lines if not line.startswith("# "))
    if any(len(row) != len(columns) for row in rows):
        raise ValueError(f"{path_of(name)}: a row has not {len(columns)} columns")
    return DataFile(Origin(**origin), tuple(columns), tuple(map(tuple, rows)))


def save(name: str, data: DataFile) -> None:
    """Write data by name."""
    with path_of(name).open("w", newline="") as file:
        for field in fields(Origin):
            if text := getattr(data.origin, field.name):
                file.write(f"# {field.name}: {text}\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(data.columns)
        writer.writerows(data.rows)
