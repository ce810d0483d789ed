"""Tables on the pages of the evidence, written from the data files.

A page has, in a line of its own, a comment that names the data, and one that ends the table:

    <!-- table: NAME; columns: a, b; where: kind = worm; by: c -->
    <!-- end -->

All but the name may be left out: `columns` shows some columns, `where` some rows, and `by` one row for each
value of a column, with the others gathered: `columns: a count, b range` (`GATHERED`). From the repository's
root

    python benchmarks/evidence/evidence_pages.py

writes all tables anew. Programs that record data do so, too.
"""

import re
from collections.abc import Callable, Iterable, Sequence
from statistics import median

from evidence_data import DATA, ROOT, DataFile, path_of, read

PAGES = ROOT / "docs/evidence"

TABLE = re.compile(r"<!-- table: (.*?) -->\n.*?<!-- end -->", re.DOTALL)
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
NOT_RECORDED = "not recorded"


def _number(text: str) -> float:
    """The number that a text begins with."""
    found = NUMBER.match(text)
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
}
"""How the values of some rows become one. Empty ones do not count; a number is what a text begins with."""


def markdown(columns: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table."""
    lines = [columns, ["---"] * len(columns), *rows]
    return "\n".join(
        "| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines
    )


def table(words: str) -> str:
    """The table that a comment asks for, with the command above it and its origin below."""
    name, *rest = (part.strip() for part in words.split(";"))
    options = dict(part.split(": ", 1) for part in rest)
    if strange := options.keys() - {"columns", "where", "by"}:
        raise ValueError(f"{name}: {', '.join(strange)}")
    data = read(name)
    if "where" in options:
        title, value = options["where"].split(" = ")
        place = data.columns.index(title)
        data = DataFile(
            data.origin, data.columns, tuple(row for row in data.rows if row[place] == value)
        )
    shown = options["columns"].split(", ") if "columns" in options else list(data.columns)
    found = _gathered(data, options["by"], shown) if "by" in options else _selected(data, shown)
    command = data.origin.command
    above = [f"`{command}`"] if command not in ("", NOT_RECORDED) else []
    return "\n\n".join([*above, found, _foot(name, data)])


def _selected(data: DataFile, titles: Sequence[str]) -> str:
    places = [data.columns.index(title) for title in titles]
    return markdown(titles, ([row[place] for place in places] for row in data.rows))


def _gathered(data: DataFile, by: str, wanted: Sequence[str]) -> str:
    """One row for each value of a column."""
    key = data.columns.index(by)
    ways = [words.rsplit(" ", 1) for words in wanted]
    rows = []
    for value in dict.fromkeys(row[key] for row in data.rows):
        some = [row for row in data.rows if row[key] == value]
        cells = []
        for title, way in ways:
            texts = [row[data.columns.index(title)] for row in some]
            known = [text for text in texts if text]
            cells.append(GATHERED[way](known) if known else "")
        rows.append([value, *cells])
    heads = [title if way in ("sum", "values") else f"{title}: {way}" for title, way in ways]
    return markdown([by, *heads], rows)


def _foot(name: str, data: DataFile) -> str:
    """One line with the commit, the machine and the date, and the file."""
    origin = data.origin
    parts = [f"commit {origin.commit}" if origin.commit else "", origin.machine, origin.date]
    link = f"[data]({path_of(name).relative_to(PAGES).as_posix()})"
    return "*" + "; ".join([*(part for part in parts if part), link]) + "*"


def with_tables(page: str) -> str:
    """A page with its tables as the data have them."""
    return TABLE.sub(
        lambda found: f"<!-- table: {found[1]} -->\n\n{table(found[1])}\n\n<!-- end -->", page
    )


def names_on(page: str) -> set[str]:
    """Names of the data that a page shows."""
    return {found[1].split(";")[0].strip() for found in TABLE.finditer(page)}


def write_tables() -> None:
    """Write the tables of all pages anew."""
    for path in sorted(PAGES.glob("*.md")):
        page = path.read_text()
        if (written := with_tables(page)) != page:
            path.write_text(written)
            print(f"{path.relative_to(ROOT)} is written anew")


def unused() -> set[str]:
    """Names of data that no page shows."""
    shown = set().union(*(names_on(path.read_text()) for path in PAGES.glob("*.md")))
    return {path.stem for path in DATA.glob("*.csv")} - shown


if __name__ == "__main__":
    write_tables()
