"""Variants of a drive side by side: what differs, verdicts, figures with their bars, flanks."""

from collections.abc import Sequence
from itertools import zip_longest

from pyworm.case.case import NO_PHYSICS
from pyworm.case.table import by_dotted_key
from pyworm.io.input_error import CaseError
from pyworm.report.findings import Findings, findings
from pyworm.report.page.content import Section, Variants
from pyworm.report.page.cover import judged, named_safety
from pyworm.report.page.figures import ERROR_BARS, key_result_rows
from pyworm.report.page.pictures import signed_pictures
from pyworm.report.table import Table
from pyworm.result.result import Result
from pyworm.result.result_case import value_shown

Rows = tuple[tuple[str, ...], ...]

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
    rows = {
        "What differs": _differences(variants),
        "Verdicts": _rows([_verdicts(variant) for variant in variants]),
        "Figures": _rows([{row[0]: row[1] for row in key_result_rows(each)} for each in variants]),
    }
    pictures = (
        [(name, picture) for name, picture in zip(names, row, strict=True) if picture]
        for row in zip_longest(*map(signed_pictures, variants))
    )
    return Variants(
        " / ".join(dict.fromkeys(variant.case.title for variant in variants)),
        tuple(names),
        tuple(
            (name, sentence)
            for name, variant in zip(names, variants, strict=True)
            for sentence in variant.opening()
        ),
        tuple(
            Section(title, (Table(("", *names), of_title),))
            for title, of_title in rows.items()
            if of_title
        ),
        tuple(map(tuple, pictures)),
        ERROR_BARS,
    )


def _differences(variants: Sequence[Findings]) -> Rows:
    """Values of the cases in which they differ, but for those that solving finds."""
    found = {
        f"{table}.{key}"
        for variant in variants
        for table, keys in variant.case.left_open.items()
        for key in keys
    }
    first, *others = (
        by_dotted_key(variant.case.tables.model_dump(mode="json", exclude=NO_PHYSICS))
        for variant in variants
    )
    keys = dict.fromkeys(key for table in (first, *others) for key in table if key not in found)
    rows = (
        (key, *(value_shown(variant.case.tables, key) for variant in variants))
        for key in keys
        if any(table.get(key) != first.get(key) for table in others)
    )
    return tuple(row for row in rows if len(set(row[1:])) > 1)


def _verdicts(variant: Findings) -> dict[str, str]:
    """Value and verdict of each safety."""
    safeties = (safety for rating in variant.ratings for safety in rating.safeties)
    return {named_safety(safety): judged(safety, safety.shown) for safety in safeties}


def _rows(columns: Sequence[dict[str, str]]) -> Rows:
    """Rows by their names, in the order of the columns; a column that has none is empty there."""
    names = dict.fromkeys(name for column in columns for name in column)
    return tuple((name, *(column.get(name, "") for column in columns)) for name in names)
