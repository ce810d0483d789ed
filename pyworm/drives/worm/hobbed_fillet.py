"""Fillet of a wheel's tooth: the envelope of the rounded tip of its hob."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array, Components
from pyworm.drives.worm.flanks.screw_generator import ScrewGenerator
from pyworm.drives.worm.flanks.surfaces import WheelSurface, WormSurface
from pyworm.drives.worm.flanks.swept_helicoid import SweptHelicoid
from pyworm.drives.worm.flanks.swept_wheel import SweptWheel
from pyworm.drives.worm.thread_solid import FILLET_STEPS, TipArc, tip_arc

SHARP_EDGE = 1e-6
"""Radius [m] of the edge of a hob's tip that is not rounded."""

EVEN = 0.4
"""First step of the arc's angle over the mean one: the cut moves fast where it leaves the flank."""

COMPLEX_STEP = 1e-30
"""Step of derivatives by complex step."""

MAX_STEPS = 40

CONVERGED = 1e-12
"""Newton step below which nothing is gained."""

MAX_NEWTON_STEP = 0.2
"""Longest Newton step that is taken whole [rad]."""


@dataclass(frozen=True)
class RoundedTip(ScrewGenerator):
    """The helicoid swept by the rounded edge of a thread's tip; its parameter is the arc's angle [rad]."""

    arc: TipArc
    """The edge."""
    screw: float
    """Advance per radian, lead / 2 pi [m]."""

    @property
    def start_radius(self) -> float:
        """Radius at which it leaves the flank [m]."""
        return self.arc.radius + self.arc.rounding * float(np.cos(self.arc.first))

    @property
    def bounds(self) -> tuple[float, float]:
        """Angles of the arc from the flank to the tip [rad]."""
        return self.arc.first, 0.0

    def curve(self, u: Array | float) -> tuple[Components, Components, Components]:
        """The arc and its derivatives by its angle."""
        out, up = self.arc.rounding * np.cos(u), self.arc.rounding * np.sin(u)
        return (
            (self.arc.radius + out, 0.0, self.arc.height + up),
            (-up, 0.0, out),
            (-out, 0.0, -up),
        )

    def at_radius(self, radius: Array | float) -> Array:
        """Angle of the arc at a distance from the axis [m]."""
        return -np.arccos((np.asarray(radius) - self.arc.radius) / self.arc.rounding)


def rounded_hob(hob: WormSurface, form_radius: float, rounding: float, ratio: float) -> SweptWheel:
    """What the rounded tip of a hob cuts, which begins on its flank at a form radius [m]."""
    arc = tip_arc(hob, form_radius, max(rounding, SHARP_EDGE))
    seat = hob.centre_distance, hob.swivel, hob.axial_shift
    return SweptWheel(SweptHelicoid(RoundedTip(arc, hob.screw), 1.0, *seat), ratio)


def fillet_points(
    cutter: SweptWheel, cut: Array, roll: Array, along: Array, finer: int = 1
) -> Array:
    """Points of a fillet (points, along, 3) [m] at places along the wheel's axis, in the wheel's frame.

    They begin on the flank at points (3, along) [m], as cut at a roll of the wheel [rad]. ValueError
    where the hob's tip cuts none.
    """
    hob = cutter.hob
    x, y, _ = hob.axes.T @ (cut - hob.axis_point[:, None])
    # the arc at the turn zero has the polar angle zero
    q = np.stack([np.arctan2(y, x), roll])
    found = []
    part = np.linspace(0.0, 1.0, finer * FILLET_STEPS + 1)
    part = EVEN * part + (1 - EVEN) * part**2
    for angle in hob.bounds[0] * (1 - part):

        def missed(q: Array, angle: float = float(angle)) -> Array:
            on = cutter.cut(np.asarray(angle), q[0], q[1])
            size = hob.centre_distance * hob.generator.arc.rounding  # type: ignore[attr-defined]
            return np.stack(
                [np.asarray(on.point[1]) - along, on.miss / (size * hob.centre_distance)]
            )

        q = solved(missed, q)
        found.append(np.moveaxis(cutter.point(np.full(along.shape, angle), *q), 0, -1))
    return np.array(found)


def solved(missed: Callable[[Array], Array], q: Array) -> Array:
    """Unknowns (n, points) at which n equations hold, by Newton's method with derivatives by complex step.

    ValueError where it does not converge.
    """
    for _ in range(MAX_STEPS):
        count = len(q)
        moved = np.repeat(q[:, None].astype(complex), count, axis=1)
        moved[np.arange(count), np.arange(count)] += COMPLEX_STEP * 1j
        value = missed(moved)
        slopes = np.moveaxis(value.imag / COMPLEX_STEP, -1, 0)
        right = value[:, 0].real.T[..., None]
        step = np.linalg.solve(slopes, right)[..., 0].T
        largest = np.abs(step).max(axis=0)
        q = q - step * (MAX_NEWTON_STEP / np.maximum(largest, MAX_NEWTON_STEP))
        if largest.max() < CONVERGED:
            return q
    raise ValueError("wheel: its fillet is not found where the tip of its hob cuts it")


def envelope_equations(flank: WheelSurface, q: Array) -> tuple[Array, list[Array]]:
    """Points (3, ...) at which the hob cuts, and what else has to vanish there."""
    if isinstance(flank, SweptWheel):
        cut = flank.cut(*q)
        return np.stack(np.broadcast_arrays(*cut.point)), [cut.miss / flank.hob.size]
    return flank.cut_point(*q), []
