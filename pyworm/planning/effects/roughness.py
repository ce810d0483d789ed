"""Roughness: load shared with asperities, and flow between rough walls."""

from dataclasses import replace
from math import exp

from pyworm.planning.effects.effect import Effect, Influence
from pyworm.planning.prediction import Prediction


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
    without=lambda scene: replace(scene, smooth=True),
    lacking=lambda scene: "roughness not given" if scene.composite_roughness is None else None,
    only_named=True,
)
