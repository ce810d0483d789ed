"""Uniform grids over the tangent plane, and nests of them around a contact."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, floor

import numpy as np

from pyworm.formulas.arrays import Array

CELLS_MULTIPLE = 8
"""Cells of every grid come in multiples of this, so that multigrid finds coarser grids."""

Box = tuple[float, float, float, float]
"""West, east, south and north side of a rectangle [m]."""


@dataclass(frozen=True)
class Grid:
    """A uniform grid of nodes."""

    west: float
    """Position of the first node along x [m]."""
    south: float
    """Position of the first node along y [m]."""
    dx: float
    """Spacing along x [m]."""
    dy: float
    """Spacing along y [m]."""
    nx: int
    """Number of nodes along x."""
    ny: int
    """Number of nodes along y."""

    @property
    def x(self) -> Array:
        """Positions of the nodes along x [m]."""
        return self.west + self.dx * np.arange(self.nx, dtype=np.float64)

    @property
    def y(self) -> Array:
        """Positions of the nodes along y [m]."""
        return self.south + self.dy * np.arange(self.ny, dtype=np.float64)

    @property
    def shape(self) -> tuple[int, int]:
        """Number of nodes along x and y."""
        return self.nx, self.ny

    @property
    def spacing(self) -> tuple[float, float]:
        """Spacing along x and y [m]."""
        return self.dx, self.dy

    @property
    def nodes(self) -> int:
        """Number of nodes."""
        return self.nx * self.ny

    @property
    def cell(self) -> float:
        """Area of a cell [m2]."""
        return self.dx * self.dy

    @property
    def box(self) -> Box:
        """The rectangle that it spans."""
        return self.west, float(self.x[-1]), self.south, float(self.y[-1])

    def mesh(self) -> tuple[Array, Array]:
        """Positions of all nodes, each (nx, ny) in Fortran order."""
        x, y = np.meshgrid(self.x, self.y)
        return x.T, y.T

    def place(self, node: Sequence[float]) -> tuple[float, float]:
        """Position of a node, or of a place between nodes, by its numbers along x and y [m]."""
        return self.west + self.dx * node[0], self.south + self.dy * node[1]

    def finer(self) -> "Grid":
        """The grid of half the spacing over the same rectangle."""
        return Grid(
            self.west, self.south, self.dx / 2, self.dy / 2, 2 * self.nx - 1, 2 * self.ny - 1
        )

    def coarser(self) -> "Grid":
        """The grid of twice the spacing over the same rectangle, up to a cell of it."""
        return Grid(
            self.west, self.south, 2 * self.dx, 2 * self.dy, self.nx // 2 + 1, self.ny // 2 + 1
        )

    def window_of(self, fine: "Grid") -> tuple[slice, slice]:
        """Index ranges of this grid's nodes that an aligned grid of half the spacing covers."""
        first_x = round((fine.west - self.west) / self.dx)
        first_y = round((fine.south - self.south) / self.dy)
        return (
            slice(first_x, first_x + (fine.nx + 1) // 2),
            slice(first_y, first_y + (fine.ny + 1) // 2),
        )

    def nodes_of(self, other: "Grid") -> tuple[slice, slice]:
        """Index ranges of this grid's nodes that an aligned grid of the same spacing has, too."""
        first_x = round((other.west - self.west) / self.dx)
        first_y = round((other.south - self.south) / self.dy)
        return _within(first_x, other.nx, self.nx), _within(first_y, other.ny, self.ny)

    def part(self, nodes: tuple[slice, slice]) -> "Grid":
        """The grid of some of its nodes."""
        x, y = self.x[nodes[0]], self.y[nodes[1]]
        return Grid(float(x[0]), float(y[0]), self.dx, self.dy, x.size, y.size)


def _within(first: int, count: int, nodes: int) -> slice:
    """The range of some nodes from a first one on, as far as there are such nodes."""
    return slice(max(first, 0), min(first + count, nodes))


def nest(inner: Box, outer: Box, dx: float, dy: float) -> tuple[Grid, ...]:
    """Grids, each of half the spacing and within the one before, from `outer` to one that spans `inner`.

    The origin is a node of all.
    """
    grids = [_spanning(inner, dx, dy)]
    while not _holds(grids[0], outer):
        last = grids[0]
        grids.insert(0, _spanning(_towards(last, outer), 2 * last.dx, 2 * last.dy))
    return tuple(grids)


def led_up_to(grid: Grid, coarser: int) -> tuple[Grid, ...]:
    """Grids over the same rectangle or a little more, of halving spacing, node on node, before a grid."""
    grids = [grid]
    for _ in range(coarser):
        grids.insert(0, _spanning(grids[0].box, 2 * grids[0].dx, 2 * grids[0].dy))
    return tuple(grids)


def _spanning(box: Box, dx: float, dy: float) -> Grid:
    """The smallest grid of a spacing that spans a rectangle."""
    west, cells_x = _span(box[0], box[1], dx)
    south, cells_y = _span(box[2], box[3], dy)
    return Grid(west * dx, south * dy, dx, dy, cells_x + 1, cells_y + 1)


def _span(low: float, high: float, step: float) -> tuple[int, int]:
    """First node and number of cells of a grid around an interval.

    First and last node are even, so that the grid of twice the spacing has them too, and the cells are a
    multiple of CELLS_MULTIPLE. What that adds goes to both sides alike, an odd pair of cells to the side
    nearer to the contact point: a contact that is turned round has its grid turned round.
    """
    first, last = 2 * floor(low / step / 2 + 1e-9), 2 * ceil(high / step / 2 - 1e-9)
    cells = CELLS_MULTIPLE * ceil((last - first) / CELLS_MULTIPLE)
    pairs = (cells - (last - first)) // 2
    nearer = pairs % 2 * (-first < last)
    return first - 2 * (pairs // 2 + nearer), cells


def _holds(grid: Grid, box: Box) -> bool:
    slack_x, slack_y = 1e-9 * grid.dx, 1e-9 * grid.dy
    return (
        grid.west <= box[0] + slack_x
        and grid.x[-1] >= box[1] - slack_x
        and grid.south <= box[2] + slack_y
        and grid.y[-1] >= box[3] - slack_y
    )


def _towards(grid: Grid, outer: Box) -> Box:
    """The grid's rectangle, each side moved outwards by half its span but not beyond `outer`."""
    reach_x = (grid.nx - 1) * grid.dx / 2
    reach_y = (grid.ny - 1) * grid.dy / 2
    west, east, south, north = grid.box
    return (
        min(west, max(outer[0], west - reach_x)),
        max(east, min(outer[1], east + reach_x)),
        min(south, max(outer[2], south - reach_y)),
        max(north, min(outer[3], north + reach_y)),
    )
