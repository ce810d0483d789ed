"""Formulas for films of a scene's kind of contact, by name."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from pyworm.formulas import film
from pyworm.formulas.film import Film
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


def films_by_formula(scene: Scene | LineScene) -> dict[str, Callable[[], Film | FormulaFilms]]:
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
