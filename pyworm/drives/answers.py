"""Answers of drives: contacts under errors of mounting, set-up of hob and wheel, the drive in space."""

from dataclasses import dataclass

import numpy as np

from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

Row = dict[str, float]
"""A set-up, its contact pattern without load and its contact at mid-mesh; keys end in their unit."""


@dataclass(frozen=True)
class DryContact:
    """A dry contact on the surfaces as they are."""

    pressure_max: float
    """Largest pressure [Pa]."""
    at_edge: bool
    """Whether it rests on an edge, so that film formulas do not apply."""


@dataclass(frozen=True)
class ElementBearing:
    """Bearing of an element that turns on its wheel, such as a roller on its pin, over the mesh."""

    name: str
    """The element."""
    radial: float
    """Constant radial load of the same life [N], by the power 10/3 of roller bearings."""
    radial_max: float
    """Largest radial load [N]."""
    axial_max: float
    """Largest thrust [N], which a needle bearing leaves to a washer."""
    speed: float
    """Mean speed [rad/s], turns under load over the time of a turn of the wheel."""
    speed_max: float
    """Largest speed [rad/s]."""
    losses: dict[str, float]
    """Power that all elements lose by closed forms [W], by its place."""


@dataclass(frozen=True)
class MountingError:
    """One error of mounting."""

    label: str
    """Kind of error, with its size."""
    contacts: tuple[Scene | LineScene, ...]
    """The contacts under the error, in the order of those without; empty where the teeth do not touch."""
    note: str
    """Further effects."""
    dry: tuple[DryContact, ...] = ()
    """The dry contact of each; empty where those of Hertz hold."""


@dataclass(frozen=True)
class Misalignment:
    """Response of the contacts of a drive to errors of mounting."""

    method: str
    """Method, a sentence."""
    errors: tuple[MountingError, ...] = ()
    """Errors, one at a time; empty where they are not computed."""
    dry: tuple[DryContact, ...] = ()
    """The dry contacts without them; empty where those of Hertz hold."""


@dataclass(frozen=True)
class FigureRow:
    """A figure of several parts of a drive."""

    key: str
    """Its name for programs, ending in its unit."""
    label: str
    """Its name for people."""
    values: tuple[float | None, ...]
    """One for each part, in SI; None where a part has none."""
    unit: str = ""
    """Unit shown."""


@dataclass(frozen=True)
class FigureTable:
    """Figures of a drive by closed forms."""

    key: str
    """Its name for programs."""
    title: str
    """Its name for people."""
    source: str
    """Method."""
    parts: tuple[str, ...]
    """Parts of the drive."""
    rows: tuple[FigureRow, ...]
    """The figures."""
    words: tuple[str, ...] = ()
    """What was assumed, in sentences."""


@dataclass(frozen=True)
class HobSetup:
    """The set-up of a hob, and the one that was looked for."""

    current: Row
    """As the drive is cut."""
    proposed: Row | None = None
    """With the wanted pattern; None where none was wanted."""
    reached: bool = True
    """Whether it has the wanted pattern, or is only nearest to it."""


@dataclass(frozen=True)
class Shim:
    """A shift of the wheel along its axis, and what it does to both flanks.

    Places are middles of the marked part along the face from its middle [m], positive to the side where the
    worm's threads leave as they drive.
    """

    shift: float
    """Shift of the wheel [m], positive to that side."""
    wanted: float
    """Wanted place on the flank that the worm drives."""
    before: float
    """Place there without the shim."""
    after: float
    """Place there with the shim."""
    other_before: float
    """Place on the other flank without the shim, which moves it by its own way."""
    other_after: float
    """Place on the other flank with the shim."""
    reached: bool
    """Whether the shim brings the pattern to the wanted place."""


@dataclass(frozen=True)
class Shape:
    """A surface that turns about an axis, with its likes around that."""

    body: int
    """Which body of the contact has it, 1 or 2."""
    axis_point: np.ndarray
    """A point of the axis, in the axes of the drive, (3,) [m]."""
    axis: np.ndarray
    """Direction of the axis, in the axes of the drive, (3,)."""
    surface: np.ndarray
    """Points of the surface before any turn [m], NaN where it ends, (rows, columns, 3)."""
    turns: np.ndarray
    """Turn about the axis at each of some places, right-handed [rad], (places,)."""
    copies: tuple[float, ...] = ()
    """Further turns at which the same surface stands again [rad]."""
    face: np.ndarray | None = None
    """Places of these points on the flank as fields know them, along the face from its middle, (rows,
    columns) [m]; None of a surface that fields do not know."""
    radius: np.ndarray | None = None
    """Places of these points from the axis, (rows, columns) [m]; None likewise."""


@dataclass(frozen=True)
class Space:
    """A drive in space at some places."""

    shapes: tuple[Shape, ...]
    """Its surfaces."""
    view: np.ndarray
    """Directions to the right, up and towards the eye, in the axes of the drive, (3, 3)."""
    size: float
    """Length that a picture should show [m]."""
    drawn: str
    """What is drawn and what is not, a sentence."""
    lines: tuple[np.ndarray, ...] = ()
    """Points (n, 3) [m] of the line of contact at each place; none where a flank shows the pressure."""
