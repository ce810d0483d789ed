"""Uniform grids along x, and the first one of a line contact."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, hypot, log, sqrt

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.scene.line import LineScene
from pyworm.scene.scales import LineScales

INLET_FILMS = 12.0
"""Height of Hertz's gap at the inlet end of the grid, in films; beyond it is `solver.line.far_field`."""

INLET_ACCURACY = 1e-3
"""Accuracy for which that height is enough; the error falls with its square (`solver.line.contact`)."""

HEATED_INLET_FILMS = 48.0
"""Gap at the inlet end of a heated film, in films: oil and bodies warm far before the contact."""

HEATED_INLET_ACCURACY = 1e-2
"""Accuracy for which that height is enough; the error falls linearly with it (`solver.line.contact`)."""

EXIT_FILMS = 1.0
"""Hertz's gap at the exit end, in films; a rigid film ruptures where it is a quarter of it."""

FIRST_CELLS = 64
"""Least number of cells of the first grid."""

CELLS_OF_RISE = 3
"""Least number of cells of the first grid from the edge of the dry contact to where Hertz's gap is a film
high.

On coarser grids at M > 800, Newton's iteration diverged on 64 cells and the window error was hidden."""


@dataclass(frozen=True)
class LineGrid:
    """A uniform grid of nodes, one of them at the contact point."""

    dx: float
    """Spacing [m]."""
    first: int
    """Number of the first node, counted from the contact point."""
    nodes: int
    """Number of nodes."""

    @property
    def x(self) -> Array:
        """Positions of the nodes [m]."""
        return self.dx * np.arange(self.first, self.first + self.nodes, dtype=np.float64)

    @property
    def shape(self) -> tuple[int]:
        """Number of nodes along x."""
        return (self.nodes,)

    @property
    def spacing(self) -> tuple[float]:
        """Spacing along x [m]."""
        return (self.dx,)

    @property
    def cell(self) -> float:
        """Length of a cell [m]."""
        return self.dx

    def mesh(self) -> tuple[Array]:
        """Positions of all nodes [m]."""
        return (self.x,)

    def place(self, node: Sequence[float]) -> tuple[float]:
        """Position of a node, or of a place between nodes, by its number [m]."""
        return (self.dx * (self.first + node[0]),)

    def finer(self) -> "LineGrid":
        """The grid of half the spacing over the same interval."""
        return LineGrid(self.dx / 2, 2 * self.first, 2 * self.nodes - 1)

    def coarser(self) -> "LineGrid":
        """The grid of twice the spacing over the same interval, up to a cell of it at either end."""
        last = self.first + self.nodes - 1
        first = self.first // 2
        return LineGrid(2 * self.dx, first, -(-last // 2) - first + 1)


def twice_as_far(narrow: LineGrid, wide: LineGrid) -> LineGrid:
    """The wider of two grids of one spacing with its inlet, where they differ, at twice the gap."""
    left = wide.first < narrow.first
    before = -wide.first if left else wide.first + wide.nodes - 1
    more = ceil((sqrt(2) - 1) * before)
    return LineGrid(wide.dx, wide.first - more * left, wide.nodes + more)


def first_grids(
    scene: LineScene, size: LineScales, accuracy: float, heated: bool
) -> tuple[LineGrid, LineGrid]:
    """The coarsest grid for an accuracy, and the one of the same spacing whose inlet reaches twice as far."""
    if heated:
        films = HEATED_INLET_FILMS * max(1.0, HEATED_INLET_ACCURACY / accuracy)
    else:
        films = INLET_FILMS * max(1.0, sqrt(INLET_ACCURACY / accuracy))
    inlet, wider, exit_ = (
        _distance(scene, size, reach) for reach in (films, 2 * films, EXIT_FILMS)
    )
    rise = _distance(scene, size, 1.0) - size.hertz.half_width
    dx = min((inlet + exit_) / FIRST_CELLS, rise / CELLS_OF_RISE)
    return _grid(scene, dx, inlet, exit_), _grid(scene, dx, wider, exit_)


def _grid(scene: LineScene, dx: float, inlet: float, exit_: float) -> LineGrid:
    before, behind = ceil(inlet / dx), ceil(exit_ / dx)
    return LineGrid(dx, -before if scene.entrainment > 0 else -behind, before + behind + 1)


def _distance(scene: LineScene, size: LineScales, films: float) -> float:
    """Distance [m] from the contact point at which Hertz's gap is `films` films high.

    Outside the contact the gap is b^2/2R {X (X^2 - 1)^(1/2) - ln[X + (X^2 - 1)^(1/2)]}, X = x/b (Johnson,
    Contact Mechanics, section 4.2).
    """
    height, b = films * size.open_film, size.hertz.half_width
    near, far = b, 2 * hypot(b, sqrt(2 * scene.radius * height))
    for _ in range(60):
        middle = (near + far) / 2
        ratio = middle / b
        root = sqrt(ratio**2 - 1)
        gap = b**2 / (2 * scene.radius) * (ratio * root - log(ratio + root))
        near, far = (middle, far) if gap < height else (near, middle)
    return far
