"""Measured or designed deviations of the wheel's flank from the one that its hob cuts."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy

from pyworm.drives.zi_worm.helicoid import Array

Rows = tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class FlankDeviations:
    """Deviations on a grid over the flank that the worm drives.

    Attributes
    ----------
    face, radius : tuple of float
        Places along the face from its middle, positive to the side where the worm's threads leave, and
        distances from the wheel's axis, both rising [m].
    deviation : tuple of tuple of float
        Out of the flank's material [m], for each place along the face over the radii.
    """

    face: tuple[float, ...]
    radius: tuple[float, ...]
    deviation: Rows

    @property
    def spread(self) -> float:
        """Largest less least deviation [m]."""
        return float(np.ptp(self.deviation))

    @cached_property
    def _spline(self) -> "scipy.interpolate.RectBivariateSpline":
        """Spline through the grid, cubic where it has four places or more along a side."""
        below = np.max(self.deviation) - np.array(self.deviation)
        degrees = (min(3, len(side) - 1) for side in (self.face, self.radius))
        return scipy.interpolate.RectBivariateSpline(
            self.face, self.radius, below, **dict(zip(("kx", "ky"), degrees, strict=True)), s=0
        )

    def taken_off(self, face: Array, radius: Array) -> Array:
        """What the flank is below the highest place of the grid [m]; beyond the grid as at its edge."""
        at = (
            np.clip(place, side[0], side[-1])
            for place, side in ((face, self.face), (radius, self.radius))
        )
        return self._spline.ev(*at)
