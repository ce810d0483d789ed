"""Heights of a rough surface at the nodes of a patch, moved along its x axis by any distance."""

from dataclasses import dataclass
from functools import cached_property
from math import cos, sin

import numpy as np
import scipy

from pyworm.formulas.arrays import Array
from pyworm.materials.topography import Topography
from pyworm.planning.grid import Grid

MIN_WAVE_NODES = 8.0
"""Minimum number of nodes in the shortest wave that counts; of shorter ones too much is filtered as noise."""

TAPS = (-1, 0, 1, 2)
"""Nodes before and after a place whose cubic B-splines are not zero there."""


def resampled(topography: Topography, grid: Grid) -> Array:
    """Heights [m] at points as far apart as the nodes of a grid, repeated along x.

    A surface that does not repeat itself along its motion is continued by reflection. The length that repeats
    is a whole number of nodes.
    """
    height, angle = topography.height, topography.x_direction
    if not topography.periodic:
        height = np.concatenate([height, height[::-1]], axis=0)
        height = np.concatenate([height, height[:, ::-1]], axis=1)
    length = height.shape[0] * topography.spacing[0]
    count = max(MIN_POINTS, round(length / grid.dx))
    x = np.arange(count) * (length / count)
    along = cos(angle) * x[:, None] + sin(angle) * grid.y[None, :]
    across = -sin(angle) * x[:, None] + cos(angle) * grid.y[None, :]
    places = [along / topography.spacing[0], across / topography.spacing[1]]
    found: Array = scipy.ndimage.map_coordinates(height, places, order=3, mode="grid-wrap")
    if abs(sin(angle)) > MAX_SKEW:
        found = np.concatenate([found, found[::-1]], axis=0)
    return found


MIN_POINTS = 4
"""Least number of points of a surface along x."""

MAX_SKEW = 1e-9
"""Sine of the angle between the surface's axes and its motion up to which they count as parallel."""


@dataclass(frozen=True)
class MovingHeights:
    """Heights of one surface that move with a speed: they enter a patch behind a front, or grow in place."""

    height: Array
    """Heights at points as far apart as the nodes [m], which repeat along x, shape (points, ny)."""
    speed: float
    """Speed along x [m/s]."""
    front: float
    """Place along x of the middle of the front at time zero [m]."""
    ramp: float
    """Length over which heights grow behind the front [m]."""
    growth: float = 0.0
    """Time in which heights grow everywhere at once [s]; zero if they enter behind the front."""

    @cached_property
    def _coefficients(self) -> Array:
        return scipy.ndimage.spline_filter1d(self.height, 3, axis=0, mode="grid-wrap")

    def at(self, x: Array, time: float, dx: float) -> Array:
        """Heights [m] at equidistant places x [m] and a time [s]."""
        start = (x[0] - self.speed * time) / dx
        whole = int(np.floor(start))
        nodes = np.arange(len(x)) + whole
        count = len(self.height)
        heights = sum(
            weight * self._coefficients[(nodes + tap) % count]
            for tap, weight in zip(TAPS, spline_weights(start - whole), strict=True)
        )
        shown: Array = np.asarray(heights * self._grown(x, time))
        return shown

    def _grown(self, x: Array, time: float) -> Array | float:
        """Part of the heights that is there, at places along x and a time."""
        if self.growth > 0:
            part = min(max(time / self.growth, 0.0), 1.0)
            return part**2 * (3 - 2 * part)
        behind: Array = 0.5 * (1 - np.tanh((x - self.speed * time - self.front) / self.ramp))
        return behind[:, None]


def spline_weights(part: float) -> tuple[float, float, float, float]:
    """Cubic B-splines of the nodes in `TAPS` at a place that is a part of a spacing behind a node."""
    return (
        (1 - part) ** 3 / 6,
        (3 * part**3 - 6 * part**2 + 4) / 6,
        (-3 * part**3 + 3 * part**2 + 3 * part + 1) / 6,
        part**3 / 6,
    )


def shortest_wave(height: Array, spacing: float, axis: int) -> float:
    """Wavelength along an axis [m] below which waves hold a twentieth of the variance; infinite if flat."""
    spectrum = (np.abs(np.fft.rfft(height, axis=axis)) ** 2).sum(axis=1 - axis)
    whole = spectrum.sum()
    spectrum[0] = 0.0
    if not spectrum.sum() > MIN_VARIANCE * whole:
        return np.inf
    share = np.cumsum(spectrum) / spectrum.sum()
    return float(height.shape[axis] * spacing / np.searchsorted(share, SHORT_SHARE))


MIN_VARIANCE = 1e-9
"""Share of the variance along an axis below which a surface is straight there."""

SHORT_SHARE = 0.95
"""Share of the variance of the heights that must be resolved."""
