"""What of the cells of a grid belongs to a contact, by sampling."""

import numpy as np

SAMPLES = 21
"""Samples along each direction of a cell."""


def shares_of_contact(pressure, fraction=0.01):
    """Share of each cell in which pressure, linear about its node, exceeds a fraction of the largest."""
    slopes = np.gradient(pressure)
    slopes = slopes if isinstance(slopes, (list, tuple)) else [slopes]
    parts = (np.arange(SAMPLES) + 0.5) / SAMPLES - 0.5
    counted = np.zeros(pressure.shape)
    for place in np.stack(np.meshgrid(*[parts] * pressure.ndim), axis=-1).reshape(
        -1, pressure.ndim
    ):
        there = pressure + sum(part * slope for part, slope in zip(place, slopes, strict=True))
        counted += there > fraction * pressure.max()
    return counted / SAMPLES**pressure.ndim
