"""A flank of a drive in space, for pictures."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Shape:
    """A flank that turns about an axis, with its likes around that.

    Attributes
    ----------
    body : int
        Which body of the contact has it, 1 or 2.
    axis_point, axis : numpy.ndarray
        A point of the axis [m] and its direction, in the axes of the drive, (3,).
    surface : numpy.ndarray
        Points of the flank before any turn [m], NaN where it ends, (rows, columns, 3).
    turns : numpy.ndarray
        Turn about the axis at each of some phases, right-handed [rad], (phases,).
    copies : tuple of float
        Further turns at which the same flank stands again [rad].
    face, radius : numpy.ndarray or None
        Places of these points on the flank as fields know them, along the face from its middle and from the
        axis [m], (rows, columns); None of a flank that fields do not know.
    """

    body: int
    axis_point: np.ndarray
    axis: np.ndarray
    surface: np.ndarray
    turns: np.ndarray
    copies: tuple[float, ...] = ()
    face: np.ndarray | None = None
    radius: np.ndarray | None = None
