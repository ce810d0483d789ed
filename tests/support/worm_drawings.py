"""The drawing of a worm gear of a = 100 mm, 2/41, m 4 mm, q 10."""

from math import radians

from pyworm.drives.worm.drawing.drawing import Drawing
from pyworm.drives.worm.drawing.usual_values import completed

SIZES = {
    "centre_distance": 0.1,
    "threads": 2,
    "teeth": 41,
    "module": 4e-3,
    "diameter_factor": 10.0,
    "pressure_angle": radians(20),
    "face_width": 30e-3,
}

BY_HOB = SIZES | {"hob_oversize": 1.6e-3}

SWIVELLED = BY_HOB | {"hob_swivel": radians(0.44)}

CONCAVE = ("ZC", "ZC2")
"""Profiles that need a positive profile shift, and more pressure angle."""


def of_profile(profile: str, **others: float) -> Drawing:
    """The drawing of a profile, with the shift that it needs."""
    shift, angle = (0.5, 23) if profile in CONCAVE else (-0.5, 20)
    shifted = {"centre_distance": 0.1 + (shift + 0.5) * 4e-3, "pressure_angle": radians(angle)}
    drawing, _ = completed(SIZES | shifted | others, profile)
    return drawing
