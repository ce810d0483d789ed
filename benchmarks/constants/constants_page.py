"""Every constant of every standard: value, clause, provenance, and the smallest change that a check detects.

    python benchmarks/constants/constants_page.py     rewrites docs/reference/constants.md and .csv

Numbers are read from the tables and formulas themselves. Each is changed up and down by 2, 10 and 25 %,
twofold and tenfold; the table has the smallest change at which some check fails both ways, the page counts
them.
"""

import re
from collections import Counter
from collections.abc import Iterator
from csv import writer
from functools import cache
from io import StringIO
from itertools import groupby
from pathlib import Path

import bearing_checks
import lubricant_checks
import oil_rule_checks
import plastic_checks
import tooth_damage_checks
import unit_loss_checks
import worm_curve_checks
import worm_gear_checks
import worm_loss_checks
from chapter import KNOWLEDGE, MEMORY, TRANSCRIBED, Chapter
from constant_slips import LADDER, Seen, smallest_slip

CHAPTERS: tuple[Chapter, ...] = (
    *worm_curve_checks.CHAPTERS,
    *worm_gear_checks.CHAPTERS,
    *worm_loss_checks.CHAPTERS,
    *bearing_checks.CHAPTERS,
    *tooth_damage_checks.CHAPTERS,
    *oil_rule_checks.CHAPTERS,
    *lubricant_checks.CHAPTERS,
    *plastic_checks.CHAPTERS,
    *unit_loss_checks.CHAPTERS,
)

PAGE = Path(__file__).parents[2] / "docs/reference/constants.md"
TABLE = PAGE.with_suffix(".csv")

INTRODUCTION = """# Constants

All constants of the standards and rules that pyworm rates by, and the evidence for each.
The table [constants.csv](constants.csv) has one line for each number: its name in the program, value,
clause of the standard, provenance, and the smallest change that a check detects. Both files are generated
by

    python benchmarks/constants/constants_page.py

Input ranges and conversions by powers of ten are not listed.

## Provenance of the numbers
"""

DETECTION = """
## Errors that the checks detect

No check repeats the constant. The checks use neighbouring rows, monotony, ratios, limits, dimensions, other
formulas, other standards and printed examples. Each number is changed up and down by 2, 10 and 25 %, by a
factor of 2 and of 10 (a misplaced decimal point). Numbers by the smallest change that a check detects:
"""

UNDETECTED = """
### Numbers whose tenfold change is not detected

Under usual conditions a tenfold change of these numbers changes results by at most the factor in the last
column.
"""


HEADS = {MEMORY: "Numbers quoted from memory", TRANSCRIBED: "Numbers seen in one transcription"}
"""Headings of the lists of numbers that no printed text confirms."""


def word_of(seen: Seen) -> str:
    """The smallest change that a check detects, in words."""
    return "none" if seen.factor is None else _step(seen.factor)


def _step(factor: float) -> str:
    return f"x{factor:g}" if factor >= 2 else f"{(factor - 1) * 100:.0f} %"


@cache
def seen_in(chapter: Chapter) -> tuple[Seen, ...]:
    """The smallest slip of every number of a chapter."""
    return tuple(
        smallest_slip(chapter.subject, index, chapter.checks, chapter.results)
        for index in range(len(chapter.subject.numbers))
    )


def rows() -> Iterator[tuple[str, ...]]:
    """The lines of the table of all numbers, its head first."""
    yield tuple(
        "chapter,place,row,value,smallest detected change,detected by,clause,known".split(",")
    )
    for chapter in CHAPTERS:
        for number, seen in zip(chapter.subject.numbers, seen_in(chapter), strict=True):
            clause = chapter.clauses[number.place]
            detected_by = "; ".join(chapter.checks[check].words for check in seen.checks)
            yield (
                *(chapter.title, number.place, number.key, f"{number.value:.10g}"),
                *(word_of(seen), detected_by, clause.words, clause.known),
            )


def table() -> str:
    """All numbers as comma-separated values."""
    text = StringIO()
    writer(text, lineterminator="\n").writerows(rows())
    return text.getvalue()


def _row(*cells: object) -> str:
    return f"|{' |'.join(map(str, cells))} |"


def _known() -> Iterator[str]:
    yield _row("chapter", "source", "numbers", *KNOWLEDGE)
    yield "|---" * (3 + len(KNOWLEDGE)) + "|"
    for chapter in CHAPTERS:
        known = Counter(chapter.clauses[number.place].known for number in chapter.subject.numbers)
        anchor = re.sub(r"[^a-z ]", "", chapter.title.lower()).replace(" ", "-")
        counts = (known[way] or "" for way in KNOWLEDGE)
        title = f'<a id="{anchor}"></a>{chapter.title}'
        yield _row(title, chapter.source, known.total(), *counts)


def _detected() -> Iterator[str]:
    yield _row(*map(_step, LADDER), "none")
    yield "|---" * (1 + len(LADDER)) + "|"
    factors = Counter(seen.factor for chapter in CHAPTERS for seen in seen_in(chapter))
    yield _row(*(factors[step] for step in (*LADDER, None)))


def _undetected() -> Iterator[str]:
    yield "| name | numbers | factor |\n|---|---|---|"
    for chapter in CHAPTERS:
        pairs = zip(chapter.subject.numbers, seen_in(chapter), strict=True)
        blind = [(number, seen.moved) for number, seen in pairs if seen.factor is None]
        for place, members in groupby(blind, key=lambda pair: pair[0].place):
            numbers, moved = zip(*members, strict=True)
            values = ", ".join(f"{number.value:.10g}" for number in numbers)
            yield _row(f"`{place}`", values, f"{max(moved):.2f}")


def _not_read() -> Iterator[str]:
    for known in (MEMORY, TRANSCRIBED):
        places = dict.fromkeys(
            f"`{place}`"
            for chapter in CHAPTERS
            for place, clause in chapter.clauses.items()
            if clause.known == known
        )
        yield f"\n### {HEADS[known]}\n\n{', '.join(places)}."


def page() -> str:
    """The page of constants."""
    lines = [INTRODUCTION, *_known(), ""]
    lines += [f"- **{known}**: {words}." for known, words in KNOWLEDGE.items()]
    lines += [*_not_read(), DETECTION, *_detected(), UNDETECTED, *_undetected()]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page())
    TABLE.write_text(table())
