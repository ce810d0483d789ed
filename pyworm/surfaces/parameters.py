"""Figures of a rough surface: heights, Abbott curve, slopes, correlation lengths and lay."""

from dataclasses import dataclass
from math import pi

import numpy as np
import scipy

from pyworm.materials.topography import Topography

Array = np.ndarray

SECANT = 0.4
"""Part of the Abbott curve over which its flattest secant makes the core (ISO 13565-2, ISO 25178-2)."""

QUANTILES = 5000
"""Points of the Abbott curve."""

DIRECTIONS = 180
"""Directions in half a turn along which the autocorrelation is read."""

PEKLENIK, TEXTURE = 0.5, 0.2
"""Autocorrelation at which lengths give the Peklenik number, and the texture ratio of ISO 25178-2."""


@dataclass(frozen=True)
class Texture:
    """Figures of a surface, over its area: those of profiles' standards in name, of ISO 25178-2 in kind."""

    rq: float
    """Root mean square height [m]; Sq of areas."""
    ra: float
    """Arithmetic mean height [m]; Sa of areas."""
    rz: float
    """Height from the lowest to the highest point [m]; Sz of areas."""
    skewness: float
    """Rsk [-]; 0 of heights spread normally."""
    kurtosis: float
    """Rku [-]; 3 of heights spread normally."""
    rk: float
    """Core height [m]."""
    rpk: float
    """Reduced peak height [m]."""
    rvk: float
    """Reduced valley height [m]."""
    mr1: float
    """Lower end of the core on the Abbott curve [-]."""
    mr2: float
    """Upper end of the core on the Abbott curve [-]."""
    slope: float
    """Root mean square slope [-]."""
    slope_x: float
    """Root mean square slope along x [-]."""
    slope_y: float
    """Root mean square slope along y [-]."""
    length_across: float
    """Shortest distance at which the autocorrelation has fallen to 0.5 [m]."""
    length_along: float
    """Longest distance at which the autocorrelation has fallen to 0.5 [m]."""
    aspect: float
    """Peklenik number: the longer of these over the shorter [-]."""
    shortest_length: float
    """Shortest distance at which the autocorrelation has fallen to 0.2 [m], Sal."""
    texture_ratio: float
    """That over the longest such distance [-], Str: 1 without lay, 0 with a lay without end."""
    lay: float
    """Angle of the lay from the x axis [rad], -pi/2 to pi/2."""


def texture(surface: Topography) -> Texture:
    """Figures of a surface, of its measured points alone."""
    height = surface.measured_heights - surface.measured_heights.mean()
    rq = float(height.std())
    slope_x, slope_y = slopes(surface)
    angles = np.arange(DIRECTIONS) * pi / DIRECTIONS - pi / 2
    half, fifth = correlation_lengths(surface, angles, (PEKLENIK, TEXTURE))
    across, along = float(half.min()), float(half.max())
    return Texture(
        rq=rq,
        ra=float(np.abs(height).mean()),
        rz=float(np.ptp(height)),
        skewness=float((height**3).mean() / rq**3),
        kurtosis=float((height**4).mean() / rq**4),
        **core(height),
        slope=float(np.hypot(slope_x, slope_y)),
        slope_x=slope_x,
        slope_y=slope_y,
        length_across=across,
        length_along=along,
        aspect=along / across,
        shortest_length=float(fifth.min()),
        texture_ratio=float(fifth.min() / fifth.max()),
        lay=_lay(angles, half),
    )


def slopes(surface: Topography) -> tuple[float, float]:
    """Root mean square slopes along x and y [-], by differences of neighbours of which both were measured."""
    height = np.where(surface.known, surface.height, np.nan)
    found = []
    for axis, step in enumerate(surface.spacing):
        closed = height
        if surface.periodic:
            closed = np.concatenate([height, height.take([0], axis=axis)], axis=axis)
        found.append(float(np.sqrt(np.nanmean(np.diff(closed, axis=axis) ** 2)) / step))
    return found[0], found[1]


def abbott(height: Array) -> tuple[Array, Array]:
    """Abbott curve: parts of the area, and the height [m] that each exceeds."""
    part = np.linspace(0.0, 1.0, QUANTILES)
    return part, np.quantile(height, 1 - part)


