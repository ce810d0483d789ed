"""Origin of the program: commit of the sources, compiler and flags, compiled kernel."""

import subprocess
from functools import cache
from hashlib import sha256
from pathlib import Path

import pyworm

DIGITS = 24
"""Hexadecimal digits of the kernel's digest."""

_PATIENCE = 5.0
"""Time that git may take [s]."""


@cache
def origin() -> dict[str, str]:
    """Commit, compiler, its flags and digest of the kernel; no commit where it is not known."""
    from pyworm.kernel.core import compiled_with

    compiler, flags = compiled_with()
    known = {"compiler": compiler, "compiler_flags": flags, "kernel_digest": kernel_digest()}
    commit = _commit()
    return known if commit is None else {"commit": commit, **known}


def kernel_digest() -> str:
    """Digest of the compiled kernel."""
    from pyworm.kernel.core import EXTENSION

    return sha256(EXTENSION.read_bytes()).hexdigest()[:DIGITS]


def _commit() -> str | None:
    """Commit of the sources that run, marked where they were changed since; None of an installed package."""
    root = Path(pyworm.__file__).parents[1]
    if not (root / ".git").exists():
        return None
    said = _git(root, "rev-parse", "HEAD")
    changed = _git(root, "status", "--porcelain", "--untracked-files=no")
    return f"{said}, changed since" if said and changed else said


def _git(root: Path, *command: str) -> str | None:
    """Output of a git command on the sources; None where it fails."""
    try:
        done = subprocess.run(
            ["git", "-C", root, *command], capture_output=True, text=True, timeout=_PATIENCE
        )
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout.strip() if done.returncode == 0 else None
