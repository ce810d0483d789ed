"""Gaussian filter of profiles and areas (ISO 16610-21, -61), by which half of a wave of its index passes."""

from collections.abc import Sequence
from math import log, pi, sqrt

import numpy as np
import scipy

from pyworm.formulas.arrays import Array

ALPHA = sqrt(log(2) / pi)
"""Constant of the weights exp(-pi (x/(ALPHA index))^2): 50 % of a wave as long as the nesting index pass."""

HALF_WIDTH_RATIO = 1.2
"""Half width of the weights over the nesting index: beyond, they are below 1e-8 of the largest."""


def smoothed(
    heights: Array, steps: Sequence[float], axes: tuple[int, ...], *, periodic: bool
) -> Array:
    """Long waves of heights by nesting indices over the distance of points along each axis.

    Near the ends of what is not periodic the weights are those within it (ISO 16610-28).
    """
    for axis, index in zip(axes, steps, strict=True):
        reach = int(np.ceil(HALF_WIDTH_RATIO * index))
        places = np.arange(-reach, reach + 1) / (ALPHA * index)
        weights = np.exp(-pi * places**2)
        weights /= weights.sum()
        if periodic:
            heights = scipy.ndimage.convolve1d(heights, weights, axis=axis, mode="wrap")
            continue
        line = _within(np.ones(heights.shape[axis]), weights, 0)
        others = [direction for direction in range(heights.ndim) if direction != axis]
        heights = _within(heights, weights, axis) / np.expand_dims(line, others)
    return heights


def _within(values: Array, weights: Array, axis: int) -> Array:
    """Sums of values by weights about each point along an axis, of those within alone."""
    shape = [len(weights) if direction == axis else 1 for direction in range(values.ndim)]
    whole = scipy.signal.oaconvolve(values, weights.reshape(shape), axes=axis)
    reach = len(weights) // 2
    summed: Array = whole.take(range(reach, reach + values.shape[axis]), axis=axis)
    return summed
