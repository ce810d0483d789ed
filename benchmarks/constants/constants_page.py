"""Every constant of every standard: value, clause, how known, and the smallest slip that a check sees.

    python benchmarks/constants/constants_page.py     rewrites docs/reference/constants.md

Numbers are read from the tables and formulas themselves. Each is changed up and down by 2, 10 and 25 %,
twofold and tenfold; the page has the smallest change at which some check fails both ways.
"""

from collections.abc import Iterator
from functools import cache
from itertools import groupby
from pathlib import Path

import bearing_checks
import oil_rule_checks
import plastic_checks
import tooth_damage_checks
import worm_curve_checks
import worm_gear_checks
import worm_loss_checks
from chapter import KNOWLEDGE, MEMORY, TRANSCRIBED, Chapter
from constant_slips import LADDER, Number, Seen, smallest_slip

CHAPTERS: tuple[Chapter, ...] = (
    *worm_curve_checks.CHAPTERS,
    *worm_gear_checks.CHAPTERS,
    *worm_loss_checks.CHAPTERS,
    *bearing_checks.CHAPTERS,
    *tooth_damage_checks.CHAPTERS,
    *oil_rule_checks.CHAPTERS,
    *plastic_checks.CHAPTERS,
)

PAGE = Path(__file__).parents[2] / "docs/reference/constants.md"

ROW = 8
"""Numbers in a line of the page."""

INTRODUCTION = """# Constants

Every constant of the standards and rules that pyworm rates by, read from its tables and formulas by

    python benchmarks/constants/constants_page.py

and how far it is checked by something that does not repeat it: neighbouring rows, monotony, ratios, limits,
dimensions, another formula, another standard, a printed example. Each number is changed up and down by 2, 10
and 25 %, twofold and tenfold (a decimal point in the wrong place). **Slip seen** is the smallest of these
changes at which a check fails both ways, **by** the first checks that fail; "no" means that a tenfold change
is not seen both ways, with the largest factor by which it moves results of usual conditions. Ranges of input
and conversions by powers of ten are not listed.
"""


def word_of(seen: Seen) -> str:
    """The smallest slip that is seen, as the page has it."""
    if seen.factor is None:
        return f"no ({seen.moved:.2f})"
    return f"x{seen.factor:g}" if seen.factor >= 2 else f"{(seen.factor - 1) * 100:.0f} %"


@cache
def seen_in(chapter: Chapter) -> tuple[Seen, ...]:
    """The smallest slip of every number of a chapter."""
    return tuple(
        smallest_slip(chapter.subject, index, chapter.checks, chapter.results)
        for index in range(len(chapter.subject.numbers))
    )


def _letters(seen: Seen) -> str:
    return "".join(chr(ord("a") + check) for check in seen.checks)


def _rows(chapter: Chapter) -> Iterator[str]:
    pairs = zip(chapter.subject.numbers, seen_in(chapter), strict=True)
    for (place, key), group in groupby(pairs, key=lambda pair: (pair[0].place, pair[0].key)):
        members: list[tuple[Number, Seen]] = list(group)
        clause = chapter.clauses[place]
        for first in range(0, len(members), ROW):
            part = members[first : first + ROW]
            cells = (
                f"`{place}`{' ' + key if key else ''}",
                ", ".join(f"{number.value:.10g}" for number, _ in part),
                ", ".join(word_of(seen) for _, seen in part),
                " ".join(sorted(set("".join(_letters(seen) for _, seen in part)))),
                clause.words,
                clause.known,
            )
            yield f"| {' | '.join(cells)} |"


def _chapter(chapter: Chapter) -> Iterator[str]:
    yield f"\n## {chapter.title}\n"
    yield f"{chapter.source}.\n"
    yield "| where | numbers | slip seen | by | clause | known from |\n|---|---|---|---|---|---|"
    yield from _rows(chapter)
    yield ""
    for index, check in enumerate(chapter.checks):
        yield f"{chr(ord('a') + index)}. {check.words}" + (
            "  " if index + 1 < len(chapter.checks) else ""
        )


def _summary() -> Iterator[str]:
    steps = [f"x{f:g}" if f >= 2 else f"{(f - 1) * 100:.0f} %" for f in LADDER]
    yield "| chapter | numbers | " + " | ".join(steps) + " | not seen |"
    yield "|---|---" + "|---" * (len(steps) + 1) + "|"
    for chapter in CHAPTERS:
        factors = [seen.factor for seen in seen_in(chapter)]
        counts = [factors.count(step) for step in (*LADDER, None)]
        cells = (chapter.title, len(factors), *(count or "" for count in counts))
        yield f"| {' | '.join(map(str, cells))} |"


def _only_remembered() -> Iterator[str]:
    for known in (MEMORY, TRANSCRIBED):
        places = [
            f"`{place}`"
            for chapter in CHAPTERS
            for place, clause in chapter.clauses.items()
            if clause.known == known
        ]
        yield f"- **{known}**: {', '.join(places)}"


def page() -> str:
    """The page of constants."""
    lines = [INTRODUCTION, *_summary(), "\nNumbers are known from\n"]
    lines += [f"- **{known}**: {words}" for known, words in KNOWLEDGE.items()]
    lines += ["\n## What was not read\n", *_only_remembered()]
    for chapter in CHAPTERS:
        lines += _chapter(chapter)
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page())
