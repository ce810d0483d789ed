"""Interpolation of fields to grids of half the spacing, and positions of the levels across the film."""

import numpy as np

from pyworm.kernel import core
from pyworm.kernel.core import fortran_array


def level_positions(levels: int) -> np.ndarray:
    """Where the levels across a film are, from -1/2 at body 1 to 1/2 at body 2."""
    return core.bindings.level_positions(levels)


def prolong(field) -> np.ndarray:
    """A field along one direction or two on the grid of half the spacing, by cubic interpolation."""
    field = fortran_array(field)
    if field.ndim == 1:
        return core.bindings.prolong_cubic(field[:, np.newaxis])[:, 0]
    return core.bindings.prolong_cubic(field)


def prolong_levels(fields) -> np.ndarray:
    """The same for fields at levels across the film, the last index."""
    return np.stack([prolong(level) for level in np.moveaxis(fields, -1, 0)], axis=-1)
