"""Effects named by the user."""

from collections.abc import Sequence
from dataclasses import dataclass

from pyworm.io.given import row
from pyworm.planning.effects.catalogue import EFFECTS
from pyworm.scene.any_contact import AnyContact

BEYOND_ISOTHERMAL = frozenset(
    {
        "shear-thinning",
        "limiting-stress",
        "surface-heating",
        "film-heating",
        "viscosity-across",
        "squeeze",
        "roughness",
    }
)
"""Effects that the steady isothermal film of a Newtonian oil between smooth surfaces does not have."""


SIMULATED = {effect.name: effect for effect in EFFECTS if effect.without is not None}

GROUPS = ("all", "isothermal")
"""Words for several effects."""


Effects = str | Sequence[str]
"""Effects as a script names them: one word, such as "auto", or several, ("auto", "-squeeze")."""


def as_text(effects: Effects) -> str:
    """A choice of effects as case files have it, with commas; ValueError for what is none."""
    if isinstance(effects, str):
        return effects
    named = tuple(row("effects", effects))
    if not named or not all(isinstance(name, str) for name in named):
        raise ValueError(f'effects = {effects!r:.40}: must be names, such as ("auto", "-squeeze")')
    return ",".join(named)


def words(text: str) -> tuple[str, ...]:
    """The names of a choice; after "auto", effects to simulate in any case, and after a minus in none.

    ValueError for an unknown name.
    """
    names = tuple(part.strip() for part in text.split(","))
    if names[0] == "auto":
        for word in names[1:]:
            name = word.removeprefix("-")
            if name not in SIMULATED:
                beside = "a minus" if word.startswith("-") else "auto"
                raise ValueError(
                    f"{name or 'nothing'} after {beside} is none of {', '.join(SIMULATED)}"
                )
        return names
    if "auto" in names:
        raise ValueError("auto comes first, as in auto,-squeeze, and goes with no other choice")
    for word in names:
        if word.removeprefix("-") not in (*GROUPS, *SIMULATED):
            raise ValueError(
                f"{word or 'nothing'} is none of auto, {', '.join(GROUPS)}, {', '.join(SIMULATED)}"
            )
    return names


@dataclass(frozen=True)
class BesideAuto:
    """Effects named beside "auto"."""

    required: frozenset[str] = frozenset()
    """Effects to simulate in any case."""
    excluded: frozenset[str] = frozenset()
    """Effects not to simulate, with those that depend on them."""


def beside_auto(text: str) -> BesideAuto | None:
    """Effects named together with "auto"; None without it; ValueError for a word that means nothing."""
    first, *names = _understood(text)
    if first != "auto":
        return None
    minus = {name.removeprefix("-") for name in names if name.startswith("-")}
    excluded = frozenset().union(*map(_with_dependents, minus))
    return BesideAuto(frozenset(name for name in names if not name.startswith("-")), excluded)


def _understood(text: str) -> tuple[str, ...]:
    try:
        return words(text)
    except ValueError as error:
        raise ValueError(f"effects = {text}: {error}") from None


def chosen(scene: AnyContact, text: str) -> frozenset[str]:
    """Names of the effects that a choice selects.

    With commas between: "all" (all that are simulated and the contact has), "isothermal" (these for a steady
    Newtonian film of one temperature between smooth surfaces), names of effects, and names after a minus,
    which are taken away. ValueError for a word that means nothing, and for an effect that is not simulated or
    that the contact has not.
    """
    whole = {name for name, effect in SIMULATED.items() if effect.lacking(scene) is None}
    groups = {"all": whole, "isothermal": whole - BEYOND_ISOTHERMAL}
    on: set[str] = set()
    for word in _understood(text):
        name = word.removeprefix("-")
        if word.startswith("-"):
            on -= groups.get(name) or _with_dependents(name)
        elif name in groups:
            on |= groups[name]
        elif name in whole:
            on |= {name, *SIMULATED[name].together}
        else:
            require(scene, name, text)
    return frozenset(on & whole)


def require(scene: AnyContact, name: str, text: str) -> None:
    """Refuse an effect that a contact has none of, but by the phase of a mesh (ValueError)."""
    effect = SIMULATED[name]
    reason = effect.lacking(scene)
    if reason is not None and not effect.passing:
        raise ValueError(f"effects = {text}: {name}: {reason}")


def _with_dependents(name: str) -> set[str]:
    return {name, *(effect.name for effect in EFFECTS if name in effect.together)}
