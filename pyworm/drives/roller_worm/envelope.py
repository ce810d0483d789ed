"""The worm flank as the exact envelope of a roller, and its contact with that roller at each instant.

Drive frame: origin in the wheel's centre, Z along the wheel's axis, the worm's axis along X through
(0, a, 0). A roller at wheel angle phi has

    e_r = (sin phi, cos phi, 0),  e_t = (cos phi, -sin phi, 0),  d = cos(tilt) e_r + sin(tilt) e_z,

d being its axis and e_t its direction of travel. Its surface is

    P = c + s d + rho(s) e(theta),  e = cos(theta) e_t + sin(theta) f,  f = d x e_t,
    n = cos(gamma) e - sin(gamma) d,  tan(gamma) = rho'(s),

with c the roller's middle. Per radian of the wheel, which turns by -e_z, the worm turns by h i e_x, i = z2/z1
and h = +1 for a left-hand, -1 for a right-hand thread. With the relative velocity v = W x P - w, W = h i e_x
+ e_z, w = h i e_x x (0, a, 0), meshing asks

    n . v = e . B - C = 0,   B = cos(gamma) (W x X - w) - rho sin(gamma) d x W,
                             C = sin(gamma) d . (W x X - w),   X = c + s d,

which is linear in e: theta follows in closed form, one root on each side of the roller. Carried into the
worm's frame over all phi these points are the two flanks of the thread.

Sources of the theory: F. L. Litvin and A. Fuentes, Gear Geometry and Applied Theory (2004), chapters 6 to 8.
The formulas were derived for this program and are tested against swept rollers, second differences and exact
tensors.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from pyworm.drives.roller_worm.profile import Array, RollerProfile

Flank = Literal["driving", "idle"]
"""Side of the rollers that a worm flank touches: behind them, so that it drives, or in front."""

E_X, E_Z = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])


def dot(a: Array, b: Array) -> Array:
    """Scalar product over the first axis."""
    return np.einsum("i...,i...->...", a, b)


def cross(a: Array, b: Array) -> Array:
    """Vector product over the first axis; an array of three takes a fifth of the time of a stack."""
    return np.array(
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    )


def about_z(vector: Array) -> Array:
    """e_z x vector."""
    return np.array([-vector[1], vector[0], np.zeros_like(vector[2])])


@dataclass(frozen=True)
class LineContact:
    """Points of contact lines, each touching the roller at its wheel angle.

    Vectors are (3, ...) in the drive frame, velocities for a wheel that turns by one radian in a second.
    """

    place: Array
    """Place along the roller's axis, from its middle [m]."""
    wheel_angle: Array
    """Wheel angle phi [rad]."""
    theta: Array
    """Angle round the roller [rad]."""
    radius: Array
    """The roller's radius there [m]."""
    point: Array
    """The point [m]."""
    normal: Array
    """The common normal, out of the roller into the worm."""
    along: Array
    """Unit vector of the tangent plane along the contact line (with s)."""
    across: Array
    """Unit vector of the plane across the contact line; right-handed are along, across and normal."""
    around: Array
    """Unit vector of the tangent plane round the roller's axis."""
    stretch: Array
    """Length of the contact line for each length along the axis [-]."""
    curvature: Array
    """Induced normal curvature across the line [1/m]: that of the gap between worm and roller."""
    limit: Array
    """Limit function Psi [m/rad2]: second derivative of the roller's distance from a point of the worm by the
    wheel's angle. The flank is cut away (undercut) where it is not positive."""
    advance: Array
    """Change of the point with phi at fixed s [m/rad], the motion of the line."""
    turning: Array
    """Change of theta with phi at fixed s [-]."""


