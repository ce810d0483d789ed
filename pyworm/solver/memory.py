"""How much memory a grid takes, told before it is asked for.

Linux promises memory that there is none of, and ends the process that then uses it.
"""

import os
import resource
from math import floor, sqrt
from pathlib import Path

from pyworm.kernel.core import NO_MEMORY, KernelError
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.model import Model

NUMBER = 8
"""Bytes of a number."""

FILM_ARRAYS = 51
"""Arrays of the grid's size that a film takes, its dry contact at the end included."""

SHEAR_ARRAYS, SHEAR_ARRAYS_A_LEVEL = 20, 3
"""What a flow law takes besides, and that for each level."""

HEAT_ARRAYS, HEAT_ARRAYS_A_LEVEL = 35, 4
"""What heat takes besides, and that for each level. All were counted on 513 x 513 nodes with 0, 5, 7 and 11
levels, and met those within 1 %; 1025 x 1025 without any took as many."""

MARGIN = 1.1
"""What is reckoned with beyond that: the grid before is prolonged, and memory has holes."""

_LIMITS = (
    (Path("/sys/fs/cgroup/memory.max"), Path("/sys/fs/cgroup/memory.current")),
    (
        Path("/sys/fs/cgroup/memory/memory.limit_in_bytes"),
        Path("/sys/fs/cgroup/memory/memory.usage_in_bytes"),
    ),
)
"""Files of a limit on a container's memory and of what is used of it, by either version of Linux's groups."""


class NoMemoryError(KernelError):
    """A grid will not fit into memory; the message says which, and the largest that fits."""

    def __init__(self, message: str):
        RuntimeError.__init__(self, message)
        self.status = NO_MEMORY


def needed(nodes: int, model: Model) -> float:
    """Memory of a film on so many nodes [bytes]."""
    arrays = FILM_ARRAYS
    if model.levels:
        arrays += SHEAR_ARRAYS + SHEAR_ARRAYS_A_LEVEL * model.levels
    if model.heated:
        arrays += HEAT_ARRAYS + HEAT_ARRAYS_A_LEVEL * model.levels
    return MARGIN * NUMBER * arrays * nodes


def available() -> float:
    """Memory that this process may still take [bytes]; infinite where nothing tells."""
    known = [_machine(), *(_group(*files) for files in _LIMITS), _process()]
    return min((of for of in known if of is not None), default=float("inf"))


def shortage(grid: Grid | LineGrid, model: Model) -> str | None:
    """What to say of a grid that will not fit into memory; None if it does."""
    wanted, free = needed(grid.nodes, model), available()
    if wanted <= free:
        return None
    largest = " x ".join(str(count) for count in _largest(grid, free / wanted))
    size = " x ".join(str(count) for count in grid.shape)
    return (
        f"{size} nodes take {wanted / 1e9:.2g} GB of memory and {free / 1e9:.2g} GB are free; "
        f"the largest such grid that fits has {largest}"
    )


def _largest(grid: Grid | LineGrid, fraction: float) -> tuple[int, ...]:
    """Counts of a grid of the same window with a fraction of the nodes."""
    by_side = fraction if len(grid.shape) == 1 else sqrt(fraction)
    return tuple(max(floor(count * by_side), 1) for count in grid.shape)


def _machine() -> float | None:
    """What the machine has left."""
    try:
        lines = Path("/proc/meminfo").read_text().splitlines()
    except OSError:
        return None
    return next((1024.0 * int(line.split()[1]) for line in lines if "MemAvailable" in line), None)


def _group(limit: Path, used: Path) -> float | None:
    """What a container has left."""
    try:
        return float(int(limit.read_text()) - int(used.read_text()))
    except (OSError, ValueError):  # no such limit
        return None


def _process() -> float | None:
    """What this process's address space may still grow by."""
    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    if limit == resource.RLIM_INFINITY:
        return None
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[0])
    except OSError:
        return float(limit)
    return float(limit - pages * os.sysconf("SC_PAGE_SIZE"))
