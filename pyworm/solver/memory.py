"""Memory of a film on a grid, estimated before it is allocated.

Linux grants more memory than there is and kills the process that then uses it.
"""

from math import floor, sqrt

from pyworm.io.free_memory import available
from pyworm.kernel.core import NO_MEMORY, KernelError
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.model import Model

NUMBER_BYTES = 8
"""Bytes of a number."""

FILM_ARRAYS = 51
"""Number of arrays of the grid's size that a film needs, with the dry contact at the end."""

SHEAR_ARRAYS, SHEAR_ARRAYS_A_LEVEL = 20, 3
"""Further arrays of a flow law, and for each level."""

HEAT_ARRAYS, HEAT_ARRAYS_A_LEVEL = 50, 5
"""Further arrays of heat, and for each level. All counts were measured on 513 x 513 nodes with 0, 5, 7 and 11
levels, within 6 %; 1025 x 1025 nodes without levels need as many."""

ROUGH_ARRAYS = 24
"""Further arrays of roughness, measured on 577 x 641 nodes with heat and 5 levels."""

MEMORY_SAFETY_FACTOR = 1.1
"""Safety factor of the estimate, for the prolongation of the grid before and fragmentation."""


class NoMemoryError(KernelError):
    """A grid does not fit into memory; the message names it and the largest that fits."""

    def __init__(self, message: str):
        RuntimeError.__init__(self, message)
        self.status = NO_MEMORY


def needed(nodes: int, model: Model, stores: bool = False) -> float:
    """Memory of a film on so many nodes [bytes], whose oil `stores` heat if it is in motion."""
    arrays = FILM_ARRAYS
    if model.levels:
        arrays += SHEAR_ARRAYS + SHEAR_ARRAYS_A_LEVEL * model.levels
    if model.heated:
        arrays += HEAT_ARRAYS + HEAT_ARRAYS_A_LEVEL * model.levels
        arrays += (
            2 * (1 + model.levels) * stores
        )  # rates of pressure and temperature, in the order of two sweeps
    if model.rough:
        arrays += ROUGH_ARRAYS
    return MEMORY_SAFETY_FACTOR * NUMBER_BYTES * arrays * nodes


def shortage(grid: Grid | LineGrid, model: Model, stores: bool = False) -> str | None:
    """Message about a grid that does not fit into memory; None if it does."""
    wanted, free = needed(grid.nodes, model, stores), available()
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
