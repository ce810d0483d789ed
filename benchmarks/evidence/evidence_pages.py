"""Tables on the pages of the evidence, written from the data files.

A page has, in a line of its own, a comment that names a table, and one that ends it:

    <!-- table: NAME -->
    <!-- end -->

A table shows the data of its name, unless `tables.toml` says how: which `data`, which `columns`, rows `where`
columns have some values, or one row for each value of a column (`by`), with the others gathered (`GATHERED`).
From the repository's root

    python benchmarks/evidence/evidence_pages.py

writes all tables anew. Programs that record data do so, too.
"""

import re
import tomllib
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from pathlib import Path
from statistics import median

from evidence_data import ROOT, DataFile, path_of, read

PAGES = ROOT / "docs/evidence"
TABLES = tomllib.loads(Path(__file__).with_name("tables.toml").read_text())

TABLE = re.compile(r"<!-- table: (.*?) -->\n.*?<!-- end -->", re.DOTALL)
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
NOT_RECORDED = "not recorded"

UNITS = {"um": "µm", "urad": "µrad", "degC": "°C", "degF": "°F"}
"""How pages write units of data."""
UNIT = re.compile(rf"\b(?:{'|'.join(UNITS)})\b")


def _number(text: str) -> float:
    """The first number of a text."""
    found = NUMBER.search(text)
    if found is None:
        raise ValueError(f"{text!r} has no number")
    return float(found[0])


def _range(texts: Sequence[str]) -> str:
    low, high = min(texts, key=_number), max(texts, key=_number)
    return low if low == high else f"{low} to {high}"


GATHERED: dict[str, Callable[[Sequence[str]], str]] = {
    "count": lambda texts: str(len(texts)),
    "sum": lambda texts: f"{sum(map(_number, texts)):g}",
    "range": _range,
    "largest": lambda texts: max(texts, key=_number),
    "smallest": lambda texts: min(texts, key=_number),
    "median": lambda texts: f"{median(map(_number, texts)):.3g}",
    "values": lambda texts: ", ".join(dict.fromkeys(texts)),
    "counts": lambda texts: ", ".join(f"{n} {text}" for text, n in Counter(texts).items()),
}
"""How the values of some rows become one. Empty ones do not count; the number of a text is its first."""


def markdown(columns: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table."""
    lines = ["|---" * len(columns) + "|"]
    for cells in (columns, *rows):
        shown = (re.sub(UNIT, lambda unit: UNITS[unit[0]], cell) for cell in cells)
        lines.append("|" + " |".join(cell.replace("|", "\\|") for cell in shown) + " |")
    return "\n".join([lines[1], lines[0], *lines[2:]])


def table(name: str) -> str:
    """A table of a page, with the command above it and the origin of its data below."""
    view = TABLES.get(name, {})
    source = view.get("data", name)
    data = read(source)
    for title, wanted in view.get("where", {}).items():
        place, values = data.columns.index(title), [wanted] if isinstance(wanted, str) else wanted
        rows = tuple(row for row in data.rows if row[place] in values)
        data = DataFile(data.origin, data.columns, rows)
    shown = view.get("columns", data.columns)
    found = _gathered(data, view["by"], shown) if "by" in view else _selected(data, shown)
    command = data.origin.command
    above = [_as_code(command)] if command not in ("", NOT_RECORDED) else []
    return "\n\n".join([*above, found, _foot(source, data)])


def _selected(data: DataFile, shown: Sequence[str]) -> str:
    """Some columns; "title -> head" shows one under another head."""
    titles, heads = zip(*(_with_head(words) for words in shown), strict=True)
    places = [data.columns.index(title) for title in titles]
    shapes = [_as_code if title == "command" else str for title in titles]
    return markdown(
        heads,
        (
            [shape(row[place]) for place, shape in zip(places, shapes, strict=True)]
            for row in data.rows
        ),
    )


def _as_code(command: str) -> str:
    """A command, or several that follow each other."""
    return ", then ".join(f"`{part}`" for part in command.split(" && "))


def _gathered(data: DataFile, by: str, shown: Sequence[str]) -> str:
    """One row for each value of a column; of the others "title way", or "title way -> head"."""
    key = data.columns.index(by)
    words, heads = zip(*(_with_head(each) for each in shown), strict=True)
    ways = [each.rsplit(" ", 1) for each in words]
    rows = []
    for value in dict.fromkeys(row[key] for row in data.rows):
        some = [row for row in data.rows if row[key] == value]
        cells = []
        for title, way in ways:
            texts = [row[data.columns.index(title)] for row in some]
            known = [text for text in texts if text]
            cells.append(GATHERED[way](known) if known else "")
        rows.append([value, *cells])
    return markdown([by, *heads], rows)


def _with_head(words: str) -> tuple[str, str]:
    """What a column shows, and its head."""
    what, arrow, head = words.partition(" -> ")
    return what, head if arrow else what


def _foot(name: str, data: DataFile) -> str:
    """One line with the commit, of times also the machine and the date as far as known, and the file."""
    origin = data.origin
    where = (origin.machine, origin.date) if name in _timed() else ()
    known = [text for text in where if text not in ("", NOT_RECORDED)]
    parts = [f"commit {origin.commit}"] if origin.commit else []
    link = f"[data]({path_of(name).relative_to(PAGES).as_posix()})"
    return "*" + "; ".join([*parts, *known, link]) + "*"


@cache
def _timed() -> frozenset[str]:
    """Names of the data whose commands measure time, which depends on the machine."""
    listed = read("commands")
    rows = (dict(zip(listed.columns, row, strict=True)) for row in listed.rows)
    return frozenset(
        name for row in rows if row["length"] == "timing" for name in row["data"].split()
    )


def with_tables(page: str) -> str:
    """A page with its tables as the data have them."""
    return TABLE.sub(
        lambda found: f"<!-- table: {found[1]} -->\n\n{table(found[1])}\n\n<!-- end -->", page
    )


def names_on(page: str) -> set[str]:
    """Names of the data that a page shows."""
    names = {found[1] for found in TABLE.finditer(page)}
    return {TABLES.get(name, {}).get("data", name) for name in names}


def write_tables() -> None:
    """Write the tables of all pages anew."""
    for path in sorted(PAGES.glob("*.md")):
        page = path.read_text()
        if (written := with_tables(page)) != page:
            path.write_text(written)
            print(f"{path.relative_to(ROOT)} is written anew")


if __name__ == "__main__":
    write_tables()
