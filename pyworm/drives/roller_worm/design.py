"""Design data of a roller enveloping worm drive: the worm's sections and the rollers."""

from dataclasses import dataclass

from pyworm.drives.roller_worm.motion import (
    FREE_OF_FRICTION,
    Pin,
)
from pyworm.drives.roller_worm.profile import RollerProfile


@dataclass(frozen=True)
class RollerWorm:
    """The worm's design table."""

    threads: int
    """Number of threads."""
    hand: int
    """+1 for a left-hand, -1 for a right-hand thread."""
    throat_coefficient: float
    """k, throat diameter over centre distance; the rollers' middles pass the throat there [-]."""
    throat_angle: float
    """Wheel angle from the throat at which either section begins [rad]."""
    outer_angle: float
    """Wheel angle from the throat at which either section ends [rad]."""
    addendum: float
    """Bearing length of the thread from the rollers' middle towards their inner end [m]."""
    dedendum: float
    """Bearing length of the thread from the rollers' middle towards their outer end [m]."""


@dataclass(frozen=True)
class Rollers:
    """The rollers on their wheel."""

    count: int
    """Number of rollers round the wheel."""
    profile: RollerProfile
    """Shape of the rollers."""
    tilt: float
    """Angle of the rollers' axes to the wheel's radius, towards its axis [rad]: 0 radial, pi/2 axial."""
    height: float
    """Height of the rollers' middles over the worm's axis, along the wheel's axis [m]."""
    pin: Pin = FREE_OF_FRICTION
    """Pin of each roller."""
    stiffness: float = float("inf")
    """Stiffness of pin and thread together [N/m]; infinite where they are rigid."""
