"""Films of one contact by every formula, and their reduction by heating of the inlet."""

from collections.abc import Callable
from functools import partial

from pyworm.formulas import film, thermal_reduction
from pyworm.formulas.film import Film, LineGroups, PointGroups
from pyworm.formulas.film_ranges import FORMULA_RANGES
from pyworm.io.present import present
from pyworm.io.quantities import QUANTITIES
from pyworm.planning.prediction import Prediction, predicted
from pyworm.ratings.rating import FILM_COLUMNS, RatedFigure, Rating
from pyworm.scene.index import ContactIndex
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.neglected_effects import NeglectedEffects
from pyworm.solver.solution import Solution

_POINT = {
    "hamrock_dowson": ("Hamrock and Dowson 1977", film.hamrock_dowson),
    "chittenden": ("Chittenden et al. 1985", film.chittenden),
    "nijenbanning_venner_moes": (
        "Nijenbanning, Venner and Moes 1994",
        film.nijenbanning_venner_moes,
    ),
    "masjedi_khonsari": ("Masjedi and Khonsari 2015", film.masjedi_khonsari),
}

_LINE = {
    "dowson_higginson": ("Dowson and Higginson 1968", film.dowson_higginson),
    "dowson_toyoda": ("Dowson and Toyoda 1979", film.dowson_toyoda),
    "moes": ("Moes 2000", film.moes_line),
}

MOST_SLIDING = 2.0
"""Slide-roll ratio up to which the formulas for heating of the inlet hold."""


def _formulas(groups: PointGroups | LineGroups) -> dict[str, tuple[str, Callable[[], Film]]]:
    """Formulas for a contact by name, each with its label and what computes the film."""
    if isinstance(groups, LineGroups):
        return {key: (label, partial(formula, groups)) for key, (label, formula) in _LINE.items()}
    return {key: (label, partial(formula, groups)) for key, (label, formula) in _POINT.items()}


def rate_films(scene: Scene | LineScene, solution: Solution | None = None) -> Rating:
    """Every film formula at a contact, side by side with the simulated film."""
    prediction = predicted(scene)
    formulas = _formulas(prediction.groups)
    objections = {
        label: FORMULA_RANGES[key].objection(prediction.groups, prediction.regime)
        for key, (label, _) in formulas.items()
    }
    films = {
        key: (label, formula())
        for key, (label, formula) in formulas.items()
        if not objections[label]
    }
    unit = QUANTITIES["film"].shown
    figures = [
        RatedFigure(f"{key}_m", label, _both(film), unit) for key, (label, film) in films.items()
    ]
    if solution is not None:
        found = solution.figures
        simulated = found.film_central.value, found.film_min.value
        figures.append(RatedFigure("simulated_m", "Simulated", simulated, unit))
    least = [float(film.minimum) for _, film in films.values() if film.minimum is not None]
    words = [_groups(prediction), "Formulas: isothermal, smooth, fully supplied."]
    outside = [f"{label} ({reason})" for label, reason in objections.items() if reason]
    if outside:
        words.append(f"Not shown, outside their range: {'; '.join(outside)}.")
    roughness = scene.composite_roughness
    if roughness is not None and least:
        ratios = sorted(film / roughness for film in least)
        span = " to ".join(dict.fromkeys(f"{film:.3g}" for film in (ratios[0], ratios[-1])))
        words.append(
            f"lambda by the minimum film thickness of the formulas: {span} "
            f"(composite roughness {roughness * 1e6:.3g} µm)."
        )
    if scene.oil.heat is not None and prediction.speed > 0:
        words.append(_heated(prediction))
    return Rating(
        key="films",
        title=f"Films by formula at {ContactIndex.of(scene)}",
        source=", ".join(label for label, _ in formulas.values()),
        columns=tuple(FILM_COLUMNS),
        figures=tuple(figures),
        words=tuple(words),
        neglected_effects=NeglectedEffects() if solution is None else solution.neglected_effects,
    )


def _both(found: Film) -> tuple[float | None, float | None]:
    central, minimum = found.central, found.minimum
    return (
        None if central is None else float(central),
        None if minimum is None else float(minimum),
    )


def _groups(prediction: Prediction) -> str:
    groups, regime = prediction.groups, prediction.regime
    sentence = f"Moes' M = {groups.moes_m:.3g}, L = {groups.moes_l:.3g}"
    if isinstance(groups, PointGroups):
        sentence += f", ellipticity k = {groups.ellipticity:.3g} across over along the entrainment"
    return f"{sentence}; {regime.words}."


def _heated(prediction: Prediction) -> str:
    """Fraction of the film left by shear heating of the inlet; Hsu and Lee's formula is for lines only."""
    groups = prediction.groups
    loading = thermal_reduction.thermal_loading(
        prediction.oil.viscosity.eta0,
        prediction.inlet_beta,
        prediction.speed,
        present(prediction.oil.heat, "oil.heat").conductivity,
    )
    sliding = prediction.sliding / prediction.speed
    ratio = min(sliding, MOST_SLIDING)
    left = {"Wilson and Sheu": thermal_reduction.wilson_sheu(loading, ratio)}
    pressed = prediction.pressure_max / prediction.scene.reduced_modulus
    if 13.2 * pressed * loading**0.42 < 1:  # beyond it his formula ends
        left["Gupta"] = thermal_reduction.gupta(loading, ratio, pressed)
    if isinstance(groups, LineGroups):
        left["Hsu and Lee"] = thermal_reduction.hsu_lee(
            loading, ratio, groups.material, groups.load
        )
    fractions = ", ".join(f"{fraction:.2g} ({source})" for source, fraction in left.items())
    beyond = f", beyond {MOST_SLIDING:g} and taken as that" if sliding > MOST_SLIDING else ""
    return (
        f"Heating of the inlet (loading L = {loading:.2g}, slide-roll ratio {sliding:.2g}{beyond}) leaves of "
        f"the film: {fractions}."
    )
