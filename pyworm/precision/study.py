"""A work-precision study: its curves, their reference, the cheapest model for an accuracy."""

from dataclasses import dataclass

from pyworm.precision.extrapolation import Limit
from pyworm.precision.grid_series import Point

TARGETS = (0.1, 0.05, 0.01, 0.001)
"""Accuracies for which the cheapest model and grid are listed."""


@dataclass(frozen=True)
class Curve:
    """Figures of one model, formula or numerical parameter at rising cost."""

    name: str
    """Name in tables and pictures."""
    kind: str
    """Kind of curve: "formula", "model" or "parameter"."""
    points: tuple[Point, ...]
    """Points of increasing cost; those of a model on grids of halving spacing."""
    limits: dict[str, Limit]
    """Figure -> its limit on finer grids; for models only."""


@dataclass(frozen=True)
class Reference:
    """Reference value of a figure, for its errors."""

    value: float
    """Value of the most complete model on an infinitely fine grid in an infinite window, in its unit."""
    size: float
    """Reference of relative errors, in the same unit."""
    band: float
    """Uncertainty of the value, relative to the size [-]."""


@dataclass(frozen=True)
class Study:
    """The data of a work-precision picture."""

    scene_name: str
    """The contact."""
    inlet_temperature: float | None
    """Temperature from which rises are counted [K]."""
    references: dict[str, Reference]
    """Figure -> reference."""
    curves: tuple[Curve, ...]
    """Curves of formulas, models from the simplest to the most complete, numerical parameters."""
    omitted: tuple[str, ...]
    """Models and grids that are not shown, each with the reason."""
    seconds: float
    """Time of the study [s]."""

    def error(self, point: Point, figure: str) -> float | None:
        """Relative error of a figure; None where the point has none."""
        return self._error(point.figures, figure)

    def limit_error(self, point: Point, figure: str) -> float | None:
        """Relative error of a figure extrapolated from the point and the one before; None where it is not."""
        return self._error(point.limits, figure)

    def _error(self, figures: dict[str, float], figure: str) -> float | None:
        if figure not in figures:
            return None
        reference = self.references[figure]
        return abs(figures[figure] - reference.value) / reference.size

    def model_error(self, curve: Curve, figure: str) -> float | None:
        """The error of a model on an infinitely fine grid, the plateau of its curve."""
        if figure not in curve.limits:
            return None
        reference = self.references[figure]
        return abs(curve.limits[figure].value - reference.value) / reference.size

    def grid_error(self, curve: Curve, point: Point, figure: str) -> float | None:
        """The discretisation error of a point."""
        if figure not in curve.limits:
            return None
        away = abs(point.figures[figure] - curve.limits[figure].value)
        return away / self.references[figure].size

    def cheapest(self, accuracy: float, figures: tuple[str, ...]) -> tuple[Curve, Point] | None:
        """The cheapest model and grid whose figures are within an accuracy, there and on finer grids.

        The reference's own uncertainty counts as an error.
        """
        found: list[tuple[Curve, Point]] = []
        for curve in self.curves:
            if curve.kind == "parameter":
                continue
            good: Point | None = None
            for point in reversed([point for point in curve.points if point.converged]):
                if not all(self._within(point, figure, accuracy) for figure in figures):
                    break
                good = point
            if good is not None:
                found.append((curve, good))
        return min(found, key=lambda candidate: candidate[1].seconds, default=None)

    def _within(self, point: Point, figure: str, accuracy: float) -> bool:
        error = self.error(point, figure)
        return error is not None and error + self.references[figure].band <= accuracy
