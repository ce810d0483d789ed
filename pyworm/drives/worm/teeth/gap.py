"""The gap and the surface velocities of a tooth contact, for a scene."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyworm.drives.worm.flanks.flank_height import FlankHeight
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.teeth.mesh_cycle import ToothContact
from pyworm.drives.worm.teeth.tooth import WheelTooth, WormTooth


def surface_points(contact: ToothContact, x: Array, y: Array, height: Array) -> Array:
    """Points in the drive frame, (3, ...) [m], above places of the tangent plane."""
    parts = zip(contact.point, *contact.axes, strict=True)
    return np.stack([o + x * ex + y * ey + height * ez for o, ex, ey, ez in parts])


@dataclass(frozen=True)
class ToothGap:
    """Undeformed gap along the common normal over the tangent plane, zero at the contact but for relief."""

    contact: ToothContact
    """The contact."""
    worm_tooth: WormTooth
    """Boundaries of the worm's tooth."""
    wheel_tooth: WheelTooth
    """Boundaries of the wheel's tooth."""

    def __call__(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Gap [m], continued beyond the teeth, and where both teeth exist."""
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        covered = np.ones(x.shape, dtype=bool)
        heights, removed = [], np.zeros(x.shape)
        for flank, tooth in (
            (self.contact.worm_height, self.worm_tooth),
            (self.contact.wheel_height, self.wheel_tooth),
        ):
            height, _, exists = flank.solve(x, y)
            covered &= exists
            surface = surface_points(self.contact, x, y, height)
            for margin in tooth.margins(surface).values():
                # a contact point at a tooth's very edge still lies on it
                covered &= margin > -1e-12
            heights.append(height)
            removed = removed + tooth.removed(surface)
        return heights[1] - heights[0] + removed, covered


@dataclass(frozen=True)
class ToothMotion:
    """Velocity of one tooth's surface, where it is, relative to the contact point on the plane's axes."""

    contact: ToothContact
    """The contact."""
    flank: FlankHeight
    """The tooth's surface."""
    axis_point: Array
    """A point of the body's axis [m], (3,)."""
    rotation: Array
    """Angular velocity of the body [rad/s], (3,)."""

    def velocity(self, x: Array, y: Array) -> Array:
        """Velocity [m/s] along x, y and the common normal, (3, ...)."""
        return np.stack(self._components(x, y))

    def _components(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        height = self.flank.moving(x, y)
        (u, v, w), (about_x, about_y, spin) = self._twist
        return (
            u + about_y * height - spin * y,
            v + spin * x - about_x * height,
            w + about_x * y - about_y * x,
        )

    @cached_property
    def _twist(self) -> tuple[Array, Array]:
        """Velocity at the origin of the tangent plane, and angular velocity, each on the contact's axes."""
        contact = self.contact
        velocity = np.cross(self.rotation, contact.point - self.axis_point) - contact.velocity
        return contact.axes @ velocity, contact.axes @ self.rotation

    def __call__(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Velocity components (u, v) [m/s] at (x, y)."""
        u, v, _ = self._components(x, y)
        return u, v
