"""Uncertainty of figures by the temperature of the oil that arrives between bodies warmer or colder than it.

Oil and bodies take the temperatures that they would have if they met a short way before the contact
(`pyworm.scene.oil_arrival`), and the film follows from the converged one.
"""

from collections.abc import Callable
from dataclasses import replace
from math import hypot, inf

import numpy as np

from pyworm.materials.body import Body
from pyworm.scene.oil_arrival import bulk_temperature, nearer_to_supply
from pyworm.solver.level import InitialGuess, Level
from pyworm.solver.newton import iterate

ENOUGH, WARMED, MOST_STEPS = 1e-4, 1e-3, 20
"""Residual and last change of temperature, over its largest rise, of a film that has followed the change,
and the most Newton steps to it."""

MIN_SPEED_RATIO = 1e-3
"""Speed of a surface over that of the faster one that it counts with at least: one at rest carries no oil."""


def other_bodies(level: Level) -> tuple[Body, Body]:
    """Both bodies, as warm as where they meet their oil a radius of curvature before the contact.

    The gap there is half of that radius: oil has no way to come in later.
    """
    scene = level.scene
    origin = (np.zeros(()),) * len(scene.radii_along)
    speeds = [
        hypot(*(float(component) for component in velocity))
        for velocity in scene.velocities_at(*origin)
    ]
    film, distance = level.read().film_central, min(scene.radii_along)
    first, second = (
        replace(
            body,
            bulk_temperature=bulk_temperature(body)
            + nearer_to_supply(
                scene.oil, body, max(speed, MIN_SPEED_RATIO * max(speeds)), film, distance
            ),
        )
        for body, speed in zip(scene.bodies, speeds, strict=True)
    )
    return first, second


def arrival_uncertainty(
    level: Level, warm: Callable[[tuple[Body, Body], InitialGuess], None]
) -> dict[str, float]:
    """Relative uncertainty of each figure [-], of temperatures over their rise above the inlet's.

    Infinite where the film that `warm` heats between other bodies does not follow. The level keeps its film.
    """
    converged, figures = level.state(), level.read().figures
    warm(other_bodies(level), converged)
    iterate(level, ENOUGH, WARMED, most=MOST_STEPS)
    followed, after = level.film.balance.within(ENOUGH, WARMED), level.read().figures
    warm(level.scene.bodies, converged)
    # the fields of its heat are those of the last sweep
    iterate(level, 0.0, most=1)
    if not followed:
        return dict.fromkeys(figures, inf)
    return {name: abs(after[name] / value - 1) if value else 0.0 for name, value in figures.items()}
