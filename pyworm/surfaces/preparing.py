"""From heights as measured to a topography: points filled, form removed, waves separated."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
import scipy

from pyworm.formulas.gaussian_filter import smoothed
from pyworm.materials.topography import Topography

Array = np.ndarray

MOST_MISSING = 0.1
"""Largest fraction of points that are missing, and filled from those around them, unless given."""

MAX_HEIGHT_DEVIATION = 15.0
"""Distance of a height from the median, over the normal deviation of the middle half, from which on it may be
an outlier: deep valleys of a plateau surface come to about 10, spikes of instruments to tens."""

AROUND, ALONE, MOSTLY = 3, 0.5, 0.5
"""An outlier differs from the median of the points so many steps around it by more than this part of its
distance from all; in a group of such points this part of them does."""

CHANGED, TOUCHED = 1.05, 1e-4
"""Outliers matter if they raise Rq by this factor, or are this part of all points: below, contact is that of
single summits (`topography_pair.LEAST_TOUCHED`)."""

LEAST_WEIGHT = 1e-3
"""Part of a filter's weights that lies on measured points, below which its mean is one of filled points."""

NORMAL_OVER_MIDDLE = 1.4826
"""Standard deviation over the median distance from the median, of heights spread normally."""

MIN_NESTING_RATIO = 4.0
"""Shortest nesting index over the distance of points that a filter can resolve."""

Outliers = Literal["refuse", "fill", "keep"]


@dataclass(frozen=True)
class SeparatedWaves:
    """Heights of a surface as separated by filters."""

    roughness: Topography
    """Waves shorter than the nesting index, without form."""
    long_waves: Topography
    """Waves longer than that, without form, which belong to the contact's gap."""
    filled: float
    """Fraction of points that were missing or left out, and filled."""
    outliers: int = 0
    """Number of outliers that were left out."""

    @property
    def all_waves(self) -> Topography:
        """Roughness and longer waves together."""
        return replace(self.roughness, height=self.roughness.height + self.long_waves.height)


def separate_waves(
    heights: Array,
    spacing: tuple[float, float],
    *,
    periodic: bool = False,
    nesting_index: float | None = None,
    shortest_wave: float | None = None,
    outliers: Outliers = "refuse",
    fill: float = MOST_MISSING,
) -> SeparatedWaves:
    """Fill, level and filter heights (nx, ny) [m], NaN where missing; only measured points count.

    Form, none of periodic ones, is a polynomial of second order. Filters are Gaussian (ISO 16610-61): without
    `nesting_index`, the longest wave of roughness [m], all that is no form is roughness; `shortest_wave` [m]
    filters noise. Outliers, heights that are far from all others, are to "refuse", "fill" or "keep"; `fill`
    is the largest fraction of points that may be missing. ValueError for too many missing points, outliers,
    or an index that the area does not hold.
    """
    level, missing, far = _levelled(heights, periodic, outliers, fill)
    if not np.nanstd(level) > 0:
        raise ValueError("is flat: all heights are equal after levelling")
    extent = [n * step for n, step in zip(level.shape, spacing, strict=True)]
    for name, index in (("nesting_index", nesting_index), ("shortest_wave", shortest_wave)):
        require_index(name, index, spacing, extent)
    if missing.any():
        level = _filled(level, missing)
    if shortest_wave is not None:
        level = _long(level, missing, spacing, shortest_wave, periodic)
    long_waves = np.zeros_like(level)
    if nesting_index is not None:
        long_waves = _long(level, missing, spacing, nesting_index, periodic)
    measured = ~missing if missing.any() else None
    rough, longer = (
        Topography(heights - heights[~missing].mean(), spacing, periodic, measured=measured)
        for heights in (level - long_waves, long_waves)
    )
    return SeparatedWaves(rough, longer, float(missing.mean()), far)


def _levelled(
    heights: Array, periodic: bool, outliers: Outliers, fill: float
) -> tuple[Array, Array, int]:
    """Heights without form, NaN where they are missing or left out, where that is, and outliers left out."""
    heights = np.where(np.isfinite(heights), heights, np.nan)
    _require_most(heights, fill)
    level = _without_form(heights, periodic)
    if outliers == "keep":
        return level, np.isnan(level), 0
    far = outlying(level)
    cleaned = np.where(far, np.nan, level)
    if far.any() and outliers == "refuse":
        if not _matter(level, cleaned, far):
            return level, np.isnan(level), 0
        worst = np.nanmax(np.abs(level[far])) * 1e6
        kept, without = (np.nanstd(field) * 1e6 for field in (level, cleaned))
        raise ValueError(
            f"has {far.sum()} outliers, up to {worst:.3g} um from the mean, which stand out of all around "
            f"them: Rq is {kept:.3g} um with them and {without:.3g} um without; give outliers = "
            '"fill" to leave them out, or "keep" if they are real'
        )
    if far.any():
        _require_most(cleaned, fill)
        level = _without_form(cleaned, periodic)
    return level, np.isnan(level), int(far.sum())


def _without_form(heights: Array, periodic: bool) -> Array:
    level = heights if periodic else heights - _form(heights)
    return level - np.nanmean(level)


