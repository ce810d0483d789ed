"""Equivalent load of rolling bearings from their radial load and thrust: ISO 281."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import degrees, tan

import numpy as np

from pyworm.formulas.bearing_life import Elements
from pyworm.formulas.ranges import one_of, positive, within

_DEEP_GROOVE = {
    **{0.014: (0.19, 2.30), 0.028: (0.22, 1.99), 0.056: (0.26, 1.71), 0.084: (0.28, 1.55)},
    **{0.11: (0.30, 1.45), 0.17: (0.34, 1.31), 0.28: (0.38, 1.15), 0.42: (0.42, 1.04)},
    0.56: (0.44, 1.00),
}
"""Thrust over static load rating -> e, Y of deep groove ball bearings."""

_DEEP_GROOVE_RADIAL = 0.56
"""X of deep groove ball bearings."""

_ANGULAR_CONTACT = {
    **{20.0: (0.57, 0.43, 1.00), 25.0: (0.68, 0.41, 0.87), 30.0: (0.80, 0.39, 0.76)},
    **{35.0: (0.95, 0.37, 0.66), 40.0: (1.14, 0.35, 0.57), 45.0: (1.34, 0.33, 0.50)},
}
"""Contact angle [deg] -> e, X, Y of single-row angular contact ball bearings."""

_ROLLER_LIMIT, _ROLLER_RADIAL, _ROLLER_THRUST = 1.5, 0.4, 0.4
"""e over tan(alpha), X, and Y tan(alpha) of single-row roller bearings."""


@dataclass(frozen=True)
class LoadFactors:
    """Factors of the equivalent load."""

    limit: float
    """e, thrust over radial load from which the thrust counts [-]."""
    radial: float
    """X [-]."""
    thrust: float
    """Y [-]."""


def load_factors(
    elements: Elements, contact_angle: float, thrust: float, static_rating: float | None
) -> LoadFactors:
    """Factors of a single-row radial bearing with a contact angle [rad] under a thrust [N].

    Deep groove ball bearings, of angle 0, need their static load rating [N]; their table is followed to both
    sides of its range as at its ends. ValueError for other angles than 20 to 45 deg of balls, and of rollers
    that take no thrust. Source: ISO 281, table of the factors X and Y, from memory: the equivalent load has
    no step at e within 2 %.
    """
    one_of("elements", elements, ("ball", "roller"))
    angle = degrees(contact_angle)
    if elements == "roller":
        if contact_angle == 0:
            raise ValueError("roller bearings with a contact_angle of 0 take no thrust")
        within("contact_angle", angle, 5, 45, "deg")
        slope = tan(contact_angle)
        return LoadFactors(_ROLLER_LIMIT * slope, _ROLLER_RADIAL, _ROLLER_THRUST / slope)
    if contact_angle == 0:
        if static_rating is None:
            raise ValueError("static_rating is missing, on which the factors of the thrust depend")
        positive("static load rating", static_rating, "N")
        relative = thrust / static_rating
        limit, factor = _between(_DEEP_GROOVE, relative)
        return LoadFactors(limit, _DEEP_GROOVE_RADIAL, factor)
    within("contact_angle", angle, 20, 45, "deg")
    limit, radial, factor = _between(_ANGULAR_CONTACT, angle)
    return LoadFactors(limit, radial, factor)


def _between(table: Mapping[float, tuple[float, ...]], place: float) -> tuple[float, ...]:
    """Values of a table, interpolated linearly between its rows."""
    columns = zip(*table.values(), strict=True)
    return tuple(float(np.interp(place, list(table), column)) for column in columns)


def equivalent_load(radial: float, thrust: float, factors: LoadFactors) -> float:
    """Equivalent dynamic load P [N]: F_r up to F_a = e F_r, X F_r + Y F_a beyond (ISO 281)."""
    if thrust <= factors.limit * radial:
        return radial
    return factors.radial * radial + factors.thrust * thrust
