"""`fitted = "fitted.toml"`: values that `pyworm calibrate` found, in a file that several cases name."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, ValidationError

from pyworm.case.dotted_keys import with_values
from pyworm.case.table import Table
from pyworm.io.input_error import CaseError, sentence, toml
from pyworm.io.plain_values import Text
from pyworm.io.toml import read_toml

LAST_DIGIT = 1.01e-4
"""Difference of two correlations that are equal but for their rounding."""

Row = list[Annotated[float, Field(ge=-1, le=1)]]


class FittedTable(Table):
    """A file of fitted values: where they are from, the values by dotted key, and their correlations."""

    source: Text
    values: Annotated[dict[str, Any], Field(min_length=1)]
    correlation: list[Row] | None = None

    def flaws(self) -> Iterator[str]:
        """Correlations that are no square table of all values, or not those of pairs."""
        size = len(self.values)
        rows = self.correlation
        if rows is not None and [len(row) for row in rows] != [size] * size:
            yield f"correlation: must be a table of {size} rows and columns, as there are values"
        elif rows is not None and not _of_pairs(rows):
            yield "correlation: must be symmetric, with 1 for each value and itself"

    def correlations(self) -> dict[tuple[str, str], float]:
        """Correlation of each two values."""
        if self.correlation is None:
            return {}
        numbered = combinations(enumerate(self.values), 2)
        return {(first, second): self.correlation[i][j] for (i, first), (j, second) in numbered}


def _of_pairs(rows: Sequence[Sequence[float]]) -> bool:
    """Whether a square table is symmetric and has ones on its diagonal, to its last digit."""
    return all(
        abs(entry - (1 if i == j else rows[j][i])) <= LAST_DIGIT
        for i, row in enumerate(rows)
        for j, entry in enumerate(row)
    )


@dataclass(frozen=True)
class FittedContent:
    """The content of a case file with the values of the file that it names."""

    content: dict[str, Any]
    """The content, without the key that names the file."""
    correlations: Mapping[tuple[str, str], float]
    """Correlations of two fitted values."""


def with_fitted(data: dict[str, Any], directory: Path) -> FittedContent:
    """The content of a case file, with fitted values in place of its own, and these among its assumptions.

    Raises:
        CaseError: No such file, or one that holds no fitted values.
    """
    if "fitted" not in data:
        return FittedContent(data, {})
    name = data["fitted"]
    if not isinstance(name, str):
        raise CaseError(f'fitted = {toml(name)}: must be the name of a file, such as "fitted.toml"')
    table = read_fitted(directory / name)
    content = with_values(
        {key: part for key, part in data.items() if key != "fitted"}, table.values
    )
    assumed = content.get("assumed", {})
    if isinstance(assumed, dict):
        content["assumed"] = assumed | dict.fromkeys(table.values, table.source)
    return FittedContent(content, table.correlations())


def read_fitted(path: Path) -> FittedTable:
    """Read a file of fitted values; CaseError with the first error found, as one line."""
    data = read_toml(path)
    try:
        return FittedTable.model_validate(data)
    except ValidationError as error:
        raise CaseError(f"{path}: {sentence(error, FittedTable, data)}") from None


def fitted_file(
    source: str, values: Mapping[str, str | float], correlation: Sequence[Sequence[float]] = ()
) -> str:
    """The text of a file of fitted values, without correlations where there are none."""
    rows = [f'"{key}" = {toml(value)}' for key, value in values.items()]
    matrix = [f"    [{', '.join(f'{entry:.4f}' for entry in row)}]," for row in correlation]
    return "\n".join([f"source = {toml(source)}", "", *_correlation(matrix), "[values]", *rows, ""])


def _correlation(matrix: Sequence[str]) -> list[str]:
    if not matrix:
        return []
    return ["# Of the values below, in their order.", "correlation = [", *matrix, "]", ""]
