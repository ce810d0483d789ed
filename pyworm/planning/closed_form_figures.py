"""Figures of a contact by closed forms, by the names of solved ones.

They are first estimates, for first steps of a search and for changes of a figure where no solution is near:
films of smooth surfaces by the atlas (point) or by Moes (line), Hertz's pressure, and friction and surface
temperatures of a film that is sheared at the mean pressure (`pyworm.planning.prediction`). Friction and
temperatures are missing where the oil has no flow law or no heat.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from pyworm.io.present import present
from pyworm.planning.prediction import Prediction, predicted
from pyworm.scene.any_contact import AnyContact


def closed_form_figures(scene: AnyContact) -> dict[str, float]:
    """Name of a figure -> its value [SI]; ValueError for a scene that `pyworm.scene.scales` refuses."""
    found = predicted(scene)
    figures = {
        "film_min": found.film_min,
        "film_central": found.film_central,
        "pressure_max": found.pressure_max,
    }
    if scene.oil.flow is not None:
        friction = found.own_hot_stress / found.pressure_mean
        figures |= {
            "friction_coefficient": friction,
            "power_loss": friction * scene.load * found.sliding,
        }
        if scene.oil.heat is not None:
            figures |= _temperatures(found)
    return figures


def _temperatures(found: Prediction) -> dict[str, float]:
    """Largest temperatures of both surfaces and of the film [K]."""
    rise = found.surface_rise(found.heat)
    bodies = [present(body.bulk_temperature, "bulk") + rise for body in found.scene.bodies]
    return {
        "temperature_max_body_1": bodies[0],
        "temperature_max_body_2": bodies[1],
        "temperature_max_film": max(bodies) + found.film_rise(found.heat),
    }


@dataclass(frozen=True)
class ClosedFormChanges:
    """Changes of the figures of a contact by closed forms, where no adjoint solution is known."""

    scene: AnyContact
    """The contact."""

    @cached_property
    def figures(self) -> Mapping[str, float]:
        """Its figures by closed forms [SI]."""
        return closed_form_figures(self.scene)

    def change(self, plus: AnyContact, minus: AnyContact) -> dict[str, float]:
        """Figures of one contact less those of another, both close to this one [SI]."""
        more, less = closed_form_figures(plus), closed_form_figures(minus)
        return {name: more[name] - less[name] for name in self.figures}
