"""Results appear whole or not at all."""

import os
import re
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from pyworm.case_error import CaseError


def check_writable(directory: Path) -> None:
    """Refuse a directory that results could not be written to, before any time is spent on them.

    Raises
    ------
    CaseError
        It is a file, or it or its nearest existing parent cannot be written to.
    """
    existing = next(path for path in (directory, *directory.absolute().parents) if path.exists())
    if not existing.is_dir():
        raise CaseError(f"{existing}: is a file, results need a directory")
    if not os.access(existing, os.W_OK | os.X_OK):
        raise CaseError(f"{existing}: no permission to write there")


PARTIAL = re.compile(r"\.(.+)\.\d+\.part")
"""Name of a file while it is written, its own name within."""


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """Write a file aside and move it into its place, whole or not at all.

    Yields
    ------
    Path
        What to write, in the same directory.
    """
    partial = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        yield partial
        os.replace(partial, path)
    finally:
        partial.unlink(missing_ok=True)


@contextmanager
def whole(directory: Path, instead_of: Sequence[str] = ()) -> Iterator[Path]:
    """Collect files aside and move them into a directory once all are written.

    Files of the same name from an earlier run are replaced; others are left alone.

    Parameters
    ----------
    directory : Path
        Where the files are to appear; made if need be.
    instead_of : sequence of str
        Patterns of files from an earlier run that go when these appear.

    Yields
    ------
    Path
        An empty directory beside it to write into.
    """
    directory = directory.absolute()
    directory.parent.mkdir(parents=True, exist_ok=True)
    # On the same file system, so that moving is renaming.
    aside = Path(tempfile.mkdtemp(prefix=f".{directory.name}-", dir=directory.parent))
    try:
        yield aside
        directory.mkdir(exist_ok=True)
        for pattern in instead_of:
            for old in directory.glob(pattern):
                old.unlink()
        for file in aside.iterdir():
            file.replace(directory / file.name)
    finally:
        shutil.rmtree(aside, ignore_errors=True)
