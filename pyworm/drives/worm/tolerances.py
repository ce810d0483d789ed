"""Errors of the assembly that a worm drive allows, one at a time.

An error is allowed as long as the largest dry pressure at mid-mesh is at most `RISE` times that without
errors, on the flanks as they are, edges included, and the teeth have play. Both directions differ: away from
the wheel crowning vanishes and the contact moves to an edge, towards it the play is used up.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import degrees
from typing import Literal

import scipy

from pyworm.drives.worm.drawing.design import AS_DESIGNED, Assembly
from pyworm.drives.worm.loads.dry_contact import dry_contact_of
from pyworm.drives.worm.loads.mesh import WormMesh

RISE = 1.2
"""Allowed pressure over that without errors [-], assumed without a source: that of the same contact under a
load larger by 70 %."""

FIRST_ERROR, MAX_ERROR = 1 / 80, 1 / 4
"""First error that is tried and the largest, over the axial module."""

ROUGHLY = 0.05
"""Accuracy of an allowed error, over it."""

UNASSEMBLED_EXCESS = 10.0
"""Excess of errors with which teeth cannot be assembled."""

ENTRIES = ("centre_distance", "axial_shift", "shaft_angle")
"""Errors of `Assembly`."""

Limit = Literal["pressure", "backlash", "none within reach"]


@dataclass(frozen=True)
class Tolerance:
    """The allowed errors of one kind."""

    entry: str
    """Entry of `Assembly`."""
    low: float
    """Smallest allowed error [m] or [rad]."""
    high: float
    """Largest allowed error [m] or [rad]."""
    low_limit: Limit
    """Limit of the smallest error: "pressure", "backlash", or "none within reach" of module/4."""
    high_limit: Limit
    """What limits the largest error, likewise."""

    @property
    def row(self) -> dict[str, float | str]:
        """As one object; angles in degrees, units in the keys."""
        angle = self.entry == "shaft_angle"
        unit, low, high = (
            ("deg", degrees(self.low), degrees(self.high)) if angle else ("m", self.low, self.high)
        )
        return {
            f"from_{unit}": low,
            f"to_{unit}": high,
            "from_limited_by": self.low_limit,
            "to_limited_by": self.high_limit,
        }


def tolerances(mesh: WormMesh) -> tuple[Tolerance, ...]:
    """The errors that a drive allows, each alone, under its load at mid-mesh without errors."""
    designed = replace(mesh, assembly=AS_DESIGNED)
    load = designed.mid_mesh_load
    allowed = RISE * dry_contact_of(designed, load).pressure_max
    return tuple(_tolerance(designed, load, allowed, entry) for entry in ENTRIES)


def _tolerance(mesh: WormMesh, load: float, allowed: float, entry: str) -> Tolerance:
    # a tilt moves the ends of the face by as much as a shift does
    unit = mesh.module / (mesh.wheel.face_width / 2 if entry == "shaft_angle" else 1.0)

    def off(error: float) -> WormMesh:
        return replace(mesh, assembly=Assembly(**{entry: error * unit}))

    def pressure(error: float) -> float:
        """Pressure over the allowed one, less 1; large where the flanks do not reach each other."""
        try:
            return dry_contact_of(off(error), load).pressure_max / allowed - 1
        except ValueError:
            return UNASSEMBLED_EXCESS

    def jammed(error: float) -> float:
        """Missing play over the module; large where a tip touches a root."""
        try:
            return -(off(error).play or 0.0) / mesh.module
        except ValueError:
            return UNASSEMBLED_EXCESS

    low, high = (_allowed(sign, pressure, jammed) for sign in (-1, 1))
    return Tolerance(entry, -low[0] * unit, high[0] * unit, low[1], high[1])


Excess = Callable[[float], float]
"""Error over the module -> what of it is too much; negative where it is allowed."""


def _allowed(sign: int, pressure: Excess, jammed: Excess) -> tuple[float, Limit]:
    """Largest allowed size of an error with a sign, and what limits it."""
    size = _first_beyond(lambda error: pressure(sign * error))
    limit: Limit = "pressure"
    if size == MAX_ERROR:
        limit = "none within reach"
    if jammed(sign * size) > 0:
        return _root(lambda error: jammed(sign * error), 0.0, size), "backlash"
    return size, limit


def _first_beyond(excess: Excess) -> float:
    """Size up to which an excess is negative, `MAX_ERROR` at most."""
    inside, beyond = 0.0, FIRST_ERROR
    while excess(beyond) <= 0:
        if beyond >= MAX_ERROR:
            return MAX_ERROR
        inside, beyond = beyond, min(2 * beyond, MAX_ERROR)
    return _root(excess, inside, beyond)


def _root(excess: Excess, inside: float, beyond: float) -> float:
    """Size between two at which an excess vanishes; the first one if it is positive from there on."""
    if excess(inside) > 0:
        return inside
    return float(scipy.optimize.brentq(excess, inside, beyond, xtol=ROUGHLY * beyond, rtol=ROUGHLY))
