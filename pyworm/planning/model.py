"""The model of a contact: levels across the film and whether heat is simulated."""

from dataclasses import dataclass

from pyworm.materials.flow_laws import NEWTONIAN
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene


@dataclass(frozen=True)
class Model:
    """Model of a contact: levels across the film, heat.

    Attributes
    ----------
    levels : int
        Levels across the film, walls included; 0 for an isothermal Newtonian film.
    heated : bool
        Whether heat is simulated, in the film and the bodies.
    """

    levels: int = 0
    heated: bool = False


PARABOLA = 3
"""Levels across a film whose temperature is a parabola."""

LEVEL_ERRORS = ((5, 1e-2), (7, 4e-4), (9, 3e-5), (11, 0.0))
"""Levels across the film and the largest relative error of films, friction and largest temperatures by them,
in seven contacts against 13 levels (`benchmarks/accuracy/levels.py`)."""

LEVEL_FRACTION = 0.1
"""Error by the levels allowed, as a fraction of the accuracy asked for."""


def model_for(simple: Scene | LineScene, accuracy: float, on: frozenset[str]) -> Model:
    """The model of a scene that has only the effects that are on."""
    if simple.oil.heat is not None:
        return Model(_levels(accuracy) if "viscosity-across" in on else PARABOLA, heated=True)
    return Model() if simple.oil.flow in (None, NEWTONIAN) else Model(_levels(accuracy))


def _levels(accuracy: float) -> int:
    """Levels across the film whose error is small against an accuracy (`docs/theory/heat.md`)."""
    return next(levels for levels, error in LEVEL_ERRORS if error <= LEVEL_FRACTION * accuracy)
