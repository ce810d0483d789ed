"""Materials of worm wheels in the worm-gear standard: stiffness, strengths, factors of friction and wear.

All numbers are those of a public transcription of DIN 3996 (the worksheet on worm gears of MITCalc, its table
of wheel materials); the standard's own text could not be read. Of CuSn12Ni2 and CuSn12 the strengths, of all
bronzes the factors of wear were found a second time, in notes that go back to the same standard.
"""

from dataclasses import dataclass
from typing import Literal

from pyworm.formulas.unknown import Unknown

Family = Literal["tin bronze", "aluminium bronze", "cast iron"]

FAMILIES: tuple[Family, ...] = ("tin bronze", "aluminium bronze", "cast iron")
"""Groups of materials with a friction at rest and a curve of base wear of their own."""


@dataclass(frozen=True)
class WheelMaterial:
    """A material of worm wheels; what the standard does not have of it is `Unknown`."""

    name: str
    """Designation of EN 1982, EN 1561 or EN 1563, as in the list of materials."""
    family: Family | Unknown
    """Group of materials."""
    friction_factor: float | Unknown
    """Y_W of the friction [-]."""
    wear_factors: dict[str, float] | Unknown
    """W_ML of the wear [-] with mineral oil, PAO and PAG."""
    pitting_strength: float | Unknown
    """sigma_HlimT [Pa]."""
    root_strength: float | Unknown
    """tau_FlimT, shear that roots of teeth endure [Pa]."""


def _wear(mineral: float, pao: float, pag: float) -> dict[str, float]:
    return {"mineral": mineral, "PAO": pao, "PAG": pag}


WHEEL_MATERIALS: dict[str, WheelMaterial] = {
    "CuSn12-C-GZ": WheelMaterial(
        "CuSn12-C-GZ", "tin bronze", 1.0, _wear(1.6, 1.6, 2.25), 425e6, 92e6
    ),
    "CuSn12Ni2-C-GZ": WheelMaterial(
        "CuSn12Ni2-C-GZ", "tin bronze", 0.95, _wear(1, 1, 1.75), 520e6, 100e6
    ),
    "CuSn12Ni2-C-GC": WheelMaterial(
        "CuSn12Ni2-C-GC", "tin bronze", 0.95, _wear(4.1, 4.1, 4.1), 520e6, 100e6
    ),
    "CuAl10Fe5Ni5-C-GZ": WheelMaterial(
        "CuAl10Fe5Ni5-C-GZ", "aluminium bronze", 1.1, _wear(1, 1, 1), 660e6, 128e6
    ),
    "EN-GJS-400-15": WheelMaterial(
        "EN-GJS-400-15", "cast iron", 1.0, _wear(1, 1, 1), 490e6, 115e6
    ),
    "EN-GJL-250": WheelMaterial(
        "EN-GJL-250", "cast iron", 1.05, _wear(1, 1, 1), 350e6, 70e6
    ),
}  # fmt: skip
"""Wheel materials of the standard by their names in the list of materials (`materials/solids.toml`)."""

_OTHER_CASTINGS = {"CuSn12-C-GC": "CuSn12-C-GZ", "CuAl10Fe5Ni5-C-GC": "CuAl10Fe5Ni5-C-GZ"}
"""Castings that the standard does not list -> the one of the same alloy, whose group and Y_W they have."""


def wheel_material(name: str) -> WheelMaterial:
    """A material of the list of materials as the worm-gear standard has it, or has it not."""
    if name in WHEEL_MATERIALS:
        return WHEEL_MATERIALS[name]
    if name in _OTHER_CASTINGS:
        lacking = Unknown(f"the worm-gear standard has no strengths and wear of {name}")
        cast = WHEEL_MATERIALS[_OTHER_CASTINGS[name]]
        return WheelMaterial(name, cast.family, cast.friction_factor, lacking, lacking, lacking)
    listed = ", ".join(WHEEL_MATERIALS)
    lacking = Unknown(
        f"{name} is not covered by the worm-gear standard (ISO/TS 14521, DIN 3996), whose wheels are of "
        f"{listed}"
    )
    return WheelMaterial(name, lacking, lacking, lacking, lacking, lacking)
