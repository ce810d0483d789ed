"""The contact pattern of worm and wheel without load: what a marking compound shows while they roll.

Each place of the wheel's flank is followed over the mesh. Its separation is the least gap to the worm on
the way, along the common normal of the instant, with tip reliefs, and with what the pair stands back while
another one leads the wheel: the ease-off, a wheel that the worm itself cuts has none. Compound of a
thickness is pressed off, or marked, where the separation is less (as shops judge patterns, with some 6 um).
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self, TypeVar

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.teeth.flank_grid import FlankGrid
from pyworm.drives.worm.teeth.gap import surface_points
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.mesh_cycle import ToothContact

THICKNESS = 6e-6
"""Usual thickness of marking compound [m]."""

PHASES = np.linspace(-0.3, 1.3, 61)
"""Phases at which the pair is looked at; the ends of the face touch before and after the middle.

Between two of them the contact moves by some 0.2 mm, which leaves 0.2 um of gap half way."""

MAX_CYLINDER_DISTANCE = 1e-3
"""Distance from the worm's cylinders [m] within which a place may lie over its flank."""

FINER = 17
"""Places along each side of the flank, and again between its nearest ones, at which it may touch first."""

PHASE_STRIDE = 3
"""One of so many `PHASES` for which that place is found; it moves slowly."""

OPEN_GAP = 1.0
"""Gap of teeth that do not face each other [m]."""


@dataclass(frozen=True)
class ContactPattern:
    """Separation of a wheel's flank from the worm over the mesh."""

    face: Array
    """Places along the face from its middle [m], (height, face)."""
    radius: Array
    """Distances from the wheel's axis [m], (height, face)."""
    separation: Array
    """Least gap over the mesh [m], NaN where the flank does not reach or meets no worm, (height, face)."""

    @classmethod
    def of_least(cls, grid: FlankGrid, least: Array) -> Self:
        """The pattern of places by their least separations [m], infinite where none was met, (places,)."""
        known = grid.found & np.isfinite(least)
        separation = np.where(known, np.maximum(least, 0.0), np.nan)
        return cls(grid.face, grid.radius, separation.reshape(grid.face.shape))

    @cached_property
    def area(self) -> Array:
        """Area of the flank for each place, seen along the wheel's tangent [m2]."""
        wide = np.gradient(self.face, axis=1)
        return np.abs(wide * np.gradient(self.radius, axis=0))

    def marked(self, thickness: float = THICKNESS) -> Array:
        """Where compound of a thickness [m] is marked."""
        return self.separation <= thickness

    def fraction(self, thickness: float = THICKNESS) -> float:
        """Part of the flank that is marked [-]; 0 where nothing is met."""
        known = float(self.area[np.isfinite(self.separation)].sum())
        return float(self.area[self.marked(thickness)].sum()) / known if known else 0.0

    def along_face(self, thickness: float = THICKNESS) -> tuple[float, float]:
        """Ends of the marked part along the face [m]; the line of zero separation is always marked."""
        face = self.face[self.marked(max(thickness, float(np.nanmin(self.separation))))]
        return float(face.min()), float(face.max())


@dataclass(frozen=True)
class PointsInMesh:
    """Places of a flank that lie over the worm's at an instant."""

    which: Array
    """Their numbers in the grid, (met,)."""
    x: Array
    """Places along x in the contact's tangent plane [m], (met,)."""
    y: Array
    """Places along y in the contact's tangent plane [m], (met,)."""
    gap: Array
    """Gap along the common normal with both reliefs [m], (met,)."""


def points_in_mesh(gears: WormGears, grid: FlankGrid, contact: ToothContact) -> PointsInMesh:
    """The places of a grid that lie over the worm's flank at a contact."""
    point = gears.wheel_flank.point(*grid.q, wheel_angle=contact.wheel_angle)
    near = np.flatnonzero(_inside(gears, point) > -MAX_CYLINDER_DISTANCE)
    point = point[:, near]
    x, y, height = contact.axes @ (point - contact.point[:, None])
    worm, _, exists = contact.worm_height.solve(x, y)
    on_worm = surface_points(contact, x, y, worm)
    gap = height - worm + gears.worm_tooth.removed(on_worm) + gears.wheel_tooth.removed(point)
    over = exists & (_inside(gears, on_worm) > 0)
    return PointsInMesh(near[over], x[over], y[over], gap[over])


