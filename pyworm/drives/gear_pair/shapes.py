"""Teeth of a gear pair in space, for pictures.

Both axes run along z, the pinion's through the origin, the gear's through (a, 0, 0). The line of action
touches the base circles at T_1 = r_b1 (cos alpha, sin alpha) and T_2 = (a, 0) - r_b2 (cos alpha, sin alpha);
a contact at the pinion's radius of curvature L is at C = T_1 + L (sin alpha, -cos alpha) (ISO 21771, section
5). There the pinion has turned clockwise through L / r_b1, the gear the other way through L / r_b2, from
where L is zero. Turned back by that, C draws the flank. At a height z of helical teeth the section is turned
by z tan(beta_b) / r_b, and the line of contact is at L - z tan(beta_b).
"""

from collections.abc import Sequence
from math import atan2, cos, pi, sin, tan

import numpy as np

from pyworm.drives.answers import Shape, Space
from pyworm.drives.gear_pair.gears import InvolutePair

Array = np.ndarray

HEIGHTS = 7
"""Points along a flank from its root to its tip."""

SLICES = 5
"""Sections along the face."""

TEETH = 9
"""Most teeth on each side of the one in contact."""

RIM = 1.5
"""Thickness of the rim below the roots in normal modules."""

SHOWN_LENGTH = 20
"""Length shown in normal modules."""

DRAWN_PARTS = (
    "Red: line of contact of this pair of teeth. Drawn are teeth without fillets, relief and crowning; the "
    "hand of a helix is not given, the pinion is drawn as right-hand."
)


def in_space(teeth: InvolutePair, lengths: Sequence[float]) -> Space:
    """Some teeth of both gears, turned to radii of curvature of the pinion in mid-face [m]."""
    along = np.asarray(lengths)
    base = [cylinder.base for cylinder in teeth.cylinders]
    return Space(
        shapes=(_gear(teeth, 0, -along / base[0]), _gear(teeth, 1, along / base[1])),
        view=np.eye(3),
        size=SHOWN_LENGTH * teeth.system.module,
        drawn=DRAWN_PARTS,
        lines=tuple(contact_line(teeth, length) for length in lengths),
    )


def contact_line(teeth: InvolutePair, length: float) -> Array:
    """Points of a line of contact (n, 3) [m], by the radius of curvature of the pinion in mid-face."""
    z = np.linspace(-0.5, 0.5, 41) * teeth.face_width
    lengths = length - z * tan(teeth.system.base_helix_angle)
    there = (lengths >= teeth.start) & (lengths <= teeth.end)
    return np.column_stack([_met(teeth, lengths[there]), z[there]])


def _met(teeth: InvolutePair, length: Array) -> Array:
    """Points of the line of action (n, 2) [m]."""
    angle = teeth.pressure_angle
    touched = teeth.cylinders[0].base * np.array([cos(angle), sin(angle)])
    return touched + length[:, None] * np.array([sin(angle), -cos(angle)])


def _gear(teeth: InvolutePair, number: int, turns: Array) -> Shape:
    size, count = teeth.cylinders[number], (teeth.pinion, teeth.gear)[number].teeth
    centre = np.array([number * teeth.centre_distance, 0.0])
    outline = _outline(teeth, number, 2 * pi / count) - centre
    z = np.linspace(-0.5, 0.5, SLICES) * teeth.face_width
    twist = (1 - 2 * number) * z * tan(teeth.system.base_helix_angle) / size.base
    polar = np.hypot(*outline.T)[:, None]
    rim = size.root - RIM * teeth.system.module
    inner = [outline / polar * np.minimum(polar, radius) for radius in (rim, size.root)]
    # the faces of the gear lie between its outline and the inside of the rim, which closes the body
    rows = [(points, 0) for points in inner] + [(outline, layer) for layer in range(SLICES)]
    rows += [(points, -1) for points in reversed(inner)] + [(inner[0], 0)]
    section = np.stack([_turned(points, twist[layer]) for points, layer in rows]) + centre
    heights = np.broadcast_to(z[[layer for _, layer in rows], None, None], (*section.shape[:2], 1))
    others = [tooth for tooth in range(-TEETH, TEETH + 1) if tooth]
    around = 2 * pi / count * np.array(others[: count - 1])
    return Shape(
        body=number + 1,
        axis_point=np.array([*centre, 0.0]),
        axis=np.array([0.0, 0.0, 1.0]),
        surface=np.concatenate([section, heights], axis=2),
        turns=turns,
        copies=tuple(around),
    )


def _outline(teeth: InvolutePair, number: int, pitch: float) -> Array:
    """One tooth from root to root, its loaded flank first, as at the turn zero, (n, 2) [m]."""
    size = teeth.cylinders[number]
    centre = np.array([number * teeth.centre_distance, 0.0])
    lengths = np.linspace(max(size.form_length, 0.0), size.tip_length, HEIGHTS)
    length = lengths if number == 0 else teeth.base_tangent - lengths
    back = (1 - 2 * number) * length / size.base
    met = _met(teeth, length) - centre
    flank = np.stack([_turned(point[None], by)[0] for point, by in zip(met, back, strict=True)])
    foot = flank[0] * size.root / np.hypot(*flank[0])
    side = np.vstack([foot, flank])
    middle = _pitch_angle(teeth, number, centre) + size.pitch_thickness / (2 * size.pitch)
    other = _mirrored(side, middle)[::-1]
    ends = middle + np.array([-pitch, pitch]) / 2
    ground = size.root * np.column_stack([np.cos(ends), np.sin(ends)])
    return np.vstack([ground[:1], side, other, ground[1:]]) + centre


def _pitch_angle(teeth: InvolutePair, number: int, centre: Array) -> float:
    """Polar angle of the loaded flank on the pitch circle, at the turn zero [rad]."""
    size = teeth.cylinders[number]
    met = _met(teeth, np.array([teeth.pitch_point]))[0] - centre
    return atan2(met[1], met[0]) + (1 - 2 * number) * teeth.pitch_point / size.base


def _turned(points: Array, angle: float) -> Array:
    return points @ np.array([[cos(angle), sin(angle)], [-sin(angle), cos(angle)]])


def _mirrored(points: Array, angle: float) -> Array:
    """Points (n, 2) mirrored at the line through the origin at a polar angle."""
    return points @ np.array([[cos(2 * angle), sin(2 * angle)], [sin(2 * angle), -cos(2 * angle)]])
