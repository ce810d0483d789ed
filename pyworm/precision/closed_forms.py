"""The cheapest models: formulas for a contact, with their processor time."""

from collections.abc import Callable
from functools import partial
from time import process_time
from typing import Any

import numpy as np

from pyworm.formulas import film
from pyworm.formulas.film import Film
from pyworm.planning.prediction import predicted
from pyworm.precision.grid_series import Point
from pyworm.scene.formula_film import FormulaFilms, film_of
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.scales import line_scales, scales

POINT_FORMULAS: dict[str, Callable[..., Film]] = {
    "Hamrock-Dowson": film.hamrock_dowson,
    "Chittenden": film.chittenden,
    "Nijenbanning-Venner-Moes": film.nijenbanning_venner_moes,
    "Masjedi-Khonsari": film.masjedi_khonsari,
}

LINE_FORMULAS: dict[str, Callable[..., Film]] = {
    "Moes": film.moes_line,
    "Dowson-Higginson": film.dowson_higginson,
    "Dowson-Toyoda": film.dowson_toyoda,
}

ATLAS = "atlas"
"""The formula of the atlas, for point contacts with entrainment at the contact point."""

PREDICTION = "estimate of plans"
"""Friction and temperature by which plans judge effects (`pyworm.planning.prediction`)."""

REPEATS = 20
"""Number of evaluations of a formula over which its cost is averaged."""


def closed_forms(scene: Scene | LineScene) -> dict[str, Point]:
    """Every formula for films of the scene's kind, and the estimate of friction and temperature."""
    points = {}
    for name, films_of in _films(scene).items():
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


def _films(scene: Scene | LineScene) -> dict[str, Callable[[], Film | FormulaFilms]]:
    """What gives the films of a scene by each formula for its kind, by name."""
    line = isinstance(scene, LineScene)
    groups: Any = (line_scales(scene) if isinstance(scene, LineScene) else scales(scene)).groups
    formulas = LINE_FORMULAS if line else POINT_FORMULAS
    films: dict[str, Callable[[], Film | FormulaFilms]] = {
        name: partial(formula, groups) for name, formula in formulas.items()
    }
    if not isinstance(scene, LineScene) and any(scene.entrainment(np.zeros(()), np.zeros(()))):
        films[ATLAS] = partial(film_of, scene)
    return films


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