def contact_pattern(gears: WormGears, grid: FlankGrid) -> ContactPattern:
    """The pattern without load of the flank that the worm drives, at places of its wheel."""
    least = np.full(grid.found.shape, np.inf)
    for phase, lag in zip(PHASES, _behind(gears), strict=True):
        points = points_in_mesh(gears, grid, gears.cycle.contact(float(phase)))
        least[points.which] = np.minimum(least[points.which], points.gap + lag)
    return ContactPattern.of_least(grid, least)


GearsT = TypeVar("GearsT", bound=WormGears)
"""Gears, or their drive."""

PatternOf = Callable[[GearsT, FlankGrid], ContactPattern]
"""Gears and places of their wheel -> the pattern of the flank that the worm drives."""


def both_flanks(
    gears: GearsT, pattern_of: PatternOf[GearsT], like: GearsT | None = None
) -> tuple[ContactPattern, ContactPattern]:
    """The patterns of the flank that the worm drives and of the wheel's other one.

    The other one is the first one of `turned` gears, with places along the face of the opposite sign, found
    at the places of gears `like` these; it has no known separation where a shift leaves no contact that way.
    """
    like = gears if like is None else like
    driven = pattern_of(gears, like.flank_grid)
    try:
        turned = gears.turned
        other = driven if turned is gears else pattern_of(turned, like.turned.flank_grid)
    except ValueError:
        other = replace(driven, separation=np.full(driven.face.shape, np.nan))
    parts = (-other.face, other.radius, other.separation)
    return driven, ContactPattern(*(part[:, ::-1] for part in parts))


def _inside(gears: WormGears, point: Array) -> Array:
    """How far points (3, ...) are between the cylinders of the worm [m]."""
    return np.min(np.stack(list(gears.worm_tooth.margins(point).values())), axis=0)


def _behind(gears: WormGears) -> Array:
    """How far a pair stands back along its normal at `PHASES` while the leading one holds the wheel [m].

    Where a flank has deviations a pair leads, or is led, by the place that touches first.
    """
    cycle, pitch = gears.cycle, gears.pitch
    point, normal = cycle.points(PHASES), cycle.normals(PHASES)
    lever = np.abs(point[0] * normal[2] - point[2] * normal[0])
    late = _first_gaps(gears) / lever
    error = cycle.transmission_error(PHASES)
    leading = np.where((PHASES >= 0) & (PHASES <= 1), error - late, -np.inf)
    most = int((PHASES[-1] - PHASES[0]) / pitch) + 1
    for step in range(-most, most + 1):
        phases = PHASES + step * pitch
        on_teeth = (phases >= 0) & (phases <= 1)
        ahead = cycle.transmission_error(np.clip(phases, 0, 1)) - np.interp(phases, PHASES, late)
        leading = np.where(on_teeth, np.maximum(leading, ahead), leading)
    return np.where(np.isfinite(leading), lever * (leading - error), np.inf)


def _first_gaps(gears: WormGears) -> Array:
    """Least gap of the flanks at `PHASES` [m], negative where misaligned or uneven ones touch before."""
    if gears.edge_contact is not None:
        touches = [
            gears.first_touch(gears.cycle.contact(float(phase))) for phase in PHASES[::PHASE_STRIDE]
        ]
        gaps = [OPEN_GAP if touch is None else touch.gap for touch in touches]
        return np.interp(PHASES, PHASES[::PHASE_STRIDE], gaps)
    if not gears.deviating:
        return np.zeros(PHASES.size)
    least = []
    sides = gears.wheel.face_width / 2, 2 * gears.module
    for phase in PHASES[::PHASE_STRIDE]:
        gap = gears.gap(gears.cycle.contact(float(phase)))
        place = 0.0, 0.0
        for part in (1.0, 2 / FINER):
            x, y = (
                coordinate + part * side * np.linspace(-1, 1, FINER)
                for coordinate, side in zip(place, sides, strict=True)
            )
            opening, covered = gap(*np.meshgrid(x, y, indexing="ij"))
            opening = np.where(covered, opening, np.inf)
            i, j = np.unravel_index(np.argmin(opening), opening.shape)
            place = x[i], y[j]
        least.append(opening[i, j])
    return np.interp(PHASES, PHASES[::PHASE_STRIDE], least)
