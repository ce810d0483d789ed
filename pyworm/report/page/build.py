"""From a result to the content of its report."""

from dataclasses import replace

from pyworm.case.case import Case
from pyworm.ratings.heating import heating_of
from pyworm.ratings.rating import Rating
from pyworm.report.console.drive import sheet_tables
from pyworm.report.findings import Findings, findings
from pyworm.report.page.assumptions import (
    assumptions_section,
    inputs_section,
    plan_section,
    provenance_section,
)
from pyworm.report.page.content import Block, Picture, Report, Section
from pyworm.report.page.cover import Identity, cover_of, overleaf_of
from pyworm.report.page.exact_sensitivity import exact_sensitivity_section
from pyworm.report.page.figures import (
    film_section,
    heat_section,
    key_results_section,
    place_of,
    printed_section,
)
from pyworm.report.page.pictures import contact_section, cycle_section, signed_pictures
from pyworm.report.page.sensitivity import sensitivity_section
from pyworm.report.ratings import rating_table, safeties_table
from pyworm.result.mesh_cycle import drive_cycle
from pyworm.result.result import Result


def build_report(
    result: Result,
    case: Case | None = None,
    differ: str | None = None,
    identity: Identity = (),
    wear: tuple[Picture, ...] = (),
) -> Report:
    """The content of the report on a result.

    Args:
        result: The result.
        case: Case of the report in place of the solved one, such as one with other ratings.
        differ: How they differ, if they do and it is taken anyway.
        identity: What the page to sign names besides the case: drawing, customer.
        wear: Simulated wear of the drive.

    Raises:
        CaseError: The result's case is none that this version knows.
    """
    found = findings(result, case)
    cover = cover_of(found, identity)
    sections = (
        _noted(found, key_results_section(found)),
        _noted(found, film_section(found)),
        _noted(found, heat_section(found)),
        _ratings_section(found),
        None if cover is not None else _sheet_section(found.case),
        _noted(found, printed_section(found)),
        _noted(found, exact_sensitivity_section(found) or sensitivity_section(found)),
        cycle_section(found, signed=cover is not None),
        contact_section(result),
        assumptions_section(found),
        plan_section(result),
        inputs_section(found.case),
        provenance_section(result),
    )
    return Report(
        found.case.title,
        found.case.source,
        _warnings(found, differ),
        tuple(s for s in sections if s is not None),
        cover,
        None if cover is None else overleaf_of(found, (*signed_pictures(found), *wear)),
    )


def _warnings(found: Findings, differ: str | None) -> tuple[str, ...]:
    """What a reader must know before all else."""
    result = found.result
    heating = heating_of(found.case, drive_cycle(result), found.standard, result)
    warnings: tuple[str, ...] = () if differ is None else (f"{differ[0].upper()}{differ[1:]}.",)
    warnings += tuple(found.opening())
    if heating is not None:
        warnings += (heating.words,)
    warnings += tuple(
        f"{place_of(solution)} did not converge: {solution.stop_reason}"
        for solution in result.solutions
        if not solution.converged
    ) + tuple(
        f"{name} could not be solved: {reason}"
        for name, reason in result.provenance.get("failed", {}).items()
    )
    warnings += tuple(dict.fromkeys((*result.provenance.get("warnings", ()), *found.case.warnings)))
    return warnings + tuple(
        f"{rating.title} fails: {reason}" for rating in found.ratings for reason in rating.failed
    )


def _noted(found: Findings, section: Section | None) -> Section | None:
    """The section, preceded by the effects left out of its figures."""
    note = found.neglected_effects.note
    if section is None or not note:
        return section
    return replace(section, blocks=(f"{note.capitalize()}.", *section.blocks))


def _sheet_section(case: Case) -> Section | None:
    """Inspection sheet of a drive; None where it has none, or the page to sign has it."""
    if case.drive is None:
        return None
    tables = sheet_tables(case.drive.geometry(), case.drive.body_names)
    return Section("Geometry and inspection", tables) if tables else None


def _ratings_section(found: Findings) -> Section | None:
    """The ratings that the case asks for, and those left out; None for a contact without a drive."""
    if not found.ratings and not found.not_rated:
        return None
    blocks = [block for rating in found.ratings for block in _rating_blocks(rating)]
    if found.not_rated:
        blocks += ["Not rated:", found.not_rated]
    return Section("Ratings: gears, scuffing, bearings", tuple(blocks))


def _rating_blocks(rating: Rating) -> list[Block]:
    sentences = (*(f"FAILED: {reason}" for reason in rating.failed), *rating.words)
    tables: list[Block] = [rating_table(rating)]
    if rating.safeties:
        tables.append(safeties_table(rating, inputs=True))
    return [*tables, sentences] if sentences else tables
