"""Fatigue below a rolling and sliding contact: Dang Van's criterion, Ioannides and Harris' risk, Miner's sum.

A material point passes below the contact: time is the place along its path. Stresses are arrays whose first
axis has the components xx, yy, zz, xy, xz, yz.
"""

from collections.abc import Iterable
from math import log, sqrt

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
from pyworm.formulas.ranges import positive
from pyworm.formulas.stress_invariants import max_shear_stress
from pyworm.formulas.unit_factors import VICKERS

LIMIT_OVER_HARDNESS = 1.6e6
"""Limit in alternating bending over Vickers hardness [Pa] (Murakami 2002, below 400 HV; from memory)."""

STRESS_EXPONENT, DEPTH_EXPONENT, CYCLE_EXPONENT = 31 / 3, 7 / 3, 10 / 9
"""c, h and e of Lundberg and Palmgren's risk integral for point contacts."""

REFERENCE_RISK = -log(0.99)
"""Risk, -ln of the probability to survive, by which the risk integral is scaled: that 1 % fail..."""

REFERENCE_CYCLES, REFERENCE_EXCESS = 1e5, 0.6
"""... after so many passes at so much beyond the limit, over it (1.6 times the endurable pressure lasts 1e5
passes: ISO 6336-2's life factor of case hardened flanks, from memory) ..."""

REFERENCE_VOLUME, REFERENCE_DEPTH = 20e-9, 0.2e-3
"""... in so large a volume [m3] at such a depth [m]: 100 mm2 of a flank. An assumption."""

MOST_STEPS = 60
"""Steps towards the middle of the smallest sphere, the first by halves: its radius is found to about 1 %."""

_DEVIATOR_SCALE = np.sqrt(np.array([1.0, 1, 1, 2, 2, 2]))


def bending_limit(hardness: npt.ArrayLike) -> Array:
    """Limit in alternating bending [Pa] by the indentation hardness [Pa], 1.6 MPa for each Vickers number."""
    return np.asarray(LIMIT_OVER_HARDNESS / VICKERS * np.asarray(hardness, dtype=float))


def dang_van_slope(bending: float, torsion: float) -> float:
    """Weight of the hydrostatic stress [-], 3 (t/f - 1/2), of limits in alternating bending f and torsion t.

    Source: Dang Van, ASTM STP 1191 (1993) 120. Range: f < 2 t, t < f.
    """
    positive("limit in alternating bending", bending, "Pa")
    return 3 * (torsion / bending - 0.5)


def dang_van(history: Array, slope: float, residual: npt.ArrayLike = 0.0) -> Array:
    """Largest equivalent stress of Dang Van over a cycle [Pa]: shear about its mean, and hydrostatic stress.

        max over time of tau(t) + slope (sigma_h(t) + residual)

    tau is Tresca's shear of the deviator less the centre of the smallest sphere about its path: the residual
    stress to which a grain shakes down. It fails where this exceeds the limit in alternating torsion.

    Args:
        history: Stress over time along the second axis [Pa].
        slope: Weight of the hydrostatic stress (`dang_van_slope`).
        residual: Hydrostatic part of the residual stress [Pa], of the shape of a component without time.
    """
    hydrostatic = history[:3].mean(axis=0)
    deviator = np.array(history)
    deviator[:3] -= hydrostatic
    shear = max_shear_stress(deviator - _centre(deviator)[:, None])
    return np.asarray((shear + slope * (hydrostatic + residual)).max(axis=0))


def _centre(path: Array) -> Array:
    """Centre of the smallest sphere about a path along the second axis (Badoiu and Clarkson 2003)."""
    scale = _DEVIATOR_SCALE.reshape(-1, *[1] * (path.ndim - 1))
    scaled = path * scale
    centre = best = (scaled.max(axis=1) + scaled.min(axis=1)) / 2
    radius = np.full(path.shape[2:], np.inf)
    for step in range(1, MOST_STEPS):
        away = ((scaled - centre[:, None]) ** 2).sum(axis=0)
        farthest = np.take_along_axis(scaled, away.argmax(axis=0)[None, None], axis=1)[:, 0]
        best = np.where(away.max(axis=0) < radius, centre, best)
        radius = np.minimum(away.max(axis=0), radius)
        centre = centre + (farthest - centre) / (step + 1)
    return np.asarray(best / scale[:, 0])


def risk(stress: Array, limit: npt.ArrayLike, depths: Array) -> Array:
    """Risk of a pass for each area of a flank [1/m2]: -ln of the share that survives N is N^(10/9) of it.

    The integral over depth of (stress - limit)^c/z^h where a stress exceeds its limit, scaled by the
    reference (`REFERENCE_RISK`), whose relative excess takes the place of a strength. Source: Ioannides and
    Harris, J. Tribol. 107 (1985) 367; exponents of Lundberg and Palmgren (1947).

    Args:
        stress: Equivalent stress [Pa], depth along the first axis.
        limit: Its limit there [Pa].
        depths: Depths [m], above zero.
    """
    limits = np.broadcast_to(np.asarray(limit, dtype=float), stress.shape)
    excess = np.maximum(stress / limits - 1, 0) / REFERENCE_EXCESS
    scale = (REFERENCE_DEPTH / depths) ** DEPTH_EXPONENT
    density = excess**STRESS_EXPONENT * scale.reshape(-1, *[1] * (stress.ndim - 1))
    constant = REFERENCE_RISK / (REFERENCE_CYCLES**CYCLE_EXPONENT * REFERENCE_VOLUME)
    return np.asarray(constant * np.trapezoid(density, depths, axis=0))


def failure_probability(duty: Iterable[tuple[npt.ArrayLike, float]]) -> Array:
    """Probability of failure [-] under loads, each its risk of a pass and its number of cycles.

    Miner's sum: the share of life that each load takes is its cycles over those to the same risk, so that
    the e-th roots of the risks add up. Source: Miner, J. Appl. Mech. 12 (1945) A159; Palmgren 1924.
    """
    root = sum(
        np.asarray(one_pass, dtype=float) ** (1 / CYCLE_EXPONENT) * cycles
        for one_pass, cycles in duty
    )
    return np.asarray(-np.expm1(-(np.asarray(root) ** CYCLE_EXPONENT)))


def torsion_limit(bending: npt.ArrayLike) -> Array:
    """Limit in alternating torsion [Pa] of ductile metals by that in bending: over the root of three."""
    return np.asarray(np.asarray(bending, dtype=float) / sqrt(3))
