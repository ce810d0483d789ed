"""Measured or designed deviations of flanks from what the worm's tool and the wheel's hob should leave."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy

from pyworm.drives.worm.flanks.helicoid import Array

Rows = tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class FlankDeviations:
    """Deviations on a grid over the flank by which the worm drives, the same on every thread or tooth."""

    along: tuple[float, ...]
    """Of the wheel, places along the face from its middle, positive to the side where the worm's threads
    leave; of the worm, places along its axis from the line of centres, positive to where the thrust on the
    driving worm acts. They rise [m]."""
    radius: tuple[float, ...]
    """Distances from the own axis. They rise [m]."""
    deviation: Rows
    """Deviation out of the flank's material [m], for each place over the radii."""
    worn: bool = False
    """Whether they are what wear took off, and not measured or designed."""

    @property
    def spread(self) -> float:
        """Largest less least deviation [m]."""
        return float(np.ptp(self.deviation))

    @cached_property
    def _spline(self) -> "scipy.interpolate.RectBivariateSpline":
        """Spline through the grid, cubic where it has four places or more along a side."""
        below = np.max(self.deviation) - np.array(self.deviation)
        degrees = (min(3, len(side) - 1) for side in (self.along, self.radius))
        return scipy.interpolate.RectBivariateSpline(
            self.along, self.radius, below, **dict(zip(("kx", "ky"), degrees, strict=True)), s=0
        )

    def removed(self, along: Array, radius: Array) -> Array:
        """What the flank is below the highest place of the grid [m]; beyond the grid as at its edge."""
        coordinates = (
            np.clip(place, side[0], side[-1])
            for place, side in ((along, self.along), (radius, self.radius))
        )
        return self._spline.ev(*coordinates)
