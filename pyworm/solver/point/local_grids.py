"""The minimum film thickness of a starved contact, on finer grids about the places where it is found.

A thin layer of oil makes a film with the outline of the dry contact, beside which the gap rises with the
power 3/2 of the distance. Where it rises by a film within a cell, oil leaves at the outline that would stay,
and the film dips there; everywhere else it has converged long before. So the neighbourhood of the least film
alone is solved on grids of halving spacing, while pressure around it, the rigid film and temperatures stay.
That raises the dip; then the lowest place of the rest follows, until none is lower than one that has settled
(best-first search).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pyworm import kernel
from pyworm.formulas.arrays import Array, Flags
from pyworm.planning.grid import Grid
from pyworm.solver.error_estimate import Reading
from pyworm.solver.figures import film_minimum
from pyworm.solver.level import InitialGuess
from pyworm.solver.newton import iterate
from pyworm.solver.point.level import PointLevel

HALF_WIDTH = 64
"""Cells of a grid from the minimum to the sides of the finer one about it."""

UNREAD_NODES = 16
"""Nodes of a finer grid next to its outline that are not read: the film there follows the given pressure."""

COLLAR = 32
"""Cells around a finer grid whose pressure deflects it at its own spacing: beside a step the deflection has
an infinite slope, which interpolation blurs."""

TOLERANCE = 1e-5
"""Residual of the films on finer grids, over the flow through them."""

SETTLED_CHANGE = 0.005
"""Change of a minimum film by the last halving of the spacing at which it has settled."""

MOST_HALVINGS, MOST_GRIDS = 6, 80
"""Maximum number of halvings about one place, and of finer grids of a film."""

DEFICIT_SHARE, MAX_DEFICIT = 0.75, 0.12
"""Most by which the minimum on finer grids is too low, over what it is above that of the whole grid, and
over itself: oil that the whole grid loses upstream is missing in all of them. So chosen on eight contacts of
the default seed, with layers of 0.05 to 0.4 flooded films; of 13 of seed 82001, which the choice had not
seen, the result by the coarsest grids is from 3 % below to 5 % above that by the finest, within what is told
(`benchmarks/accuracy/local_grids.py`)."""

Continue = Callable[[PointLevel, Grid, Array, InitialGuess], PointLevel]
"""What makes the film on a finer grid: of the film around it, by that grid, deflection and guess."""


@dataclass
class _Piece:
    """A film on one grid, and its minimum among the nodes that no finer grid has."""

    level: PointLevel
    counted: Flags
    """Nodes that it is read at."""
    halvings: int = 0
    change: float = np.inf
    """Relative change of the minimum by the last halving."""
    value: float = np.inf
    place: tuple[float, ...] = ()
    last: bool = False
    """Whether there is no film on half the spacing."""

    def find(self) -> None:
        """Find the minimum; infinite where no node with pressure is left."""
        within = self.counted & self.level.borne()
        self.value = np.inf
        if within.any():
            film = self.level.film.thickness()
            found = film_minimum(self.level.grid, film, within, self.level.covered)
            self.value, self.place = found

    @property
    def has_settled(self) -> bool:
        """Whether half the spacing would hardly change the minimum, or is too fine."""
        return self.last or self.halvings >= MOST_HALVINGS or self.change <= SETTLED_CHANGE


def resolved(level: PointLevel, reading: Reading, continued: Continue, tolerance: float) -> Reading:
    """A reading whose minimum film thickness is that on finer grids, with the error that they leave.

    Half of what it may be too low by is added to it, as far as the film at the contact point, and half is
    its error, beside its change by the last halving. Where no film is found within a tolerance on the first
    of the finer grids the reading stays as it is.
    """
    pieces = [_Piece(level, np.ones(level.grid.shape, dtype=bool))]
    pieces[0].find()
    while not (lowest := min(pieces, key=lambda piece: piece.value)).has_settled:
        finer = None if len(pieces) > MOST_GRIDS else _refined(lowest, continued, tolerance)
        if finer is None:
            lowest.last = True
        else:
            pieces.append(finer)
    if lowest is pieces[0]:
        return reading
    least = lowest.value
    deficit = min(DEFICIT_SHARE * abs(1 - reading.film_min / least), MAX_DEFICIT)
    return replace(
        reading,
        film_min=min(least * (1 + deficit / 2), reading.film_central),
        film_min_at=lowest.place,
        left={"film_min": deficit / 2 + lowest.change},
    )


def _refined(piece: _Piece, continued: Continue, tolerance: float) -> _Piece | None:
    """The film about the minimum of a piece on half the spacing; None where it is not found.

    The nodes that it is read at no longer count for the piece.
    """
    level = piece.level
    window = _window(level.grid, piece.place)
    grid = level.grid.part(window).finer()
    guess = level.state().finer(window)
    finer = continued(level, grid, _deflection(level, grid, window), guess)
    iterate(finer, TOLERANCE)
    if not finer.film.balance.residual <= tolerance:
        return None
    counted = np.zeros(grid.shape, dtype=bool)
    counted[UNREAD_NODES:-UNREAD_NODES, UNREAD_NODES:-UNREAD_NODES] = True
    found = _Piece(finer, counted, piece.halvings + 1)
    found.find()
    found.change = float(abs(found.value - piece.value) / abs(found.value))
    inner = tuple(
        slice(part.start + UNREAD_NODES // 2, part.stop - UNREAD_NODES // 2) for part in window
    )
    piece.counted[inner] = False
    piece.find()
    return found


def _window(grid: Grid, place: Sequence[float]) -> tuple[slice, slice]:
    """Nodes of a grid about a place, within it."""
    along_x, along_y = (
        _about(round((position - first) / step), nodes)
        for position, first, step, nodes in zip(
            place, (grid.west, grid.south), grid.spacing, grid.shape, strict=True
        )
    )
    return along_x, along_y


def _about(node: int, nodes: int) -> slice:
    cells = min(2 * HALF_WIDTH, nodes - 1)
    first = min(max(node - cells // 2, 0), nodes - 1 - cells)
    return slice(first, first + cells + 1)


def _deflection(level: PointLevel, grid: Grid, window: tuple[slice, slice]) -> Array:
    """Deflection [m] on a finer grid by pressure beyond it, near it at its own spacing."""
    coarse = level.grid
    near = tuple(
        slice(max(part.start - COLLAR, 0), min(part.stop + COLLAR, nodes))
        for part, nodes in zip(window, coarse.shape, strict=True)
    )
    far, close = level.film.pressure.copy(order="F"), level.film.pressure[near]
    far[near] -= _halved_on_outline(close)
    beyond = level.far + _deflected(level, far, coarse)
    around = _halved_on_outline(np.maximum(kernel.prolong(close), 0.0))
    whole = coarse.part((near[0], near[1])).finer()
    inner = whole.nodes_of(grid)
    around[inner] = 0.0
    return kernel.prolong(beyond[window]) + _deflected(level, around, whole)[inner]


def _deflected(level: PointLevel, pressure: Array, grid: Grid) -> Array:
    """Deflection [m] under a pressure on a grid of some spacing."""
    scene = level.scene
    return kernel.elastic_deflection(
        pressure, grid.dx, grid.dy, scene.bending_modulus, scene.layers
    )


def _halved_on_outline(pressure: Array) -> Array:
    """A pressure with half of it on the outline, whose cells lie half beyond."""
    halved = pressure.copy(order="F")
    for side in (0, -1):
        halved[side] /= 2
        halved[:, side] /= 2
    return halved
