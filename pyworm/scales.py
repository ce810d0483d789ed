"""The size of things in a scene before anything is solved: Hertz's ellipse, Moes' groups, a film."""

from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin

import numpy as np

from pyworm.formulas.film import (
    PointGroups,
    nijenbanning_venner_moes,
    point_groups,
    radii_at_angle,
)
from pyworm.formulas.hertz import HertzContact, hertz
from pyworm.scene import Scene


@dataclass(frozen=True)
class Scales:
    """The size of things in a scene.

    Attributes
    ----------
    hertz : HertzContact
        The elliptic contact of the radii at the contact point.
    groups : PointGroups
        Dimensionless groups along the entrainment.
    angle : float
        Direction of the entrainment, from x to y [rad].
    film : float
        Central film by Nijenbanning, Venner and Moes [m].
    """

    hertz: HertzContact
    groups: PointGroups
    angle: float
    film: float


def scales(scene: Scene) -> Scales:
    """Sizes of a scene from its radii, load, oil and entrainment at the contact point.

    Where the contact point is at rest (pure spin), the root mean square of the entrainment over Hertz's
    ellipse stands in for it.

    Raises
    ------
    ValueError
        If the surfaces entrain no oil anywhere in the contact.
    """
    contact = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    u, v = (float(component) for component in scene.entrainment(np.zeros(()), np.zeros(())))
    speed = hypot(u, v)
    typical = _typical_speed(scene, contact)
    if not typical > 0:
        raise ValueError(
            f"{scene.name}: the surfaces entrain no oil (mean velocity 0 m/s all over the contact); "
            "give them velocities whose mean is not zero"
        )
    angle = atan2(v, u) if speed > 0 else 0.0
    groups = point_groups(
        *(float(radius) for radius in radii_at_angle(*scene.radii, angle)),
        scene.load,
        scene.reduced_modulus,
        max(speed, typical / 10),
        scene.oil.viscosity.eta0,
        scene.oil.viscosity.alpha,
    )
    return Scales(contact, groups, angle, float(nijenbanning_venner_moes(groups).central))


def _typical_speed(scene: Scene, contact: HertzContact) -> float:
    """Root mean square of the entrainment over eight points halfway out in Hertz's ellipse [m/s]."""
    angles = [k * pi / 4 for k in range(8)]
    x = np.array([contact.semi_axis_x * cos(angle) / 2 for angle in angles])
    y = np.array([contact.semi_axis_y * sin(angle) / 2 for angle in angles])
    u, v = scene.entrainment(x, y)
    return float(np.sqrt(np.mean(u**2 + v**2)))
