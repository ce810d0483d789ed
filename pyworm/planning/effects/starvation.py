"""Starvation: films from the oil there is."""

from dataclasses import replace

from pyworm.formulas.starvation import film_over_flooded
from pyworm.planning.effects.effect import Effect, Influence
from pyworm.planning.prediction import Prediction, predicted
from pyworm.scene.contact import Contact

BOUND = 2.0
"""Exponent of the law below those of circular contacts, 2.1 to 4, and of wide ones, so that it overestimates
the influence (`benchmarks/validation/starvation.py`)."""

FLOODING = 20.0
"""Supply over the flooded film beyond which a contact counts as flooded: what a film lacks is by that law
less than 0.13 %."""


def _by_starvation(prediction: Prediction) -> Influence:
    change = 1 - film_over_flooded(prediction.supply_ratio, BOUND)
    return Influence(change, change, change)


def _lacking(scene: Contact) -> str | None:
    if scene.oil.supply is None:
        return "flooded, assumed: oil.supply not given"
    if predicted(scene).supply_ratio > FLOODING:
        return f"flooded: the supply is more than {FLOODING:g} films"
    return None


STARVATION = Effect(
    name="starvation",
    symbol="h_oil / h",
    source="h/h_flooded = r/(1 + r^g)^(1/g), Chevalier, Lubrecht, Cann, Colin and Dalmaz (1998)",
    indicator=lambda prediction: prediction.supply_ratio,
    influence=_by_starvation,
    without=lambda scene: replace(scene, oil=replace(scene.oil, supply=None)),
    lacking=_lacking,
)
