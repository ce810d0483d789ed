"""From a result to the content of its report."""

from dataclasses import replace

from pyworm.case.case import Case, case_again
from pyworm.case.kinds import rated
from pyworm.case.ratings import RatedCase
from pyworm.io.input_error import CaseError
from pyworm.ratings.heating import heating_of
from pyworm.ratings.rated_case import asked_of, not_rated, ratings
from pyworm.ratings.rating import Rating
from pyworm.ratings.standard_loss import NoStandard, StandardLoss, standard_loss
from pyworm.report.page.assumptions import assumptions_section, plan_section, provenance_section
from pyworm.report.page.content import Block, Items, Picture, Report, Section, Table, Words
from pyworm.report.page.cover import Identity, cover_of, overleaf_of
from pyworm.report.page.figures import (
    film_section,
    glance_section,
    heat_section,
    place_of,
    printed_section,
)
from pyworm.report.page.inputs import inputs_section
from pyworm.report.page.pictures import contact_section, cycle_section, signed_pictures
from pyworm.report.page.sensitivity import sensitivity_section
from pyworm.report.page.symbols import made_of, named
from pyworm.result.headline import of_all, opening
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.result.result import Result
from pyworm.solver.left_out import LeftOut


def build_report(
    result: Result,
    case: Case | None = None,
    differ: str | None = None,
    identity: Identity = (),
    wear: tuple[Picture, ...] = (),
) -> Report:
    """The content of the report on a result.

    Parameters
    ----------
    result : Result
        The result.
    case : Case, optional
        Case of the report in place of the solved one, such as one with other ratings.
    differ : str, optional
        How they differ, if they do and it is taken anyway.
    identity : tuple of tuple of str
        What the page to sign names besides the case: drawing, customer.
    wear : tuple of Picture, optional
        Simulated wear of the drive.

    Raises
    ------
    CaseError
        The result's case is none that this version knows.
    """
    case = case or case_again(result.case)
    standard, left_out = standard_loss(case), of_all(result.solutions)
    made, unrated = _rated(case, result)
    sound, cover = result.sound, cover_of(case, result, made, identity)
    sections = (
        _noted(left_out, glance_section(case, sound, made, standard)),
        _noted(left_out, film_section(case, result)),
        _noted(left_out, heat_section(case, result)),
        _ratings_section(made, unrated),
        _noted(left_out, printed_section(case, sound)),
        _noted(left_out, sensitivity_section(case, sound)),
        cycle_section(result, signed=cover is not None),
        contact_section(result),
        assumptions_section(case, result),
        plan_section(result),
        inputs_section(case),
        provenance_section(result),
    )
    return Report(
        case.title,
        case.source,
        _warnings(case, result, differ, standard, made),
        tuple(s for s in sections if s is not None),
        cover,
        None
        if cover is None
        else overleaf_of(case, result, made, standard, (*signed_pictures(result), *wear)),
    )


def _warnings(
    case: Case,
    result: Result,
    differ: str | None,
    standard: StandardLoss | NoStandard,
    made: tuple[Rating, ...],
) -> tuple[str, ...]:
    """What a reader must know before all else."""
    heating = heating_of(case, drive_cycle(result), standard)
    warnings: tuple[str, ...] = () if differ is None else (f"{differ[0].upper()}{differ[1:]}.",)
    warnings += tuple(opening(result.solutions, standard.words, case.beyond_limits))
    if heating is not None:
        warnings += (heating.words,)
    warnings += tuple(
        f"{place_of(of)} did not converge: {of.stop_reason}"
        for of in result.solutions
        if not of.converged
    ) + tuple(
        f"{name} could not be solved: {reason}"
        for name, reason in result.provenance.get("failed", {}).items()
    )
    warnings += tuple(dict.fromkeys((*result.provenance.get("warnings", ()), *case.warnings)))
    return warnings + tuple(f"{of.title} fails: {reason}" for of in made for reason in of.failed)


def _noted(left_out: LeftOut, section: Section | None) -> Section | None:
    """The section, preceded by the effects left out of its figures."""
    if section is None or not left_out.note:
        return section
    return replace(section, blocks=(Words(f"{left_out.note.capitalize()}."), *section.blocks))


def _rated(case: Case, result: Result) -> tuple[tuple[Rating, ...], tuple[str, ...]]:
    """The ratings of a case, and those left out with the reason."""
    if case.drive is None:
        return (), ()
    if not isinstance(case.tables, RatedCase):
        kinds = ", ".join(rated())
        return (), (f"Gears, scuffing and bearings: only drives of kind {kinds} are rated.",)
    try:
        asked = asked_of(case)
        made = ratings(asked, result)
    except CaseError as error:
        return (), (f"Not rated: {error}.",)
    return made, not_rated(asked, made)


def _ratings_section(made: tuple[Rating, ...], unrated: tuple[str, ...]) -> Section | None:
    """The ratings that the case asks for, and those left out; None for a contact without a drive."""
    if not made and not unrated:
        return None
    blocks = [block for rating in made for block in _rating_blocks(rating)]
    if unrated:
        blocks += [Words("Not rated:"), Items(unrated)]
    return Section("Ratings: gears, scuffing, bearings", tuple(blocks))


def _rating_blocks(rating: Rating) -> list[Block]:
    columns = range(len(rating.columns))
    table = Table(
        head=("", *rating.headings),
        rows=tuple(
            (figure.label, *(figure.shown(n) for n in columns)) for figure in rating.figures
        ),
        title=rating.titled.replace("\n", "; "),
        note=f"Source: {rating.source}.",
    )
    sentences = (*(f"FAILED: {reason}" for reason in rating.failed), *rating.words)
    tables: list[Block] = [table, _safeties(rating)] if rating.safeties else [table]
    return [*tables, Items(sentences)] if sentences else tables


def _safeties(rating: Rating) -> Table:
    """The safeties of a rating with what they require and were made of."""
    return Table(
        head=("Safety", "Value", "Required", "Verdict", "Made of"),
        rows=tuple(
            (
                f"{named(of.symbol)}, {of.label}",
                of.shown,
                f"{of.minimum:g}",
                of.verdict,
                made_of(of),
            )
            for of in rating.safeties
        ),
        title=f"{rating.title}: safeties",
    )
