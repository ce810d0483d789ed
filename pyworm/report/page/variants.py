"""Variants of a drive side by side: what differs, verdicts, figures with their bars, flanks."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from pyworm.case.case import NO_PHYSICS, Case, case_again
from pyworm.case.table import by_dotted_key
from pyworm.io.input_error import CaseError
from pyworm.ratings.rated_case import asked_of, ratings
from pyworm.ratings.rating import Rating
from pyworm.ratings.standard_loss import standard_loss
from pyworm.report.page.content import Beside, Matrix, Variants
from pyworm.report.page.cover import verdict_of
from pyworm.report.page.figures import ERROR_BARS, glance_rows
from pyworm.report.page.pictures import signed_pictures
from pyworm.result.headline import opening
from pyworm.result.result import Result
from pyworm.result.result_case import value_shown

FEWEST, MOST = 2, 6
"""Numbers of variants that stand side by side."""


@dataclass(frozen=True)
class Variant:
    """A variant with all that is shown of it.

    Attributes
    ----------
    name : str
        What it is called.
    case : Case
        Its case.
    result : Result
        Its result.
    """

    name: str
    case: Case
    result: Result

    @property
    def rated(self) -> tuple[Rating, ...]:
        """Its ratings; none where nothing is rated."""
        try:
            return ratings(asked_of(self.case), self.result)
        except CaseError:
            return ()


def variants_page(results: Sequence[Result], names: Sequence[str]) -> Variants:
    """The page of variants.

    Parameters
    ----------
    results : sequence of Result
        Two to six results.
    names : sequence of str
        What they are called, each another.

    Raises
    ------
    CaseError
        Fewer or more, or a case that this version does not know.
    """
    if not FEWEST <= len(results) <= MOST:
        raise CaseError(f"{len(results)} results: {FEWEST} to {MOST} stand side by side")
    variants = [
        Variant(name, case_again(result.case), result)
        for name, result in zip(names, results, strict=True)
    ]
    titles = tuple(dict.fromkeys(variant.case.title for variant in variants))
    return Variants(
        " / ".join(titles),
        tuple(names),
        tuple(
            f"{variant.name}: {sentence}"
            for variant in variants
            for sentence in opening(variant.result.solutions, standard_loss(variant.case).words)
        ),
        _differences(variants),
        _verdicts(variants),
        _figures(variants),
        tuple(Beside(variant.name, signed_pictures(variant.result)) for variant in variants),
        ERROR_BARS,
    )


def _differences(variants: Sequence[Variant]) -> Matrix:
    """Values of the cases in which they differ, but for those that solving finds."""
    found = {
        f"{table}.{key}"
        for of in variants
        for table, keys in of.case.left_open.items()
        for key in keys
    }
    tables = [
        by_dotted_key(of.case.tables.model_dump(mode="json", exclude=NO_PHYSICS)) for of in variants
    ]
    keys = dict.fromkeys(key for of in tables for key in of if key not in found)
    rows = (
        (key, tuple(value_shown(of.case.tables, key) for of in variants))
        for key in keys
        if any(of.get(key) != tables[0].get(key) for of in tables)
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


def _verdicts(variants: Sequence[Variant]) -> Matrix:
    """Value and verdict of each safety; the value and the verdict are parted by a bar."""
    columns = [
        {
            verdict.what: verdict
            for rating in variant.rated
            for verdict in map(verdict_of, rating.safeties)
        }
        for variant in variants
    ]
    return _matrix(columns, lambda of: f"{of.value}|{of.words}")


def _figures(variants: Sequence[Variant]) -> Matrix:
    columns = []
    for variant in variants:
        sound = variant.result.sound
        rows = (
            glance_rows(variant.case, sound, standard_loss(variant.case)) if sound.solutions else ()
        )
        columns.append({label: value for label, value, _ in rows})
    return _matrix(columns, str)
