"""The way of the contact point of worm and wheel through space while they turn."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from math import inf

from pyworm.drives.worm.flanks.flank_surface import FlankSurface
from pyworm.drives.worm.flanks.helicoid import Array, Seated


@dataclass(frozen=True)
class Touches:
    """Unloaded contacts of a tooth pair at some places of their path."""

    worm_angle: Array
    """Rotation angle of the worm [rad], (places,)."""
    wheel_angle: Array
    """Rotation angle of the wheel [rad], (places,)."""
    point: Array
    """Contact points [m], (3, places)."""
    normal: Array
    """Unit normals from worm to wheel, (3, places)."""
    travel: Array
    """Way of the contact point by the worm's rotation [m], (3, places)."""
    worm_start: Array
    """Parameters of the worm's flank there, (parameters, places)."""
    wheel_start: Array
    """Parameters of the wheel's flank there, (parameters, places)."""


class ContactPath(ABC):
    """A path of contact, whose places are in proportion to the worm's rotation."""

    worm: Seated
    """The worm as assembled."""

    @abstractmethod
    def touches(self, places: Array) -> Touches:
        """Contacts at places, (places,)."""

    def ends(self) -> tuple[float, float]:
        """Places between which contacts are followed; beyond them they are continued."""
        return -inf, inf

    @abstractmethod
    def search(self, tip_radius: float) -> Array:
        """Places, as the worm turns, between which teeth of a tip radius [m] begin and end, if at all."""

    @abstractmethod
    def worm_surface(self, angle: float) -> FlankSurface:
        """The worm's flank at a rotation angle [rad]."""

    @abstractmethod
    def wheel_surface(self, angle: float) -> FlankSurface:
        """The wheel's flank at a rotation angle [rad]."""
