"""Maximum of a measure of the stress below a surface, over depth and plane, with its uncertainty."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, partial
from math import exp, log, log2

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.stress_invariants import von_mises
from pyworm.solver import extremum
from pyworm.solver.stress.layer import CoatedBody
from pyworm.solver.stress.thermal import HeatedBody
from pyworm.solver.stress.tractions import Tractions

Measure = Callable[[Array], Array]
"""Stress, components along the first axis -> its measure at each place."""

DEPTHS = (0.15, 0.2, 0.3, 0.4, 0.55, 0.75, 1.0)
"""Depths over the half-width that are searched upwards from `FIRST`."""

FIRST = 4
"""Place of the first depth among them: Hertz's maxima lie between 0.47 and 0.79."""

SURFACE_DEPTHS = (0.0, 0.05)
"""Further depths that are searched, on the finest grid, where a pressure spike or friction may decide."""

SURFACE_STRESS = (0.35, 2.0)
"""Equivalent stress at most at a surface, over pressure (circular: (1 - 2 nu)/2) and over shear traction
(behind a sliding cylinder: sqrt(1 - nu + nu^2) 2 mu p)."""

SEARCH_CELLS, FINAL_CELLS = 1, 6
"""Grid cells to a depth: in the search over depths, and at the maximum that is found."""

MIN_HALF_CELLS = 4
"""Least number of cells of a grid to the half-width."""

DEPTH_STEP = 0.1
"""Relative distance of the depths by which the maximum over depth is refined."""


@dataclass(frozen=True)
class Peak:
    """Maximum of a measure below a surface."""

    value: float
    """The maximum [Pa]."""
    depth: float
    """Its depth [m]."""
    position: tuple[float, ...]
    """Its position along the surface [m]."""
    grid_error: float
    """A third of the relative change from a grid of twice the spacing, all of it where the grid does not
    resolve the depth."""
    depth_error: float
    """Relative change by the last refinement of the depth, beyond that foreseen."""


