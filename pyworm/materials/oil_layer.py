"""The layer of oil that arrives at a contact, where it is not the same everywhere across the track."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.ranges import within
from pyworm.io import units
from pyworm.io.given import Given, WithUnit, in_si, take
from pyworm.io.shown import ShownFields


@dataclass(frozen=True, repr=False)
class OilLayer(ShownFields):
    """Thickness of the inlet film of a contact, over the place across its track.

    Raises:
        ValueError: Places that do not increase, or thicknesses that are negative or not as many.
    """

    across: tuple[units.Offset, ...]
    """Places across the entrainment from the contact point, to its left, increasing [m]."""
    thickness: tuple[units.FilmOrZero, ...]
    """Thickness of the oil on both surfaces together there [m]; in between linear, beyond as at the ends."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI

        def __init__(self, across: Sequence[WithUnit], thickness: Sequence[WithUnit]) -> None: ...

    def __post_init__(self) -> None:
        """Refuse what is no profile."""
        take(self)
        if len(self.across) != len(self.thickness) or len(self.across) < 2:
            raise ValueError("across, thickness: must be two numbers at least, and as many of each")
        if not all(a < b for a, b in pairwise(self.across)):
            raise ValueError("across: must increase")
        within("thickness", self.thickness, 0.0, 1.0, "m")

    def at(self, across: Given) -> Array:
        """Thickness [m] at places across the entrainment [m]."""
        return np.asarray(
            np.interp(in_si("across", across, units.Offset), self.across, self.thickness)
        )
