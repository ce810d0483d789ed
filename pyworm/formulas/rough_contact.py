"""Pressure and real area of contact of nominally flat rough surfaces, by the gap between their mean planes.

Three curves of one pair of surfaces: asperities of one radius and heights spread normally (J. A. Greenwood
and J. H. Tripp, Proc. IMechE 185 (1970) 625-633), elastic surfaces that are rough on all scales, whose
pressure falls exponentially with the gap (B. N. J. Persson, arXiv:0706.2762), and plastic ones, which bear
their hardness over the area in which they would overlap (E. J. Abbott and F. A. Firestone, Mechanical
Engineering 55 (1933) 569).
"""

from math import pi, sqrt

import numpy as np
import numpy.typing as npt
import scipy

from pyworm.formulas.arrays import Array

RQ_OVER_RA = sqrt(pi / 2)
"""Root mean square over arithmetic mean of heights spread normally."""

GREENWOOD_TRIPP = 16 * sqrt(2) * pi / 15
"""Factor of their pressure, equation 11."""

SELF_AFFINE_PRESSURE, SELF_AFFINE_LENGTH, SELF_AFFINE_AREA = 0.34, 0.47, 2.0
"""Pressure at mean planes that touch over E* h'rms, the gap over Rq in which pressure falls e-fold, and the
real area of contact times E* h'rms over the pressure, of a Hurst exponent of 0.8. The cell solver
(`pyworm/surfaces/cell.py`) finds 0.34 to 0.43, 0.43 to 0.49 and 2.2 to 2.6 on six surfaces; Persson's theory
has an area of 1.6, and C. Akarapu, T. Sharp and M. O. Robbins, PRL 106 (2011) 204301, a length of 0.48 (from
memory)."""


MAX_GAP_RATIO = 35.0
"""Gap over the roughness that no height reaches: the normal distribution beyond it is less than 1e-260."""


def overlap_moment(order: float, gap: npt.ArrayLike) -> Array:
    """Moment F_n(H) = int_H^inf (t - H)^n exp(-t^2/2) dt / sqrt(2 pi) of the heights above a gap H.

    n is above -1; 5/2 gives the pressure and 2 the real area of Greenwood and Tripp's contact.
    """
    gap = np.asarray(gap, dtype=float)
    near = np.minimum(gap, MAX_GAP_RATIO)
    # D_-n-1(H) exp(-H^2/4) is the integral times sqrt(2 pi)/Gamma(n + 1) (Abramowitz and Stegun, 19.5.3)
    cylinder = scipy.special.pbdv(-order - 1, near)[0]
    moment = scipy.special.gamma(order + 1) / sqrt(2 * pi) * np.exp(-(near**2) / 4) * cylinder
    return np.where(gap < MAX_GAP_RATIO, moment, 0.0)


def open_gap(gap: npt.ArrayLike) -> Array:
    """Mean thickness of the gap over the roughness [-], where surfaces of normal heights overlap nowhere."""
    gap = np.asarray(gap, dtype=float)
    thickness = gap * scipy.special.ndtr(gap) + np.exp(-(gap**2) / 2) / sqrt(2 * pi)
    open_gap: Array = np.maximum(thickness, 0.0)
    return open_gap


def greenwood_tripp(
    gap: npt.ArrayLike, density: float, sharpness: float, modulus: float
) -> tuple[Array, Array]:
    """Pressure [Pa] and real area over the nominal one of two rough surfaces with spherical asperities.

    By the gap between mean planes over the composite roughness, the number density of asperities times their
    radius times that roughness, usually 0.03 to 0.05, the roughness over their radius (`sharpness`), and E* =
    E'/2 [Pa].
    """
    pressure = GREENWOOD_TRIPP * density**2 * sqrt(sharpness) * modulus * overlap_moment(2.5, gap)
    return pressure, (pi * density) ** 2 * overlap_moment(2.0, gap)


def self_affine(gap: npt.ArrayLike, slope: float, modulus: float) -> tuple[Array, Array]:
    """Pressure [Pa] and real area over the nominal one of elastic surfaces that are rough on all scales.

    By the gap between mean planes over the composite roughness, the composite root mean square slope h'rms,
    and E* = E'/2 [Pa].
    """
    scale = modulus * slope
    pressure = (
        SELF_AFFINE_PRESSURE * scale * np.exp(-np.asarray(gap, dtype=float) / SELF_AFFINE_LENGTH)
    )
    return pressure, np.minimum(SELF_AFFINE_AREA * pressure / scale, 1.0)
