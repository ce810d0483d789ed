"""A flank at an instant, of which heights over a tangent plane are asked."""

from abc import ABC, abstractmethod

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.flanks.screw_generator import Vector
from pyworm.kernel.flank_height import FlankNumbers


def dot(first: Vector, other: Vector) -> Array:
    """Scalar product of components."""
    return np.asarray(first[0] * other[0] + first[1] * other[1] + first[2] * other[2])


class FlankSurface(ABC):
    """A flank by parameters q."""

    @property
    @abstractmethod
    def numbers(self) -> FlankNumbers:
        """Its numbers for the kernel, which finds its heights."""
