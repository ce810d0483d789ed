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

    def without(self, *names: str) -> "AccuracyTarget":
        """The target without some figures."""
        return replace(self, figures=tuple(other for other in self.figures if other not in names))

    def worst(self, errors: Mapping[str, float], figures: Mapping[str, float]) -> float:
        """Largest relative error of the figures, temperatures given as rises [K]; 0 without any figure."""
        return max(
            (errors[name] * self._weight(name, figures[name]) for name in self.figures), default=0.0
        )

    def _weight(self, name: str, value: float) -> float:
        if name not in HEAT_FIGURES or abs(value) >= self.warmth:
            return 1.0
        return abs(value) / self.warmth
