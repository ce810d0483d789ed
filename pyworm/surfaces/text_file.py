"""Text files of heights: lines of a header, then rows of numbers or a list of points x, y, z."""

import codecs
import re
from dataclasses import dataclass
from io import StringIO
from pathlib import Path

import numpy as np

from pyworm.surfaces.text_header import Header, read_header

Array = np.ndarray

MISSING = (
    "", "nan", "-nan", "bad", "na", "n/a", "-", "--", "---", "*", "**", "***", "inf", "-inf", "none", "null",
    "invalid", "missing", "-nan(ind)", "1.#qnan", "1.#ind", "-1.#ind",
)  # fmt: skip
"""What stands for a point that was not measured, in small letters."""

SHOWN_CHARACTERS = 30
"""Characters of a wrong entry that a sentence shows."""

HEADER_LINES = 1000
"""Most lines before the first number."""

_COMMENT = ("#", "%", "//")
_DECIMAL_COMMA = re.compile(r"[-+]?\d*,\d+(?:[eE][-+]?\d+)?")


@dataclass(frozen=True)
class TextHeights:
    """Numbers of a text file as they stand there."""

    numbers: Array
    """Rows and columns, NaN where points are missing."""
    header: Header
    """What the lines before them say."""


def read_text(path: Path) -> TextHeights:
    """Numbers of a text and its header; ValueError without rows of numbers of one length."""
    lines = _decoded(path.read_bytes()).splitlines()
    start, separator = _first_row(lines)
    header = read_header(lines[:start])
    _require_single(lines, start)
    rows = [line for line in lines[start:] if line.strip() and not _comment(line)]
    if separator != "," and "," in rows[0]:
        rows = [row.replace(",", ".") for row in rows]
    return TextHeights(_numbers(rows, separator, lines, start), header)


def _decoded(content: bytes) -> str:
    """The text of a file; programs of instruments write UTF-8, UTF-16 with its mark, or Latin 1."""
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return content.decode("utf-16", errors="replace")
    if b"\0" in content:
        raise ValueError("cannot be read as rows of numbers (it is no text)")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def _require_single(lines: list[str], start: int) -> None:
    """Refuse a second header among the numbers: another channel would be taken for more of the same area."""
    said = [n for n in range(start, len(lines)) if _comment(lines[n]) and ":" in lines[n]]
    if said and any(line.strip() and not _comment(line) for line in lines[said[0] :]):
        raise ValueError(f"has another header in line {said[0] + 1}; give a file of one channel")


def _comment(line: str) -> bool:
    return line.lstrip().startswith(_COMMENT)


def _first_row(lines: list[str]) -> tuple[int, str | None]:
    """Number of the first line of numbers, and the separator of its entries, None for blanks.

    A line of another length than the next one, such as a count of points, still belongs to the header.
    """
    full = [(n, line) for n, line in enumerate(lines[: HEADER_LINES + 2]) if line.strip()]
    for k, (n, line) in enumerate(full):
        separator = _separator(line)
        count = _count(line, separator)
        following = full[k + 1][1] if k + 1 < len(full) else line
        if count and count == _count(following, separator):
            _require_words(full[:k], separator, count)
            return n, separator
    raise ValueError("cannot be read as rows of numbers (no line has numbers alone)")


def _require_words(above: list[tuple[int, str]], separator: str | None, count: int) -> None:
    """Refuse a row of numbers with something else among them that would count as a line of the header."""
    for n, line in above:
        entries = _entries(line, separator)
        wrong = [entry for entry in entries if not _number(entry)]
        if not _comment(line) and len(entries) >= count > 3 and 2 * len(wrong) < len(entries):
            if wrong:
                raise _no_number(n, wrong[0])
            raise ValueError(
                f"cannot be read as rows of numbers (line {n + 1} has {len(entries)} entries, the next "
                f"{count})"
            )


def _no_number(line: int, entry: str) -> ValueError:
    return ValueError(
        f'cannot be read as rows of numbers (line {line + 1} has "{entry[:SHOWN_CHARACTERS]}", which is none)'
    )


def _separator(line: str) -> str | None:
    """What separates the entries of a line, None for blanks."""
    if ";" in line:
        return ";"
    entries = line.split()
    commas = "," in line and not all(_DECIMAL_COMMA.fullmatch(entry) for entry in entries)
    if commas:
        return ","
    return "\t" if "\t\t" in line.strip() else None


def _entries(line: str, separator: str | None) -> list[str]:
    """Entries of a line; one after the last separator counts only if something stands there."""
    if separator is None:
        return line.split()
    entries = [entry.strip() for entry in line.split(separator)]
    return entries[:-1] if len(entries) > 1 and not entries[-1] else entries


def _count(line: str, separator: str | None) -> int:
    """Number of entries of a line of numbers; zero of any other."""
    entries = _entries(line, separator)
    if _comment(line) or all(_missing(entry) for entry in entries):
        return 0
    try:
        for entry in entries:
            _value(entry.replace(",", "."))
    except ValueError:
        return 0
    return len(entries)


def _missing(entry: str) -> bool:
    return entry.lower() in MISSING


def _value(entry: str) -> float:
    return np.nan if _missing(entry) else float(entry)


def _numbers(rows: list[str], separator: str | None, lines: list[str], start: int) -> Array:
    """Rows as an array; by numpy at once, or where that stumbles entry by entry with the line of a fault."""
    try:
        return np.loadtxt(StringIO("\n".join(rows)), delimiter=separator, comments=None, ndmin=2)
    except ValueError:
        pass
    numbers: list[list[float]] = []
    where = [n for n in range(start, len(lines)) if lines[n].strip() and not _comment(lines[n])]
    for n, row in zip(where, rows, strict=True):
        entries = _entries(row, separator)
        if numbers and len(entries) != len(numbers[0]):
            raise ValueError(
                f"cannot be read as rows of numbers (line {n + 1} has {len(entries)} entries, those before "
                f"{len(numbers[0])}; it may be cut short)"
            )
        try:
            numbers.append([_value(entry) for entry in entries])
        except ValueError:
            raise _no_number(n, next(entry for entry in entries if not _number(entry))) from None
    return np.array(numbers)


def _number(entry: str) -> bool:
    try:
        _value(entry)
    except ValueError:
        return False
    return True
