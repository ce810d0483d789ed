"""Flow factors of Patir and Cheng: oil between rough surfaces against oil between their mean planes.

Pressure flow factors phi multiply the flow by a pressure gradient, shear flow factors Phi_s times the
roughness and half the sliding are what a rough wall drags along (N. Patir and H. S. Cheng, J. Lubr.
Technol. 100 (1978) 12-17 and 101 (1979) 220-230). Their fits hold to a gap of 4 times the roughness; from 5
on the asymptotes of second order hold (J. H. Tripp, J. Lubr. Technol. 105 (1983) 458-465), to which the
fits fall too fast.
"""

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
from pyworm.formulas.rough_contact import open_gap

ASPECTS = np.array([1 / 9, 1 / 6, 1 / 3, 1.0, 3.0, 6.0, 9.0])
"""Peklenik numbers of the tables: correlation length along the flow over that across it."""

PRESSURE_FACTORS = (
    (1.48, 0.42),
    (1.38, 0.42),
    (1.18, 0.42),
    (0.90, 0.56),
    (0.225, 1.5),
    (0.520, 1.5),
    (0.870, 1.5),
)
"""C and r of 1 - C exp(-r H), of aspects above 1 of 1 + C H^-r (1978, table 1)."""

SHEAR_FACTORS = (
    (2.046, 1.12, 0.78, 0.03),
    (1.962, 1.08, 0.77, 0.03),
    (1.858, 1.01, 0.76, 0.03),
    (1.899, 0.98, 0.92, 0.05),
    (1.560, 0.85, 1.13, 0.08),
    (1.290, 0.62, 1.09, 0.08),
    (1.011, 0.54, 1.07, 0.08),
)
"""A1, a1, a2 and a3 of A1 H^a1 exp(-a2 H + a3 H^2) (1979, table 2, not seen in print)."""

FITTED, ASYMPTOTIC = 4.0, 5.0
"""Gaps over roughness up to which fits, and from which asymptotes hold, blended between."""

MIN_FITTED_GAP = 0.5
"""Gap over roughness below which the fits, that would diverge or be negative, go on as constants."""


def pressure_flow_factor(gap: npt.ArrayLike, aspect: float) -> Array:
    """Pressure flow factor [-], at least zero, by the gap between mean planes over the composite roughness.

    `aspect` is Peklenik's number: correlation length along the flow over that across it [-].
    """
    gap = np.asarray(gap, dtype=float)
    near, far = np.maximum(gap, MIN_FITTED_GAP), np.maximum(gap, FITTED)
    fits = np.array(
        [
            1 + c * near**-r if fitted_aspect > 1 else 1 - c * np.exp(-r * np.maximum(gap, 0.0))
            for fitted_aspect, (c, r) in zip(ASPECTS, PRESSURE_FACTORS, strict=True)
        ]
    )
    asymptote = 1 + 3 * (1 - 3 / (1 + aspect)) / far**2
    pressure_flow_factor: Array = np.maximum(_blend(gap, _between(fits, aspect), asymptote), 0.0)
    return pressure_flow_factor


def shear_flow_factor(gap: npt.ArrayLike, aspect: float) -> Array:
    """Shear flow factor [-] of a rough surface against a smooth one; arguments likewise.

    Below the fits the oil is in valleys, which move with their surface: the factor stays the same part of
    the mean thickness. Fits that vanish with the gap would let the valleys stand still.
    """
    gap = np.asarray(gap, dtype=float)
    near = np.clip(gap, MIN_FITTED_GAP, ASYMPTOTIC)
    fits = np.array([a * near**b * np.exp(-c * near + d * near**2) for a, b, c, d in SHEAR_FACTORS])
    part = open_gap(np.minimum(gap, MIN_FITTED_GAP)) / open_gap(MIN_FITTED_GAP)
    asymptote = 3 / ((1 + aspect) * np.maximum(gap, FITTED))
    shear_flow_factor: Array = part * _blend(gap, _between(fits, aspect), asymptote)
    return shear_flow_factor


def _between(fits: Array, aspect: float) -> Array:
    """Values at an aspect from those at `ASPECTS`, linear in its logarithm; the nearest beyond them."""
    place = np.interp(np.log(aspect), np.log(ASPECTS), np.arange(len(ASPECTS)))
    before = min(int(place), len(ASPECTS) - 2)
    part = place - before
    between: Array = (1 - part) * fits[before] + part * fits[before + 1]
    return between


def _blend(gap: Array, fit: Array, asymptote: Array) -> Array:
    part = np.clip((gap - FITTED) / (ASYMPTOTIC - FITTED), 0.0, 1.0)
    part = part**2 * (3 - 2 * part)
    blend: Array = (1 - part) * fit + part * asymptote
    return blend
