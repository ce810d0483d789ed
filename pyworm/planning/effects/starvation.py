"""Starvation, which the kernel does not simulate, with its estimated influence."""

from pyworm.planning.effects.effect import Effect, Influence
from pyworm.planning.prediction import Prediction

STARVATION_POWER = 2.0
"""Exponent g of the law, below the measured 3 to 5, which overestimates the influence."""


def _supply(prediction: Prediction) -> float:
    """Ratio of the thickness of the supplied oil to that of a flooded film."""
    return prediction.oil.supply / prediction.film_central


def _by_starvation(prediction: Prediction) -> Influence:
    supply = _supply(prediction)
    change = 1 - supply / (1 + supply**STARVATION_POWER) ** (1 / STARVATION_POWER)
    return Influence(change, change, change)


STARVATION = Effect(
    name="starvation",
    symbol="h_oil / h",
    source="h/h_flooded = r/(1 + r^g)^(1/g), Chevalier, Lubrecht, Cann, Colin and Dalmaz (1998)",
    indicator=_supply,
    influence=_by_starvation,
    without=None,
    lacking=lambda scene: "flooded" if scene.oil.supply is None else None,
)
