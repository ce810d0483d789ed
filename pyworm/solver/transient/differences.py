"""Interpolation in time: weights of a polynomial through the values at some times, or near them."""

from collections.abc import Sequence

import numpy as np

from pyworm.scene.contact import Array

DEGREE = 3
"""Highest degree of the polynomials."""


def weights(times: Sequence[float], at: float) -> tuple[Array, Array]:
    """Weights of values at some times in a polynomial and in its rate of change.

    The polynomial goes through up to four values; nearest to more in the sense of least squares.

    Parameters
    ----------
    times : sequence of float
        Times of the values [s].
    at : float
        Time at which the polynomial is wanted [s].

    Returns
    -------
    values, rates : ndarray
        Weights in the value [-] and in the rate of change [1/s].
    """
    since = np.asarray(times, float) - at
    scale = np.abs(since).max() or 1.0
    terms = min(len(since), DEGREE + 1)
    coefficients = np.linalg.pinv(np.vander(since / scale, terms, increasing=True))
    rates = coefficients[1] / scale if terms > 1 else np.zeros(len(since))
    return coefficients[0], rates
