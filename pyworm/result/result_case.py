"""Comparison of a result with a case, by the physics and not by the name."""

from pathlib import Path
from typing import TYPE_CHECKING

from pydantic import BaseModel

from pyworm.case.case import NO_PHYSICS, Case, case_again, load
from pyworm.case.case_file import CaseTable
from pyworm.case.table import by_dotted_key
from pyworm.case.workshop_units import as_text
from pyworm.io.input_error import CaseError

if TYPE_CHECKING:
    from pyworm.result.result import Result


MOST_LISTED = 6
"""Number of differences that are listed."""


def differences(case: Case, result: "Result") -> tuple[str, ...]:
    """Differences between a case and the one that a result was solved with, each with both values.

    Titles, comparisons, accuracy, lists of places, ratings and values that the solution determines do not
    count. Of a gap's file only the name counts. CaseError if this version does not know the result's case.
    """
    before, now = case_again(result.case).tables, case.tables
    found = {f"{table}.{key}" for table, keys in case.left_open.items() for key in keys}
    old, new = (
        by_dotted_key(tables.model_dump(mode="json", exclude=NO_PHYSICS))
        for tables in (before, now)
    )
    keys = [key for key in {**new, **old} if old.get(key) != new.get(key) and key not in found]
    return tuple(
        f"{key} is {value_shown(now, key)}, was {value_shown(before, key)}" for key in keys
    )


def value_shown(tables: CaseTable, key: str) -> str:
    """A value of a case, by its dotted key, in workshop units; "not given" if the case leaves it out."""
    *parents, last = key.split(".")
    value, table = tables.at(key), tables.at(".".join(parents)) if parents else tables
    if value is None:
        return "not given"
    return as_text(
        value, type(table).model_fields.get(last) if isinstance(table, BaseModel) else None
    )


def as_solved(case: Case, result: "Result") -> Case:
    """A case with the values that its solution determined: friction, lifts, loss between the teeth."""
    kept = case_again(result.case).tables
    return case.with_found(
        {
            table: {key: getattr(getattr(kept, table), key) for key in keys}
            for table, keys in case.left_open.items()
            if getattr(kept, table, None) is not None
        }
    )


def case_for(path: Path, result: "Result", anyway: bool) -> tuple[Case, str | None]:
    """The case file of a result, as solved, and differences that `--anyway` accepts; else CaseError."""
    return as_solved_in(
        load(path), path, result, anyway, "; solve it again, or take it with --anyway"
    )


def as_solved_in(
    case: Case, name: object, result: "Result", anyway: bool = False, advice: str = ""
) -> tuple[Case, str | None]:
    """A case as it was solved in a result, and differences that are accepted; else CaseError with both.

    Args:
        name: What the case is called.
        anyway: Whether differences are accepted.
        advice: What the error proposes.
    """
    differ = differences(case, result)
    if not differ:
        return as_solved(case, result), None
    more = f" and {len(differ) - MOST_LISTED} more" if len(differ) > MOST_LISTED else ""
    sentence = f"the result is of another case than {name}: {'; '.join(differ[:MOST_LISTED])}{more}"
    if not anyway:
        raise CaseError(f"{sentence}{advice}")
    return as_solved(case, result), sentence
