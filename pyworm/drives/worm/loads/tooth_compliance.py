"""Compliance of tooth contacts: force against approach, and the separation of teeth that do not touch."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from math import inf

import numpy as np
import scipy

from pyworm import kernel
from pyworm.drives.worm.drawing.design import Assembly, Hob, Wheel, Worm
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.formulas.arrays import Array, Flags
from pyworm.formulas.hertz import hertz
from pyworm.scene.point import Gap

EDGE_CONTACT_PHASES = 0.24
"""Range of phases before and after the mesh cycle in which a loaded pair may touch at an edge of a tooth."""

_END = np.array([-EDGE_CONTACT_PHASES, -0.18, -0.12, -0.08, *np.arange(-0.06, 0.09, 0.02)])

SPRING_PHASES = np.array([*_END, *np.arange(0.1, 0.95, 0.1), *(1 - _END[::-1])])
"""Phases at which dry contacts are solved, dense where an edge comes into the contact."""

LOAD_SHARES = np.array([2e-3, 0.02, 0.1, 0.3, 0.6, 1.0])
"""Loads of these dry contacts, as fractions of the whole load."""

CELLS = 96, 48
"""Number of cells along and across the contact: the error is 0.5 % of a load, less for load shares."""

SEARCH_CELLS = 48, 24
"""Number of cells in the search for the least gap, about which the window is centred."""

LONGEST_RATIO = 1e3
"""Largest ratio of the radii; a longer contact is limited by the teeth."""

HALF_SIDES = 1.7, 2.2
"""Half sides of the window over Hertz's semi-axes under the whole load."""

DRY_TOLERANCE = 1e-4

CROSSED = 10e-6
"""Depth [m] beyond which flanks that cross are none: continued from where their contact can be followed no
farther, as of concave worms beyond their mesh cycle."""


@dataclass(frozen=True)
class ToothSprings:
    """Approach of one tooth pair over phase and load."""

    phases: Array
    """Phases at which the pair can touch under load, (phases,)."""
    loads: Array
    """Normal loads [N], (loads,)."""
    separations: Array
    """Least gap between the teeth without load when the flanks would touch at their contact point [m],
    (phases,); negative where they touch at an edge before."""
    approaches: Array
    """Approach [m] from that instant, (phases, loads)."""

    @cached_property
    def _separation(self) -> "scipy.interpolate.PchipInterpolator":
        return scipy.interpolate.PchipInterpolator(self.phases, self.separations, extrapolate=False)

    @cached_property
    def _pressed(self) -> "scipy.interpolate.PchipInterpolator":
        """Interpolant of the logarithm of the approach beyond the first touch over phase."""
        pressed = self.approaches - self.separations[:, None]
        return scipy.interpolate.PchipInterpolator(self.phases, np.log(pressed), extrapolate=False)

    def at(self, phase: float) -> "ToothSpring":
        """The pair at a phase; beyond the last ones it never touches."""
        if not self.phases[0] <= phase <= self.phases[-1]:
            return ToothSpring(inf, None)
        # splines go through the loads solved, and on along the power that holds there
        pressed, loads = self._pressed(phase), np.log(self.loads)
        step = np.array([-20.0, 20.0])
        powers = np.diff(loads)[[0, -1]] / np.diff(pressed)[[0, -1]]
        far = loads[[0, -1]] + powers * step
        pressed = np.concatenate(([pressed[0] - 20], pressed, [pressed[-1] + 20]))
        curve = scipy.interpolate.PchipInterpolator(
            pressed, np.concatenate((far[:1], loads, far[1:]))
        )
        return ToothSpring(float(self._separation(phase)), curve)


@dataclass(frozen=True)
class ToothSpring:
    """Normal load of one tooth pair at one phase over its approach."""

    separation: float
    """Approach at which it touches [m]; inf where it never does."""
    curve: "scipy.interpolate.PchipInterpolator | None"
    """Logarithm of the approach from there [ln m] -> logarithm of the load [ln N]."""

    def load(self, approach: float) -> float:
        """Normal load [N] at an approach [m]."""
        pressed = approach - self.separation
        if self.curve is None or not pressed > 0:
            return 0.0
        return float(np.exp(self.curve(np.log(pressed))))


Place = tuple[float, float]
"""A place on a tangent plane [m]."""

CONTACT_POINT: Place = (0.0, 0.0)


