"""Provenance of a result: plans, versions, time and machine, and the program that solved it.

Of the program the commit of its sources, compiler and flags, the compiled kernel, and a digest of all.
"""

import platform
import subprocess
from datetime import UTC, datetime
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

import pyworm


def provenance(plans: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """Provenance of solutions: the plan of each by its task's key, in their order; for JSON."""
    return where_and_when() | {"plans": list(plans.values()), "keys": list(plans)}


def where_and_when() -> dict[str, str]:
    """Versions, commit, compiler, kernel, time and machine."""
    return {
        "pyworm": pyworm.__version__,
        "python": platform.python_version(),
        "numpy": np.__version__,
        **origin(),
        "machine": platform.machine(),
        "created": datetime.now(UTC).isoformat(timespec="seconds"),
    }


@cache
def program_digest() -> str:
    """Digest of all of pyworm that affects solutions, so that those of another program are not reused."""
    from pyworm.kernel.core import EXTENSION

    package = Path(pyworm.__file__).parent
    sources = {
        path.relative_to(package).as_posix(): path
        for path in package.rglob("*")
        if path.is_file() and path.suffix in _DECIDING and "plots" not in path.parts
    }
    sources["_core"] = EXTENSION
    digest = sha256()
    for name in sorted(sources):
        digest.update(name.encode() + sha256(sources[name].read_bytes()).digest())
    return digest.hexdigest()


_DECIDING = {".py", ".toml", ".json", ".csv", ".npz"}
"""Endings of files of the package that may decide a solution."""

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
