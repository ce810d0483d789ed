"""Computed numbers as indices."""

import numpy as np

from pyworm.formulas.arrays import Array, Indices


def whole(values: Array) -> Indices:
    """Integers of computed numbers, without their fractions; ValueError if one is not finite."""
    values = np.asarray(values)
    if not np.isfinite(values).all():
        count = values.size - int(np.isfinite(values).sum())
        raise ValueError(f"{count} of {values.size} places are not finite numbers")
    return values.astype(int)
