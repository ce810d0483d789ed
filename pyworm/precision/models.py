"""The model hierarchy: one contact, simulated with more and more of its effects."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from pyworm.io.given import Names
from pyworm.planning.effects.judgement import simplified
from pyworm.planning.plan import Plan, plan_of
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

ACCURACY = 1e-3
"""Accuracy of the models' plans; it decides the levels across the film and the windows of lines."""

CONDUCTING = 1e3
"""Conductivity of an oil of uniform temperature across the film, over that of the oil.

Ten times less changed films by 0.1 % and temperatures by 0.02 K; three levels are then as accurate as
eleven."""


@dataclass(frozen=True)
class Fidelity:
    """One model of the hierarchy."""

    name: str
    """Name in tables and pictures."""
    scene: Scene | LineScene
    """The contact with the model's effects and no others."""
    plan: Plan
    """Plan of its solve."""


def fidelities(
    scene: Scene | LineScene,
    quantities: Sequence[str] | None = None,
    accuracy: float = ACCURACY,
) -> tuple[tuple[Fidelity, ...], dict[str, str]]:
    """The models of a contact, the most complete one last, and the reasons for missing ones by name.

    Quantities and accuracy [-] are those of `pyworm.plan`, and so are the errors.
    """
    point = isinstance(scene, Scene)
    body = "point" if point else "line"
    isothermal = f"isothermal Newtonian {body}"
    wanted: list[tuple[str, Scene | LineScene, Names]] = [
        ("line contact", scene, ("isothermal", "-second-dimension")),
        (isothermal, scene, "isothermal"),
    ][0 if point else 1 :]
    if scene.oil.flow is not None:
        cold = ("all", "-roughness", "-film-heating", "-surface-heating")
        wanted.append(("+ rheology", scene, cold))
    if scene.oil.heat is not None:
        wanted.append(
            ("+ surface heat", conducting(scene), ("all", "-roughness", "-viscosity-across"))
        )
        wanted.append(("+ film heat", scene, ("all", "-roughness")))
    if scene.composite_roughness is not None:
        wanted.append(("+ roughness", scene, "all"))
    models: list[Fidelity] = []
    lacking: dict[str, str] = {}
    for name, contact, effects in wanted:
        try:
            planned = plan_of(contact, accuracy, effects, quantities)
            model = Fidelity(name, simplified(contact, planned.on), planned)
        except ValueError as error:
            if name == wanted[-1][0]:
                raise
            lacking[name] = str(error)
            continue
        if any(model.scene == other.scene for other in models):
            lacking[name] = "the same as the previous model"
        else:
            models.append(model)
    return tuple(models), lacking


def conducting(scene: Scene | LineScene) -> Scene | LineScene:
    """The contact with an oil of uniform temperature across the film, so that only the surfaces warm."""
    heat = scene.oil.thermal
    warm = replace(heat, conductivity=CONDUCTING * heat.conductivity)
    return replace(scene, oil=replace(scene.oil, heat=warm))
