"""Solid of a wheel as its hob cuts it: flanks, fillets, root, throat, tip cylinder, faces and rim.

In a plane square to its axis the wheel has the polar angle theta, z / -x = tan(theta), zero on the line of
centres. A space between teeth lies from the driven flank to the other one, which is the driven flank of the
gears after half a turn about that line.
"""

from itertools import pairwise
from math import pi

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.hobbed_fillet import (
    envelope_equations,
    fillet_points,
    rounded_hob,
    solved,
)
from pyworm.drives.worm.teeth.gears import WormGears
from pyworm.drives.worm.teeth.tooth import WheelTooth, wheel_radius
from pyworm.drives.worm.teeth.tooth_form import undercut, worm_thickness
from pyworm.drives.worm.teeth.tooth_outline import flank_places
from pyworm.drives.worm.thread_solid import FLANK_STEPS, LAND_STEPS, MIN_LAND, between
from pyworm.io.solid import Solid

FACE_STEPS, MIN_FACE_STEPS = 24, 8
"""Steps along the face in the coarsest net, and along the throat or the tip cylinder beside it."""

RIM = 2.0
"""Thickness of the rim below the root in the mid-plane over the module."""

REACHED = 1e-6
"""Distance from its place below which a point of the flank is found [m]."""

RELIEF_OF_FLANK = 0.8
"""Largest part of the flank's height that is the part with relief; a relief may reach into its fillet."""

KINK_WITHIN = 0.98
"""Largest distance of the tip's kink from the mid-plane over half the face at which surfaces end there."""


def wheel_solid(gears: WormGears, angle: float, finer: int = 1) -> Solid:
    """The wheel at a rotation angle [rad]; ValueError if it is undercut, pointed or without a root."""
    if undercut(gears) > 0:
        raise ValueError(
            "wheel: it is undercut, and solids are made of wheels without undercut only"
        )
    pitch = 2 * pi / gears.wheel.teeth
    breaks, driven = _side(gears, finer)
    mirrored = driven if gears.turned is gears else _side(gears.turned, finer)[1]
    shift = _other_flank_angle(gears)
    other = [
        np.array([1.0, -1.0, -1.0])[:, None, None] * part[:, ::-1, ::-1]
        + np.array([0.0, shift, 0.0])[:, None, None]
        for part in reversed(mirrored)
    ]
    apart = float((other[0][1, 0] - driven[-1][1, -1]).mean())
    other = [_ahead(part, -pitch * np.floor(apart / pitch)) for part in other]
    root = between(driven[-1][:, -1], other[0][:, 0], finer * LAND_STEPS)
    driven = [_ahead(part, pitch) for part in driven]
    tip = between(other[-1][:, -1], driven[0][:, 0], finer * LAND_STEPS)
    for land, where in ((root, "root"), (tip, "tip")):
        if (land[0, 0] * (land[1, -1] - land[1, 0])).min() < MIN_LAND * gears.module:
            raise ValueError(
                f"wheel: its flanks meet before its {where}, of which no solid is made"
            )
    nets = []
    for radius, polar, along in (root, *other, tip, *driven):
        turn = polar - angle
        nets.append(np.stack([-radius * np.cos(turn), along, radius * np.sin(turn)], axis=-1))
    middle = gears.hob.centre_distance - gears.hob.tip_radius
    bore = max(middle - RIM * gears.module, middle / 2)
    axis = np.array([0.0, 1.0, 0.0])
    flank = tuple(range(len(other) + 2, len(nets) - 1))
    return Solid("wheel", tuple(nets), breaks, gears.wheel.teeth, np.zeros(3), axis, bore, flank)


def _ahead(part: Array, by: float) -> Array:
    return part + np.array([0.0, by, 0.0])[:, None, None]


class _Face:
    """Places along the face, by the distance below the tip."""

    def __init__(self, tooth: WheelTooth, deepest: float, finer: int) -> None:
        self.tooth, self.half = tooth, tooth.face_width / 2
        within = KINK_WITHIN * self.half
        self.kinked = tooth.throat_half_width() < within
        self.followed = tooth.throat_half_width(deepest) < within
        ends = self._ends(deepest)
        self.steps = [
            finer * max(round(FACE_STEPS * (last - first) / (2 * self.half)), MIN_FACE_STEPS)
            for first, last in pairwise(ends)
        ]

    def _ends(self, below_tip: float) -> list[float]:
        if not self.kinked:
            return [-self.half, self.half]
        kink = self.tooth.throat_half_width(below_tip if self.followed else 0.0)
        return [-self.half, -kink, kink, self.half]

    @property
    def breaks(self) -> tuple[int, ...]:
        """Indices of the places between which the tip is smooth."""
        return 0, *(int(place) for place in np.cumsum(self.steps))

    def along(self, below_tip: float) -> Array:
        """Places along the face [m]."""
        ends = self._ends(below_tip)
        parts = [
            np.linspace(first, last, steps + 1)[1:]
            for (first, last), steps in zip(pairwise(ends), self.steps, strict=True)
        ]
        places = np.concatenate([[-self.half], *parts])
        return (places - places[::-1]) / 2


