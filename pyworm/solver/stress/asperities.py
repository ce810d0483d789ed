"""Fatigue of the layer below the asperities of a solved contact, by its other body's measured surface."""

from pyworm.materials.body import reduced_modulus
from pyworm.scene.any_contact import AnyContact
from pyworm.solver.solution import Solution
from pyworm.surfaces.asperity_stress import AsperityLayer, asperity_layer
from pyworm.surfaces.cell import periodic_cell


def asperity_fatigue(solution: Solution, scene: AnyContact, body: int) -> AsperityLayer:
    """The layer of body 1 or 2 where the asperities of the other one press most.

    ValueError of a body without fatigue limits, a counterface without topography, or a film without
    asperities.
    """
    below, other = scene.bodies[body - 1], scene.bodies[2 - body]
    if below.fatigue is None:
        raise ValueError(f"{solution.name}: body {body} has no fatigue limits")
    if other.topography is None:
        raise ValueError(f"{solution.name}: body {3 - body} has no surface point by point")
    fields = solution.dataset("fields")
    if "asperity_pressure" not in fields:
        raise ValueError(f"{solution.name}: roughness was not simulated")
    return asperity_layer(
        periodic_cell(other.topography),
        float(fields["asperity_pressure"].values.max()),
        below,
        below.fatigue,
        reduced_modulus(*scene.bodies),
        scene.boundary_friction,
    )
