"""Roots of threads, teeth and pins under the loads of a mesh cycle."""

from dataclasses import dataclass

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.root_bending import bearing_width, pin_root_stress, plate_root_stress


@dataclass(frozen=True)
class LoadedRoot:
    """The root of a thread, a tooth or a pin; arrays over the contact lines of a mesh cycle."""

    name: str
    """What it is: "worm thread", "wheel tooth" or "roller pin"."""
    body: int
    """Number of its body."""
    phase: Array
    """Phase of each contact line."""
    force: Array
    """Force across the root [N]."""
    arm: Array
    """Its arm [m]."""
    line: Array
    """Length of the loaded line [m]."""
    thickness: float
    """Thickness of the root, or diameter of the pin [m]."""
    width: float
    """Length of the root [m]; 0 of a round pin."""
    words: str
    """The model, in a sentence."""

    @property
    def stress(self) -> Array:
        """Equivalent stress at the root under each contact line [Pa]."""
        lines = zip(self.force, self.arm, self.line, strict=True)
        return np.array([self._stress(*map(float, line)) for line in lines])

    def _stress(self, force: float, arm: float, line: float) -> float:
        if not self.width:
            return pin_root_stress(force, arm, self.thickness)
        width = bearing_width(arm, line, self.width)
        return plate_root_stress(force, arm, self.thickness, width)
