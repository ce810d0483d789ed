"""Choice of effects: every entry of the catalogue judged against the accuracy."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace

from pyworm.planning.effects.catalogue import EFFECTS
from pyworm.planning.effects.effect import Effect
from pyworm.planning.prediction import Prediction
from pyworm.scene.any_contact import AnyContact


@dataclass(frozen=True)
class Judgement:
    """Decision of a plan about one effect."""

    name: str
    """Name of the effect."""
    on: bool
    """Whether it is simulated."""
    indicator: float | None
    """Number by which it is judged [-]; None where the contact does not have it or that is unknown."""
    influence: dict[str, float]
    """Relative change of each quantity asked for by leaving it out (`Influence`); empty likewise."""
    reason: str
    """Reason why it is on or off."""


def judge(
    scene: AnyContact,
    accuracy: float,
    quantities: Sequence[str],
    prediction: Prediction,
    asked: frozenset[str] | None = None,
    required: frozenset[str] = frozenset(),
    excluded: Mapping[str, str] | None = None,
) -> tuple[Judgement, ...]:
    """Judge every effect, whether to simulate it, by a contact in closed form or solved figures.

    Effects are left out, the most expensive first, as long as together they change the quantities asked for
    by no more than the accuracy. Beside those `asked` or `required` those `excluded` have a reason each.
    """
    judgements, excluded = {}, excluded or {}
    allowed = accuracy
    for effect in EFFECTS:
        lacking = effect.lacking(scene)
        if lacking is not None:
            judgements[effect.name] = Judgement(effect.name, False, None, {}, lacking)
            continue
        influence = effect.influence(prediction)
        worst = influence.on(tuple(quantities))
        decided = _decided(effect, asked, judgements, excluded)
        if decided is not None:
            on, reason = decided
        elif effect.name in required:
            on = True
            reason = (
                _needed(allowed) if worst > allowed else f"requested; within {_percent(allowed)}"
            )
        else:
            on = not worst <= allowed
            reason = _needed(allowed) if on else f"within {_percent(allowed)}"
            allowed -= 0.0 if on else worst
        judgements[effect.name] = Judgement(
            effect.name,
            on,
            effect.indicator(prediction),
            {quantity: asdict(influence)[quantity] for quantity in quantities},
            reason,
        )
    if asked is None:
        for effect in EFFECTS:
            _bring(effect, judgements, excluded)
    return tuple(judgements.values())


def _decided(
    effect: Effect,
    asked: frozenset[str] | None,
    judgements: Mapping[str, Judgement],
    excluded: Mapping[str, str],
) -> tuple[bool, str] | None:
    """Decide an effect without its influence, with the reason; None where the influence decides."""
    if effect.name in excluded:
        return False, excluded[effect.name]
    if effect.without is None:
        return False, "not simulated"
    if asked is not None:
        return (True, "requested") if effect.name in asked else (False, "not requested")
    if effect.part_of is not None and not judgements[effect.part_of].on:
        return False, f"none without {effect.part_of}"
    return None


def simplified(scene: AnyContact, on: frozenset[str]) -> AnyContact:
    """The contact without the effects that are off."""
    for effect in EFFECTS:
        if effect.without is not None and effect.name not in on:
            scene = effect.without(scene)
    return scene


def _needed(allowed: float) -> str:
    return f"more than {_percent(allowed)}"


def _percent(fraction: float) -> str:
    return f"{fraction * 100:.2g} %"


def _bring(effect: Effect, judgements: dict[str, Judgement], excluded: Mapping[str, str]) -> None:
    """Switch on the effects that an effect needs, and those that ease its solution, unless excluded."""
    if not judgements[effect.name].on:
        return
    for verb, names in (("goes with", effect.together), ("stabilises", effect.eased_by)):
        for name in set(names) - excluded.keys():
            other = judgements[name]
            if not other.on and other.indicator is not None:
                judgements[name] = replace(other, on=True, reason=f"{verb} {effect.name}")
