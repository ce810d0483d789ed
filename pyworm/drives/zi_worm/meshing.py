"""Meshing of screws with a wheel: the wheel flank as envelope of the hob, and the line of action.

Let the hob turn by psi and the wheel by ratio psi.  In the wheel's frame the hob's tangent planes are a
family with two parameters: theta (the generator) and roll = ratio psi,

    n(theta, roll) . x = support(theta) - lever roll,     n = turn(roll) n_hob(theta),

lever = base_travel / ratio.  The wheel flank is the envelope of this family; its points solve the three
equations of the plane and of its two derivatives, which are linear in x.  The roll derivative is the
meshing equation: the moment arm of the normal about the wheel's axis is the lever, whatever the angle.
So the envelope is exact and needs no iteration.

A worm meshing with that wheel has the same equation with its own base travel.  Hence the common normal
of worm and wheel is fixed in space while the contact point moves along it, and the wheel's speed is constant:
the line of action of an involute screw drive is a straight line in space.
"""

from dataclasses import dataclass

import numpy as np
import scipy

from pyworm.drives.zi_worm.helicoid import Array, Helicoid

WHEEL_AXIS = np.array([0.0, 1.0, 0.0])


def turned(vector: Array, angle: Array) -> Array:
    """Vectors (3, ...) turned by an angle [rad] about the wheel's axis Y.

    The wheel itself turns the other way about Y: positive wheel angles are turns by minus the angle.
    """
    cos, sin = np.cos(angle), np.sin(angle)
    return np.stack(
        [cos * vector[0] + sin * vector[2], vector[1] + 0 * cos, cos * vector[2] - sin * vector[0]]
    )


def across_axis(vector: Array) -> Array:
    """Cross product of the wheel's axis with vectors (3, ...)."""
    return np.stack([vector[2], 0 * vector[1], -vector[0]])


@dataclass(frozen=True)
class WheelFlank:
    """The wheel flank that a hob cuts.

    Attributes
    ----------
    hob : Helicoid
        The hob at its place on the cutting machine.
    ratio : float
        Wheel angle by hob angle, threads / teeth [-].
    """

    hob: Helicoid
    ratio: float

    @property
    def lever(self) -> float:
        """Moment arm of every flank normal about the wheel's axis [m]."""
        return self.hob.base_travel / self.ratio

    def cut_point(self, theta: Array, roll: Array) -> Array:
        """Point of the cutting contact in the drive frame, where hob and wheel touch, (3, ...) [m].

        Parameters
        ----------
        theta : array
            Generator of the hob [rad].
        roll : array
            Wheel angle while cutting [rad].
        """
        theta, roll = np.broadcast_arrays(np.asarray(theta), np.asarray(roll))
        normal, slope, _ = self.hob.normals(theta)
        support, support_slope, _ = self.hob.supports(theta)
        rows = np.stack([normal, slope, across_axis(normal)])
        right = np.stack([support - self.lever * roll, support_slope, 0 * roll - self.lever])
        rows = np.moveaxis(rows, (0, 1), (-2, -1))
        right = np.moveaxis(right, 0, -1)
        return np.moveaxis(np.linalg.solve(rows, right[..., None])[..., 0], -1, 0)

    def point(self, theta: Array, roll: Array, wheel_angle: float = 0.0) -> Array:
        """Point of the wheel flank at a wheel angle, in the drive frame, (3, ...) [m]."""
        return turned(self.cut_point(theta, roll), np.asarray(roll) - wheel_angle)

    def normal(self, theta: Array, roll: Array, wheel_angle: float = 0.0) -> Array:
        """Unit normal of the wheel flank, out of the wheel, in the drive frame, (3, ...)."""
        return turned(self.hob.normals(theta)[0], np.asarray(roll) - wheel_angle)


