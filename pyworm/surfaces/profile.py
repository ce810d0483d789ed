"""A profile along a line, as measured by a stylus: points filled, form removed, waves filtered."""

from dataclasses import dataclass, replace

import numpy as np

from pyworm.formulas.arrays import Array, Flags
from pyworm.formulas.gaussian_filter import smoothed
from pyworm.surfaces.preparing import (
    MIN_NESTING_RATIO,
    MOST_MISSING,
    Outliers,
    outlying,
    require_index,
)

FORM_DEGREE = 2
"""Degree of the polynomial that is removed as form, as of areas."""

PART_COUNT = 4
"""Number of parts of a profile by which its figures scatter."""

CLASSES = ((0.02e-6, 0.08e-3), (0.1e-6, 0.25e-3), (2e-6, 0.8e-3), (10e-6, 2.5e-3), (80e-6, 8e-3))
"""Largest Ra [m] of each class and its nesting index [m] (ISO 21920-3, as ISO 4288; from memory)."""


@dataclass(frozen=True, eq=False)
class Profile:
    """Heights of the roughness profile, without form and the waves that filters remove."""

    height: Array
    """Heights [m] of mean zero, shape (n,)."""
    spacing: float
    """Distance of points [m]."""
    measured: Flags
    """True where a height was measured."""
    section: float
    """Section length [m], over which peaks and valleys are counted: the nesting index, or a fifth of the
    length of a profile too short for one."""
    nesting_index: float | None = None
    """Longest wave of the roughness [m]; None where form alone was removed."""
    waviness: float = 0.0
    """Root mean square height of the longer waves that were removed [m]."""
    outliers: int = 0
    """Number of outliers that were left out."""

    @property
    def length(self) -> float:
        """Evaluation length [m]."""
        return len(self.height) * self.spacing

    @property
    def filled(self) -> float:
        """Fraction of points that were missing or left out, and filled."""
        return float(1 - self.measured.mean())

    @property
    def parts(self) -> "tuple[Profile, ...]":
        """`PART_COUNT` profiles, each a part of its length, without form of its own as the whole is."""
        count = len(self.height) // PART_COUNT
        places = [slice(number * count, (number + 1) * count) for number in range(PART_COUNT)]
        return tuple(
            replace(
                self,
                height=_without_form(self.height[place]),
                measured=self.measured[place],
            )
            for place in places
        )

    @property
    def sections(self) -> list[Array]:
        """Heights [m] of its whole sections, at least one."""
        points = max(2, round(self.section / self.spacing))
        count = max(1, len(self.height) // points)
        return np.array_split(self.height[: count * points], count)


def roughness_profile(
    heights: Array,
    spacing: float,
    *,
    nesting_index: float | None = None,
    shortest_wave: float | None = None,
    outliers: Outliers = "refuse",
    fill: float = MOST_MISSING,
    by_class: bool = True,
) -> Profile:
    """Fill, level and filter heights (n,) [m], NaN where missing, of points so far apart [m].

    Form is a polynomial of second order. Filters are Gaussian (ISO 16610-21, ends by ISO 16610-28):
    `nesting_index` is the longest wave of the roughness [m]; without it that of the class by Ra (`CLASSES`),
    of a profile as long as that, or with `by_class` false form alone is removed; `shortest_wave` filters
    noise [m]. Outliers are to "refuse", "fill" or "keep"; `fill` is the largest fraction of points that may
    be missing. ValueError for too many missing points, outliers, or an index that the profile does not hold.
    """
    heights = np.where(np.isfinite(heights), heights, np.nan)
    for name, index in (("nesting_index", nesting_index), ("shortest_wave", shortest_wave)):
        require_index(name, index, (spacing,), [len(heights) * spacing])
    _require_most(heights, fill)
    level, outlier_count = _without_form(heights), 0
    if outliers != "keep" and (far := outlying(level[:, None])[:, 0]).any():
        if outliers == "refuse":
            raise ValueError(
                f"has {far.sum()} outliers, up to {np.nanmax(np.abs(level[far])) * 1e6:.3g} um from the "
                'mean; give outliers = "fill" to leave them out, or "keep" if they are real'
            )
        heights, outlier_count = np.where(far, np.nan, heights), int(far.sum())
        _require_most(heights, fill)
        level = _without_form(heights)
    measured = np.isfinite(level)
    places = np.arange(len(level))
    level = np.interp(places, places[measured], level[measured])
    if not level.std() > 0:
        raise ValueError("is flat: all heights are equal after levelling")
    if shortest_wave is not None:
        level = _long(level, shortest_wave / spacing)
    waves = np.zeros_like(level)
    if nesting_index is None and by_class:
        nesting_index = _usual_index(level, spacing)
    if nesting_index is not None:
        waves = _long(level, nesting_index / spacing)
    rough = level - waves
    section = nesting_index or len(level) * spacing / 5
    return Profile(
        rough - rough.mean(),
        spacing,
        measured,
        section,
        nesting_index,
        float(waves.std()),
        outlier_count,
    )


def _require_most(heights: Array, fill: float) -> None:
    missing = float(np.isnan(heights).mean())
    if missing > fill:
        raise ValueError(
            f"{missing * 100:.0f} % of its points are missing, at most {fill * 100:.0f} % are filled"
        )


def _without_form(heights: Array) -> Array:
    place, there = np.linspace(-1, 1, len(heights)), np.isfinite(heights)
    form = np.polynomial.Polynomial.fit(place[there], heights[there], FORM_DEGREE)
    level: Array = heights - form(place)
    return level


def _usual_index(level: Array, spacing: float) -> float | None:
    """The nesting index of the first class whose Ra a profile does not exceed; None if it is too short."""
    for most, index in CLASSES:
        if index > len(level) * spacing:
            return None
        if index >= MIN_NESTING_RATIO * spacing:
            rough = level - _long(level, index / spacing)
            if np.abs(rough - rough.mean()).mean() <= most:
                return index
    return None


def _long(level: Array, index: float) -> Array:
    return smoothed(level, [index], (0,), periodic=False)
