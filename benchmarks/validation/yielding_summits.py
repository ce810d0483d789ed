"""Rough surfaces of Masjedi and Khonsari's contacts: summits of one radius on a flat, elastic, then yielding.

Y. Zhao, D. M. Maietta and L. Chang (J. Tribol. 122 (2000) 86): a summit is elastic up to an indentation d1,
fully plastic from 54 d1 on; between, area and mean pressure go from one to the other. Their gap counts from
the mean of the heights, summits lie above it (W. R. Chang, I. Etsion and D. B. Bogy, J. Tribol. 109 (1987)
257). All from memory.
"""

from math import log, pi, sqrt

import numpy as np

from pyworm.materials.rough_surfaces import RoughPair

Array = np.ndarray

DENSITY, SHARPNESS = 0.05, 0.01
"""Summits for each area times radius times roughness, and roughness over radius [-]."""

SUMMITS_ABOVE = 0.045944 / DENSITY
"""Mean of the summits above that of the heights, over the roughness [-]."""

SPREAD = sqrt(1 - 3.717e-4 / DENSITY**2)
"""Root mean square height of the summits about their mean, over the roughness [-]."""

YIELD_FACTOR, FULLY_PLASTIC = 0.4, 54.0
"""Mean pressure where a summit begins to yield over the hardness, and the indentation from which it yields
all over, over that."""

POINTS, HIGHEST = 400, 8.0
"""Points of Gauss's quadrature over the summits, and the highest of them over their spread."""


class YieldingSummits(RoughPair):
    """Two surfaces whose composite roughness is that of summits on a flat."""

    def contact(self, gap) -> tuple[Array, Array]:
        """Pressure of the summits [Pa] and real area over the nominal one, by the gap over the roughness."""
        gaps = np.asarray(gap, dtype=float)
        hardness = self.surfaces[0].hardness
        both = [summits(one - SUMMITS_ABOVE, self.modulus, hardness) for one in gaps.ravel()]
        pressure, area = np.array(both).T.reshape(2, *gaps.shape)
        return pressure, np.minimum(area, 1.0)


def summits(gap: float, modulus: float, hardness: float | None) -> tuple[float, float]:
    """Pressure [Pa] and real area of summits on a flat, by the gap from their mean over the roughness."""
    nodes, weights = np.polynomial.legendre.leggauss(POINTS)
    top = HIGHEST * SPREAD
    if gap >= top:
        return 0.0, 0.0
    low = max(gap, -top)
    height = (top + low) / 2 + (top - low) / 2 * nodes
    count = np.exp(-((height / SPREAD) ** 2) / 2) / (sqrt(2 * pi) * SPREAD)
    count *= DENSITY * SHARPNESS * weights * (top - low) / 2
    force, area = one_summit(height - gap, modulus, hardness)
    return float((count * force).sum()), float((count * area).sum())


def one_summit(indented: Array, modulus: float, hardness: float | None) -> tuple[Array, Array]:
    """Force [Pa] and area [-] of a summit, both over the roughness squared, by the indentation over it."""
    circle = pi * indented / SHARPNESS
    elastic = 4 / 3 * modulus * np.sqrt(indented**3 / SHARPNESS)
    if hardness is None:
        return elastic, circle
    first = (3 * pi * YIELD_FACTOR * hardness / (4 * modulus)) ** 2 / SHARPNESS
    last = FULLY_PLASTIC * first
    part = np.clip((indented - first) / (last - first), 0.0, 1.0)
    area = circle * (1 + 3 * part**2 - 2 * part**3)
    left = (log(last) - np.log(np.clip(indented, first, last))) / log(FULLY_PLASTIC)
    yielding = area * hardness * (1 - (1 - YIELD_FACTOR) * left)
    return np.where(indented < first, elastic, yielding), area
