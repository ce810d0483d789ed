"""Misaligned flanks over the tangent planes of aligned ones.

With errors of the assembly the flanks may have no common normal on the teeth, or none at all: the error takes
away more than their crowning, and they touch at an edge of a tooth. Gap, velocities and load are those over
the tangent planes that the flanks have without the errors; over these planes they lie aslant and apart.
"""

from dataclasses import dataclass, replace

from pyworm.drives.worm.flanks.contact_path import ContactPath, Touches
from pyworm.drives.worm.flanks.flank_points import WormPoints
from pyworm.drives.worm.flanks.flank_surface import FlankSurface
from pyworm.drives.worm.flanks.helicoid import Array, Helicoid
from pyworm.drives.worm.flanks.surfaces import WormSurface
from pyworm.drives.worm.flanks.tangent_planes import WormPlanes


@dataclass(frozen=True)
class SeenPath(ContactPath):
    """The path of contact of aligned flanks, with the worm where errors of the assembly have it."""

    aligned: ContactPath
    """The path without them."""
    worm: WormSurface
    """The worm as assembled."""
    ahead: float = 0.0
    """Turn of the wheel by which the flanks touch, or nearly so [rad]; wheel angles include it."""

    def touches(self, places: Array) -> Touches:
        """Contacts without the errors."""
        touches = self.aligned.touches(places)
        return replace(touches, wheel_angle=touches.wheel_angle + self.ahead)

    def ends(self) -> tuple[float, float]:
        """Places between which the aligned path is followed."""
        return self.aligned.ends()

    def search(self, tip_radius: float) -> Array:
        """Places of the aligned path."""
        return self.aligned.search(tip_radius)

    def worm_surface(self, angle: float) -> FlankSurface:
        """The worm's flank as assembled."""
        if isinstance(self.worm, Helicoid):
            return WormPlanes(self.worm, angle)
        return WormPoints(self.worm, angle)

    def wheel_surface(self, angle: float) -> FlankSurface:
        """The wheel's flank."""
        return self.aligned.wheel_surface(angle)
