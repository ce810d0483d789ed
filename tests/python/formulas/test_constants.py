"""Every constant of every standard is held by a check that does not repeat it, and the page says how well."""

import pytest
from constant_slips import ModuleNumbers, smallest_slip
from constants_page import CHAPTERS, PAGE, TABLE, page, seen_in, table
from worm_curve_checks import CURVES

HARMLESS = 1.2
"""Factor by which a tenfold slip that no check sees may move a result of usual conditions."""

chapters = pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.title)


@chapters
def test_every_check_holds(chapter):
    printed = chapter.subject.as_printed()
    assert [check.words for check in chapter.checks if not check.holds(printed)] == []


@chapters
def test_a_decimal_point_in_the_wrong_place_is_seen(chapter):
    unseen = [
        (number, seen)
        for number, seen in zip(chapter.subject.numbers, seen_in(chapter), strict=True)
        if seen.factor is None and seen.moved > HARMLESS
    ]
    assert unseen == []


@chapters
def test_every_number_has_a_clause(chapter):
    assert {number.place for number in chapter.subject.numbers} == set(chapter.clauses)


def test_page_and_table_are_what_the_program_has():
    for path, text in ((PAGE, page()), (TABLE, table())):
        assert path.read_text() == text, "python benchmarks/constants/constants_page.py rewrites it"


def test_the_misprint_of_mineral_oil_in_a_bath_would_be_seen():
    """0.079 for 0.0079: neighbouring oils, injection, and AGMA's curve each tell."""
    index = next(
        i
        for i, number in enumerate(CURVES.subject.numbers)
        if number.key == "bath, mineral" and number.value == 0.0079
    )
    misprinted = CURVES.subject.with_number(index, 0.079)
    assert sum(check.sees(misprinted) for check in CURVES.checks) >= 3


def test_a_number_that_no_check_looks_at_is_told():
    subject = ModuleNumbers("pyworm.formulas.worm_root", only=("DEDENDUM",))
    blind = smallest_slip(subject, 0, (), lambda of: [of.DEDENDUM])
    assert blind.factor is None
    assert blind.moved == pytest.approx(10)
