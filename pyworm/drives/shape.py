"""A drive in space, for pictures: flanks that turn, and where they touch."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Shape:
    """A surface that turns about an axis, with its likes around that.

    Attributes
    ----------
    body : int
        Which body of the contact has it, 1 or 2.
    axis_point, axis : numpy.ndarray
        A point of the axis [m] and its direction, in the axes of the drive, (3,).
    surface : numpy.ndarray
        Points of the surface before any turn [m], NaN where it ends, (rows, columns, 3).
    turns : numpy.ndarray
        Turn about the axis at each of some places, right-handed [rad], (places,).
    copies : tuple of float
        Further turns at which the same surface stands again [rad].
    face, radius : numpy.ndarray or None
        Places of these points on the flank as fields know them, along the face from its middle and from the
        axis [m], (rows, columns); None of a surface that fields do not know.
    """

    body: int
    axis_point: np.ndarray
    axis: np.ndarray
    surface: np.ndarray
    turns: np.ndarray
    copies: tuple[float, ...] = ()
    face: np.ndarray | None = None
    radius: np.ndarray | None = None


@dataclass(frozen=True)
class Space:
    """A drive in space at some places.

    Attributes
    ----------
    shapes : tuple of Shape
        Its surfaces.
    view : numpy.ndarray
        Directions to the right, up and towards the eye, in the axes of the drive, (3, 3).
    size : float
        Length that a picture should show [m].
    lines : tuple of numpy.ndarray
        Points of the line of contact at each place [m], in the axes of the drive, (n, 3); none where a flank
        shows the pressure in its place.
    drawn : str
        What is drawn and what is not, a sentence.
    """

    shapes: tuple[Shape, ...]
    view: np.ndarray
    size: float
    drawn: str
    lines: tuple[np.ndarray, ...] = ()
