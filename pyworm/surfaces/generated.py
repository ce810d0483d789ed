"""Generated rough surfaces: random phases of a given spectrum, repeated in both directions, by a seed."""

from collections.abc import Callable
from math import pi

import numpy as np

from pyworm.materials.topography import Topography

Array = np.ndarray

GAUSSIAN_NODES, GAUSSIAN_LENGTHS = 256, 20.0
"""Points along each side of a Gaussian surface, and correlation lengths in it."""

WAVES, NODES_A_WAVE = 4, 4
"""Longest waves along each side of a self-affine surface, and least number of points in the shortest wave."""

MOST_RATIO = 64.0
"""Largest ratio of the longest to the shortest wave: 1024 points along each side."""


def gaussian(
    roughness: float, correlation_length: float, aspect: float = 1.0, seed: int = 0
) -> Topography:
    """Surface of normal heights of a root mean square [m], autocorrelation exp(-ln 10 (x/length)^2).

    `correlation_length` [m], across the lay, is where it has fallen to 0.1; `aspect` is that along the lay,
    x, over it.
    """
    side = GAUSSIAN_LENGTHS * correlation_length
    # the spectral density of exp(-ln 10 x^2/l^2)
    decay = correlation_length**2 / (4 * np.log(10))

    def density(qx: Array, qy: Array) -> Array:
        return np.exp(-decay * ((qx * aspect) ** 2 + qy**2))

    return _generated(roughness, GAUSSIAN_NODES, (side * aspect, side), density, seed)


def self_affine(
    roughness: float,
    hurst: float,
    longest_wave: float,
    shortest_wave: float,
    aspect: float = 1.0,
    seed: int = 0,
) -> Topography:
    """Surface that is rough on all scales between two [m]: spectral density q^(-2 - 2 Hurst).

    The waves' ends are across the lay; `aspect` is the length of waves along it, x, over those across.
    ValueError for waves that are the wrong way round, or more scales than a cell can hold.
    """
    ratio = longest_wave / shortest_wave
    if not 1 < ratio <= MOST_RATIO:
        raise ValueError(
            f"longest_wave over shortest_wave is {ratio:.3g}; it must lie above 1 and be at most "
            f"{MOST_RATIO:g}"
        )
    nodes = 2 ** int(np.ceil(np.log2(WAVES * NODES_A_WAVE * ratio)))
    side = WAVES * longest_wave

    def density(qx: Array, qy: Array) -> Array:
        q = np.hypot(qx * aspect, qy)
        within = (q >= 2 * pi / longest_wave * (1 - 1e-9)) & (q <= 2 * pi / shortest_wave)
        return np.where(within, np.where(within, q, 1.0) ** (-2 - 2 * hurst), 0.0)

    return _generated(roughness, nodes, (side * aspect, side), density, seed)


def _generated(
    roughness: float,
    nodes: int,
    extent: tuple[float, float],
    density: Callable[[Array, Array], Array],
    seed: int,
) -> Topography:
    """A surface of nodes by nodes points with a spectral density of random phases and amplitudes."""
    spacing = extent[0] / nodes, extent[1] / nodes
    qx, qy = (2 * pi * np.fft.fftfreq(nodes, step) for step in spacing)
    amplitude = np.sqrt(density(qx[:, None], qy[None, :]))
    amplitude[0, 0] = 0.0
    noise = np.fft.fft2(np.random.default_rng(seed).standard_normal((nodes, nodes)))
    height = np.fft.ifft2(noise * amplitude).real
    return Topography(height * (roughness / height.std()), spacing, periodic=True)
