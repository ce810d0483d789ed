"""Long waves of measured surfaces in the gap of a contact.

In a frame that moves with the contact point waves roll through with their surface. A steady film has those
that rest there: all of a surface at rest, and of a moving one what is constant along its motion. A film in
motion has all of them, each where its surface has carried it. In a line contact, the same all along, waves
count by their mean along the line.
"""

from dataclasses import dataclass
from math import cos, hypot, pi, sin

import numpy as np

from pyworm.formulas.arrays import Array, Flags
from pyworm.materials.long_waves import LongWaves
from pyworm.scene.contact import Contact
from pyworm.scene.line import LineScene

ANGLE_TOLERANCE = 1e-9
"""Angle [rad] by which a direction may be off what it is but for rounding."""


@dataclass(frozen=True)
class MovingWaves:
    """Waves that no gap holds since they roll through the contact."""

    height: float
    """Root mean square height of both surfaces' together [m]."""
    length: float
    """Length of the higher ones [m]."""


def opening(scene: Contact, *places: Array) -> tuple[Array, Flags]:
    """Undeformed gap [m] with the surfaces' long waves, and where both surfaces exist."""
    gap, covered = scene.gap(*places)
    for waves, direction, number in _known(scene):
        gap = gap - _heights(scene, waves, direction, number, places)
    return gap, covered


def waves_in_gap(scene: Contact) -> float:
    """Root mean square height of the waves in the gap of a contact [m]."""
    return hypot(*(_rms(scene, *wave) for wave in _known(scene)))


def moving_waves(scene: Contact) -> MovingWaves | None:
    """Waves that are not in the gap of a contact; None where there are none."""
    left = [
        (max(waves.rms**2 - _rms(scene, waves, direction, number) ** 2, 0.0) ** 0.5, waves.length)
        for waves, direction, number in _known(scene)
    ]
    height = hypot(*(height_left for height_left, _ in left))
    return MovingWaves(height, max(left)[1]) if height > 0 else None


def _known(scene: Contact) -> list[tuple[LongWaves, float, int]]:
    """Long waves of the bodies that have some, the direction of their motion [rad], and the body's number.

    A surface that turns round keeps its waves as they are.
    """
    if scene.smooth or scene.composite_roughness is None:
        return []
    return [
        (body.long_waves, (angle + ANGLE_TOLERANCE) % pi, number)
        for number, (body, angle) in enumerate(zip(scene.bodies, scene.motion_angles, strict=True))
        if body.long_waves is not None
    ]


def velocities(scene: Contact) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Velocities of both surfaces at the contact point, along each direction [m/s]."""
    origin = [np.zeros(()) for _ in range(1 if isinstance(scene, LineScene) else 2)]
    body_1, body_2 = scene.velocities_at(*origin)
    return tuple(map(float, body_1)), tuple(map(float, body_2))


def _whole(scene: Contact, number: int) -> bool:
    """Whether all waves of a surface are in the gap: it rests at the contact point, or moves with a film."""
    return scene.travelled is not None or not any(velocities(scene)[number])


def _heights(
    scene: Contact, waves: LongWaves, direction: float, number: int, places: tuple[Array, ...]
) -> Array:
    """Heights of a surface's waves at places of the contact [m]."""
    moved = scene.travelled[number] if scene.travelled is not None else (0.0,) * len(places)
    here = [place - by for place, by in zip(places, moved, strict=True)]
    whole = _whole(scene, number)
    if len(here) == 1:
        return waves.ridges(pi / 2).at(-here[0]) if whole else np.zeros(np.shape(here[0]))
    x, y = here
    along, across = cos(direction) * x + sin(direction) * y, cos(direction) * y - sin(direction) * x
    return waves.at(along, across) if whole else waves.ridges(0.0).at(across)


def _rms(scene: Contact, waves: LongWaves, direction: float, number: int) -> float:
    """Root mean square height of a surface's waves in the gap [m]."""
    whole = _whole(scene, number)
    if isinstance(scene, LineScene):
        return waves.ridges(pi / 2).rms if whole else 0.0
    return waves.rms if whole else waves.ridges(0.0).rms
