"""Atomic writing: files and directories appear complete or not at all.

A file being written lies in its final directory under a temporary name, `.NAME.TOKEN.part`,
and its writer holds a lock on it. Such a thing that nobody holds was left by a process that was killed.
"""

import os
import re
import shutil
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from errno import ENOENT
from fcntl import LOCK_EX, LOCK_NB, flock
from pathlib import Path
from secrets import token_hex

from pyworm.io.input_error import CaseError


class NotWrittenError(OSError):
    """A file or directory that cannot be written, such as on a full disk."""

    def __str__(self) -> str:
        return f"{self.filename}: cannot be written ({self.strerror})"


def check_writable(directory: Path) -> None:
    """Refuse a directory without permission to write, or a file, before anything is solved; CaseError."""
    existing = next(path for path in (directory, *directory.absolute().parents) if path.exists())
    if not existing.is_dir():
        raise CaseError(f"{existing}: is a file, results need a directory")
    if not os.access(existing, os.W_OK | os.X_OK):
        raise CaseError(f"{existing}: no permission to write there")


MAX_ATTEMPTS = 100
"""Maximum number of attempts to make a file that other processes may remove at the same moment."""

_PARTIAL = re.compile(r"\..+\.[0-9a-f]{8}\.part")
"""Name of what is being written."""


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """Write a file under a temporary name and rename it: complete or absent, even if power fails.

    Yields the empty file to write, in the same directory, which is made if need be. NotWrittenError.
    """
    with _named(path):
        partial, handle = _held(path.parent, path.name, _new_file)
        try:
            yield partial
            os.fsync(handle)
            os.replace(partial, path)
        finally:
            partial.unlink(missing_ok=True)
            os.close(handle)


@contextmanager
def atomic_directory(directory: Path, instead_of: Sequence[str] = ()) -> Iterator[Path]:
    """Write files into a temporary directory, which is yielded, and move them once all are complete.

    Files of the same name from an earlier run, and those of the patterns `instead_of`, are replaced; what
    killed processes left half written goes; others are left alone. The empty directory lies in the other one,
    whose own parent may be closed to writing. NotWrittenError if the files cannot be written.
    """
    directory = directory.absolute()
    existed = directory.exists()
    remove_abandoned(directory)
    with _named(directory):
        aside, handle = _held(directory, "files", _new_directory)
        try:
            yield aside
            _move(aside, directory, instead_of)
        finally:
            shutil.rmtree(aside, ignore_errors=True)
            os.close(handle)
            if not existed:
                with suppress(OSError):  # files have appeared
                    directory.rmdir()


def _move(aside: Path, directory: Path, instead_of: Sequence[str]) -> None:
    """Move the files of a directory into another, in place of those of an earlier run."""
    written = list(aside.iterdir())
    for file in written:
        _to_disk(file)
    for pattern in instead_of:
        for old in directory.glob(pattern):
            old.unlink(missing_ok=True)  # another run may be at the same
    for file in written:
        os.replace(file, directory / file.name)


@contextmanager
def _named(path: Path) -> Iterator[None]:
    """Turn a failure to write into one that names the file itself, not its temporary name."""
    try:
        yield
    except OSError as error:
        raise NotWrittenError(error.errno, error.strerror or str(error), str(path)) from error


def remove_abandoned(directory: Path) -> None:
    """Remove the partial files of killed processes from a directory, if it exists.

    On file systems without locks abandoned files are not recognised and remain.
    """
    for path in directory.glob(".*.part"):
        if _PARTIAL.fullmatch(path.name):
            with suppress(OSError):
                _remove_unless_held(path)


def _remove_unless_held(path: Path) -> None:
    handle = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_NOFOLLOW)
    try:
        flock(handle, LOCK_EX | LOCK_NB)
        if path.is_dir():
            shutil.rmtree(path)
        else:
            path.unlink()
    finally:
        os.close(handle)


def _held(directory: Path, name: str, make: Callable[[Path], int]) -> tuple[Path, int]:
    """A new file or directory, and the handle that locks it until closed; OSError if there can be none."""
    refusal = FileNotFoundError(ENOENT, "other processes keep removing what is written there")
    for _ in range(MAX_ATTEMPTS):
        partial = directory / f".{name}.{token_hex(4)}.part"
        directory.mkdir(parents=True, exist_ok=True)
        try:
            handle = make(partial)
        except FileNotFoundError as error:  # another run has just removed it, or the directory
            refusal = error
            continue
        with suppress(OSError):  # a file system without locks
            flock(handle, LOCK_EX)
        if partial.exists():
            return partial, handle
        os.close(handle)  # taken for abandoned before it was locked
    raise refusal


def _new_file(path: Path) -> int:
    return os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666)


def _new_directory(path: Path) -> int:
    path.mkdir()
    return os.open(path, os.O_RDONLY)


def _to_disk(file: Path) -> None:
    handle = os.open(file, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
