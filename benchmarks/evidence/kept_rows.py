"""Rows that a benchmark program has found so far, kept as CSV for its next run to go on from."""

import csv
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path


def kept_rows(path: Path, texts: Collection[str], flags: Collection[str] = ()) -> list[dict]:
    """Rows of earlier runs, if there are any; columns that are neither texts nor flags are numbers."""
    if not path.exists():
        return []

    def value(column: str, text: str) -> object:
        return text if column in texts else text == "True" if column in flags else float(text)

    with path.open() as file:
        return [
            {column: value(column, text) for column, text in row.items()}
            for row in csv.DictReader(file)
        ]


def keep_rows(path: Path, rows: Sequence[Mapping]) -> None:
    """Write what is known so far."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
