"""Procedures of the kernel: what belongs together is a derived type, and none is longer than a page."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from folders import ROOT

KERNEL = ROOT / "fortran"

OTHER_LANGUAGES = {"pyworm_contact_c.f90", "lapack.f90", "fftw.f90"}
"""Files whose procedures are called from C, or are LAPACK's or FFTW's: they take numbers and arrays alone."""

MAX_ARGUMENTS = 10
"""Arguments of a procedure."""

MAX_LINES = 60
"""Lines of a procedure, without those of the procedures that it contains."""

HEADING = re.compile(
    r"^(?!\s*end\s)(?:[^!'\"]*\s)?(?:subroutine|function)\s+(\w+)\s*(?:\(([^)]*)\))?"
)
"""First line of a procedure, continuation lines joined."""


class Procedure(NamedTuple):
    """One procedure of a file."""

    name: str
    """File and name."""
    arguments: int
    """Number of dummy arguments."""
    lines: int
    """Number of its own lines."""


def _joined(lines: list[str], first: int) -> str:
    """A statement with its continuation lines."""
    statement = lines[first].rstrip()
    while statement.endswith("&"):
        first += 1
        statement = statement[:-1] + lines[first].strip()
    return statement


def procedures(file: Path) -> Iterator[Procedure]:
    """All procedures of a file, contained ones and those of interfaces too."""
    lines = file.read_text(encoding="utf-8").splitlines()
    open_ones: list[tuple[str, int, int]] = []
    for number, line in enumerate(lines):
        if heading := HEADING.match(_joined(lines, number)):
            arguments = [name for name in (heading[2] or "").split(",") if name.strip()]
            open_ones.append((f"{file.relative_to(KERNEL)}: {heading[1]}", len(arguments), 1))
        elif open_ones:
            name, count, own_lines = open_ones.pop()
            open_ones.append((name, count, own_lines + 1))
        if re.match(r"\s*end (subroutine|function)\b", line):
            yield Procedure(*open_ones.pop())
    assert not open_ones, file


def own_procedures() -> list[Procedure]:
    """All procedures of the kernel that only Fortran calls."""
    return [
        procedure
        for file in sorted(KERNEL.rglob("*.f90"))
        if file.name not in OTHER_LANGUAGES
        for procedure in procedures(file)
    ]


def test_no_procedure_takes_more_than_ten_arguments():
    found = own_procedures()
    assert len(found) > 400
    assert not [one for one in found if one.arguments > MAX_ARGUMENTS]


def test_no_procedure_is_longer_than_a_page():
    assert not [one for one in own_procedures() if one.lines > MAX_LINES]


def test_arguments_and_lines_are_counted(tmp_path, monkeypatch):
    (tmp_path / "counted.f90").write_text(
        "pure real(wp) function area(a, &\n    b) result(c)\n  !> a function in words\n  c = a*b\ncontains\n"
        "  subroutine none()\n  end subroutine none\nend function area\n"
    )
    monkeypatch.setitem(globals(), "KERNEL", tmp_path)
    assert list(procedures(tmp_path / "counted.f90")) == [
        ("counted.f90: none", 0, 2),
        ("counted.f90: area", 2, 6),
    ]
