"""The effects that a user asks for in words."""

from pyworm.effects.catalogue import EFFECTS
from pyworm.effects.effect import Contact

OF_HEAT_AND_FLOW = frozenset(
    {
        "shear-thinning",
        "limiting-stress",
        "surface-heating",
        "film-heating",
        "viscosity-across",
    }
)
"""What a Newtonian film of one temperature has none of."""


def chosen(scene: Contact, words: str) -> frozenset[str]:
    """Names of the effects that words choose.

    Parameters
    ----------
    scene : Scene or LineScene
        The contact.
    words : str
        With commas between: "all" (all that are simulated and the contact has), "isothermal" (these for a
        Newtonian film of one temperature), names of effects, and names after a minus, which are taken away.

    Raises
    ------
    ValueError
        For a word that means nothing, and for an effect that is not simulated or the contact has none of.
    """
    simulated = {effect.name: effect for effect in EFFECTS if effect.without is not None}
    whole = {name for name, effect in simulated.items() if effect.lacking(scene) is None}
    groups = {"all": whole, "isothermal": whole - OF_HEAT_AND_FLOW}
    on: set[str] = set()
    for word in (part.strip() for part in words.split(",")):
        name = word.removeprefix("-")
        if name not in simulated and name not in groups:
            raise ValueError(
                f"effects = {words}: {word or 'nothing'} is none of auto, {', '.join(groups)}, "
                f"{', '.join(simulated)}"
            )
        if word.startswith("-"):
            on -= groups.get(name, _with_dependents(name))
            continue
        if name in simulated and name not in whole:
            raise ValueError(f"effects = {words}: {name}: {simulated[name].lacking(scene)}")
        on |= groups.get(name, {name, *simulated[name].together} if name in simulated else set())
    return frozenset(on & whole)


def _with_dependents(name: str) -> set[str]:
    """An effect and those that go only with it."""
    return {name, *(effect.name for effect in EFFECTS if name in effect.together)}