@dataclass(frozen=True)
class LineOfAction:
    """The common normal of worm and wheel, fixed in space.

    Attributes
    ----------
    worm_theta, hob_theta : float
        Generators of the worm and of the hob whose normals lie on the line [rad].
    lag : float
        Cutting roll minus wheel angle of the touching point [rad].
    foot : ndarray
        Point of the line nearest the wheel's centre, (3,) [m].
    direction : ndarray
        Unit normal from the wheel into the worm, (3,).
    """

    worm_theta: float
    hob_theta: float
    lag: float
    foot: Array
    direction: Array


def _matched(worm: Helicoid, flank: WheelFlank, theta: Array) -> tuple[Array, Array, Array, Array]:
    """Lag and hob generator whose normal is that of the worm's generator, and the residual of contact.

    A contact needs three planes, all parallel to the normal, to share a line: the worm's generator
    plane, the wheel's meshing plane and the hob's generator plane.  Returned are the lag, the hob's
    theta, the determinant that vanishes when they do, and the line's foot; NaN where no rotation about
    the wheel's axis brings the normals together.
    """
    hob = flank.hob
    normal, slope, _ = worm.normals(theta)
    # turn(lag) hob axis . normal = cos(hob base lead angle):  a sin(lag) + c cos(lag) = d
    a = normal[0] * np.cos(hob.swivel)
    c = normal[2] * np.cos(hob.swivel)
    d = np.cos(hob.base_lead_angle) + normal[1] * np.sin(hob.swivel)
    with np.errstate(invalid="ignore"):
        # the root nearest zero in the form that keeps its digits when hob and worm are nearly alike
        half = (d - c) / (a - np.sqrt(a**2 + c**2 - d**2))
    lag = 2 * np.arctan(half)
    own = np.tensordot(hob.axes.T, turned(normal, -lag), 1)
    hob_theta = np.arctan2(own[0], -own[1])
    planes = (slope, -across_axis(normal), turned(hob.normals(hob_theta)[1], lag))
    reach = (worm.supports(theta)[1], flank.lever + 0 * lag, hob.supports(hob_theta)[1])
    first = planes[1] / np.linalg.norm(planes[1], axis=0)
    second = np.cross(normal, first, axis=0)
    u = [np.sum(plane * first, 0) for plane in planes]
    v = [np.sum(plane * second, 0) for plane in planes]
    miss = (
        reach[0] * (u[1] * v[2] - u[2] * v[1])
        + reach[1] * (u[2] * v[0] - u[0] * v[2])
        + reach[2] * (u[0] * v[1] - u[1] * v[0])
    )
    span = u[0] * v[1] - u[1] * v[0]
    foot = (reach[0] * v[1] - reach[1] * v[0]) / span * first
    foot = foot + (u[0] * reach[1] - u[1] * reach[0]) / span * second
    return lag, hob_theta, miss, foot


def lines_of_action(worm: Helicoid, flank: WheelFlank) -> tuple[LineOfAction, ...]:
    """All lines along which worm and wheel flank can touch.

    A wheel cut by its own worm touches along a line and every generator has a line of action; then the
    one through the wheel's mid-plane at the worm's mid-plane is taken.
    """
    grid = np.linspace(-np.pi, 0.0, 1443)[1:-1]
    _, _, miss, foot = _matched(worm, flank, grid)
    size = worm.base_travel
    if not np.isfinite(miss).any():
        return ()
    if np.nanmax(np.abs(miss)) < 1e-12 * size:

        def offset(theta: Array) -> Array:
            foot = _matched(worm, flank, theta)[3]
            normal = worm.normals(theta)[0]
            return foot[1] - foot[2] * normal[1] / normal[2]

        values = offset(grid)
    else:

        def offset(theta: Array) -> Array:
            return _matched(worm, flank, theta)[2]

        values = miss
    changes = np.flatnonzero(values[:-1] * values[1:] < 0)
    lines = []
    for i in changes:
        theta = scipy.optimize.brentq(
            lambda t: float(offset(np.array(t))), grid[i], grid[i + 1], xtol=1e-15
        )
        lag, hob_theta, _, foot = _matched(worm, flank, np.array(theta))
        lines.append(
            LineOfAction(theta, float(hob_theta), float(lag), foot, worm.normals(theta)[0])
        )
    return tuple(lines)
