"""Uncertainty of figures of a surface by its place: other places of the same flank would show others."""

from collections.abc import Sequence

import numpy as np
import scipy

from pyworm.formulas.arrays import Array

CONFIDENCE = 0.95
"""Probability with which the mean of many places lies within the uncertainty."""


def uncertainty_of_mean(values: Sequence[Array] | Sequence[float]) -> Array:
    """Half width of the confidence interval of the mean of independent samples, by Student's t."""
    count = len(values)
    factor = scipy.stats.t.ppf((1 + CONFIDENCE) / 2, count - 1)
    found: Array = factor * np.std(values, axis=0, ddof=1) / np.sqrt(count)
    return found


def uncertainty_of_whole(values: Sequence[Array] | Sequence[float], whole: Array | float) -> Array:
    """Uncertainty of what a whole shows, by its n parts: that of their mean, and the bias of the whole.

    A part is n times shorter and, to first order, n times as far from a surface without end; from the whole
    it is n - 1 times as far as the whole from that surface (M. H. Quenouille, Biometrika 43 (1956) 353).
    """
    bias = np.abs(np.mean(values, axis=0) - whole) / (len(values) - 1)
    found: Array = uncertainty_of_mean(values) + bias
    return found


def figures_scatter(
    samples: Sequence[dict[str, float]], whole: dict[str, float]
) -> dict[str, float]:
    """Uncertainty of each figure of a whole by those of its parts."""
    return {
        name: float(uncertainty_of_whole([sample[name] for sample in samples], whole[name]))
        for name in samples[0]
    }
