"""Checks whether deviations of a flank are in micrometres and at the places of that flank.

Each refusal begins with the key that is wrong.
"""

from collections.abc import Sequence

import numpy as np

from pyworm.drives.worm.teeth.gears import WormGears

MAX_DEVIATION_DIFFERENCE = 0.05
"""Maximum difference of deviations on a flank over the module."""

MAX_WORN_DIFFERENCE = 0.3
"""Largest difference of deviations on a worn flank over the module (0.3 m_x cos gamma)."""

SHORT = 0.5
"""Distance from the ends of a mesh cycle over the module within which deviations of the worm may end."""

MIN_FACE_COVERAGE = 0.9
"""Part of half of the face that deviations must reach over; those of the ends are hard to measure."""


def check_deviations(gears: WormGears) -> None:
    """Refuse deviations of other units, or of other places than the flank's (ValueError)."""
    for name, deviations in gears.deviating.items():
        spread = deviations.spread
        if deviations.worn:
            if spread > MAX_WORN_DIFFERENCE * gears.module:
                raise ValueError(f"{name} is worn by {_mm(spread)}, more than 0.3 of the module")
        elif spread > MAX_DEVIATION_DIFFERENCE * gears.module:
            raise ValueError(
                f"{name}.deviations differ by {_mm(spread)}, more than a twentieth of the module; are they "
                "in other units? deviation_um is in micrometres"
            )
    _check_wheel(gears)
    _check_worm(gears)


def _check_wheel(gears: WormGears) -> None:
    """Refuse deviations of the wheel beside its flank."""
    wheel = gears.wheel
    if wheel.deviations is None:
        return
    half, face = wheel.face_width / 2, wheel.deviations.along
    if face[0] > -MIN_FACE_COVERAGE * half or face[-1] < MIN_FACE_COVERAGE * half:
        raise ValueError(
            f"wheel.deviations reach along the face from {_mm(face[0])} to {_mm(face[-1])}; they must reach "
            f"from {_mm(-half)} to {_mm(half)}, from the middle of face_width"
        )
    _check_radii("wheel", wheel.deviations.radius, wheel.throat_radius, gears.module)


def _check_worm(gears: WormGears) -> None:
    """Refuse deviations of the worm beside the part of its threads that meets the wheel."""
    worm = gears.worm
    if worm.deviations is None:
        return
    met = gears.worm_flank.along_axis(gears.cycle.points(np.array([0.0, 1.0])))
    low, high, axial = met.min(), met.max(), worm.deviations.along
    slack = SHORT * gears.module
    if axial[0] > low + slack or axial[-1] < high - slack:
        raise ValueError(
            f"worm.deviations reach along the axis from {_mm(axial[0])} to {_mm(axial[-1])}; they must reach "
            f"from {_mm(low)} to {_mm(high)}, where the wheel touches, from the line of centres, positive to "
            "where the thrust on the driving worm acts"
        )
    _check_radii("worm", worm.deviations.radius, worm.tip_radius, gears.module)


def _check_radii(name: str, radius: Sequence[float], tip: float, module: float) -> None:
    """Refuse radii that do not reach from the middle of the flank to its tip."""
    low = tip - module
    if radius[0] > low or radius[-1] < tip:
        raise ValueError(
            f"{name}.deviations reach over the radii from {_mm(radius[0])} to {_mm(radius[-1])}; they must "
            f"reach from {_mm(low)} or less to {_mm(tip)} or more, from the {name}'s axis"
        )


def _mm(value: float) -> str:
    return f"{value * 1e3:.2f} mm"
