"""Output to the terminal: text is shown literally, never as control sequences.

Titles, paths and values come from files. Control characters in them are shown by their code, and what a
stream cannot write is spelled in letters that it can. A reader who goes away, or a stream that was never
open, costs neither the work nor its exit code.
"""

import os
import sys
import unicodedata
from contextlib import suppress
from typing import IO

_LETTERS = {
    "µ": "u", "μ": "u", "±": "+-", "°": "deg", "²": "^2", "³": "^3", "·": " ", "×": "x", "–": "-", "—": "-",
    "−": "-", "…": "...", "→": "->", "≤": "<=", "≥": ">=", "≈": "~", "∞": "inf", "’": "'", "‘": "'",
    "“": '"', "”": '"', "ß": "ss", "α": "alpha", "β": "beta", "η": "eta", "λ": "lambda", "ν": "nu",
    "τ": "tau",
}  # fmt: skip
"""What stands for a character where it cannot be written; for others, their letter without its accent."""

_SHOWN_BY_CODE = ("Cc", "Cf", "Cs", "Zl", "Zp")
"""Categories of characters that control a terminal instead of being shown."""


def prepare() -> None:
    """Open closed standard streams on the null device, so that no other file takes their descriptors."""
    for number in (0, 1, 2):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # the least number that is free
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w"))


def encoding_of(stream: IO[str]) -> str:
    """The encoding that a stream is to be written in.

    In the locale C Python writes UTF-8 all the same (PEP 538); whoever sets it reads ASCII.
    """
    locale = os.environ.get("LC_ALL") or os.environ.get("LANG")
    return "ascii" if locale in ("C", "POSIX") else getattr(stream, "encoding", None) or "utf-8"


def plain(text: str, stream: IO[str], lines: bool = True) -> str:
    """A text as a stream can show it, ends of lines left as they are unless not `lines`."""
    encoding = encoding_of(stream)
    return "".join(
        _plain(character, encoding) if character != "\n" or not lines else character
        for character in text
    )


def _plain(character: str, encoding: str) -> str:
    if " " <= character <= "~":
        return character
    if unicodedata.category(character) in _SHOWN_BY_CODE:
        return character.encode("unicode_escape").decode()
    with suppress(UnicodeEncodeError):
        character.encode(encoding)
        return character
    bare = unicodedata.normalize("NFKD", character).encode("ascii", "ignore").decode()
    return _LETTERS.get(character) or bare or "?"


def print_result(text: str) -> None:
    """Print a line, or lines, on standard output."""
    _write(sys.stdout, plain(text, sys.stdout))


def print_message(message: str) -> None:
    """Print one message of the program on standard error."""
    _write(sys.stderr, f"pyworm: {plain(message, sys.stderr, lines=False)}")


def _write(stream: IO[str], text: str) -> None:
    try:
        print(text, file=stream, flush=True)
    except BrokenPipeError:
        silence(stream)


def flush() -> None:
    """Flush standard output, if anyone reads it; OSError where it cannot be written."""
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        silence(sys.stdout)
    except OSError:
        silence(sys.stdout)
        raise


def silence(stream: IO[str]) -> None:
    """Redirect further output of a stream to the null device."""
    with suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)
