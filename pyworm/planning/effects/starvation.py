"""Starvation: films from the oil there is."""

from dataclasses import replace

from pyworm.planning.effects.effect import Effect, Influence
from pyworm.planning.prediction import Prediction, predicted
from pyworm.scene.contact import Contact

STARVATION_POWER = 2.0
"""Exponent g of the law, below those of 2.1 to 4 of circular contacts and above of wide ones, so that it
overestimates the influence (`benchmarks/validation/starvation.py`)."""

FLOODING = 20.0
"""Supply over the flooded film beyond which a contact counts as flooded: what a film lacks is by that law
less than 0.13 %."""


def _supply(prediction: Prediction) -> float:
    """Ratio of the thickness of the supplied oil, in the middle of the track, to that of a flooded film.

    A solved film may be starved itself: then the flooded one is that of the closed form.
    """
    flooded = max(prediction.film_central, predicted(prediction.scene).film_central)
    return float(prediction.oil.layer_at(0.0)) / flooded


def _by_starvation(prediction: Prediction) -> Influence:
    supply = _supply(prediction)
    change = 1 - supply / (1 + supply**STARVATION_POWER) ** (1 / STARVATION_POWER)
    return Influence(change, change, change)


def _lacking(scene: Contact) -> str | None:
    if scene.oil.supply is None:
        return "flooded, assumed: oil.supply not given"
    if _supply(predicted(scene)) > FLOODING:
        return f"flooded: the supply is more than {FLOODING:g} films"
    return None


STARVATION = Effect(
    name="starvation",
    symbol="h_oil / h",
    source="h/h_flooded = r/(1 + r^g)^(1/g), Chevalier, Lubrecht, Cann, Colin and Dalmaz (1998)",
    indicator=_supply,
    influence=_by_starvation,
    without=lambda scene: replace(scene, oil=replace(scene.oil, supply=None)),
    lacking=_lacking,
)
