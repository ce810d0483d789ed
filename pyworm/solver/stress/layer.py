"""What a coating changes of the stress below the surface of a body."""

from collections.abc import Sequence

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.layered_half_space import Layer, layered_stress
from pyworm.solver.stress.tractions import Tractions

ROOM = 0.5
"""Room on both sides of the tractions over their extent: the layer's part repeats itself beyond."""

FACE = 1e-9
"""Distance from the lower face of the layer over its thickness at which stresses on both sides are taken."""


class CoatedBody:
    """A coating's part of the stress below tractions."""

    def __init__(self, layer: Layer):
        self.layer = layer
        """The layer."""
        self.faces = (layer.thickness * (1 - FACE), layer.thickness * (1 + FACE))
        """Depths just above and below its lower face [m]."""

    def stress(self, grid: Tractions, depths: Sequence[float] | Array) -> Array:
        """Stress with the layer less that of the bare body [Pa], (component, depth, nx[, ny])."""
        wide = grid.widened(ROOM)
        acting = wide.sharpened()
        inside = tuple(
            slice(round(ROOM * count), round(ROOM * count) + count) for count in grid.pressure.shape
        )
        found = [
            layered_stress(acting, grid.spacing, self.layer, float(depth))[:, *inside]
            for depth in depths
        ]
        return np.stack(found, axis=1)
