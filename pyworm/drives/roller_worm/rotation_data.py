"""Rotation of a roller through both sections as data for tables and pictures."""

from typing import Any

import numpy as np

from pyworm.drives.roller_worm.mesh import RollerMesh
from pyworm.drives.roller_worm.rotation_figures import pressed_rotations, rotates_freely
from pyworm.drives.roller_worm.spin_up import spin_up

SAMPLES = 400
"""Times from the first touch to the last, beside the steps of the integration."""


def rotation_data(mesh: RollerMesh) -> dict[str, Any]:
    """Variables of the rotation, by closed forms; none where rollers are not turned by friction."""
    if not rotates_freely(mesh):
        return {}
    rotations = pressed_rotations(mesh)
    entries = {name: spin_up(rotation, name) for name, rotation in rotations.items()}
    rotation = rotations[mesh.driving]
    spun = rotation.spun
    last = max(rotation.passages(name)[1] for name in spun.paths)
    steps = rotation.steps
    times = np.unique([*np.linspace(0.0, last, SAMPLES), *steps[steps < last]])
    rows = []
    for seconds in times.tolist():
        speed = rotation.speed(seconds)
        found = [slices for _, slices in spun.slices(seconds)]
        values = [np.nan] * 3
        if found:
            film = spun.shear.film(found[0], speed)
            entrained = found[0].entrainment(speed)
            values = [found[0].rolling, found[0].mean(entrained), found[0].mean(film)]
        rows.append((seconds, spun.wheel.wheel_angle(seconds), speed, *values))
    names = ("time", "wheel_angle", "speed", "rolling", "entrainment", "film")
    columns = np.array(rows).T
    by_section = {
        "spin_up_time": [
            entries[name].seconds if name in entries else np.nan for name in mesh.sections
        ],
        "spin_up_distance": [
            entries[name].sliding_distance if name in entries else np.nan for name in mesh.sections
        ],
        "spin_up_loss": [
            entries[name].energies.sliding if name in entries else np.nan for name in mesh.sections
        ],
    }
    return {
        **{
            f"rotation_{name}": ("moment", column)
            for name, column in zip(names, columns, strict=True)
        },
        **{name: ("section", np.array(values)) for name, values in by_section.items()},
    }
