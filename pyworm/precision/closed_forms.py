"""The cheapest models: formulas for a contact, with their processor time."""

from collections.abc import Callable
from time import process_time

import numpy as np

from pyworm.planning.prediction import predicted
from pyworm.precision.grid_series import Point
from pyworm.scene.film_formulas import films_by_formula
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

PREDICTION = "estimate of plans"
"""Friction and temperature by which plans judge effects (`pyworm.planning.prediction`)."""

REPEATS = 20
"""Number of evaluations of a formula over which its cost is averaged."""


def closed_forms(scene: Scene | LineScene) -> dict[str, Point]:
    """Every formula for films of the scene's kind, and the estimate of friction and temperature."""
    points = {}
    for name, films_of in films_by_formula(scene).items():
        found, seconds = _timed(films_of)
        films = {"film_min": found.minimum, "film_central": found.central}
        points[name] = Point(
            (),
            seconds,
            0.0,
            {key: float(thickness) for key, thickness in films.items() if thickness is not None},
        )
    if scene.oil.flow is not None or scene.oil.heat is not None:
        figures, seconds = _timed(lambda: _estimate(scene))
        points[PREDICTION] = Point((), seconds, 0.0, figures)
    return points


def _estimate(scene: Scene | LineScene) -> dict[str, float]:
    prediction = predicted(scene)
    figures = {"friction_coefficient": prediction.hot_stress() / prediction.pressure_mean}
    if scene.oil.heat is not None:
        figures["temperature_max_film"] = prediction.warmest
    return figures


def _timed(work: Callable[[], object]) -> tuple:
    """The result of a function, and its processor time [s]."""
    started = process_time()
    for _ in range(REPEATS):
        with np.errstate(all="ignore"):  # a formula far outside its range may overflow
            found = work()
    return found, (process_time() - started) / REPEATS