def _require_most(heights: Array, fill: float) -> None:
    missing = float(np.isnan(heights).mean())
    if missing > fill:
        raise ValueError(
            f"{missing * 100:.0f} % of its points are missing, at most {fill * 100:.0f} % are filled; "
            f"give a part of it that is complete by crop, or fill = {min(missing + 0.05, 0.99):.2f}"
        )


def require_index(
    name: str, index: float | None, spacing: tuple[float, ...], extent: list[float]
) -> None:
    """Refuse a filter whose waves the points do not resolve or the area or profile does not hold."""
    if index is None:
        return
    if index < MIN_NESTING_RATIO * max(spacing):
        raise ValueError(
            f"{name} of {index * 1e6:.4g} um is too short for points {max(spacing) * 1e6:.3g} um apart, "
            f"at least {MIN_NESTING_RATIO * max(spacing) * 1e6:.4g} um is needed"
        )
    if index > min(extent):
        raise ValueError(
            f"{name} of {index * 1e6:.4g} um is longer than what was measured, "
            f"{min(extent) * 1e6:.4g} um"
        )


def _long(
    level: Array, missing: Array, spacing: tuple[float, float], index: float, periodic: bool
) -> Array:
    """Waves longer than an index: weighted means of measured points, of filled ones only amid a gap."""

    def filtered(heights: Array) -> Array:
        return smoothed(heights, [index / step for step in spacing], (0, 1), periodic=periodic)

    if not missing.any():
        return filtered(level)
    weight = filtered(1.0 - missing)
    enough = weight > LEAST_WEIGHT
    mean = filtered(np.where(missing, 0.0, level)) / np.where(enough, weight, 1.0)
    return np.where(enough, mean, filtered(level))


def _form(heights: Array) -> Array:
    """Polynomial of second order nearest to the heights that are there."""
    along, across = (np.vander(np.linspace(-1, 1, n), 5, increasing=True) for n in heights.shape)
    there = np.isfinite(heights)
    sums = along.T @ there.astype(float) @ across
    right = along[:, :3].T @ np.where(there, heights, 0.0) @ across[:, :3]
    terms = [(i, j) for i in range(3) for j in range(3 - i)]
    matrix = np.array([[sums[i + k, j + m] for k, m in terms] for i, j in terms])
    solved = np.linalg.solve(matrix, [right[term] for term in terms])
    coefficients = np.zeros((3, 3))
    for term, coefficient in zip(terms, solved, strict=True):
        coefficients[term] = coefficient
    polynomial: Array = along[:, :3] @ coefficients @ across[:, :3].T
    return polynomial


def outlying(level: Array) -> Array:
    """Where levelled heights are outliers: far from all, and from those around them too.

    A real feature as deep or high, a groove, a step or a particle, has neighbours of its own height; a spike
    of an instrument stands alone, or in a small group of which most points do.
    """
    distance = np.abs(level - np.nanmedian(level))
    far: Array = distance > MAX_HEIGHT_DEVIATION * NORMAL_OVER_MIDDLE * np.nanmedian(distance)
    if not far.any():
        return far
    padded = np.pad(level, AROUND, constant_values=np.nan)
    rows, columns = np.nonzero(far)
    around = [
        padded[rows + i, columns + j] for i in range(2 * AROUND + 1) for j in range(2 * AROUND + 1)
    ]
    alone = np.zeros_like(far)
    alone[far] = np.abs(level[far] - np.nanmedian(around, axis=0)) > ALONE * distance[far]
    group, count = scipy.ndimage.label(far, np.ones((3, 3)))
    share = scipy.ndimage.mean(alone, group, np.arange(count + 1))
    share[0] = 0.0  # what is not far
    return share[group] >= MOSTLY


def _matter(level: Array, cleaned: Array, far: Array) -> bool:
    """Whether outliers change the figures, or the contact, of which they are the highest points."""
    changed = np.nanstd(level) > CHANGED * np.nanstd(cleaned)
    highest = np.nanmax(np.abs(level[far])) > np.nanmax(np.abs(cleaned))
    return bool(changed or (highest and far.mean() > TOUCHED))


def _filled(level: Array, missing: Array) -> Array:
    """Heights with missing ones such that each is the mean of its neighbours."""
    number = np.full(level.shape, -1)
    number[missing] = np.arange(missing.sum())
    rows, columns, values = [], [], []
    right = np.zeros(missing.sum())
    count = np.zeros(missing.sum())
    for axis, step in ((0, 1), (0, -1), (1, 1), (1, -1)):
        beside, height = (_neighbours(field, axis, step) for field in (number, level))
        inside = missing & (beside > -2)
        count += inside[missing]
        known = inside & (beside == -1)
        right[number[known]] += height[known]
        unknown = inside & (beside >= 0)
        rows.append(number[unknown])
        columns.append(beside[unknown])
        values.append(np.full(unknown.sum(), -1.0))
    matrix = scipy.sparse.coo_array(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
        shape=(len(right), len(right)),
    ).tocsr() + scipy.sparse.diags_array(count)
    full = level.copy()
    full[missing] = scipy.sparse.linalg.spsolve(matrix.tocsc(), right)
    return full


def _neighbours(field: Array, axis: int, step: int) -> Array:
    """The field's value at each point's neighbour; -2 beyond the edge."""
    beside = np.roll(field, -step, axis=axis)
    edge: list[slice | int] = [slice(None)] * 2
    edge[axis] = -1 if step == 1 else 0
    beside[tuple(edge)] = -2
    return beside
