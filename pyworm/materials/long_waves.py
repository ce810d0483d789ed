"""Waves of a surface longer than its roughness, as the gap of a contact has them."""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import ceil, cos, hypot, pi, sin

import numpy as np
import scipy

from pyworm.formulas.arrays import Array
from pyworm.materials.topography import Topography

MIN_TRACK_FRACTION = 0.5
"""Length of a track over the longest one from which on it counts for the mean along tracks."""

LEAST_VARIANCE = 1e-40
"""Variance of heights [m2] that is none."""

ON_A_WAVE = 32
"""Places on a wave of mean length at which tracks are sampled."""


@dataclass(frozen=True)
class LongWaves:
    """Waves of a surface; beyond what was measured they go on as in a mirror."""

    surface: Topography
    """Heights [m], outwards of the body, and the direction of their x axis from the surface's own motion."""

    @property
    def rms(self) -> float:
        """Root mean square height [m]."""
        return self.surface.rms

    @cached_property
    def length(self) -> float:
        """Mean length of the waves [m]: of one sine wave as high and as steep."""
        slopes = [
            np.gradient(self.surface.height, step, axis=axis)
            for axis, step in enumerate(self.surface.spacing)
        ]
        steepness = hypot(*(float(slope[self.surface.known].std()) for slope in slopes))
        return 2 * pi * self.rms / steepness if steepness > 0 else 0.0

    @property
    def _beyond(self) -> str:
        return "grid-wrap" if self.surface.periodic else "mirror"

    @cached_property
    def _coefficients(self) -> Array:
        coefficients: Array = scipy.ndimage.spline_filter(self.surface.height, mode=self._beyond)
        return coefficients

    def at(self, along: Array, across: Array) -> Array:
        """Heights [m] at places [m] from the middle, along the surface's own motion and to its left."""
        turn = self.surface.x_direction
        places = (cos(turn) * along + sin(turn) * across, cos(turn) * across - sin(turn) * along)
        rows = [
            place / step + (count - 1) / 2
            for place, step, count in zip(
                places, self.surface.spacing, self.surface.height.shape, strict=True
            )
        ]
        heights: Array = scipy.ndimage.map_coordinates(
            self._coefficients, np.broadcast_arrays(*rows), mode=self._beyond, prefilter=False
        )
        return heights

    def ridges(self, direction: float) -> "Ridges":
        """The waves' part that is constant along a direction from the surface's own motion [rad].

        Of the mean along tracks that part counts which the tracks' two halves have in common: the rest is
        left by chance of waves that change along them.
        """
        return _ridges(self, direction)


@dataclass(frozen=True, eq=False)
class Ridges:
    """Waves that are constant along one direction."""

    height: Array
    """Heights across it [m], of mean zero."""
    spacing: float
    """Distance of places across it [m]."""
    middle: float
    """Row of the place in the middle of the waves."""

    @property
    def rms(self) -> float:
        """Root mean square height [m]."""
        return float(self.height.std())

    def at(self, across: Array) -> Array:
        """Heights [m] at places across them from the middle [m]; beyond the ends as in a mirror."""
        rows = np.asarray(across) / self.spacing + self.middle
        heights: Array = scipy.ndimage.map_coordinates(self.height, [rows], mode="mirror")
        return heights


@lru_cache(maxsize=8)
def _ridges(waves: LongWaves, direction: float) -> Ridges:
    """Ridges along a direction, as of `LongWaves.ridges`."""
    surface, turn = waves.surface, waves.surface.x_direction
    step = max(*surface.spacing, waves.length / ON_A_WAVE)
    reach = ceil(hypot(*surface.extent) / 2 / step)
    places = np.arange(-reach, reach + 1) * step
    across, along = np.meshgrid(places, places, indexing="ij")
    x = cos(direction) * along - sin(direction) * across
    y = sin(direction) * along + cos(direction) * across
    on_surface = cos(turn) * x + sin(turn) * y, cos(turn) * y - sin(turn) * x
    inside = np.logical_and(
        *(np.abs(place) <= side / 2 for place, side in zip(on_surface, surface.extent, strict=True))
    )
    halves = [inside & half for half in (along < 0, along > 0)]
    counts = [half.sum(axis=1) for half in halves]
    least = np.minimum(*counts)
    held = least >= MIN_TRACK_FRACTION * least.max()
    heights = waves.at(x, y)
    first, second = (
        (heights * half).sum(axis=1)[held] / count[held]
        for half, count in zip(halves, counts, strict=True)
    )
    mean = (first + second) / 2
    common = float(np.mean((first - first.mean()) * (second - second.mean())))
    part = min(max(common / max(float(mean.var()), LEAST_VARIANCE), 0.0), 1.0)
    return Ridges(part * (mean - mean.mean()), step, -places[held][0] / step)
