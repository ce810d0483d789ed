"""Places of a wheel's flank at which contact patterns are found."""

from dataclasses import dataclass

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.flanks.surfaces import WheelSurface
from pyworm.drives.worm.teeth.tooth import WheelTooth, wheel_radius
from pyworm.drives.worm.teeth.tooth_outline import flank_places

FACE_PLACES, HEIGHT_PLACES = 41, 15
"""Places along the face and over the height."""

REACHED = 1e-6
"""Distance from its place below which a place of the flank is found [m]."""


@dataclass(frozen=True)
class FlankGrid:
    """Places of a wheel's flank, whatever worm it meets."""

    face: Array
    """Places along the face from its middle [m], (height, face)."""
    radius: Array
    """Distances from the wheel's axis [m], (height, face)."""
    q: Array
    """Parameters of the flank there, (parameters, places)."""
    found: Array
    """Whether the flank reaches there, (places,)."""


def flank_grid(tooth: WheelTooth, flank: WheelSurface, within: tuple[float, ...]) -> FlankGrid:
    """Places between tip and root, from one end of the face to the other, about parameters within them."""
    half = tooth.face_width / 2
    face, part = np.meshgrid(
        np.linspace(-half, half, FACE_PLACES), np.linspace(0.0, 1.0, HEIGHT_PLACES)
    )
    root = tooth.root(face)
    radius = root + part * (tooth.tip(face) - root)
    target = np.stack([radius.ravel(), face.ravel()])
    q = flank_places(flank, within, target, tooth.hob_form_radius)
    cut = flank.cut_point(*q)
    found = np.abs(np.stack([wheel_radius(cut), cut[1]]) - target).max(axis=0) < REACHED
    return FlankGrid(face, radius, q, found)