def core(height: Array) -> dict[str, float]:
    """Core, peaks and valleys [m] of the Abbott curve and its ends [-] (ISO 13565-2), by name."""
    part, level = abbott(height)
    steps = round(SECANT * (QUANTILES - 1))
    drop = level[:-steps] - level[steps:]
    start = int(drop.argmin())
    slope = drop[start] / SECANT
    top = level[start] + slope * part[start]
    bottom = top - slope
    mr1, mr2 = (float(np.interp(-edge, -level, part)) for edge in (top, bottom))
    peaks = np.trapezoid(np.maximum(level - top, 0.0), part)
    valleys = np.trapezoid(np.maximum(bottom - level, 0.0), part)
    return {
        "rk": float(slope),
        "rpk": float(2 * peaks / mr1) if mr1 > 0 else 0.0,
        "rvk": float(2 * valleys / (1 - mr2)) if mr2 < 1 else 0.0,
        "mr1": mr1,
        "mr2": mr2,
    }


def correlation_lengths(
    surface: Topography, angles: Array, levels: tuple[float, ...]
) -> list[Array]:
    """Distances [m] along directions from the x axis [rad] at which the autocorrelation falls to levels.

    Where it does not within half the area, half its shorter side.
    """
    correlation = _autocorrelation(surface)
    reach = min(surface.extent) / 2
    distance = np.arange(0.0, reach, min(surface.spacing) / 2)
    lengths = [np.full(len(angles), reach) for _ in levels]
    centre = [n // 2 for n in correlation.shape]
    for k, angle in enumerate(angles):
        place = [
            middle + distance * part / step
            for middle, part, step in zip(
                centre, (np.cos(angle), np.sin(angle)), surface.spacing, strict=True
            )
        ]
        profile = scipy.ndimage.map_coordinates(correlation, place, order=1, mode="nearest")
        for found, level in zip(lengths, levels, strict=True):
            below = np.flatnonzero(profile <= level)
            if below.size:
                i = below[0]
                rest = (profile[i - 1] - level) / (profile[i - 1] - profile[i])
                found[k] = distance[i - 1] + rest * (distance[i] - distance[i - 1])
    return lengths


def _autocorrelation(surface: Topography) -> Array:
    """Autocorrelation with its middle in the middle: of pairs of measured points.

    Of what is not periodic the pairs are those within the area.
    """
    known = surface.known
    height = np.where(known, surface.height - surface.measured_heights.mean(), 0.0)
    shape = height.shape
    padded = shape
    if not surface.periodic:
        padded = tuple(scipy.fft.next_fast_len(2 * n, real=True) for n in shape)
    raw = _correlated(height, padded)
    if known.all():  # pairs at a distance; all of them where it is periodic
        along, across = (
            np.maximum(n - np.minimum(np.arange(m), m - np.arange(m)) * (m > n), 1)
            for n, m in zip(shape, padded, strict=True)
        )
        raw /= along[:, np.newaxis]
        raw /= across
    else:
        raw /= np.maximum(_correlated(known.astype(float), padded), 1.0)
    raw /= raw[0, 0]
    middle = np.fft.fftshift(raw)
    if surface.periodic:
        return middle
    start = [m // 2 - n // 2 for m, n in zip(middle.shape, shape, strict=True)]
    return middle[start[0] : start[0] + shape[0], start[1] : start[1] + shape[1]]


def _correlated(field: Array, padded: tuple[int, ...]) -> Array:
    """Sums of products of all pairs of values at a distance, padded by zeros."""
    spectrum = scipy.fft.rfft2(field, s=padded)
    power = spectrum.real**2 + spectrum.imag**2
    summed: Array = scipy.fft.irfft2(power, s=padded, overwrite_x=True)
    return summed


def _lay(angles: Array, lengths: Array) -> float:
    """Direction of the longest correlation: the axis of the lengths' second harmonic near it."""
    longest = angles[int(lengths.argmax())]
    near = np.abs((angles - longest + pi / 2) % pi - pi / 2) < pi / 8
    turn = np.sum((lengths[near] - lengths[near].min()) * np.exp(2j * angles[near]))
    return float(np.angle(turn) / 2) if abs(turn) > 0 else float(longest)
