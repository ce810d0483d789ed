"""The bibliography: sorted, without doubles, named somewhere, and every link to it arrives."""

import re
from itertools import chain
from pathlib import Path
from unicodedata import combining, normalize

from folders import ROOT

PAGE = ROOT / "docs/reference/bibliography.md"
ENTRY = re.compile(r'^- <a id="([\w-]+)"></a>\*\*(.+?)\.\*\* (.+)$', re.M)
"""Anchor, authors with the year or number of a standard, reference."""

LINK = re.compile(r"bibliography\.md#([\w-]+)")
NAMING = {"docs": "*.md", "pyworm": "*", "fortran": "*.f90", "cases": "*.toml"} | {
    "benchmarks": "*.py",
    "tests": "*",
}
"""Folders that name sources, and which files do."""


def _texts() -> dict[Path, str]:
    files = chain.from_iterable((ROOT / folder).rglob(name) for folder, name in NAMING.items())
    kinds = {".md", ".py", ".f90", ".toml"}
    named = (path for path in files if path.suffix in kinds and path != PAGE)
    return {path: path.read_text() for path in (ROOT / "README.md", *named)}


def test_every_line_of_the_lists_is_an_entry():
    lines = [line for line in PAGE.read_text().splitlines() if line.startswith("- ")]
    assert len(lines) == len(ENTRY.findall(PAGE.read_text()))


def test_entries_are_sorted_and_single():
    papers, standards = PAGE.read_text().split("## Standards")
    for part in (papers, standards):
        anchors = [anchor for anchor, _, _ in ENTRY.findall(part)]
        assert anchors == sorted(set(anchors))


def test_an_anchor_is_author_and_year():
    for anchor, head, _ in ENTRY.findall(PAGE.read_text().split("## Standards")[0]):
        year = re.search(r"\((\d{4}b?)\)", head)
        assert year is None or anchor.endswith(f"-{year[1]}"), anchor


def test_every_source_is_named_somewhere():
    texts = _texts()
    text, cited = plain("\n".join(texts.values())), set(LINK.findall("\n".join(texts.values())))
    for anchor, head, _ in ENTRY.findall(PAGE.read_text()):
        surname = re.split(r" [A-Z]\.| et al| \(", head)[0]
        spellings = plain(surname), plain(surname.replace("ü", "ue"))
        named = any(spelling in text for spelling in spellings)
        assert anchor in cited or named, f"nothing names {anchor}"


def plain(text: str) -> str:
    """A text without accents."""
    return "".join(of for of in normalize("NFKD", text) if not combining(of))


def test_links_to_the_bibliography_arrive():
    anchors = {anchor for anchor, _, _ in ENTRY.findall(PAGE.read_text())}
    for path, text in _texts().items():
        missing = set(LINK.findall(text)) - anchors
        assert not missing, f"{path.relative_to(ROOT)} cites {sorted(missing)}"
