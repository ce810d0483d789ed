"""The undeformed gap as an array: measured, or computed by another program."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import scipy

from pyworm.formulas.arrays import Array, Flags
from pyworm.io import units
from pyworm.io.given import Given, in_si
from pyworm.scene.contact import as_arrays

MIN_SAMPLES = 5
"""Fewest samples along each side: a cubic spline and the second differences of the filling need them."""

FIT_FRACTION = 0.1
"""Half side of the window in which the radii are fitted, as a fraction of the array's side."""

OFF_CENTRE = 0.25
"""Distance of the least gap from the contact point beyond which a gap is refused, in half sides of the window
in which the radii are fitted."""

MIN_CURVATURE_RATIO = 1e-3
"""Curvature along the flatter direction is taken as at least this fraction of the other one, so that a
straight roller has radii too; they only set the scale of the contact."""


@dataclass(frozen=True, repr=False)
class SampledGap:
    """An undeformed gap between samples and a little beyond them.

    The gap is a cubic spline between the samples, the surface of least second differences where a body is
    missing (NaN), and outside the array its least-squares quadratic, shifted to be continuous at the edge.

    Raises:
        ValueError: If the array has another shape, is too small or empty, does not increase or lacks the
            contact point.
    """

    x: Array
    """Evenly or unevenly spaced, increasing coordinates [m]; the contact point is at x = y = 0."""
    y: Array
    """Evenly or unevenly spaced, increasing coordinates across [m]."""
    gap: Array
    """Undeformed gap [m], shape (y, x); NaN where a body is missing."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI

        def __init__(self, x: Given, y: Given, gap: Given) -> None: ...

    def __post_init__(self) -> None:
        """Refuse an array that is no gap over x and y."""
        for name in ("x", "y", "gap"):
            given = in_si(name, getattr(self, name), units.Offset)
            object.__setattr__(self, name, np.asarray(given, dtype=float))
        if self.gap.ndim != 2:
            raise ValueError(f"gap must have two dimensions (y, x), not {self.gap.ndim}")
        if self.gap.shape != (self.y.size, self.x.size):
            raise ValueError(
                f"gap has the shape {self.gap.shape}, but y and x have {self.y.size} and "
                f"{self.x.size} entries"
            )
        if min(self.gap.shape) < MIN_SAMPLES:
            raise ValueError(
                f"gap has the shape {self.gap.shape}; at least {MIN_SAMPLES} samples a side are needed"
            )
        for name, axis in (("x", self.x), ("y", self.y)):
            if not (np.all(np.isfinite(axis)) and np.all(np.diff(axis) > 0)):
                raise ValueError(f"{name} must increase from sample to sample")
            if not axis[0] < 0 < axis[-1]:
                raise ValueError(
                    f"{name} runs from {axis[0]:g} to {axis[-1]:g} m and must have the contact point, "
                    f"{name} = 0, inside"
                )
        if np.any(np.isinf(self.gap)):
            raise ValueError("gap must be finite, or NaN where a body is missing")
        if not self._covered(np.zeros(1), np.zeros(1)).all():
            raise ValueError("gap must be a number at the contact point x = y = 0")
        for name, place, reach in zip("xy", self._closest, self._half_window, strict=True):
            if abs(place) > OFF_CENTRE * reach:
                raise ValueError(
                    f"gap is least near {name} = {place:.3g} m, not at the contact point x = y = 0; "
                    f"shift the coordinates by that ({name}0 in an npz file)"
                )

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, SampledGap):
            return NotImplemented
        return all(
            np.array_equal(first, second, equal_nan=True)
            for first, second in zip(self._arrays, other._arrays, strict=True)
        )

    def __hash__(self) -> int:
        return hash(tuple(array.tobytes() for array in self._arrays))

    @property
    def _arrays(self) -> tuple[Array, Array, Array]:
        return self.x, self.y, self.gap

    def __repr__(self) -> str:
        ny, nx = self.gap.shape
        return f"<SampledGap of {nx} x {ny} heights, radii {self.radii[0]:.4g} and {self.radii[1]:.4g} m>"

    def __call__(self, x: Given, y: Given) -> tuple[Array, Flags]:
        """Gap [m] at (x, y) [m], zero at the contact point, and where both bodies exist."""
        x, y = as_arrays(x, y)
        return self._height(x, y) - self._datum, self._covered(x, y)

    def _height(self, x: Array, y: Array) -> Array:
        inside_x = np.clip(x, self.x[0], self.x[-1])
        inside_y = np.clip(y, self.y[0], self.y[-1])
        height: Array = self._rest.ev(inside_y, inside_x) + self._quadratic(x, y)
        return height

    @cached_property
    def _datum(self) -> float:
        """Value of the array at the contact point [m]; a constant only shifts the bodies."""
        return float(self._height(np.zeros(1), np.zeros(1))[0])

    @cached_property
    def radii(self) -> tuple[float, float]:
        """Relative radii of curvature along x and y near the contact point [m].

        Raises:
            ValueError: The gap opens in neither direction.
        """
        curvatures = self._curvatures
        return 1 / curvatures[0], 1 / curvatures[1]

    @cached_property
    def _half_window(self) -> tuple[float, float]:
        """Half sides of the rectangle about the contact point in which curvatures are fitted [m]."""
        return tuple(
            max(FIT_FRACTION * np.ptp(axis), 2.5 * np.diff(axis).max()) for axis in (self.x, self.y)
        )

    @cached_property
    def _near_fit(self) -> Array:
        """Coefficients of the least-squares quadratic through the samples near the contact point."""
        near_x, near_y = (
            np.abs(axis) <= half
            for axis, half in zip((self.x, self.y), self._half_window, strict=True)
        )
        return _fit_quadratic(
            self.x, self.y, np.where(near_x[None, :] & near_y[:, None], self.gap, np.nan)
        )

    @cached_property
    def _curvatures(self) -> tuple[float, float]:
        """Relative curvatures along x and y near the contact point [1/m], none flatter than FLATTEST."""
        curvatures = [2 * float(self._near_fit[term]) for term in (3, 5)]
        if max(curvatures) <= 0:
            raise ValueError("gap must open away from the contact point x = y = 0")
        floor = MIN_CURVATURE_RATIO * max(curvatures)
        return max(curvatures[0], floor), max(curvatures[1], floor)

    @property
    def _closest(self) -> tuple[float, float]:
        """Place of the least gap along x and y [m], by slope over curvature at the contact point."""
        x, y = (
            -float(slope) / curvature
            for slope, curvature in zip(self._near_fit[1:3], self._curvatures, strict=True)
        )
        return x, y

    def _covered(self, x: Array, y: Array) -> Flags:
        inside = (self.x[0] <= x) & (x <= self.x[-1]) & (self.y[0] <= y) & (y <= self.y[-1])
        row = np.clip(np.searchsorted(self.y, y, side="right") - 1, 0, self.y.size - 2)
        column = np.clip(np.searchsorted(self.x, x, side="right") - 1, 0, self.x.size - 2)
        covered: Flags = inside & self._covered_cells[row, column]
        return covered

    @cached_property
    def _covered_cells(self) -> Flags:
        """Cells whose four corners are known; by the nearest sample alone edges would be too wide."""
        known = np.isfinite(self.gap)
        covered_cells: Flags = known[1:, 1:] & known[1:, :-1] & known[:-1, 1:] & known[:-1, :-1]
        return covered_cells

    def _quadratic(self, x: Array, y: Array) -> Array:
        terms = _quadratic_terms(x, y)
        quadratic: Array = sum(c * term for c, term in zip(self._coefficients, terms, strict=True))
        return quadratic

    @cached_property
    def _coefficients(self) -> Array:
        return _fit_quadratic(self.x, self.y, self.gap)

    @cached_property
    def _rest(self) -> "scipy.interpolate.RectBivariateSpline":
        """Spline through the residual of the quadratic, filled where a body is missing [m]."""
        rest = self.gap - self._quadratic(self.x[None, :], self.y[:, None])
        return scipy.interpolate.RectBivariateSpline(self.y, self.x, _fill(rest))


def _quadratic_terms(x: Array, y: Array) -> tuple[Array, ...]:
    x, y = np.broadcast_arrays(x, y)
    return np.ones(x.shape), x, y, x**2, x * y, y**2


def _fit_quadratic(x: Array, y: Array, gap: Array) -> Array:
    """Coefficients of 1, x, y, x^2, xy, y^2 by least squares over the finite samples."""
    known = np.isfinite(gap)
    terms = [term[known] for term in _quadratic_terms(x[None, :], y[:, None])]
    # Scaled columns: in metres the quadratic ones would be lost beside the constant.
    scales = [np.abs(term).max() or 1.0 for term in terms]
    matrix = np.column_stack([term / scale for term, scale in zip(terms, scales, strict=True)])
    fit_quadratic: Array = np.linalg.lstsq(matrix, gap[known], rcond=None)[0] / scales
    return fit_quadratic


def _fill(values: Array) -> Array:
    """Replace NaN so that the sum of the squared second differences is least."""
    unknown = ~np.isfinite(values).ravel()
    if not unknown.any():
        return values
    ny, nx = values.shape
    bend_x, bend_y = (
        scipy.sparse.diags_array([1.0, -2.0, 1.0], offsets=[0, 1, 2], shape=(count - 2, count))
        for count in (nx, ny)
    )
    slope_x, slope_y = (
        scipy.sparse.diags_array([-1.0, 1.0], offsets=[0, 1], shape=(count - 1, count))
        for count in (nx, ny)
    )
    differences = scipy.sparse.vstack(
        [
            scipy.sparse.kron(scipy.sparse.eye_array(ny), bend_x),
            scipy.sparse.kron(bend_y, scipy.sparse.eye_array(nx)),
            np.sqrt(2) * scipy.sparse.kron(slope_y, slope_x),
        ]
    ).tocsc()
    filled = np.where(unknown, 0.0, values.ravel())
    free = differences[:, unknown]
    filled[unknown] = scipy.sparse.linalg.spsolve(
        (free.T @ free).tocsc(), -free.T @ (differences @ filled)
    )
    return filled.reshape(values.shape)
