"""Invariants of a stress tensor: principal stresses, maximum shear stress, equivalent stresses.

Stresses are arrays whose first axis has the components xx, yy, zz, xy, xz, yz.
"""

from math import pi

import numpy as np

from pyworm.formulas.arrays import Array


def von_mises(stress: Array) -> Array:
    """Equivalent stress of the distortion energy (von Mises 1913), in the unit of the stress."""
    xx, yy, zz, xy, xz, yz = stress
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    equivalent: Array = np.sqrt(normal / 2 + 3 * (xy**2 + xz**2 + yz**2))
    return equivalent


def principal_stresses(stress: Array) -> Array:
    """Principal stresses along the first axis, largest (most tensile) first.

    Roots of the characteristic polynomial by the angle of Lode (Smith, Comm. ACM 4, 1961, 168).
    """
    xx, yy, zz, xy, xz, yz = stress
    mean = (xx + yy + zz) / 3
    a, b, c = xx - mean, yy - mean, zz - mean
    size = np.sqrt((a**2 + b**2 + c**2 + 2 * (xy**2 + xz**2 + yz**2)) / 6)
    half_determinant = (a * (b * c - yz**2) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz)) / 2
    with np.errstate(invalid="ignore", divide="ignore"):
        cosine = np.where(size > 0, half_determinant / size**3, 1.0)
    angle = np.arccos(np.clip(cosine, -1, 1)) / 3
    first, last = (mean + 2 * size * np.cos(angle + turn) for turn in (0.0, 2 * pi / 3))
    return np.stack([first, 3 * mean - first - last, last])


def max_shear_stress(stress: Array) -> Array:
    """Maximum shear stress, half the difference of the extreme principal stresses."""
    first, _, last = principal_stresses(stress)
    return np.asarray((first - last) / 2)


def tresca(stress: Array) -> Array:
    """Equivalent stress of the maximum shear stress (Tresca 1864)."""
    return 2 * max_shear_stress(stress)
