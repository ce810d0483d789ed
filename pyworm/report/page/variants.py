"""Variants of a drive side by side: what differs, verdicts, figures with their bars, flanks."""

from collections.abc import Callable, Sequence
from typing import Any

from pyworm.case.case import NO_PHYSICS
from pyworm.case.table import by_dotted_key
from pyworm.io.input_error import CaseError
from pyworm.report.findings import Findings, findings
from pyworm.report.page.content import Beside, Matrix, Variants
from pyworm.report.page.cover import verdict_of
from pyworm.report.page.figures import ERROR_BARS, key_result_rows
from pyworm.report.page.pictures import signed_pictures
from pyworm.result.result import Result
from pyworm.result.result_case import value_shown

MIN_VARIANTS, MAX_VARIANTS = 2, 6
"""Numbers of variants that stand side by side."""


def variants_page(results: Sequence[Result], names: Sequence[str]) -> Variants:
    """The page of variants.

    Args:
        results: Two to six results.
        names: What they are called, each another.

    Raises:
        CaseError: Fewer or more, or a case that this version does not know.
    """
    if not MIN_VARIANTS <= len(results) <= MAX_VARIANTS:
        raise CaseError(
            f"{len(results)} results: {MIN_VARIANTS} to {MAX_VARIANTS} stand side by side"
        )
    variants = [findings(result) for result in results]
    titles = tuple(dict.fromkeys(variant.case.title for variant in variants))
    return Variants(
        " / ".join(titles),
        tuple(names),
        tuple(
            f"{name}: {sentence}"
            for name, variant in zip(names, variants, strict=True)
            for sentence in variant.opening()
        ),
        _differences(variants),
        _verdicts(variants),
        _figures(variants),
        tuple(
            Beside(name, signed_pictures(variant))
            for name, variant in zip(names, variants, strict=True)
        ),
        ERROR_BARS,
    )


def _differences(variants: Sequence[Findings]) -> Matrix:
    """Values of the cases in which they differ, but for those that solving finds."""
    found = {
        f"{table}.{key}"
        for variant in variants
        for table, keys in variant.case.left_open.items()
        for key in keys
    }
    tables = [
        by_dotted_key(variant.case.tables.model_dump(mode="json", exclude=NO_PHYSICS))
        for variant in variants
    ]
    keys = dict.fromkeys(key for table in tables for key in table if key not in found)
    rows = (
        (key, tuple(value_shown(variant.case.tables, key) for variant in variants))
        for key in keys
        if any(table.get(key) != tables[0].get(key) for table in tables)
    )
    return Matrix(tuple((key, cells) for key, cells in rows if len(set(cells)) > 1))


def _matrix(columns: Sequence[dict[str, Any]], text: Callable[[Any], str]) -> Matrix:
    """Rows by their names, in the order of the columns; a column that has none is empty there."""
    names = dict.fromkeys(name for column in columns for name in column)
    return Matrix(
        tuple(
            (name, tuple(text(column[name]) if name in column else "" for column in columns))
            for name in names
        )
    )


def _verdicts(variants: Sequence[Findings]) -> Matrix:
    """Value and verdict of each safety; the value and the verdict are parted by a bar."""
    columns = [
        {
            verdict.what: verdict
            for rating in variant.ratings
            for verdict in map(verdict_of, rating.safeties)
        }
        for variant in variants
    ]
    return _matrix(columns, lambda verdict: f"{verdict.value}|{verdict.words}")


def _figures(variants: Sequence[Findings]) -> Matrix:
    columns = [
        {label: value for label, value, _ in key_result_rows(variant)} for variant in variants
    ]
    return _matrix(columns, str)
