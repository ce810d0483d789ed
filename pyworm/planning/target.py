"""The figures to which the accuracy applies."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

FILMS = ("film_min", "film_central")

FIGURES = (*FILMS, "pressure_max")

SHEAR_FIGURES = ("friction_coefficient", "power_loss", "shear_rate_max")

ROUGH_FIGURES = ("asperity_load_fraction", "friction_boundary")

HEAT_FIGURES = ("temperature_max_body_1", "temperature_max_body_2", "temperature_max_film")


@dataclass(frozen=True)
class AccuracyTarget:
    """The figures to which an accuracy applies.

    The largest pressure is never among them: under light loads it is the tip of a spike at the exit, which no
    practicable grid resolves. Nor is the film's largest temperature on the largest grid allowed, where it is
    the tip of a spike (`solver.error_estimate.hot_spike`).
    """

    figures: tuple[str, ...]
    """Names of the figures."""
    warmth: float = 0.0
    """Temperature difference to which errors of temperatures are relative where the rise is smaller [K]."""
    roughness: float = 0.0
    """Composite roughness to which errors of films are relative where the film is thinner [m].

    In mixed lubrication the film is a mean over heights of that size: asperity contact and flow factors are
    functions of film over roughness (Patir and Cheng 1978), and below a film of one roughness a share of the
    film itself says nothing of either. Zero for smooth surfaces."""

    def films(self) -> "AccuracyTarget":
        """The target of both films alone."""
        return replace(self, figures=FILMS)

    def without(self, *names: str) -> "AccuracyTarget":
        """The target without some figures."""
        return replace(self, figures=tuple(other for other in self.figures if other not in names))

    def worst(self, errors: Mapping[str, float], figures: Mapping[str, float]) -> float:
        """Largest relative error of the figures, temperatures given as rises [K]; 0 without any figure.

        Errors of films are relative to the roughness, of temperatures to `warmth`, where these are larger.
        """
        return max(
            (errors[name] * self._weight(name, figures[name]) for name in self.figures), default=0.0
        )

    def _weight(self, name: str, value: float) -> float:
        least = self.roughness * (name in FILMS) + self.warmth * (name in HEAT_FIGURES)
        return 1.0 if abs(value) >= least else abs(value) / least
