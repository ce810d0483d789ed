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
    square = np.square(pressure)
    padded = np.pad(square, 2)
    total, count = np.zeros_like(square), np.zeros_like(square)
    for axis in (0, 1):
        for step in (1, -1):
            next_in, second_in = (
                np.roll(padded, distance * step, axis)[2:-2, 2:-2] for distance in (1, 2)
            )
            reached = (square == 0) & (next_in > 0)
            first, second = next_in[reached], second_in[reached]
            continued = np.where(second > first, 2 * first - second, -first)
            # The continuation may still be positive where the pressure is not that of a parabola.
            total[reached] += np.minimum(continued, -1e-3 * first)
            count[reached] += 1
    field: np.ndarray = np.where(square > 0, square, -square.max())
    beside = count > 0
    field[beside] = total[beside] / count[beside]
    return field