@dataclass(frozen=True)
class RollerEnvelope:
    """A worm flank enveloped by the rollers of a wheel."""

    profile: RollerProfile
    """The roller; the envelope ignores its crown."""
    ratio: float
    """i, wheel teeth over worm threads [-]."""
    centre_distance: float
    """Distance a of worm and wheel axes [m]."""
    pitch_radius: float
    """Radius of the rollers' middles about the wheel's axis [m]."""
    tilt: float
    """Angle of the roller's axis to the wheel's radius, towards its axis [rad]: 0 radial, pi/2 axial."""
    height: float
    """Height of the rollers' middles over the worm's axis, along the wheel's axis [m]."""
    flank: Flank
    """Flank of the thread: "driving" touches the rollers from behind, "idle" from the front."""
    hand: int
    """+1 for a left-hand, -1 for a right-hand thread."""

    @property
    def worm_turn(self) -> Array:
        """Angular velocity of the worm for one radian of the wheel in a second, (3,)."""
        return self.hand * self.ratio * E_X

    @property
    def worm_centre(self) -> Array:
        """Point of the worm's axis nearest the wheel's, (3,) [m]."""
        return np.array([0.0, self.centre_distance, 0.0])

    def axes(self, wheel_angle: Array) -> tuple[Array, Array, Array, Array]:
        """e_t, f and d of a roller, and its middle [m], each (3, ...)."""
        phi = np.asarray(wheel_angle, float)
        sin, cos, zero, ones = np.sin(phi), np.cos(phi), np.zeros_like(phi), np.ones_like(phi)
        radial, going, up = (
            np.array(parts) for parts in ((sin, cos, zero), (cos, -sin, zero), (zero, zero, ones))
        )
        axis = np.cos(self.tilt) * radial + np.sin(self.tilt) * up
        middle = self.pitch_radius * radial + self.height * up
        return going, cross(axis, going), axis, middle

    def relative_velocity(self, point: Array) -> Array:
        """Velocity of the worm relative to the wheel at points (3, ...) [m/rad]."""
        worm = cross(_wide(self.worm_turn, point), point - _wide(self.worm_centre, point))
        return worm + about_z(point)

    def theta(self, place: Array, wheel_angle: Array) -> Array:
        """Angle round the roller at which it touches [rad]; NaN where it does not."""
        return self._theta(place, *self.axes(wheel_angle))

    def _theta(self, place: Array, going: Array, side: Array, axis: Array, middle: Array) -> Array:
        """Evaluate `theta` from the result of `axes`."""
        radius, gamma = self.profile(place)
        velocity = self.relative_velocity(middle + place * axis)
        turn = _wide(self.worm_turn + E_Z, axis)
        b = np.cos(gamma) * velocity - radius * np.sin(gamma) * cross(axis, turn)
        b_going, b_side = dot(b, going), dot(b, side)
        cosine = np.sin(gamma) * dot(axis, velocity) / np.hypot(b_going, b_side)
        with np.errstate(invalid="ignore"):
            spread = np.arccos(cosine)
        towards = np.arctan2(b_side, b_going)
        # of both roots the one on the wanted side of the roller
        roots = [towards - spread, towards + spread]
        first_is_front = np.cos(roots[0]) > np.cos(roots[1])
        root = np.where(first_is_front == (self.flank == "idle"), *roots)
        return np.arctan2(np.sin(root), np.cos(root))

    def point(self, place: Array | float, wheel_angle: Array | float) -> Array:
        """Points of the contact lines [m] in the drive frame, (3, ...)."""
        s, phi = np.broadcast_arrays(np.asarray(place, float), np.asarray(wheel_angle, float))
        going, side, axis, middle = self.axes(phi)
        theta = self._theta(s, going, side, axis, middle)
        out = np.cos(theta) * going + np.sin(theta) * side
        return middle + s * axis + self.profile(s)[0] * out

    def contact(self, place: Array, wheel_angle: Array) -> LineContact:
        """The contact at places along the roller [m] and wheel angles [rad], which are broadcast."""
        s, phi = np.broadcast_arrays(np.asarray(place, float), np.asarray(wheel_angle, float))
        going, side, axis, middle = self.axes(phi)
        rho, gamma = self.profile(s)
        theta = self._theta(s, going, side, axis, middle)
        out = np.cos(theta) * going + np.sin(theta) * side
        around = np.cos(theta) * side - np.sin(theta) * going
        normal = np.cos(gamma) * out - np.sin(gamma) * axis
        meridian = np.cos(gamma) * axis + np.sin(gamma) * out
        point = middle + s * axis + rho * out

        turn = _wide(self.worm_turn + E_Z, point)
        velocity = self.relative_velocity(point)
        # gradients of f = n . v over the roller's surface, per length round it and along its side
        q_around = np.cos(gamma) / rho * dot(around, velocity) + dot(normal, cross(turn, around))
        bend = -self.profile.turning(s) * np.cos(gamma)
        q_meridian = bend * dot(meridian, velocity) + dot(normal, cross(turn, meridian))
        drift = -dot(about_z(normal), velocity) - dot(normal, cross(turn, about_z(point)))
        limit = drift + q_around * dot(around, velocity) + q_meridian * dot(meridian, velocity)

        # theta(s, phi) along f = 0
        theta_s = -q_meridian / (np.cos(gamma) * q_around * rho)
        turning = -drift / (q_around * rho)
        step = meridian / np.cos(gamma) + rho * theta_s * around
        stretch = np.sqrt(dot(step, step))
        along = step / stretch
        return LineContact(
            place=s,
            wheel_angle=phi,
            theta=theta,
            radius=rho,
            point=point,
            normal=normal,
            along=along,
            across=cross(normal, along),
            around=around,
            stretch=stretch,
            curvature=(q_around**2 + q_meridian**2) / limit,
            limit=limit,
            advance=rho * turning * around - about_z(point),
            turning=turning,
        )

    def worm_point(self, place: Array, wheel_angle: Array) -> Array:
        """Points of the flank [m] in the worm's frame, which is the drive's at wheel angle 0."""
        return self.into_worm(self.point(place, wheel_angle), wheel_angle)

    def into_worm(self, point: Array, wheel_angle: Array) -> Array:
        """Points (3, ...) of the drive frame at a wheel angle, in the worm's frame."""
        return self._turned(point, -self.hand * self.ratio * wheel_angle)

    def from_worm(self, point: Array, wheel_angle: Array) -> Array:
        """Points (3, ...) of the worm's frame, in the drive frame at a wheel angle."""
        return self._turned(point, self.hand * self.ratio * wheel_angle)

    def _turned(self, point: Array, angle: Array) -> Array:
        """Points turned about the worm's axis."""
        sin, cos = np.sin(angle), np.cos(angle)
        y, z = point[1] - self.centre_distance, point[2]
        return np.stack([point[0], self.centre_distance + cos * y - sin * z, sin * y + cos * z])


def _wide(vector: Array, like: Array) -> Array:
    """A single vector (3,) with as many axes as vectors (3, ...)."""
    return vector.reshape((3,) + (1,) * (like.ndim - 1))
