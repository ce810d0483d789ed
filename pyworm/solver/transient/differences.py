"""Interpolation in time: weights of a polynomial through the values at some times."""

from collections.abc import Sequence

import numpy as np

from pyworm.formulas.arrays import Array


def weights(times: Sequence[float], time: float) -> tuple[Array, Array]:
    """Weights of values at some times in the polynomial through them and in its rate of change.

    Args:
        times: Times of the values [s].
        time: Time at which the polynomial is wanted [s].

    Returns:
        values, rates: Weights in the value [-] and in the rate of change [1/s].
    """
    since = np.asarray(times, float) - time
    scale = np.abs(since).max() or 1.0
    coefficients = np.linalg.inv(np.vander(since / scale, increasing=True))
    rates = coefficients[1] / scale if len(since) > 1 else np.zeros(1)
    return coefficients[0], rates


DIFFERENCE_SHARE = 0.48
"""Share of the difference through four values in that by which films are integrated."""


def backward_weights(times: Sequence[float]) -> Array:
    """Weights of values at some times, the latest first, in their rate of change at the latest [1/s].

    Of four values those through four and through three, blended (BDF2OPT; Vatsa, Carpenter and Lockard 2010,
    AIAA 2010-122): of second order with half the error of three alone, and stable for all that the oil
    carries. The difference through four is not: waves of six steps a period grow e-fold within twelve steps
    where a step takes the oil through several cells, and a thin film under high pressure filled with them.
    """
    _, rates = weights(times, times[0])
    if len(times) < 4:
        return rates
    _, fewer = weights(times[:3], times[0])
    return DIFFERENCE_SHARE * rates + (1 - DIFFERENCE_SHARE) * np.append(fewer, 0.0)
