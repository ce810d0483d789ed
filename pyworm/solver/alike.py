"""What contacts near each other have in common, of all that the equations of a film take."""

from dataclasses import fields

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.materials.body import Body
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.point import Paraboloid, RigidMotion, Scene

ELASTIC = frozenset({"youngs_modulus", "poisson_ratio", "modulus_by_temperature", "coating"})
"""Attributes of a body that a film of smooth surfaces takes by its deflection alone."""

CONDUCTING = ("conductivity", "density", "specific_heat")
"""Attributes of a body that decide with its motion how heat spreads in it."""


def gaps_alike(first: AnyContact, second: AnyContact) -> bool:
    """Whether the undeformed gaps of two contacts are known to be alike before they are evaluated."""
    if any(body.long_waves is not None for body in (*first.bodies, *second.bodies)):
        return False
    by_radii = isinstance(first.gap, Parabola | Paraboloid)
    return first.gap is second.gap or (by_radii and first.gap == second.gap)


def laws_alike(
    first: AnyContact, second: AnyContact, places: tuple[Array, ...], heated: bool, rough: bool
) -> bool:
    """Whether films of two contacts follow the same equations at one gap and deflection, by places [m].

    They do with the same oil and motions, between rough surfaces with the same bodies, and with heat with
    bodies that differ by their elastic constants alone.
    """
    if first.oil != second.oil or not motions_alike(first, second, places):
        return False
    if not (heated or rough):
        return True
    leaving_out = frozenset() if rough else ELASTIC
    names = [each.name for each in fields(Body) if each.name not in leaving_out]
    return _bodies_alike(first, second, names)


def spread_alike(first: AnyContact, second: AnyContact, places: tuple[Array, ...]) -> bool:
    """Whether heat spreads alike in the bodies of two contacts: by motion, at places [m], and material."""
    return motions_alike(first, second, places) and _bodies_alike(first, second, CONDUCTING)


def motions_alike(first: AnyContact, second: AnyContact, places: tuple[Array, ...]) -> bool:
    """Whether the surfaces of two contacts move alike, at places [m]."""
    if isinstance(first, LineScene) or isinstance(second, LineScene):
        return getattr(first, "velocities", None) == getattr(second, "velocities", None)
    if _rigid(first) and _rigid(second):
        return first.motions == second.motions
    return all(
        here is there or np.array_equal(here(*places), there(*places))
        for here, there in zip(first.motions, second.motions, strict=True)
    )


def _rigid(scene: Scene) -> bool:
    return all(isinstance(motion, RigidMotion) for motion in scene.motions)


def _bodies_alike(
    first: AnyContact, second: AnyContact, names: list[str] | tuple[str, ...]
) -> bool:
    return all(
        here is there or all(getattr(here, name) == getattr(there, name) for name in names)
        for here, there in zip(first.bodies, second.bodies, strict=True)
    )