def tooth_springs(
    gap_at: Callable[[float], Gap],
    radii_at: Callable[[float], tuple[float, float]],
    reduced_modulus: float,
    whole_load: float,
    stiffness: float,
    longest: float,
    touch_at: Callable[[float], Place] = lambda phase: CONTACT_POINT,
    follows: Callable[[float], bool] = lambda phase: 0 <= phase <= 1,
) -> ToothSprings:
    """Dry contacts of one tooth pair over its mesh cycle and a little beyond.

    By phase are given the undeformed gap over the tangent plane, the radii of curvature [m], the place about
    which flanks touch first (`touch_at`), by default their contact point, and whether the contact `follows`
    the flanks and is not continued, by default within the mesh cycle. `whole_load` is that of all pairs
    together [N], `stiffness` that beyond the contact [N/m], `longest` half the side of the window that no
    contact exceeds [m].
    """
    loads = LOAD_SHARES * whole_load
    phases, separations, approaches = [], [], []
    for phase in SPRING_PHASES:
        radii = radii_at(float(np.clip(phase, 0, 1)))
        placed = placed_gap(
            gap_at(float(phase)),
            radii,
            whole_load,
            reduced_modulus,
            longest,
            middle=touch_at(float(phase)),
        )
        if placed is None or not placed.covered.any():
            continue
        least = float(placed.gap[placed.covered].min())
        if least < -CROSSED and not follows(float(phase)):
            continue
        phases.append(phase)
        separations.append(least)
        pressure = placed.covered.astype(float)
        row = []
        for load in loads[::-1]:
            dry = placed.pressed(load, reduced_modulus, pressure)
            pressure = dry.pressure
            row.append(dry.approach + load / stiffness)
        approaches.append(row[::-1])
    return ToothSprings(np.array(phases), loads, np.array(separations), np.array(approaches))


@dataclass(frozen=True)
class MeshedTeeth:
    """Teeth by what decides their contacts."""

    parts: tuple[Worm, Wheel, Hob]
    """The design table."""
    distance: float
    """Distance of worm and wheel axes [m]."""
    assembly_under_load: Assembly
    """Where the worm runs."""
    gears: WormGears = field(compare=False)
    """The gears of them, whatever their load and oil."""

    @classmethod
    def of(cls, gears: WormGears) -> "MeshedTeeth":
        """The teeth of gears, or of a drive."""
        parts = gears.worm, gears.wheel, gears.hob
        return cls(parts, gears.centre_distance, gears.assembly_under_load, gears)


@lru_cache(maxsize=2)
def mesh_springs(
    teeth: MeshedTeeth, modulus: float, whole_load: float, stiffness: float
) -> ToothSprings:
    """Compliance by all that decides it; cached, as drives often differ in friction, lifts and oil only."""
    gears = teeth.gears
    return tooth_springs(
        gap_at=lambda phase: gears.gap(gears.cycle.contact(phase)),
        radii_at=lambda phase: gears.cycle.contact(phase).radii,
        reduced_modulus=modulus,
        whole_load=whole_load,
        stiffness=stiffness,
        longest=gears.wheel.face_width,
        touch_at=lambda phase: gears.touching_place(gears.cycle.contact(phase)),
        follows=gears.cycle.follows,
    )


@dataclass(frozen=True)
class PlacedGap:
    """A tooth pair's gap on a grid about the place where it is least."""

    x: Array
    """Nodes along the x axis of the tangent plane [m]."""
    y: Array
    """Nodes along the y axis of the tangent plane [m]."""
    gap: Array
    """Undeformed gap [m], (x, y)."""
    covered: Flags
    """Where both teeth exist, (x, y)."""

    def pressed(self, load: float, reduced_modulus: float, guess: Array) -> kernel.DryContact:
        """The dry contact under a load [N], from a first guess of the pressure."""
        steps = self.x[1] - self.x[0], self.y[1] - self.y[0]
        return kernel.dry_contact(
            self.gap, self.covered, *steps, reduced_modulus, load, guess, DRY_TOLERANCE
        )


def placed_gap(
    gap: Gap,
    radii: tuple[float, float],
    load: float,
    reduced_modulus: float,
    longest: float,
    cells: tuple[int, int] = CELLS,
    middle: Place = CONTACT_POINT,
) -> PlacedGap | None:
    """The gap about its least near a `middle` [m], under a load [N]; None without teeth."""
    size = hertz(min(radii[0], LONGEST_RATIO * radii[1]), radii[1], load, reduced_modulus)
    sides = [
        min(fraction * axis, longest)
        for fraction, axis in zip(HALF_SIDES, (size.semi_axis_x, size.semi_axis_y), strict=True)
    ]
    x, y = _window(middle, sides, SEARCH_CELLS)
    height, covered = gap(*np.meshgrid(x, y, indexing="ij"))
    if not covered.any():
        return None
    i, j = np.unravel_index(np.argmin(np.where(covered, height, inf)), height.shape)
    x, y = _window((x[i], y[j]), sides, cells)
    return PlacedGap(x, y, *gap(*np.meshgrid(x, y, indexing="ij")))


def _window(middle: tuple[float, float], sides: list[float], cells: tuple[int, int]) -> list[Array]:
    """Nodes along x and y [m]."""
    return [
        centre + np.linspace(-side, side, count + 1)
        for centre, side, count in zip(middle, sides, cells, strict=True)
    ]
