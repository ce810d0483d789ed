"""Provenance of a result: plans, versions, time and machine; the digest of the program that solved it."""

import platform
from datetime import UTC, datetime
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

import pyworm
from pyworm.batch.origin import origin


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
