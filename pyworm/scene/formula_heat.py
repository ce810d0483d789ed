"""Groups of heat and flow of scenes, for the reduction of their films by the formula of the atlas."""

from math import cos, hypot, inf, sin, sqrt

import numpy as np

from pyworm.formulas.arrays import Values
from pyworm.formulas.film_reduction import HeatGroups
from pyworm.formulas.hertz import hertz
from pyworm.io.present import present
from pyworm.materials.flow_laws import LEAST_LIMIT
from pyworm.materials.oil import Oil
from pyworm.scene.point import Scene

LAWS = ("eyring", "eyring-limited")
"""Flow laws whose stress is Eyring's; that of the thermal contacts of the atlas is the second."""

NO_LIMIT = 1.0
"""Limiting stress over the Hertz pressure of oils without one: beyond the box of the atlas."""


def lacks_heat(scene: Scene) -> bool:
    """Whether the oil or the bodies lack data for heat and shear thinning."""
    oil = scene.oil
    constants = [getattr(body, name) for body in scene.bodies for name in BODY_CONSTANTS]
    return oil.heat is None or oil.flow is None or oil.flow.law not in LAWS or None in constants


BODY_CONSTANTS = "conductivity", "density", "specific_heat"


def heat_groups(scene: Scene, central: Values) -> HeatGroups:
    """The groups of a scene that does not lack heat, from its central film without heat [m].

    Of bodies that differ the geometric mean counts. Sliding counts by its size, in whatever direction.
    """
    oil, flow = scene.oil, scene.oil.sheared
    dry = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    (u, v), sliding = (
        [float(np.ravel(component)[0]) for component in along(np.zeros(1), np.zeros(1))]
        for along in (scene.entrainment_at, scene.sliding_at)
    )
    speed = hypot(u, v)
    turned = np.arctan2(v, u)
    half = 1 / hypot(cos(turned) / dry.semi_axis_x, sin(turned) / dry.semi_axis_y)
    eta, conductivity = oil.viscosity.eta0, oil.thermal.conductivity
    bodies, capacity = (
        sqrt(first * second)
        for first, second in (
            tuple(present(body.conductivity, "conductivity") for body in scene.bodies),
            tuple(body.heat_capacity for body in scene.bodies),
        )
    )
    beta = oil.beta
    sheared = (
        beta * hypot(*sliding) * _stress(oil, 2 * dry.pressure_max / 3, hypot(*sliding) / central)
    )
    carried = oil.density.rho0 * oil.thermal.specific_heat * speed
    return HeatGroups(
        loading=eta * beta * speed**2 / conductivity,
        sliding=hypot(*sliding) / speed,
        shear=eta * speed / (central * flow.stress),
        conductivity_ratio=conductivity / bodies,
        eyring=flow.stress / dry.pressure_max,
        limiting=_limit(oil, dry.pressure_max) / dry.pressure_max if flow.limited else NO_LIMIT,
        graetz=carried * central**2 / (conductivity * half),
        peclet=capacity * speed * half / bodies,
        film_warmth=sheared * central / (8 * conductivity),
        surface_warmth=sheared * sqrt(half / (speed * capacity * bodies)),
    )


def _stress(oil: Oil, pressure: float, rate: Values) -> Values:
    """Shear stress of an oil of Eyring's law at a shear rate [1/s], below its limit [Pa]."""
    flow = oil.sheared
    viscous = np.minimum(oil.eta(pressure) * rate / flow.stress, LARGEST_SINH)
    stress = flow.stress * np.arcsinh(viscous)
    return stress / (1 + stress / (_limit(oil, pressure) if flow.limited else inf))


def _limit(oil: Oil, pressure: float) -> float:
    """Limiting stress at a pressure [Pa]."""
    return max(oil.sheared.limit + oil.sheared.limit_pressure * pressure, LEAST_LIMIT)


LARGEST_SINH = 1e8
"""Newtonian stress over Eyring's beyond which it grows no further."""
