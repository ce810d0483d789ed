"""Whether measured heights are those of a surface that there is: else a unit was mistaken."""

from math import atan, degrees, hypot, inf, log, radians, tan

import numpy as np

from pyworm.materials.topography import Topography
from pyworm.surfaces.parameters import slopes

Array = np.ndarray

SIDES = 1e-8, 1.0
"""Shortest and longest side [m]: a scan of an atomic force microscope, a large part on a table."""

MAX_HEIGHT = 1e3
"""Size of a height [m] beyond which it is none, in whatever unit: a mark of a missing point, or damage."""

MIN_RMS_HEIGHT = 1e-11
"""Least root mean square height [m]: a tenth of an atom; cleaved mica has some 0.05 nm."""

MAX_RMS_SLOPE = radians(60)
"""Largest root mean square slope [rad]: optics and styli measure no steeper ones."""


USUAL = 0.5e-6
"""Root mean square height of a ground flank [m], by which the unit of bare numbers is guessed."""

UNITS = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "nm": 1e-9}


def likely_unit(deviation: float) -> str:
    """The unit in which heights of a standard deviation, a bare number, are most likely given."""
    if not 0 < deviation < inf:
        return "um"
    return min(UNITS, key=lambda unit: abs(log(deviation * UNITS[unit] / USUAL)))


def _worst_side(points: tuple[int, ...], steps: tuple[float, ...]) -> float:
    """The side [m] that is least plausible, of points so far apart [m] along x and y."""
    sides = [count * step for count, step in zip(points, steps, strict=True)]
    return max(sides, key=lambda side: max(side / SIDES[1], SIDES[0] / side) if side > 0 else inf)


def plausible_side(points: tuple[int, ...], steps: tuple[float, ...]) -> bool:
    """Whether an area of points so far apart [m] along x and y has sides that measurements have."""
    return SIDES[0] <= _worst_side(points, steps) <= SIDES[1]


def require_plausible_sides(points: tuple[int, ...], steps: tuple[float, ...], given: bool) -> None:
    """Refuse an area, of steps [m] given by the user or the file, that no measurement has (ValueError)."""
    if plausible_side(points, steps):
        return
    mended = (
        "check the unit of spacing"
        if given
        else 'if its own distance of points is wrong, give spacing = "0.5 um" in its place'
    )
    raise ValueError(
        f"has a side of {_worst_side(points, steps):.3g} m, points {max(steps):.3g} m apart; sides are "
        f"between {SIDES[0]:g} m and {SIDES[1]:g} m; {mended}"
    )


def require_plausible(surface: Topography) -> None:
    """Refuse heights and slopes, without form, that no surface has (ValueError)."""
    spacing = float(np.min(surface.spacing))
    _require_plausible(surface.rms, hypot(*slopes(surface)), spacing)


def require_plausible_profile(height: Array, spacing: float) -> None:
    """Refuse a profile [m] of points so far apart [m] that no surface has (ValueError)."""
    steepness = float(np.sqrt(np.mean(np.diff(height) ** 2))) / spacing
    _require_plausible(float(height.std()), steepness, spacing)


def _require_plausible(rms: float, steepness: float, spacing: float) -> None:
    if rms < MIN_RMS_HEIGHT:
        raise ValueError(
            f"has heights of {rms * 1e9:.2g} nm root mean square, less than "
            f"{MIN_RMS_HEIGHT * 1e9:g} nm, a tenth of an atom; check the unit of its heights, height_unit"
        )
    if steepness > tan(MAX_RMS_SLOPE):
        raise ValueError(
            f"has a root mean square slope of {degrees(atan(steepness)):.3g} degrees, more than "
            f"{degrees(MAX_RMS_SLOPE):g}, with heights of {rms * 1e6:.3g} um and points "
            f"{spacing * 1e6:.3g} um apart; check the units of both, height_unit and spacing"
        )


def require_possible_heights(heights: Array) -> None:
    """Refuse heights [m] that are infinite or larger than any unit makes them; NaN are missing points."""
    highest = float(np.nanmax(np.abs(heights), initial=0.0))
    if highest > MAX_HEIGHT:
        raise ValueError(
            f"has a height of {highest:.3g} m, which no surface has; points that are missing must be NaN"
        )
