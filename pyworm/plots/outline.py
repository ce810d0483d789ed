"""The boundary of the dry contact, to better than the grid."""

import numpy as np


def signed_square(pressure: np.ndarray) -> np.ndarray:
    """Square of the pressure, continued to negative values outside the contact.

    The square of a dry pressure falls to zero linearly, so it is continued linearly by one point
    past the boundary; contours are then free of the steps of the grid. Where the pressure does not
    fall (at the edge of a tooth) the boundary is put half-way to the next point.

    Parameters
    ----------
    pressure : array
        Dry pressure over a regular grid, zero outside the contact [any unit].
    """
    padded = np.pad(np.square(pressure), 2)
    total, count = np.zeros_like(padded), np.zeros_like(padded)
    for axis in (0, 1):
        for step in (1, -1):
            next_in = np.roll(padded, step, axis)
            second_in = np.roll(padded, 2 * step, axis)
            reached = (padded == 0) & (next_in > 0)
            continued = np.where(second_in > next_in, 2 * next_in - second_in, -next_in)
            # The continuation may still be positive where the pressure is not that of a parabola.
            total += np.where(reached, np.minimum(continued, -1e-3 * next_in), 0)
            count += reached
    field = np.where(padded > 0, padded, -padded.max())
    field = np.where(count > 0, total / np.maximum(count, 1), field)
    return field[2:-2, 2:-2]
