"""The cheapest rung of a plan: films by the formula of the atlas, where they are as accurate as asked for."""

from pyworm.planning.effects.catalogue import EFFECTS
from pyworm.planning.effects.effect import FILM
from pyworm.planning.effects.selection import BEYOND_ISOTHERMAL
from pyworm.planning.plan import Plan
from pyworm.scene.formula_film import FormulaFilms, film_of
from pyworm.scene.line import LineScene
from pyworm.scene.point import RigidMotion, Scene

BEYOND_FORMULA = BEYOND_ISOTHERMAL | {"real-gap", "starvation"}
"""Effects that the formula does not have."""


def films_by_formula(scene: Scene | LineScene, plan: Plan) -> FormulaFilms | None:
    """Films of a contact by the formula, where a plan asks for no more than they give; None else.

    They suffice if films alone are asked for, effects are for the accuracy to decide, and the larger bar of
    both films and the influences of all effects that the formula leaves out are together within it.
    """
    if plan.asked is not None or plan.quantities != (FILM,) or isinstance(scene, LineScene):
        return None
    beyond = _beyond(scene)
    if scene.separation is not None or not plan.on.isdisjoint(beyond):
        return None
    try:
        found = film_of(scene)
    except ValueError:  # nothing is entrained at the contact point
        return None
    left = sum(
        judged.influence.get(FILM, 0.0)
        for judged in plan.effects
        if judged.name in beyond and judged.name not in plan.excluded
    )
    bar = max(float(found.central_error), float(found.minimum_error))
    return found if bar + left <= plan.accuracy else None


def _beyond(scene: Scene) -> frozenset[str]:
    """Effects that the formula does not have, each but once: it has the spin of bodies that move rigidly."""
    parts = {effect.name for effect in EFFECTS if effect.part_of is not None}
    rigid = all(isinstance(motion, RigidMotion) for motion in scene.motions)
    return (BEYOND_FORMULA - parts) | (frozenset() if rigid else {"varying-velocity"})
