"""A scene as one flat object for JSON, units in the keys.

Vectors are lists with an entry for each direction, [x, y] or [x].
"""

from collections.abc import Callable
from dataclasses import asdict
from typing import Any

import numpy as np

from pyworm.formulas.hertz import hertz, hertz_line
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


def scene_summary(scene: Scene | LineScene) -> dict[str, Any]:
    """The scene with the Hertz contact of its radii; unknown properties of its surfaces have no key."""
    roughness = scene.composite_roughness
    return {
        "name": scene.name,
        **asdict(ContactIndex.of(scene)),
        "reduced_modulus_Pa": scene.reduced_modulus,
        **({} if roughness is None else {"composite_roughness_m": roughness}),
        **_SUMMARIES[type(scene)](scene),
    }


def _point(scene: Scene) -> dict[str, Any]:
    origin = np.zeros(1)
    entrainment, sliding = (
        [float(component[0]) for component in velocity(origin, origin)]
        for velocity in (scene.entrainment, scene.sliding)
    )
    contact = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    semi_axes = contact.semi_axis_x, contact.semi_axis_y
    return {
        "kind": "point",
        "load_N": scene.load,
        "radii_m": list(scene.radii),
        "entrainment_m_per_s": entrainment,
        "sliding_m_per_s": sliding,
        "radius_long_m": max(scene.radii),
        "radius_short_m": min(scene.radii),
        "hertz_length_m": 2 * max(semi_axes),
        "hertz_width_m": 2 * min(semi_axes),
        "hertz_pressure_max_Pa": contact.pressure_max,
    }


def _line(scene: LineScene) -> dict[str, Any]:
    contact = hertz_line(scene.radius, scene.load, scene.reduced_modulus)
    return {
        "kind": "line",
        "load_per_length_N_m": scene.load,
        "radii_m": [scene.radius],
        "entrainment_m_per_s": [scene.entrainment],
        "sliding_m_per_s": [scene.sliding],
        "radius_m": scene.radius,
        "hertz_width_m": 2 * contact.half_width,
        "hertz_pressure_max_Pa": contact.pressure_max,
    }


_SUMMARIES: dict[type, Callable[[Any], dict[str, Any]]] = {Scene: _point, LineScene: _line}
"""Keys of each kind of contact."""
