"""What weighted least squares say of a fit: uncertainties, correlations, what the data do not determine.

All from the sensitivities J of the fitted values to the unknowns and the weights W, the reciprocal squares of
the standard uncertainties of the measurements: the covariance of the unknowns is (J^T W J)^-1. Where the
residuals scatter more than these uncertainties say it is enlarged by chi squared over the degrees of freedom,
the Birge ratio squared; it is never reduced by less scatter.

Source: G. A. F. Seber and C. J. Wild, Nonlinear Regression, Wiley 1989, sections 2.1 and 5.1; for the
enlargement R. T. Birge, Phys. Rev. 40 (1932) 207-227.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy

from pyworm.formulas.arrays import Array, Flags

CONFIDENCE = 0.95
"""Probability of the intervals."""

LARGEST_CONDITION = 1e8
"""Largest over smallest singular value from which an unknown has no bound at all."""

UNDETERMINED = 0.5
"""Relative standard uncertainty from which a combination of unknowns counts as not determined: its 95 %
interval then reaches to zero."""

SMALLEST_EXPONENT = 0.1
"""Exponent in a power product below which an unknown has no part worth a word."""


@dataclass(frozen=True)
class LeastSquares:
    """A fit of unknowns to measurements."""

    values: Array
    """The unknowns, (unknowns)."""
    sensitivity: Array
    """Change of each fitted value with each unknown, (measurements, unknowns)."""
    residuals: Array
    """Measured less fitted values, (measurements)."""
    uncertainties: Array
    """Standard uncertainties of the measurements, (measurements)."""
    fixed: tuple[bool, ...] = ()
    """Which unknowns are held at a bound and have no share in the uncertainties; by default none."""

    @property
    def _free(self) -> Flags:
        return ~np.array(self.fixed or [False] * len(self.values))

    @property
    def degrees(self) -> int:
        """Degrees of freedom: measurements less unknowns that are not held at a bound."""
        return len(self.residuals) - int(self._free.sum())

    @property
    def chi_squared(self) -> float:
        """Sum of the squares of the residuals over their standard uncertainties."""
        return float(np.sum(np.square(self.residuals / self.uncertainties)))

    @property
    def enlargement(self) -> float:
        """Factor on the standard uncertainties by the scatter of the residuals, 1 or more."""
        return float(np.sqrt(max(1.0, self.chi_squared / max(self.degrees, 1))))

    @cached_property
    def _singular(self) -> tuple[Array, Array]:
        """Singular values of the weighted sensitivity to relative changes, and the directions, a row each."""
        scaled = self.sensitivity * self.values / self.uncertainties[:, None]
        _, values, directions = np.linalg.svd(scaled[:, self._free], full_matrices=False)
        return values, directions

    @cached_property
    def covariance(self) -> Array:
        """Covariance of the unknowns, (unknowns, unknowns): 0 at a bound, infinite where not determined."""
        singular, directions = self._singular
        largest = singular.max(initial=0.0)
        seen = singular * LARGEST_CONDITION > largest
        inverse = np.zeros_like(singular)
        np.divide(1.0, singular, out=inverse, where=seen & (singular > 0))
        root = directions.T * inverse
        relative = root @ root.T
        blind = (np.abs(directions[~seen | (singular == 0)]) > SMALLEST_EXPONENT).any(axis=0)
        relative[np.ix_(blind, blind)] = np.where(np.eye(blind.sum()) > 0, np.inf, 0.0)
        whole = np.zeros((len(self.values),) * 2)
        scale = np.outer(self.values[self._free], self.values[self._free])
        whole[np.ix_(self._free, self._free)] = relative * scale * self.enlargement**2
        return whole

    @property
    def standard(self) -> Array:
        """Standard uncertainties of the unknowns, (unknowns)."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def coverage(self) -> float:
        """Half width of a 95 % interval over the standard uncertainty: Student's t."""
        return float(scipy.special.stdtrit(self.degrees, (1 + CONFIDENCE) / 2))

    @property
    def half_widths(self) -> Array:
        """Half widths of the 95 % intervals of the unknowns, (unknowns)."""
        return self.coverage * self.standard

    @property
    def correlation(self) -> Array:
        """Correlations of the unknowns, (unknowns, unknowns): 0 with one at a bound or without one."""
        size = np.outer(self.standard, self.standard)
        found = np.zeros_like(size)
        np.divide(self.covariance, size, out=found, where=np.isfinite(size) & (size > 0))
        np.fill_diagonal(found, 1.0)
        return found

    @property
    def combinations(self) -> tuple["Combination", ...]:
        """Power products of the unknowns by how well the data determine them, the best one first."""
        singular, directions = self._singular
        places = np.flatnonzero(self._free)
        found = []
        for value, direction in zip(singular, directions, strict=True):
            largest = direction[np.argmax(np.abs(direction))]
            exponents = np.zeros(len(self.values))
            exponents[places] = direction / largest
            # the standard uncertainty of a unit step, rescaled to these exponents
            blind = value * LARGEST_CONDITION <= singular.max()
            spread = np.inf if blind else self.enlargement / (value * abs(largest))
            found.append(Combination(tuple(exponents), float(spread)))
        return tuple(found)


@dataclass(frozen=True)
class Combination:
    """A power product of unknowns."""

    exponents: tuple[float, ...]
    """Exponent of each unknown; the largest one is 1."""
    spread: float
    """Relative standard uncertainty by the data [-]."""

    @property
    def determined(self) -> bool:
        """Whether the data determine it."""
        return self.spread < UNDETERMINED

    def words(self, names: Sequence[str]) -> str:
        """The power product in words: "alpha eta0^1.3"."""
        return " ".join(
            name if abs(exponent - 1) < SMALLEST_EXPONENT / 2 else f"{name}^{exponent:.2g}"
            for name, exponent in zip(names, self.exponents, strict=True)
            if abs(exponent) >= SMALLEST_EXPONENT
        )
