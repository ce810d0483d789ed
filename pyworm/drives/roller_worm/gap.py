"""The gap between worm and roller over the tangent plane of a contact, with the roller's ends and crown."""

from dataclasses import dataclass

import numpy as np

from pyworm.drives.roller_worm.envelope import Array, LineContact, cross, dot
from pyworm.drives.roller_worm.section import WormSection

NEWTON_STEPS = 12
"""Largest number of Newton steps for a flank's parameters; five or six are typical."""

DISTANCE_TOLERANCE = 1e-13
"""Residual distance in the tangent plane [m] at convergence; the error of a height is it times a slope."""

BLOCK = 8192
"""Points solved at once: keeps the work arrays within the processor's cache."""


@dataclass(frozen=True)
class ContactFrame:
    """The tangent plane at a contact point: z points from the worm to the roller."""

    section: WormSection
    """The worm's section."""
    contact: LineContact
    """The contact point, a single one."""
    x_axis: Array
    """Across the contact line, (3,)."""
    y_axis: Array
    """Along the contact line, (3,)."""

    @property
    def z_axis(self) -> Array:
        """From the worm to the roller, (3,)."""
        return -self.contact.normal

    def lifted(self, x: Array, y: Array, height: Array) -> Array:
        """Points in the drive frame (3, ...) [m] above places of the tangent plane."""
        parts = zip(self.contact.point, self.x_axis, self.y_axis, self.z_axis, strict=True)
        return np.stack([o + x * ex + y * ey + height * ez for o, ex, ey, ez in parts])

    def roller_height(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height [m] of the real roller, place along its axis [m], and whether it is there.

        Where a line along the normal misses the roller, the height of its equator is continued.
        """
        envelope = self.section.envelope
        _, _, axis, middle = envelope.axes(self.contact.wheel_angle)
        lean = float(axis @ self.z_axis)
        base = self.lifted(x, y, np.zeros(np.shape(x))) - _wide(middle, x)
        height = np.zeros(np.shape(x))
        met = np.ones(np.shape(x), dtype=bool)
        wide_axis, up = _wide(axis, x), _wide(self.z_axis, x)
        for _ in range(NEWTON_STEPS):
            arm = base + height * up
            place = dot(arm, wide_axis)
            radius = envelope.profile(place)[0] - envelope.profile.relief(place)
            # the near one of two crossings, its place along the axis held
            out = up - lean * wide_axis
            a = 1 - lean**2
            off = base - dot(base, wide_axis) * wide_axis
            b, c = dot(off, out), dot(off, off) - radius**2
            root = b**2 - a * c
            met = root > 0
            new = (-b - np.sqrt(np.maximum(root, 0.0))) / a
            change = np.max(np.abs(new - height), initial=0.0)
            height = new
            if change < DISTANCE_TOLERANCE:
                break
        return height, place, met

    def worm_height(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height [m] of the worm's flank, place along its roller [m], and whether it is there."""
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        height, place = np.empty(x.size), np.empty(x.size)
        sound = np.empty(x.size, dtype=bool)
        for first in range(0, x.size, BLOCK):
            part = slice(first, first + BLOCK)
            height[part], place[part], sound[part] = self._worm_block(
                x.ravel()[part], y.ravel()[part]
            )
        return height.reshape(x.shape), place.reshape(x.shape), sound.reshape(x.shape)

    def _worm_block(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        envelope, here = self.section.envelope, self.contact
        place = np.full(x.shape, float(here.place))
        angle = np.full(x.shape, float(here.wheel_angle))
        centre = _wide(envelope.worm_centre, x)
        turn = _wide(envelope.worm_turn, x)
        origin = _wide(here.point, x)
        axes = [_wide(axis, x) for axis in (self.x_axis, self.y_axis)]
        with np.errstate(all="ignore"):
            for _ in range(NEWTON_STEPS):
                contact = envelope.contact(place, angle)
                back = here.wheel_angle - angle
                spun = envelope.hand * envelope.ratio * back
                point = turned(contact.point, spun, envelope.centre_distance)
                drift = contact.advance - cross(
                    np.broadcast_to(turn, contact.point.shape), contact.point - centre
                )
                by_place = rotated(contact.along * contact.stretch, spun)
                by_angle = rotated(drift, spun)
                miss = [
                    place - dot(point - origin, axis)
                    for place, axis in zip((x, y), axes, strict=True)
                ]
                a, c = (dot(by_place, axis) for axis in axes)
                b, d = (dot(by_angle, axis) for axis in axes)
                determinant = a * d - b * c
                place = place + np.clip((d * miss[0] - b * miss[1]) / determinant, -5e-3, 5e-3)
                angle = angle + np.clip((a * miss[1] - c * miss[0]) / determinant, -0.05, 0.05)
                left = np.hypot(*miss)
                if np.nanmax(left) < DISTANCE_TOLERANCE:
                    break
            height = dot(point - origin, _wide(self.z_axis, x))
            sound = (left < 1e3 * DISTANCE_TOLERANCE) & (contact.limit > 0)
        return height, place, sound


def turned(point: Array, angle: Array, centre_distance: float) -> Array:
    """Points (3, ...) turned about the worm's axis."""
    shift = np.array([0.0, centre_distance, 0.0]).reshape((3,) + (1,) * (point.ndim - 1))
    return rotated(point - shift, angle) + shift


def rotated(vector: Array, angle: Array) -> Array:
    """Vectors (3, ...) turned about X."""
    sin, cos = np.sin(angle), np.cos(angle)
    return np.stack(
        [vector[0], cos * vector[1] - sin * vector[2], sin * vector[1] + cos * vector[2]]
    )


@dataclass(frozen=True)
class RollerGap:
    """Undeformed gap between a worm's flank and a real roller over the tangent plane."""

    frame: ContactFrame
    """The contact."""

    def __call__(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Gap [m], and where roller and thread both exist; beyond, their surfaces are continued."""
        frame, section = self.frame, self.frame.section
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        roller, along, met = frame.roller_height(x, y)
        worm, place, sound = frame.worm_height(x, y)
        profile = section.envelope.profile
        # where the worm is not found it continues from the roller with the contact's curvature
        opening = 0.5 * float(frame.contact.curvature) * x**2
        start = frame.roller_height(np.zeros(()), np.zeros(()))[0]
        gap = np.where(sound & met, roller - worm, opening + profile.relief(along)) - start
        before, after = section.faces
        on_worm = frame.lifted(x, y, np.where(sound, worm, roller))[0]
        covered = sound & met & (np.abs(along) <= profile.length / 2)
        covered &= (place >= section.lowest) & (place <= section.highest)
        covered &= (on_worm >= before) & (on_worm <= after)
        return gap, covered


@dataclass(frozen=True)
class RollerMotion:
    """Velocity of a rigid surface, evaluated at the roller, relative to the contact point on its axes."""

    frame: ContactFrame
    """The contact."""
    velocity: Array
    """Velocity of the body's surface relative to the contact point, (3,) [m/s]."""
    rotation: Array
    """The body's angular velocity, (3,) [rad/s]."""

    def __call__(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Velocity components (u, v) [m/s] at (x, y)."""
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        frame = self.frame
        height = frame.roller_height(x, y)[0]
        turn_x, turn_y, turn_z = (
            float(self.rotation @ axis) for axis in (frame.x_axis, frame.y_axis, frame.z_axis)
        )
        u, v = (float(self.velocity @ axis) for axis in (frame.x_axis, frame.y_axis))
        return u + turn_y * height - turn_z * y, v + turn_z * x - turn_x * height


def _wide(vector: Array, like: Array) -> Array:
    """A single vector (3,) with as many axes as points (...) have, and one."""
    return vector.reshape((3,) + (1,) * np.ndim(like))
