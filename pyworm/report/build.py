"""From a result to the content of its report."""

from pyworm.case import Case, case_again
from pyworm.case_error import CaseError
from pyworm.drives.gear_pair import GearPairDrive
from pyworm.drives.zi_worm import ZiWormDrive
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
    made, not_rated = _rated(case, result)
    sections = (
        glance_section(case, result, made),
        film_section(case, result),
        heat_section(case, result),
        _ratings_section(made, not_rated),
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


def _rated(case: Case, result: Result) -> tuple[tuple[Rating, ...], tuple[str, ...]]:
    """The ratings of a case, and what is not rated for which reason."""
    if case.drive is None:
        return (), ()
    if not isinstance(case.tables, RatedCase):
        kinds = "drives of kind zi-worm and gear-pair"
        return (), (f"Gears, scuffing and bearings: only {kinds} are rated.",)
    try:
        made = ratings(asked_of(case), result)
    except CaseError as error:
        return (), (f"Not rated: {error}.",)
    missing = []
    if isinstance(case.drive, ZiWormDrive):
        if case.tables.worm_rating is None:
            missing.append("Worm gear: the case has no [worm_rating].")
        missing.append(
            "Scuffing: the closed forms are those of steel on steel, a worm gear has a bronze wheel."
        )
    if isinstance(case.drive, GearPairDrive) and case.drive.surfaces is None:
        missing.append("Scuffing: the case has no [surfaces] with a coefficient of friction.")
    if not case.tables.bearings:
        missing.append("Bearings: the case has no [bearings.NAME].")
    return made, tuple(missing)


def _ratings_section(made: tuple[Rating, ...], not_rated: tuple[str, ...]) -> Section | None:
    """The ratings that the case asks for, and what is not rated; None of a contact without a drive."""
    if not made and not not_rated:
        return None
    blocks = [block for rating in made for block in _rating_blocks(rating)]
    if not_rated:
        blocks += [Words("Not rated:"), Items(not_rated)]
    return Section("Ratings: gears, scuffing, bearings", tuple(blocks))


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
