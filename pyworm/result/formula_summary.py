"""Films by a formula as one object, as solutions have them."""

from dataclasses import asdict
from math import inf
from typing import Any

from pyworm.formulas.film import moes_line
from pyworm.formulas.lubrication import lubrication
from pyworm.planning.plan import Plan
from pyworm.scene.formula_film import FormulaFilms, film_of
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.scales import line_scales
from pyworm.solver import neglected_effects

LINE_FORMULA, POINT_FORMULA = "Moes (line)", "atlas"


def formula_summary(
    scene: Scene | LineScene, plan: Plan, films: FormulaFilms | None = None
) -> dict[str, Any]:
    """The films of a scene by formula as one object, units in the keys, as of `Solution.summary`.

    Errors are relative; infinite outside the box of the atlas, and of line contacts, whose formula has none.
    The plan gives the accuracy from which neglected effects are reported. ValueError without entrainment at
    the contact point.
    """
    if isinstance(scene, LineScene):
        found = _line_films(scene)
    else:
        found = _point_films(films or film_of(scene))
    roughness = scene.composite_roughness
    known: dict[str, Any] = {"lubrication": lubrication(None, None)}
    if roughness is not None:
        ratios = [found[key] / roughness for key in ("film_central_m", "film_min_m")]
        known = {
            "composite_roughness_m": roughness,
            "specific_film": ratios[1],
            "specific_film_error": found["film_min_error"],
            "lambda_central": ratios[0],
            "lubrication": lubrication(*ratios),
        }
    return {
        "name": scene.name,
        **asdict(ContactIndex.of(scene)),
        **found,
        **known,
        "left_out": neglected_effects.expected(scene, plan).influence,
    }


def _point_films(found: FormulaFilms) -> dict[str, Any]:
    return {
        "kind": "point",
        "formula": POINT_FORMULA,
        "film_central_m": float(found.central),
        "film_central_error": float(found.central_error),
        "film_min_m": float(found.minimum),
        "film_min_error": float(found.minimum_error),
        "inside_atlas": bool(found.inside),
        **found.single_regime().summary(),
        "moes_M": float(found.groups.moes_m),
        "moes_L": float(found.groups.moes_l),
    }


def _line_films(scene: LineScene) -> dict[str, Any]:
    size = line_scales(scene)
    groups = size.groups
    found = moes_line(groups)
    return {
        "kind": "line",
        "formula": LINE_FORMULA,
        "film_central_m": found.central_number,
        "film_central_error": inf,
        "film_min_m": found.minimum_number,
        "film_min_error": inf,
        "inside_atlas": False,
        **size.regime.summary(),
        "moes_M": float(groups.moes_m),
        "moes_L": float(groups.moes_l),
    }
