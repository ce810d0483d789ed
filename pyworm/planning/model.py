"""The model of a contact: levels across the film and whether heat is simulated."""

from dataclasses import dataclass

from pyworm.materials.flow_laws import NEWTONIAN
from pyworm.planning import error_budget
from pyworm.planning.prediction import Prediction
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


@dataclass(frozen=True)
class Model:
    """Model of a contact: levels across the film, heat."""

    levels: int = 0
    """Levels across the film, walls included; 0 for an isothermal Newtonian film between smooth surfaces."""
    heated: bool = False
    """Whether heat is simulated, in the film and the bodies."""
    level_error: float = 0.0
    """Largest relative error of films, friction and largest temperatures by the number of levels [-]."""
    rough: bool = False
    """Whether the surfaces' roughness is simulated."""


PARABOLA = 3
"""Levels across a film whose temperature is a parabola."""

LEVEL_ERRORS = ((5, 1e-2), (7, 4e-4), (9, 3e-5), (11, 0.0))
"""Levels across the film and the largest relative error of films, friction and largest temperatures by them,
in seven contacts against 13 levels (`benchmarks/accuracy/levels.py`)."""

CALM_ERRORS, CALM_GRAETZ = ((2.5, 1e-3), (3.0, 2e-3), (4.0, 5e-3)), 0.04
"""Largest slide-roll ratio and the largest error by five levels in a heated film, and its largest Graetz
number (the same benchmark): heat is conducted across it much sooner than it is carried through the contact,
so that no layer within the film is much hotter or colder than its neighbours."""


def model_for(
    simple: Scene | LineScene, accuracy: float, on: frozenset[str], prediction: Prediction
) -> Model:
    """The model of a scene that has only the effects that are on."""
    rough = "roughness" in on
    if simple.oil.heat is not None:
        if "viscosity-across" not in on:
            return Model(PARABOLA, heated=True, rough=rough)
        five = (5, _error_by_five(prediction))
        levels, error = _levels(accuracy, (five, *LEVEL_ERRORS[1:]))
        return Model(levels, heated=True, level_error=error, rough=rough)
    if simple.oil.flow in (None, NEWTONIAN):
        # three levels hold the parabola of a Newtonian oil's velocity exactly
        return Model(PARABOLA, rough=True) if rough else Model()
    levels, error = _levels(accuracy, LEVEL_ERRORS)
    return Model(levels, level_error=error, rough=rough)


def _levels(accuracy: float, errors: tuple[tuple[int, float], ...]) -> tuple[int, float]:
    """Levels across the film whose error is small against an accuracy, and that error."""
    return next(entry for entry in errors if entry[1] <= error_budget.PLANNED_LEVELS * accuracy)


def _error_by_five(prediction: Prediction) -> float:
    """Largest relative error by five levels across a heated film."""
    oil = prediction.oil
    carried = (
        oil.density.rho0 * oil.thermal.specific_heat * prediction.speed * prediction.film_central**2
    )
    conducted = oil.thermal.conductivity * prediction.half_width
    if carried > CALM_GRAETZ * conducted:
        return LEVEL_ERRORS[0][1]
    ratio = prediction.sliding / prediction.speed
    return next((error for most, error in CALM_ERRORS if ratio <= most), LEVEL_ERRORS[0][1])
