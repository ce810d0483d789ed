"""Answers of drives: contacts under errors of mounting, set-up of hob and wheel, the drive in space."""

from dataclasses import dataclass

import numpy as np

from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

Row = dict[str, float]
"""A set-up, its contact pattern without load and its contact at mid-mesh; keys end in their unit."""


@dataclass(frozen=True)
class DryContact:
    """A dry contact on the surfaces as they are.

    Attributes
    ----------
    pressure_max : float
        Largest pressure [Pa].
    at_edge : bool
        Whether it rests on an edge, so that film formulas do not apply.
    """

    pressure_max: float
    at_edge: bool


@dataclass(frozen=True)
class MountingError:
    """One error of mounting.

    Attributes
    ----------
    label : str
        Kind of error, with its size.
    contacts : tuple of Scene or LineScene
        The contacts under the error, in the order of those without; empty where the teeth do not touch.
    note : str
        Further effects.
    dry : tuple of DryContact
        The dry contact of each; empty where those of Hertz hold.
    """

    label: str
    contacts: tuple[Scene | LineScene, ...]
    note: str
    dry: tuple[DryContact, ...] = ()


@dataclass(frozen=True)
class Misalignment:
    """Response of the contacts of a drive to errors of mounting.

    Attributes
    ----------
    method : str
        Method, a sentence.
    errors : tuple of MountingError
        Errors, one at a time; empty where they are not computed.
    dry : tuple of DryContact
        The dry contacts without them; empty where those of Hertz hold.
    """

    method: str
    errors: tuple[MountingError, ...] = ()
    dry: tuple[DryContact, ...] = ()


@dataclass(frozen=True)
class HobSetup:
    """The set-up of a hob, and the one that was looked for.

    Attributes
    ----------
    now : dict
        As the drive is cut.
    found : dict or None
        With the wanted pattern; None where none was wanted.
    reached : bool
        Whether it has the wanted pattern, or is only nearest to it.
    """

    now: Row
    found: Row | None = None
    reached: bool = True


@dataclass(frozen=True)
class Shim:
    """A shift of the wheel along its axis, and what it does to both flanks.

    Places are middles of the marked part along the face from its middle [m], positive to the side where the
    worm's threads leave as they drive.

    Attributes
    ----------
    shift : float
        Of the wheel [m], positive to that side.
    wanted : float
        Wanted place on the flank that the worm drives.
    before, after : float
        Place there without the shim and with it.
    other_before, other_after : float
        Likewise on the other flank, which the same shift moves by its own way.
    reached : bool
        Whether the shim brings the pattern to the wanted place.
    """

    shift: float
    wanted: float
    before: float
    after: float
    other_before: float
    other_after: float
    reached: bool


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
