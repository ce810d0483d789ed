"""Designs of studies: points that fill ranges of several values evenly, by scipy.stats.qmc."""

from collections.abc import Mapping, Sequence
from typing import Any, Literal

import numpy as np

from pyworm.io.given import WithUnit
from pyworm.io.number_with_unit import parse_in

Method = Literal["sobol", "latin-hypercube"]
"""Scrambled sequences of Sobol' (1967), or Latin hypercubes (McKay, Beckman and Conover 1979)."""

METHODS: tuple[Method, ...] = "sobol", "latin-hypercube"
"""Designs of several values together."""


def fractions(method: Method, count: int, dimensions: int, seed: int) -> np.ndarray:
    """Points of a design in the unit cube, shape (count, dimensions).

    ValueError for Sobol points whose number is no power of two, which fill ranges unevenly.
    """
    from scipy.stats import qmc  # takes half a second to load

    if method not in METHODS:
        raise ValueError(f"method = {method!r:.40}: must be one of {', '.join(METHODS)}")
    if count < 1 or (method == "sobol" and count & (count - 1)):
        power = 1 << max(count - 1, 1).bit_length()
        raise ValueError(
            f"count = {count}: must be a power of two for Sobol points, such as {power}"
        )
    sampler = {"sobol": qmc.Sobol, "latin-hypercube": qmc.LatinHypercube}[method]
    points: np.ndarray = sampler(dimensions, seed=seed).random(count)
    return points


def spread(low: float, high: float, fraction: np.ndarray, logarithmic: bool) -> np.ndarray:
    """Values between two ends at fractions of their distance, or of that of their logarithms."""
    if logarithmic:
        values: np.ndarray = low * (high / low) ** fraction
        return values
    return low + (high - low) * fraction


def draw(
    method: Method,
    count: int,
    *,
    seed: int = 1,
    logarithmic: Sequence[str] = (),
    **ranges: tuple[WithUnit, WithUnit],
) -> Mapping[str, Sequence[WithUnit]]:
    """Draw a design for `pyworm.sweep`, `sweep(make, together=draw("sobol", 64, load=(10, 80)))`.

    Args:
        method: "sobol" or "latin-hypercube".
        count: Number of points, for "sobol" a power of two.
        seed: Whole number that decides them.
        logarithmic: Names whose logarithms are spread evenly.
        **ranges: Least and largest value of each name, numbers or texts with a unit.

    Returns:
        Values of each name, in the unit of its least one.

    Raises:
        ValueError: No such method, no range, or none that a logarithm has.
    """
    if not ranges or set(logarithmic) - ranges.keys():
        raise ValueError(
            "give the ranges of names to draw, load=(10, 80), logarithmic ones among them"
        )
    points = fractions(method, count, len(ranges), seed)
    return {
        name: _drawn(name, ends, fraction, name in logarithmic)
        for (name, ends), fraction in zip(ranges.items(), points.T, strict=True)
    }


def _drawn(name: str, ends: Any, fraction: np.ndarray, logarithmic: bool) -> Sequence[WithUnit]:
    """Values of a name between its ends."""
    try:
        low, high = ends
        unit = None
        if isinstance(low, str):
            low, unit = parse_in(low)
            high, _ = parse_in(high, unit)
        low, high = float(low), float(high)
    except (TypeError, ValueError) as error:
        raise ValueError(
            f"{name} = {ends!r:.40}: must be the least and the largest value ({error})"
        ) from None
    if not np.isfinite([low, high]).all() or not low < high or (logarithmic and low <= 0):
        zero = " and above zero" if logarithmic else ""
        raise ValueError(f"{name} = {ends!r:.40}: must be two ends that rise{zero}")
    values = [float(f"{value:.12g}") for value in spread(low, high, fraction, logarithmic)]
    return values if unit is None else [f"{value:.12g} {unit}".rstrip() for value in values]
