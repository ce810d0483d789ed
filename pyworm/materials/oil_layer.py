"""The layer of oil that arrives at a contact, where it is not the same everywhere across the track."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from pyworm.formulas.ranges import within


@dataclass(frozen=True)
class OilLayer:
    """Thickness of the oil that arrives at a contact, over the place across its track.

    Attributes
    ----------
    across : tuple of float
        Places across the entrainment from the contact point, to its left, increasing [m].
    thickness : tuple of float
        Thickness of the oil on both surfaces together there [m]; in between linear, beyond as at the ends.

    Raises
    ------
    ValueError
        Places that do not increase, or thicknesses that are negative or not as many.
    """

    across: tuple[float, ...]
    thickness: tuple[float, ...]

    def __post_init__(self) -> None:
        """Refuse what is no profile."""
        if len(self.across) != len(self.thickness) or len(self.across) < 2:
            raise ValueError("across, thickness: must be two numbers at least, and as many of each")
        if not all(a < b for a, b in pairwise(self.across)):
            raise ValueError("across: must increase")
        within("thickness", self.thickness, 0.0, 1.0, "m")

    def at(self, across: np.ndarray) -> np.ndarray:
        """Thickness [m] at places across the entrainment [m]."""
        return np.interp(across, self.across, self.thickness)
