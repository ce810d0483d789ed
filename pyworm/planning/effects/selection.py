"""Effects named by the user."""

from collections.abc import Sequence
from dataclasses import dataclass

from pyworm.io.given import Names, name_list
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

EXAMPLE = '"auto" or "auto", "-squeeze"'
"""A choice of one effect and one of several."""

AUTO = ("auto",)
"""Effects that the accuracy requires."""


def effect_names(effects: Names) -> tuple[str, ...]:
    """The names of a choice, such as "auto" or ("auto", "-squeeze"); ValueError for what is none."""
    return name_list("effects", effects, EXAMPLE)


def quantity_names(quantities: Names | None) -> tuple[str, ...] | None:
    """The names of requested quantities, such as ("film", "friction"); None where none are named."""
    return (
        None
        if quantities is None
        else name_list("quantities", quantities, '"film" or "film", "friction"')
    )


def require_known(names: Sequence[str]) -> None:
    """Refuse an unknown name (ValueError).

    After "auto" stand effects to simulate in any case, and after a minus those to simulate in none.
    """
    if names[0] == "auto":
        for word in names[1:]:
            name = word.removeprefix("-")
            if name not in SIMULATED:
                beside = "a minus" if word.startswith("-") else "auto"
                raise ValueError(
                    f"{name or 'nothing'} after {beside} is none of {', '.join(SIMULATED)}"
                )
        return
    if "auto" in names:
        raise ValueError("auto comes first, as in auto,-squeeze, and goes with no other choice")
    for word in names:
        if word.removeprefix("-") not in (*GROUPS, *SIMULATED):
            raise ValueError(
                f"{word or 'nothing'} is none of auto, {', '.join(GROUPS)}, {', '.join(SIMULATED)}"
            )


@dataclass(frozen=True)
class BesideAuto:
    """Effects named beside "auto"."""

    required: frozenset[str] = frozenset()
    """Effects to simulate in any case."""
    excluded: frozenset[str] = frozenset()
    """Effects not to simulate, with those that depend on them."""


def beside_auto(names: Sequence[str]) -> BesideAuto | None:
    """Effects named together with "auto"; None without it; ValueError for an unknown name."""
    first, *others = _understood(names)
    if first != "auto":
        return None
    minus = {name.removeprefix("-") for name in others if name.startswith("-")}
    excluded = frozenset().union(*map(_with_dependents, minus))
    return BesideAuto(frozenset(name for name in others if not name.startswith("-")), excluded)


def _understood(names: Sequence[str]) -> Sequence[str]:
    try:
        require_known(names)
    except ValueError as error:
        raise ValueError(f"effects = {','.join(names)}: {error}") from None
    return names


def chosen(scene: AnyContact, names: Sequence[str]) -> frozenset[str]:
    """Names of the effects that a choice selects.

    "all" (all that are simulated and the contact has), "isothermal" (these for a steady Newtonian film of one
    temperature between smooth surfaces), names of effects, and names after a minus, which are taken away.
    ValueError for an unknown name, and for an effect that is not simulated or that the contact has not.
    """
    whole = {name for name, effect in SIMULATED.items() if effect.lacking(scene) is None}
    groups = {"all": whole, "isothermal": whole - BEYOND_ISOTHERMAL}
    on: set[str] = set()
    for word in _understood(names):
        name = word.removeprefix("-")
        if word.startswith("-"):
            on -= groups.get(name) or _with_dependents(name)
        elif name in groups:
            on |= groups[name]
        elif name in whole:
            on |= {name, *SIMULATED[name].together}
        else:
            require(scene, name, names)
    return frozenset(on & whole)


def require(scene: AnyContact, name: str, names: Sequence[str]) -> None:
    """Refuse an effect that a contact has none of, but by the phase of a mesh (ValueError)."""
    effect = SIMULATED[name]
    reason = effect.lacking(scene)
    if reason is not None and not effect.passing:
        raise ValueError(f"effects = {','.join(names)}: {name}: {reason}")


def _with_dependents(name: str) -> set[str]:
    return {name, *(effect.name for effect in EFFECTS if name in effect.together)}