class StressBelow:
    """Stress below tractions, on their own grid and on coarser ones, which suffice at larger depths.

    With that by a coating, and by the heat of the surface, where they are given.
    """

    def __init__(
        self,
        tractions: Tractions,
        poisson_ratio: float,
        coated: CoatedBody | None = None,
        heated: HeatedBody | None = None,
    ):
        self._grids = [tractions]
        self.coated, self.heated = coated, heated
        self.poisson_ratio = poisson_ratio
        """Poisson's ratio of the body."""
        self.half_width = tractions.half_width
        """Half-width of the contact [m]."""
        self._fields: dict[tuple[bool, int, float], Array] = {}
        self._step = max(tractions.spacing)
        cells = self.half_width / (MIN_HALF_CELLS * self._step)
        self.coarsest = int(log2(cells)) if cells > 1 else 0
        """Number of the coarsest grid, 0 the finest."""

    def grid(self, level: int) -> Tractions:
        """The tractions on a grid whose spacing is halved so many times from it to the finest one."""
        while len(self._grids) <= level:
            self._grids.append(self._grids[-1].coarser())
        return self._grids[level]

    def stress(self, grid: Tractions, depths: Sequence[float] | Array) -> Array:
        """Stress below the nodes of a grid [Pa], (component, depth, nx[, ny])."""
        stress = self._by_tractions(grid, depths)
        return stress if self.heated is None else stress + self.heated.stress(grid, depths)

    def _by_tractions(self, grid: Tractions, depths: Sequence[float] | Array) -> Array:
        """Stress by the tractions alone."""
        stress = grid.stress(self.poisson_ratio, depths)
        return stress if self.coated is None else stress + self.coated.stress(grid, depths)

    def _known(self, depths: Sequence[float], level: int, heat: bool) -> list[Array]:
        """Stress by heat, or by the tractions, at each depth below the nodes of a grid, computed once."""
        compute = self.heated.stress if heat and self.heated else self._by_tractions
        missing = [depth for depth in depths if (heat, level, depth) not in self._fields]
        if missing:
            found = np.swapaxes(compute(self.grid(level), missing), 0, 1)
            self._fields |= zip(((heat, level, depth) for depth in missing), found, strict=True)
        return [self._fields[heat, level, depth] for depth in depths]

    def heat_share(self, measure: Measure, peak: Peak) -> float:
        """Share of a maximum that thermal stress makes, at its depth [-]."""
        if self.heated is None:
            return 0.0
        level = self.level_for(peak.depth, FINAL_CELLS) + 1
        hot, cold = (self.highest(measure, peak.depth, level, heat)[0] for heat in (True, False))
        return abs(1 - cold / hot)

    @cached_property
    def layer_depths(self) -> tuple[float, ...]:
        """Depths where the stress over depth has an edge, which are searched besides [m]."""
        return () if self.coated is None else (0.0, *self.coated.faces)

    def level_for(self, depth: float, cells: int) -> int:
        """Number of the coarsest grid with so many cells to a depth."""
        ratio = depth / (cells * self._step)
        return min(int(log2(ratio)), self.coarsest) if ratio > 1 else 0

    def highest(
        self, measure: Measure, depth: float, level: int, heat: bool = True
    ) -> tuple[float, tuple[float, ...]]:
        """Largest value at a depth, between the nodes of a grid, and its position [m]."""
        field = self._field(measure, depth, level, heat)
        everywhere = np.ones(field.shape, bool)
        value, nodes = extremum.minimum(-field, everywhere, everywhere)
        return -value, self.grid(level).position(nodes)

    def _field(self, measure: Measure, depth: float, level: int, heat: bool = True) -> Array:
        """A measure at the nodes of a grid, at a depth."""
        stress = self._known([depth], level, False)[0]
        if heat and self.heated is not None:
            stress = stress + self._known([depth], level, True)[0]
        return measure(stress)

    @cached_property
    def critical_depth(self) -> float:
        """Depth of the largest equivalent stress among those searched [m]."""
        edges = {depth / self.half_width: depth for depth in self.layer_depths}

        @cache
        def searched(factor: float) -> float:
            depth = factor * self.half_width
            if factor in edges:
                depth = edges[factor]
            level = self.level_for(depth, SEARCH_CELLS)
            return float(self._field(von_mises, depth, level).max())

        place = FIRST
        while (best := max(_neighbours(place), key=lambda near: searched(DEPTHS[near]))) != place:
            place = best
        factors = [DEPTHS[place]]
        if self.largest_near_surface > searched(DEPTHS[place]):
            factors += SURFACE_DEPTHS
        best_factor = max([*factors, *edges], key=searched)
        return edges.get(best_factor, self.half_width * best_factor)

    @cached_property
    def largest_near_surface(self) -> float:
        """Bound of the equivalent stress at the surface, by its tractions, pressure spikes and heat [Pa]."""
        finest, coarsest = self.grid(0), self.grid(self.coarsest)
        sample = (slice(None, None, 2**self.coarsest),) * finest.pressure.ndim
        counted = tuple(slice(count) for count in finest.pressure[sample].shape)
        spike = float(np.max(finest.pressure[sample] - coarsest.pressure[counted]))
        shear = np.sqrt(sum(component**2 for component in finest.shear))
        by_pressure, by_shear = SURFACE_STRESS
        elastic = by_pressure * finest.pressure.max() + by_shear * shear.max() + spike
        return float(elastic) + (0.0 if self.heated is None else self.heated.largest)

    def peak(self, measure: Measure, depth: float) -> Peak:
        """Maximum of a measure near a depth, which is refined by a parabola over its logarithm."""
        fine = self.level_for(depth, FINAL_CELLS)
        on_coarse = partial(self.highest, measure, level=fine + 1)
        foreseen = 0.0
        refined = depth > 0 and depth not in self.layer_depths
        if refined:
            depths = [depth * factor for factor in (1 / (1 + DEPTH_STEP), 1, 1 + DEPTH_STEP)]
            for heat in (False, True)[: 1 if self.heated is None else 2]:
                self._known(depths, fine + 1, heat)  # together, which is cheaper
            before, middle, behind = (on_coarse(near)[0] for near in depths)
            step, gain = _vertex(before, middle, behind)
            depth *= exp(step * log(1 + DEPTH_STEP))
            foreseen = middle + gain
        value, grid_error, position = self._extrapolated(measure, depth, fine)
        return Peak(
            value,
            depth,
            position,
            grid_error / value,
            abs(on_coarse(depth)[0] - foreseen) / value if refined else 0.0,
        )

    def _extrapolated(
        self, measure: Measure, depth: float, fine: int
    ) -> tuple[float, float, tuple[float, ...]]:
        """Largest value at a depth, extrapolated to fourth order, its uncertainty and its position [m].

        For the part of heat, which is smooth, a coarser grid suffices below a depth.
        """
        resolved = depth >= FINAL_CELLS * self._step
        apart = self.heated is not None and depth >= SEARCH_CELLS * self._step
        value, position = self.highest(measure, depth, fine, heat=not apart)
        change = value - self.highest(measure, depth, fine + 1, heat=not apart)[0]
        error = abs(change) / (3 if resolved else 1)  # as if of second order
        value += change / 15
        if apart:
            (hot, position), *parts = (
                self.highest(measure, depth, level, heat)
                for level in (fine + 1, fine + 2)
                for heat in (True, False)
            )
            cold, coarse_hot, coarse_cold = (part for part, _ in parts)
            value += hot - cold
            error += abs(hot - cold - coarse_hot + coarse_cold) / 3
        return value, error, position


def _neighbours(place: int) -> range:
    """A place among `DEPTHS`, and those next to it."""
    return range(max(place - 1, 0), min(place + 2, len(DEPTHS)))


def _vertex(before: float, middle: float, behind: float) -> tuple[float, float]:
    """Place of the vertex of a parabola, at most two steps from the middle of three values, and its rise."""
    slope, bend = (behind - before) / 2, before - 2 * middle + behind
    step = float(np.clip(-slope / bend, -2, 2)) if bend < 0 else float(np.sign(slope))
    return step, slope * step + bend * step**2 / 2
