"""Roughness: load shared with asperities, and flow between rough walls."""

from dataclasses import replace
from math import exp

import numpy as np

from pyworm.io.present import present
from pyworm.materials.rough_surfaces import GapCurves
from pyworm.planning.effects.effect import Effect, Influence
from pyworm.planning.prediction import Prediction
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.waves import waves_in_gap

OF_FLOW = 0.5
"""Change of a film, thicker than the roughness, over that of its flow by the factors of rough walls; the
inlet feels a part of it, more where asperities carry load."""


def _curves(scene: AnyContact) -> GapCurves:
    return present(scene.rough_pair, "roughness").curves()


def _thickness(prediction: Prediction) -> float:
    """Specific film: minimum film over the composite roughness."""
    return prediction.film_min / present(prediction.scene.composite_roughness, "roughness")


def _by_roughness(prediction: Prediction) -> Influence:
    film = min(_of_film(prediction), 1.0)
    friction = film + _of_boundary_friction(prediction)
    return Influence(film, friction, friction * prediction.warmth)


def _of_film(prediction: Prediction) -> float:
    """Relative change of the film, by the flow factors at the least film and by long waves in the gap."""
    flow, shear = _curves(prediction.scene).at_thickness(prediction.film_min)[3:].reshape(2, 3)
    by_pressure = float(np.abs(1 - flow[:2]).max())
    dragged = float(np.abs(shear[:2]).max()) / prediction.film_min
    by_shear = dragged * prediction.sliding / (2 * prediction.speed)
    of_flow = OF_FLOW + (1 - OF_FLOW) * exp(-_thickness(prediction))
    return (by_pressure + by_shear) * of_flow + waves_in_gap(prediction.scene) / prediction.film_min


def _of_boundary_friction(prediction: Prediction) -> float:
    """Relative change of the friction, by the asperities' pressure at the central film."""
    if not prediction.sliding > 0:
        return 0.0
    scene = prediction.scene
    borne = exp(_curves(scene).at_thickness(prediction.film_central)[0])
    share = min(borne / prediction.pressure_mean, 1.0)
    fluid = prediction.heat / (prediction.sliding * prediction.pressure_mean)
    boundary = share * scene.boundary_friction
    return share * abs(scene.boundary_friction - fluid) / (boundary + (1 - share) * fluid)


ROUGHNESS = Effect(
    name="roughness",
    symbol="h / sigma",
    source="Patir and Cheng (1978), Tripp (1983): flow between rough walls; elastic asperities",
    indicator=_thickness,
    influence=_by_roughness,
    without=lambda scene: scene if scene.smooth else replace(scene, smooth=True),
    lacking=lambda scene: "roughness not given" if scene.composite_roughness is None else None,
)
