"""Computed numbers as indices."""

import numpy as np

from pyworm.formulas.arrays import Array, Indices


def whole(values: Array) -> Indices:
    """Integers of computed numbers, without their fractions.

    Raises:
        ValueError: A number is not finite; cast to an integer it would be an index like any other.
    """
    values = np.asarray(values)
    if not np.isfinite(values).all():
        count = values.size - int(np.isfinite(values).sum())
        raise ValueError(f"{count} of {values.size} places are not finite numbers")
    return values.astype(int)
