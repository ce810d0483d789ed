"""How much memory this process may still allocate."""

import os
import resource
from pathlib import Path

_LIMITS = (
    (Path("/sys/fs/cgroup/memory.max"), Path("/sys/fs/cgroup/memory.current")),
    (
        Path("/sys/fs/cgroup/memory/memory.limit_in_bytes"),
        Path("/sys/fs/cgroup/memory/memory.usage_in_bytes"),
    ),
)
"""Files of the limit and the use of a container's memory, in both versions of Linux's control groups."""


def available() -> float:
    """Memory that this process may still allocate [bytes]; infinite where it is unknown."""
    known = [_machine(), *(_group(*files) for files in _LIMITS), _process()]
    return min((amount for amount in known if amount is not None), default=float("inf"))


def _machine() -> float | None:
    """Free memory of the machine [bytes]."""
    try:
        lines = Path("/proc/meminfo").read_text().splitlines()
    except OSError:
        return None
    return next((1024.0 * int(line.split()[1]) for line in lines if "MemAvailable" in line), None)


def _group(limit: Path, used: Path) -> float | None:
    """Free memory of a container [bytes]."""
    try:
        return float(int(limit.read_text()) - int(used.read_text()))
    except (OSError, ValueError):  # no such limit
        return None


def _process() -> float | None:
    """Free address space of this process [bytes]."""
    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    if limit == resource.RLIM_INFINITY:
        return None
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[0])
    except OSError:
        return float(limit)
    return float(limit - pages * os.sysconf("SC_PAGE_SIZE"))
