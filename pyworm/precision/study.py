"""A work-precision picture in numbers: its lines, what errors are against, the cheapest for an accuracy."""

from dataclasses import dataclass

from pyworm.precision.extrapolation import Limit
from pyworm.precision.grid_series import Point

TARGETS = (0.1, 0.05, 0.01, 0.001)
"""Accuracies for which the cheapest rung and grid are told."""


@dataclass(frozen=True)
class Curve:
    """One line of the picture.

    Attributes
    ----------
    name : str
        What it is called.
    kind : str
        "formula", "rung" or "knob".
    points : tuple of Point
        Dearer and dearer; of a rung on grids of halving spacing.
    limits : dict
        Figure -> where it goes on finer grids; of rungs only.
    """

    name: str
    kind: str
    points: tuple[Point, ...]
    limits: dict[str, Limit]


@dataclass(frozen=True)
class Reference:
    """What errors of a figure are against.

    Attributes
    ----------
    value : float
        The most complete rung's on an infinitely fine grid in an infinitely wide window, in its unit.
    size : float
        What errors are relative to, in the same unit.
    band : float
        How far the value may be off, relative to the size [-].
    """

    value: float
    size: float
    band: float


@dataclass(frozen=True)
class Study:
    """A work-precision picture in numbers.

    Attributes
    ----------
    scene_name : str
        The contact.
    inlet_temperature : float or None
        What temperatures count from [K].
    references : dict
        Figure -> reference.
    curves : tuple of Curve
        Formulas, rungs from the simplest to the most complete, knobs.
    left_out : tuple of str
        What is not shown, and why.
    seconds : float
        Time of it all [s].
    """

    scene_name: str
    inlet_temperature: float | None
    references: dict[str, Reference]
    curves: tuple[Curve, ...]
    left_out: tuple[str, ...]
    seconds: float

    def error(self, point: Point, figure: str) -> float | None:
        """Relative error of a figure; None where the point has none."""
        if figure not in point.figures:
            return None
        reference = self.references[figure]
        return abs(point.figures[figure] - reference.value) / reference.size

    def model_error(self, curve: Curve, figure: str) -> float | None:
        """What is left of a rung's error on an infinitely fine grid: its plateau."""
        if figure not in curve.limits:
            return None
        reference = self.references[figure]
        return abs(curve.limits[figure].value - reference.value) / reference.size

    def grid_error(self, curve: Curve, point: Point, figure: str) -> float | None:
        """The part of an error that finer grids take away."""
        if figure not in curve.limits:
            return None
        away = abs(point.figures[figure] - curve.limits[figure].value)
        return away / self.references[figure].size

    def cheapest(self, accuracy: float, figures: tuple[str, ...]) -> tuple[Curve, Point] | None:
        """The cheapest rung and grid with all figures within an accuracy, there and on its finer grids.

        The reference's own uncertainty counts as an error.
        """
        found: list[tuple[Curve, Point]] = []
        for curve in self.curves:
            if curve.kind == "knob":
                continue
            good: Point | None = None
            for point in reversed([point for point in curve.points if point.settled]):
                if not all(self._within(point, figure, accuracy) for figure in figures):
                    break
                good = point
            if good is not None:
                found.append((curve, good))
        return min(found, key=lambda one: one[1].seconds, default=None)

    def _within(self, point: Point, figure: str, accuracy: float) -> bool:
        error = self.error(point, figure)
        return error is not None and error + self.references[figure].band <= accuracy
