"""What a material endures without end, over the depth below its surface."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.fatigue import dang_van_slope
from pyworm.io import units
from pyworm.io.given import WithUnit, in_si, take
from pyworm.io.shown import ShownFields

BIAXIAL = 2 / 3
"""Hydrostatic part of equal stresses along both directions of a surface."""


@dataclass(frozen=True, repr=False)
class FatigueStrength(ShownFields):
    """Limits of a material in fatigue, with profiles over depth, interpolated linearly.

    Raises:
        ValueError: Limits that no material has, or profiles without rising depths.
    """

    bending_limit: units.Stress
    """Limit in alternating bending at the surface [Pa], above the limit in torsion."""
    torsion_limit: units.Stress
    """Limit in alternating torsion at the surface [Pa], above half of that in bending."""
    depths: tuple[units.DepthOrZero, ...] = ()
    """Depths of the profiles [m]."""
    residual_stresses: tuple[units.ResidualStress, ...] = ()
    """Residual stress along both directions of the surface at each depth [Pa], pressure negative."""
    hardnesses: tuple[units.Hardness, ...] = ()
    """Hardness at each depth [Pa], to which limits are proportional; the first is that of the limits."""

    if TYPE_CHECKING:  # given with units, kept as numbers in SI
        # fmt: off
        def __init__(
            self, bending_limit: WithUnit, torsion_limit: WithUnit, depths: Sequence[WithUnit] = ...,
            residual_stresses: Sequence[WithUnit] = ..., hardnesses: Sequence[WithUnit] = ...
        ) -> None: ...
        # fmt: on

    def __post_init__(self) -> None:
        """Read quantities with units; refuse impossible limits and profiles."""
        take(self)
        check_strength(self)

    @property
    def slope(self) -> float:
        """Weight of the hydrostatic stress in Dang Van's criterion [-]."""
        return dang_van_slope(self.bending_limit, self.torsion_limit)

    def limit(self, depths: Sequence[WithUnit] | Array) -> Array:
        """Limit in alternating torsion at depths [m], [Pa]."""
        places = np.asarray(in_si("depths", depths, units.DepthOrZero), dtype=float)
        if not self.hardnesses:
            return np.full(places.shape, self.torsion_limit)
        hardness = np.interp(places, self.depths, self.hardnesses)
        return np.asarray(self.torsion_limit * hardness / self.hardnesses[0])

    def residual(self, depths: Sequence[WithUnit] | Array) -> Array:
        """Hydrostatic part of the residual stress at depths [m], [Pa]."""
        places = np.asarray(in_si("depths", depths, units.DepthOrZero), dtype=float)
        if not self.residual_stresses:
            return np.zeros(places.shape)
        return np.asarray(BIAXIAL * np.interp(places, self.depths, self.residual_stresses))


def check_strength(strength: FatigueStrength) -> None:
    """Refuse impossible limits and profiles; ValueError."""
    ratio = strength.torsion_limit / strength.bending_limit
    if not 0.5 <= ratio < 1:
        raise ValueError(
            f"torsion_limit is {ratio:.3g} of bending_limit: must be 0.5 to 1 of it, such as 0.58 of steel"
        )
    if (np.diff(strength.depths) <= 0).any():
        raise ValueError("depths: must rise from point to point")
    for name in ("residual_stresses", "hardnesses"):
        count = len(getattr(strength, name))
        if count not in (0, len(strength.depths)):
            raise ValueError(
                f"{name}: needs one value for each of the {len(strength.depths)} depths"
            )
