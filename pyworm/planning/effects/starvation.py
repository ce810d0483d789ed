"""Starvation: films from the oil there is."""

from dataclasses import replace

from pyworm.formulas.starvation import film_over_flooded
from pyworm.planning.effects.effect import Effect, Influence
from pyworm.planning.prediction import Prediction, predicted
from pyworm.scene.any_contact import AnyContact

CIRCULAR, WIDENING = 1.8, 0.4
"""Exponent of the law for circular contacts, and the power of their width over their length along the
entrainment with which it rises: below what was measured, 1.9 to 3.3 and at a width of ten lengths 4 to 12, so
that it overestimates the influence (`benchmarks/validation/starvation.py`)."""

FLOODED = 1.3e-3
"""Influence below which a contact counts as flooded; of circular ones from some thirty films on."""


def _influence(prediction: Prediction) -> float:
    """Relative change of the film by the supply, from above."""
    width = max(prediction.half_length / prediction.half_width, 1.0)
    return 1 - film_over_flooded(prediction.supply_ratio, CIRCULAR * width**WIDENING)


def _by_starvation(prediction: Prediction) -> Influence:
    change = _influence(prediction)
    return Influence(change, change, change)


def _lacking(scene: AnyContact) -> str | None:
    if scene.oil.supply is None:
        return "flooded, assumed: oil.supply not given"
    expected = predicted(scene)
    if _influence(expected) < FLOODED:
        return f"flooded: the supply is {expected.supply_ratio:.2g} films"
    return None


def _flooded(scene: AnyContact) -> AnyContact:
    """The contact with oil in plenty."""
    if scene.oil.supply is None:
        return scene
    return replace(scene, oil=replace(scene.oil, supply=None))


STARVATION = Effect(
    name="starvation",
    symbol="h_oil / h",
    source="h/h_flooded = r/(1 + r^g)^(1/g), Chevalier, Lubrecht, Cann, Colin and Dalmaz (1998)",
    indicator=lambda prediction: prediction.supply_ratio,
    influence=_by_starvation,
    without=_flooded,
    lacking=_lacking,
)
