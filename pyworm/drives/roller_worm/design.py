"""Design data of a roller enveloping worm drive: the worm's sections and the rollers."""

from dataclasses import dataclass
from typing import Literal

from pyworm.drives.roller_worm.motion import FREE_OF_FRICTION, Pin
from pyworm.drives.roller_worm.profile import RollerProfile
from pyworm.io import units
from pyworm.io.plain_values import Count, PositiveNumber

Arrangement = Literal["divided", "double"]
"""How the two flanks of the thread get their rollers."""


@dataclass(frozen=True)
class RollerWorm:
    """The worm's design table."""

    threads: Count
    """Number of threads."""
    throat_coefficient: PositiveNumber
    """k, throat diameter over centre distance; the rollers' middles pass the throat there [-]."""
    outer_angle: units.Angle
    """Wheel angle from the throat at which either section ends [rad]."""
    addendum: units.Length
    """Bearing length of the thread from the rollers' middle towards their inner end [m]."""
    dedendum: units.Length
    """Bearing length of the thread from the rollers' middle towards their outer end [m]."""
    throat_angle: units.AngleOrZero = 0.0
    """Wheel angle from the throat at which either section of a divided worm begins [rad]."""
    hand: Literal["right", "left"] = "right"
    """Hand of the thread."""
    arrangement: Arrangement = "divided"
    """Rollers of both flanks: "divided", a section of the worm for each, parted at the throat; "double", a
    row of rollers for each along the whole worm, the rows mirrored about its axis."""

    @property
    def turn(self) -> int:
        """+1 for a left-hand, -1 for a right-hand thread."""
        return 1 if self.hand == "left" else -1


@dataclass(frozen=True)
class Rollers:
    """The rollers on their wheel."""

    count: int
    """Number of rollers round the wheel."""
    profile: RollerProfile
    """Shape of the rollers."""
    tilt: float
    """Angle of the rollers' axes to the wheel's radius, towards its axis [rad]: 0 radial on a rim, pi/2 axial
    on a disc, pi radial on the inside of a ring."""
    height: float
    """Height of the rollers' middles over the worm's axis, along the wheel's axis [m]; of two rows that of
    the driving one."""
    pin: Pin = FREE_OF_FRICTION
    """Pin of each roller."""
    stiffness: float = float("inf")
    """Stiffness of pin and thread together [N/m]; infinite where they are rigid."""
    inertia: float | None = None
    """Moment of inertia of a roller about its axis [kg m2]; None: that of a solid bored for its pin."""
