"""Materials of worm wheels in the worm-gear standard: stiffness, strengths, factors of friction and wear.

All numbers are those of a public transcription of DIN 3996 (the worksheet on worm gears of MITCalc, its table
of wheel materials); the standard's own text could not be read. Of CuSn12Ni2 and CuSn12 the strengths, of all
bronzes the factors of wear were found a second time, in notes that go back to the same standard.
"""

from dataclasses import dataclass
from typing import Literal

Family = Literal["tin bronze", "aluminium bronze", "cast iron"]

WheelMaterialName = Literal[
    "CuSn12", "CuSn12Ni2", "CuSn12Ni2-GC", "CuAl10Fe5Ni5", "EN-GJS-400-15", "EN-GJL-250"
]

FAMILIES: tuple[Family, ...] = ("tin bronze", "aluminium bronze", "cast iron")
"""Groups of materials with a friction at rest and a curve of base wear of their own."""


@dataclass(frozen=True)
class WheelMaterial:
    """A material of worm wheels.

    Attributes
    ----------
    name : str
        Designation of EN 1982, EN 1561 or EN 1563.
    family : str
        Group of materials.
    friction_factor : float
        Y_W of the friction [-].
    wear_factors : dict of str to float
        W_ML of the wear [-] with mineral oil, PAO and PAG.
    pitting_strength : float
        sigma_HlimT [Pa].
    root_strength : float
        tau_FlimT, shear that roots of teeth endure [Pa].
    """

    name: str
    family: Family
    friction_factor: float
    wear_factors: dict[str, float]
    pitting_strength: float
    root_strength: float


def _wear(mineral: float, pao: float, pag: float) -> dict[str, float]:
    return {"mineral": mineral, "PAO": pao, "PAG": pag}


WHEEL_MATERIALS: dict[WheelMaterialName, WheelMaterial] = {
    "CuSn12": WheelMaterial(
        "CuSn12-C-GZ", "tin bronze", 1.0, _wear(1.6, 1.6, 2.25), 425e6, 92e6
    ),
    "CuSn12Ni2": WheelMaterial(
        "CuSn12Ni2-C-GZ", "tin bronze", 0.95, _wear(1, 1, 1.75), 520e6, 100e6
    ),
    "CuSn12Ni2-GC": WheelMaterial(
        "CuSn12Ni2-C-GC", "tin bronze", 0.95, _wear(4.1, 4.1, 4.1), 520e6, 100e6
    ),
    "CuAl10Fe5Ni5": WheelMaterial(
        "CuAl10Fe5Ni5-C-GZ", "aluminium bronze", 1.1, _wear(1, 1, 1), 660e6, 128e6
    ),
    "EN-GJS-400-15": WheelMaterial(
        "EN-GJS-400-15", "cast iron", 1.0, _wear(1, 1, 1), 490e6, 115e6
    ),
    "EN-GJL-250": WheelMaterial(
        "EN-GJL-250", "cast iron", 1.05, _wear(1, 1, 1), 350e6, 70e6
    ),
}  # fmt: skip
"""Wheel materials by the name that a case gives; GZ is cast in a centrifuge, GC continuously."""
