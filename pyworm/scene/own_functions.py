"""Checks of gaps and motions that users write as functions, before anything is planned with them."""

from collections.abc import Callable

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.scene.contact import Contact

TRIAL_DISTANCE = 1e-3
"""Distance of the places where a function is tried, over the radii: within any contact's reach."""

_EXAMPLE = {
    1: "return x**2 / 0.02, abs(x) < 0.005",
    2: "return x**2 / 0.02 + y**2 / 0.02, abs(y) < 0.005",
}


def require_functions(scene: Contact) -> None:
    """Refuse functions that fail or give no gap and mask, or no velocities, at the contact (ValueError)."""
    steps = [TRIAL_DISTANCE * radius * np.linspace(-1, 1, 3) for radius in scene.radii_along]
    places = tuple(np.meshgrid(*steps, indexing="ij"))
    names = ", ".join("xy"[: len(places)])
    example = _EXAMPLE[len(places)]
    wanted = (
        f"the gap [m] and where both surfaces exist, arrays of the shape of x, such as {example}"
    )
    gap, covered = _parts(f"gap({names})", scene.gap, places, 2, wanted)
    if not np.isfinite(gap).all():
        raise ValueError(
            f"gap({names}) gives {gap[~np.isfinite(gap)].flat[0]} near the contact point: must be finite "
            "everywhere, outside of the surfaces too"
        )
    if covered.dtype != bool:
        raise ValueError(
            f"gap({names}) gives a second array of {covered.dtype}: must be true where both surfaces exist, "
            f"else false, such as {example.rpartition(', ')[2]}"
        )
    for body, motion in enumerate(getattr(scene, "motions", ()), 1):
        wanted = "its velocities along x and y [m/s], arrays of the shape of x"
        for velocity in _parts(f"the motion of body {body}", motion, places, 2, wanted):
            if not np.isfinite(velocity).all():
                raise ValueError(f"the motion of body {body} is not finite near the contact point")


def _parts(
    name: str, function: Callable[..., object], places: tuple[Array, ...], count: int, wanted: str
) -> tuple[Array, ...]:
    """What a function gives at places; ValueError if that is not so many arrays of their shape."""
    try:
        given = function(*places)
    except Exception as error:  # whatever a function of the user's stumbles over
        raise ValueError(
            f"{name} fails ({type(error).__name__}: {error}); it must give {wanted}"
        ) from error
    if not (isinstance(given, tuple | list) and len(given) == count):
        raise ValueError(f"{name} gives {_described(given)}: must give {wanted}")
    parts = tuple(map(np.asarray, given))
    for part in parts:
        if part.shape != places[0].shape:
            raise ValueError(f"{name} gives {_described(given)}: must give {wanted}")
    return parts


def _described(given: object) -> str:
    if isinstance(given, tuple | list):
        return (
            f"{len(given)} values, {' and '.join(_described(value) for value in given) or 'none'}"
        )
    if isinstance(given, np.ndarray):
        return f"one array of the shape {given.shape}"
    return f"{type(given).__name__} {given!r:.40}"
