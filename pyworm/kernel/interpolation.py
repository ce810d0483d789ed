"""Interpolation of fields to grids of half the spacing, and positions of the levels across the film."""

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Array
from pyworm.kernel import core
from pyworm.kernel.core import fortran_array


def level_positions(levels: int) -> Array:
    """Positions of the levels across a film, from -1/2 at body 1 to 1/2 at body 2."""
    level_positions: Array = core.bindings.level_positions(levels)
    return level_positions


def at_levels(field: npt.ArrayLike, levels: int) -> Array:
    """A field at levels across a film, along its last axis, at another number of them, by a polynomial."""
    nodes: Array = np.asarray(field)
    given = nodes.shape[-1]
    if given == levels:
        return nodes
    there, here = (np.vander(level_positions(count), given) for count in (levels, given))
    return nodes @ np.linalg.solve(here.T, there.T)


def prolong(field: npt.ArrayLike) -> Array:
    """Interpolate a field along one direction or two to half the spacing, by cubics."""
    nodes = fortran_array(field)
    if nodes.ndim == 1:
        prolong: Array = core.bindings.prolong_cubic(nodes[:, np.newaxis])[:, 0]
        return prolong
    prolong = core.bindings.prolong_cubic(nodes)
    return prolong


def prolong_levels(fields: Array) -> Array:
    """Interpolate fields at levels across the film, along the last axis, to half the spacing by cubics."""
    return np.stack([prolong(level) for level in np.moveaxis(fields, -1, 0)], axis=-1)
