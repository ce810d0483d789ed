"""What benchmark programs call to write what they found: `record`."""

import os
import subprocess
import sys
from collections.abc import Iterable, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

from evidence_data import ROOT, DataFile, Origin, path_of, read, save
from evidence_pages import markdown, write_tables

PROGRAM = "pyworm", "fortran", "benchmarks", "tests", "cases"
"""Directories whose uncommitted changes make a commit an incomplete statement."""


def record(
    name: str,
    columns: Sequence[str],
    rows: Iterable[Sequence[object]],
    key: Sequence[str] = (),
    first: str = "",
) -> None:
    """Write what this command found, print it, and write the tables of the pages anew.

    Args:
        name: Name of the data.
        columns: Titles of the columns, with units.
        rows: One value for each column.
        key: Columns that identify a row: rows of an earlier run with other values there are kept. Without
            them nothing is kept.
        first: Command that has to run first.
    """
    rows = [tuple(map(str, row)) for row in rows]
    places = [columns.index(title) for title in key]
    new = {tuple(row[place] for place in places) for row in rows}
    origin = Origin(
        " && ".join(filter(None, (first, command()))),
        commit(),
        machine(),
        datetime.now(UTC).date().isoformat(),
    )
    kept = []
    if key and path_of(name).exists():
        known = read(name)
        if known.columns != tuple(columns):
            raise ValueError(f"{path_of(name)} has other columns: {', '.join(known.columns)}")
        kept = [row for row in known.rows if tuple(row[place] for place in places) not in new]
        if kept:
            origin = _of_both(known.origin, origin)
    if "commit" in columns:
        origin = replace(origin, commit="of each row")
    save(name, DataFile(origin, tuple(columns), (*kept, *rows)))
    print(markdown(columns, rows), f"-> {path_of(name).relative_to(ROOT)}", sep="\n\n", flush=True)
    write_tables()


def _of_both(known: Origin, new: Origin) -> Origin:
    """Origin of rows of which some were known; the command is that of all of them."""
    both = {
        name: old if (old := getattr(known, name)).endswith(of) else f"{old}, {of}"
        for name in ("commit", "machine", "date")
        if (of := getattr(new, name))
    }
    return replace(known, **both)


def command() -> str:
    """The command that runs, as typed in the repository's root."""
    program = Path(sys.argv[0]).resolve()
    if program.name == "__main__.py":
        program = program.parent
    return " ".join(["python", os.path.relpath(program, ROOT), *sys.argv[1:]])


def commit() -> str:
    """Commit of the program, with a word on changes since."""
    head = _git("rev-parse", "--short=8", "HEAD")
    return head + (" with changes" if _git("status", "--porcelain", "--", *PROGRAM) else "")


def machine() -> str:
    """Processor, and number of cores."""
    known = Path("/proc/cpuinfo")
    lines = known.read_text().splitlines() if known.exists() else []
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return f"{models[0] if models else 'processor not known'}, {os.cpu_count()} cores"


def _git(*words: str) -> str:
    done = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=True)
    return done.stdout.strip()
