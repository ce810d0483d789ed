"""Effects that the kernel does not simulate, with their estimated influence."""

from math import exp

from pyworm.planning.effects.effect import Effect, Influence
from pyworm.planning.prediction import Prediction

# ---------------------------------------------------------------------------------------- starvation

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


# ----------------------------------------------------------------------------------------- roughness


def _thickness(prediction: Prediction) -> float:
    """Specific film: minimum film over the composite roughness."""
    return prediction.film_min / prediction.scene.composite_roughness


def _by_roughness(prediction: Prediction) -> Influence:
    # Patir and Cheng (1978), isotropic: the pressure flow factor's 1 - 0.9 exp(-0.56 h/sigma)
    change = 0.9 * exp(-0.56 * _thickness(prediction))
    return Influence(change, change, change)


ROUGHNESS = Effect(
    name="roughness",
    symbol="h / sigma",
    source="Patir and Cheng (1978), pressure flow factor of isotropic surfaces",
    indicator=_thickness,
    influence=_by_roughness,
    without=None,
    lacking=lambda scene: "roughness not given" if scene.composite_roughness is None else None,
)
