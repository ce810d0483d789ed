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


def figures_scatter(samples: Sequence[dict[str, float]]) -> dict[str, float]:
    """Uncertainty of each figure by those of samples."""
    return {
        name: float(uncertainty_of_mean([sample[name] for sample in samples]))
        for name in samples[0]
    }
