"""A contact over time by its load, motion and radii: the states that a `Life` goes through."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.life import Life, unturned
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.point import Paraboloid, RigidMotion
from pyworm.scene.waves import velocities

OverTime = Callable[[float], float]
"""Time since the beginning [s] -> a number."""

DISTANCE_STEPS = 16
"""Intervals between two knots over which velocities that are functions of time are integrated."""


@dataclass(frozen=True)
class Interpolated:
    """Values at some times, straight between them."""

    times: tuple[float, ...]
    """Times since the beginning [s]."""
    values: tuple[float, ...]
    """The values at these times."""
    scale: float = 1.0
    """What they are multiplied by."""

    def __call__(self, seconds: float) -> float:
        """The value at a time [s]."""
        return float(np.interp(seconds, self.times, self.values)) * self.scale


@dataclass(frozen=True, kw_only=True)
class History:
    """Time since the beginning [s] -> the contact then; ValueError where it carries no load."""

    contact: AnyContact
    """The contact, of which everything that is not given stays as it is."""
    times: tuple[float, ...]
    """Knots [s], the first of them zero: what is given is smooth between them."""
    load: OverTime | None = None
    """Normal load [N], of a line contact for each length [N/m]."""
    speed: OverTime | None = None
    """Factor of the surfaces' velocities and spins [-]."""
    sliding: OverTime | None = None
    """Velocity of body 1 relative to body 2 [m/s], along the sliding of the contact, or along its
    entrainment if it does not slide."""
    radii: tuple[OverTime, ...] | None = None
    """Relative radii of curvature along each direction [m]."""
    separation: OverTime | None = None
    """Distance of the undeformed surfaces [m], which holds where the load is zero."""

    @property
    def life(self) -> Life[AnyContact]:
        """The life of the contact from the first of the times to the last."""
        return Life(self.times[-1], self, unturned, self.times[1:-1])

    def __call__(self, seconds: float) -> AnyContact:
        """The contact at a time [s]."""
        curved = self.contact
        if self.radii is not None:
            curved = _curved(curved, tuple(radius(seconds) for radius in self.radii))
        factor = 1.0 if self.speed is None else self.speed(seconds)
        moving = _moving(curved, factor, self._velocities(seconds))
        moving = replace(moving, travelled=self._travelled(seconds))
        load = self.contact.load if self.load is None else self.load(seconds)
        if load > 0:
            return replace(moving, load=load)
        if self.separation is None:
            raise ValueError("the contact carries no load")
        return replace(moving, separation=self.separation(seconds))

    def _velocities(self, seconds: float) -> Array:
        """Velocities [m/s] of both bodies, shape (2, directions)."""
        factor = 1.0 if self.speed is None else self.speed(seconds)
        whole = np.array(velocities(self.contact))
        if self.sliding is None:
            scaled: Array = factor * whole
            return scaled
        mean, difference = whole.mean(axis=0), whole[0] - whole[1]
        along = difference if difference.any() else mean
        half = self.sliding(seconds) / 2 * along / np.linalg.norm(along)
        return np.array([factor * mean + half, factor * mean - half])

    def _travelled(self, seconds: float) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """How far the surfaces are from their place at the last time, along each direction [m]."""
        knots = np.array([seconds, *(time for time in self.times if time > seconds)])
        if not {type(self.speed), type(self.sliding)} <= {type(None), Interpolated}:
            parts = np.linspace(0, knots.size - 1, DISTANCE_STEPS * (knots.size - 1) + 1)
            knots = np.interp(parts, np.arange(knots.size), knots)
        if self.sliding is None:  # by the factor, whose sum is that of both surfaces
            factors = np.ones(knots.size)
            if self.speed is not None:
                factors = np.array([self.speed(knot) for knot in knots.tolist()])
            left = float(np.trapezoid(factors, knots)) * np.array(velocities(self.contact))
        else:
            along = np.array([self._velocities(knot) for knot in knots.tolist()])
            left = np.trapezoid(along, knots, axis=0)
        first, second = (-left).tolist()
        return tuple(first), tuple(second)


def _moving(contact: AnyContact, factor: float, speeds: Array) -> AnyContact:
    """A contact with other velocities [m/s] of both bodies, and its spins times a factor."""
    if isinstance(contact, LineScene):
        first, second = speeds[:, 0].tolist()
        return replace(contact, velocities=(first, second))
    spins = [motion.spin for motion in contact.motions if isinstance(motion, RigidMotion)]
    body_1, body_2 = (
        RigidMotion(u, v, factor * spin)
        for (u, v), spin in zip(speeds.tolist(), spins, strict=True)
    )
    return replace(contact, motions=(body_1, body_2))


def _curved(contact: AnyContact, radii: tuple[float, ...]) -> AnyContact:
    """A contact with other radii of curvature [m]."""
    if isinstance(contact, LineScene):
        return replace(contact, gap=Parabola(*radii), radius=radii[0])
    along_x, along_y = radii
    return replace(contact, gap=Paraboloid(along_x, along_y), radii=(along_x, along_y))
