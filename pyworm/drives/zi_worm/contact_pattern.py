"""The contact pattern of worm and wheel without load: what a marking compound shows while they roll.

Each place of the wheel's flank is followed over the mesh. Its separation is the least gap to the worm on
the way, along the common normal of the instant, with tip reliefs, and with what the pair stands back while
another one leads the wheel: the ease-off, a wheel that the worm itself cuts has none. Compound of a
thickness is pressed off, or marked, where the separation is less (as shops judge patterns, with some 6 um).
"""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from pyworm.drives.zi_worm.gap import surface_points
from pyworm.drives.zi_worm.helicoid import Array
from pyworm.drives.zi_worm.tooth import wheel_radius
from pyworm.drives.zi_worm.tooth_outline import flank_places

if TYPE_CHECKING:
    from pyworm.drives.zi_worm.gears import ZiWormGears

THICKNESS = 6e-6
"""Usual thickness of marking compound [m]."""

FACE_PLACES, HEIGHT_PLACES = 41, 15
"""Places along the face and over the height."""

PHASES = np.linspace(-0.3, 1.3, 61)
"""Phases at which the pair is looked at; the ends of the face touch before and after the middle.

Between two of them the contact moves by some 0.2 mm, which leaves 0.2 um of gap half way."""

NEAR = 1e-3
"""Distance from the worm's cylinders [m] within which a place may lie over its flank."""

REACHED = 1e-6
"""Distance from its place below which a place of the flank is found [m]."""


@dataclass(frozen=True)
class ContactPattern:
    """Separation of a wheel's flank from the worm over the mesh.

    Attributes
    ----------
    face, radius : ndarray
        Places along the face from its middle, and distances from the wheel's axis [m], (height, face).
    separation : ndarray
        Least gap over the mesh [m], NaN where the flank does not reach or meets no worm, (height, face).
    """

    face: Array
    radius: Array
    separation: Array

    @cached_property
    def area(self) -> Array:
        """Area of the flank for each place, seen along the wheel's tangent [m2]."""
        wide = np.gradient(self.face, axis=1)
        return np.abs(wide * np.gradient(self.radius, axis=0))

    def marked(self, thickness: float = THICKNESS) -> Array:
        """Where compound of a thickness [m] is marked."""
        return self.separation <= thickness

    def fraction(self, thickness: float = THICKNESS) -> float:
        """Part of the flank that is marked [-]."""
        known = np.isfinite(self.separation)
        return float(self.area[self.marked(thickness)].sum() / self.area[known].sum())

    def along_face(self, thickness: float = THICKNESS) -> tuple[float, float]:
        """Ends of the marked part along the face [m]; the line of zero separation is always marked."""
        face = self.face[self.marked(max(thickness, float(np.nanmin(self.separation))))]
        return float(face.min()), float(face.max())


def contact_pattern(gears: "ZiWormGears") -> ContactPattern:
    """The pattern of the flank that the worm drives."""
    tooth, flank, cycle = gears.wheel_tooth, gears.wheel_flank, gears.cycle
    half = gears.wheel.face_width / 2
    face, part = np.meshgrid(
        np.linspace(-half, half, FACE_PLACES), np.linspace(0.0, 1.0, HEIGHT_PLACES)
    )
    root = tooth.root(face)
    radius = root + part * (tooth.tip(face) - root)
    target = np.stack([radius.ravel(), face.ravel()])
    q = flank_places(flank, gears.within, target, gears.hob.tip_radius)
    cut = flank.cut_point(*q)
    found = np.abs(np.stack([wheel_radius(cut), cut[1]]) - target).max(axis=0) < REACHED
    least = np.full(found.shape, np.inf)
    behind = _behind(gears)
    for phase, lag in zip(PHASES, behind, strict=True):
        contact = cycle.contact(float(phase))
        point = flank.point(*q, contact.wheel_angle)
        near = np.flatnonzero(_inside(gears, point) > -NEAR)
        point = point[:, near]
        x, y, height = contact.axes @ (point - contact.point[:, None])
        worm, _, exists = contact.worm_height.solve(x, y)
        on_worm = surface_points(contact, x, y, worm)
        gap = height - worm + gears.worm_tooth.taken_off(on_worm) + tooth.taken_off(point) + lag
        touched = exists & (_inside(gears, on_worm) > 0)
        least[near] = np.where(touched, np.minimum(least[near], gap), least[near])
    separation = np.where(found & np.isfinite(least), np.maximum(least, 0.0), np.nan)
    return ContactPattern(face, radius, separation.reshape(face.shape))


def both_patterns(gears: "ZiWormGears") -> tuple[ContactPattern, ContactPattern]:
    """The patterns of the flank that the worm drives and of the wheel's other one.

    That is the first one turned by half a turn about X, by which shifts along the wheel's axis change their
    sign, and so do places along the face.
    """
    own = turned = contact_pattern(gears)
    if gears.hob.axial_shift or gears.assembly.axial_shift:
        changed = replace(
            gears,
            hob=replace(gears.hob, axial_shift=-gears.hob.axial_shift),
            assembly=replace(gears.assembly, axial_shift=-gears.assembly.axial_shift),
        )
        turned = contact_pattern(changed)
    parts = (-turned.face, turned.radius, turned.separation)
    return own, ContactPattern(*(part[:, ::-1] for part in parts))


def _inside(gears: "ZiWormGears", point: Array) -> Array:
    """How far points (3, ...) are between the cylinders of the worm [m]."""
    return np.min(np.stack(list(gears.worm_tooth.margins(point).values())), axis=0)


def _behind(gears: "ZiWormGears") -> Array:
    """How far a pair stands back along its normal at `PHASES` while the leading one holds the wheel [m]."""
    cycle, pitch = gears.cycle, gears.pitch
    own = cycle.transmission_error(PHASES)
    leading = np.where((PHASES >= 0) & (PHASES <= 1), own, -np.inf)
    most = int((PHASES[-1] - PHASES[0]) / pitch) + 1
    for step in range(-most, most + 1):
        phases = PHASES + step * pitch
        on_teeth = (phases >= 0) & (phases <= 1)
        ahead = cycle.transmission_error(np.clip(phases, 0, 1))
        leading = np.where(on_teeth, np.maximum(leading, ahead), leading)
    point, normal = cycle.points(PHASES), cycle.normals(PHASES)
    lever = point[0] * normal[2] - point[2] * normal[0]
    return np.where(np.isfinite(leading), np.abs(lever) * (leading - own), np.inf)
