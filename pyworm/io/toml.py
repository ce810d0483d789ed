"""Reading TOML files, in spite of wrong encodings, sizes and types of files."""

import codecs
import json
import re
import stat
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pyworm.io.bounded_number import fault_of
from pyworm.io.input_error import CaseError, dotted, shortened, toml

MAX_FILE_BYTES = 2**20
"""Bytes of the largest file that is read: what people write has a hundredth of it."""


MAX_KEY_DOTS = 100
"""Dots of the longest key that is read; the time that Python's reader takes grows with their square."""

_KEYS_END = re.compile(r"[=,{}\[\]\n]")


def read_toml(path: Path) -> dict[str, Any]:
    """The content of a TOML file, with or without a byte-order mark.

    CaseError: the file cannot be read, is no TOML, or holds a number that is not finite or too large.
    """
    content = _parsed(path)
    try:
        _require_bounded(content, [])
    except ValueError as error:
        raise CaseError(f"{path}: {error}") from None
    return content


def toml_text(content: Mapping[str, Any], table: str = "") -> str:
    """The text of a TOML file with some content: tables by name, texts, numbers, and lists of them."""
    rows = {key: value for key, value in content.items() if not isinstance(value, Mapping)}
    lines = [f"{key} = {json.dumps(value, ensure_ascii=False)}" for key, value in rows.items()]
    text = "\n".join([f"[{table}]", *lines] if table and lines else lines)
    below = [
        toml_text(value, f"{table}.{key}".lstrip("."))
        for key, value in content.items()
        if isinstance(value, Mapping)
    ]
    return "\n\n".join(filter(None, [text, *(part.rstrip("\n") for part in below)])) + "\n"


def _require_bounded(value: object, keys: list[str | int]) -> None:
    """Refuse a value of a file, or one in it, that is a number out of bounds; ValueError names its key."""
    if isinstance(value, dict | list):
        entries = value.items() if isinstance(value, dict) else enumerate(value)
        for key, entry in entries:
            _require_bounded(entry, [*keys, key])
    elif (fault := fault_of(value)) is not None:
        raise ValueError(f"{shortened(dotted(keys))} = {shortened(toml(value))}: {fault}")


def _parsed(path: Path) -> dict[str, Any]:
    text = _text(path)
    if max(part.count(".") for part in _KEYS_END.split(text)) > MAX_KEY_DOTS:
        raise CaseError(f"{path}: not a TOML file: too many tables within each other")
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise CaseError(f"{path}: not a TOML file: {error}") from None
    except RecursionError:
        raise CaseError(f"{path}: not a TOML file: too many brackets within each other") from None
    except ValueError:  # the one thing more that Python's reader refuses
        raise CaseError(f"{path}: not a TOML file: a number of too many digits") from None


def _text(path: Path) -> str:
    content = _content(path).removeprefix(codecs.BOM_UTF8)
    try:
        return content.decode()
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise CaseError(
            f"{path}: is not in UTF-8 (line {line} has the byte {content[error.start]:#x}, as in Latin-1 or "
            "UTF-16); save it as UTF-8"
        ) from None


def _content(path: Path) -> bytes:
    """The bytes of a file; a path that is no file, or a file too large for a case, is not opened."""
    try:
        about = path.stat()
        if stat.S_ISREG(about.st_mode) and about.st_size <= MAX_FILE_BYTES:
            return path.read_bytes()
    except FileNotFoundError:
        raise CaseError(f"{path}: no such file") from None
    except (OSError, ValueError) as error:
        raise CaseError(f"{path}: cannot be read ({error})") from None
    if not stat.S_ISREG(about.st_mode):
        raise CaseError(f"{path}: is no file but a {_kind(about.st_mode)}")
    raise CaseError(
        f"{path}: has {about.st_size / 1e6:.1f} MB, a case file has {MAX_FILE_BYTES / 1e6:.1f} MB at most"
    )


def _kind(mode: int) -> str:
    """The type of a path that is no regular file, for a message."""
    if stat.S_ISDIR(mode):
        return "directory"
    return "pipe" if stat.S_ISFIFO(mode) else "device or socket"