def _side(gears: WormGears, finer: int) -> tuple[tuple[int, ...], list[Array]]:
    """Breaks along the face, and smooth parts of the driven flank and its fillet from the tip to the root.

    Each has radii [m], polar angles [rad] and places along the face [m], (3, points, along).
    """
    flank, tooth = gears.wheel_flank, gears.wheel_tooth
    deepest = _relief_depth(gears)
    face = _Face(tooth, deepest, finer)
    part = np.linspace(0.0, 1.0, finer * FLANK_STEPS + 1)
    along = face.along(deepest)
    form = _form_line(gears, along)
    at_form = wheel_radius(flank.cut_point(*form))
    top = tooth.below_tip(along, deepest)
    whole = np.broadcast_to(along, (part.size, along.size))
    rows = [(top + part[:, None] * (at_form - top), whole)]
    if deepest > 0:
        places = np.array([face.along(below) for below in part * deepest])
        below = zip(places, part * deepest, strict=True)
        rows.insert(
            0, (np.array([tooth.below_tip(row, float(depth)) for row, depth in below]), places)
        )
    parts, shift = [], np.zeros(along.shape)
    for radius, places in rows:
        points, normal = _flank_points(gears, radius, places, form if places is whole else None)
        taken = _taken_angle(tooth, points, normal)
        shift = taken[-1]
        parts.append(np.stack([radius, _polar(points) - taken, places]))
    cutter = rounded_hob(flank.hob, tooth.hob_form_radius, gears.wheel.fillet_radius, gears.ratio)
    fillet = fillet_points(cutter, flank.cut_point(*form), form[-1], along, finer)
    fillet = np.moveaxis(fillet, -1, 0)
    radius = wheel_radius(fillet)
    radius[0] = at_form
    parts.append(np.stack([radius, _polar(fillet) - shift, along + 0 * radius]))
    return face.breaks, parts


def _relief_depth(gears: WormGears) -> float:
    """Distance below the tip of the part of the flank with relief [m]; zero without relief."""
    tooth = gears.wheel_tooth
    if not tooth.tip_relief.amount:
        return 0.0
    half = tooth.face_width / 2
    along = np.linspace(-half, half, FACE_STEPS + 1)
    cut = gears.wheel_flank.cut_point(*_form_line(gears, along))
    margins = tooth.margins(cut)
    height = float(np.minimum(margins["wheel tip"], margins["wheel throat"]).min())
    if height <= 0:
        raise ValueError("wheel: its fillet reaches its tip, and no flank is left there")
    return min(tooth.tip_relief.length, RELIEF_OF_FLANK * height)


def _form_line(gears: WormGears, along: Array) -> Array:
    """Parameters of the flank where the hob's rounded tip begins to cut, at places along the face [m]."""
    flank, form = gears.wheel_flank, gears.wheel_tooth.hob_form_radius
    target = np.stack([gears.wheel_tooth.root(along), along])
    start = flank_places(flank, gears.within, target, form)

    def missed(q: Array) -> Array:
        point, others = envelope_equations(flank, q)
        return np.stack([flank.hob.radius(point) - form, point[1] - along, *others])

    return solved(missed, start)


def _flank_points(
    gears: WormGears, radius: Array, along: Array, form: Array | None
) -> tuple[Array, Array]:
    """Points of the flank and their normals (3, points, along), the last ones at given parameters."""
    flank = gears.wheel_flank
    target = np.stack([radius, along]).reshape(2, -1)
    q = flank_places(flank, gears.within, target)
    if form is not None:
        q = q.reshape(len(q), *radius.shape).copy()
        q[:, -1] = form
        q = q.reshape(len(q), -1)
    points = flank.point(*q)
    off = np.abs(np.stack([wheel_radius(points), points[1]]) - target).max()
    if off > REACHED:
        raise ValueError(
            "wheel: its flank does not reach from its fillet to its tip over the whole face"
        )
    shape = 3, *radius.shape
    return points.reshape(shape), flank.normal(*q).reshape(shape)


def _polar(points: Array) -> Array:
    return np.arctan2(points[2], -points[0])


def _taken_angle(tooth: WheelTooth, points: Array, normal: Array) -> Array:
    """Angle about the wheel's axis by which relief and deviations set the flank back [rad]."""
    lever = np.abs(points[2] * normal[0] - points[0] * normal[2])
    return tooth.removed(points) / lever


def _other_flank_angle(gears: WormGears) -> float:
    """Sum of the polar angles of the other flank and of the driven one of the turned gears [rad].

    With the driven flank in contact at mid-mesh the other one is the backlash ahead of contact. The thread's
    other flank is its driving one after half a turn at the angle (2 A + thickness) / p less the worm's own.
    """
    flank, radius = gears.worm_flank, gears.reference_radius
    across = 2 * flank.axial_profile(radius) + worm_thickness(gears, radius)
    ahead = gears.cycle.absolute_error + gears.turned.cycle.absolute_error
    play = (gears.wheel.backlash or 0.0) / gears.wheel_reference_radius
    return gears.ratio * across / flank.screw + ahead + play
