"""From a result to the content of its report."""

from pyworm.case import Case, case_again
from pyworm.case_error import CaseError
from pyworm.ratings.asked import asked_of, ratings
from pyworm.ratings.rating import Rating
from pyworm.report.assumptions import assumptions_section, plan_section, provenance_section
from pyworm.report.content import Block, Items, Report, Section, Table, Words
from pyworm.report.figures import (
    film_section,
    glance_section,
    heat_section,
    place_of,
    printed_section,
)
from pyworm.report.inputs import inputs_section
from pyworm.report.pictures import contact_pictures, cycle_pictures
from pyworm.report.sensitivity import sensitivity_section
from pyworm.result import Result
from pyworm.schema.rating import RatedCase


def build_report(result: Result) -> Report:
    """Everything a report says of a result.

    Raises
    ------
    CaseError
        The result's case is none that this version knows.
    """
    case = case_again(result.case)
    warnings = tuple(
        f"{place_of(of)} did not converge: {of.stop_reason}"
        for of in result.solutions
        if not of.converged
    ) + tuple(
        f"{name} could not be solved: {reason}"
        for name, reason in result.provenance.get("failed", {}).items()
    )
    sections = (
        glance_section(case, result),
        film_section(case, result),
        heat_section(case, result),
        _ratings_section(case, result),
        printed_section(case, result),
        sensitivity_section(case, result),
        cycle_pictures(result),
        contact_pictures(result),
        assumptions_section(case, result),
        plan_section(result),
        inputs_section(case),
        provenance_section(result),
    )
    return Report(case.title, case.source, warnings, tuple(s for s in sections if s is not None))


def _ratings_section(case: Case, result: Result) -> Section | None:
    """The ratings that the case asks for; None where it asks for none."""
    if not isinstance(case.tables, RatedCase):
        return None
    try:
        made = ratings(asked_of(case), result)
    except CaseError as error:
        return Section("Ratings", (Words(f"Not rated: {error}."),))
    if not made:
        return None
    return Section("Ratings", tuple(block for rating in made for block in _rating_blocks(rating)))


def _rating_blocks(rating: Rating) -> list[Block]:
    columns = range(len(rating.columns))
    table = Table(
        head=("", *(column.capitalize() for column in rating.columns)),
        rows=tuple(
            (figure.label, *(figure.shown(n) for n in columns)) for figure in rating.figures
        ),
        title=rating.title,
        note=f"Source: {rating.source}.",
    )
    return [table, Items(rating.words)] if rating.words else [table]
