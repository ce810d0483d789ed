"""The line of action of an involute worm and its wheel.

A worm meshing with a wheel that an involute hob cut has the meshing equation of the hob (`wheel_envelope`)
with its own base travel.  Hence the common normal of worm and wheel is fixed in space while the contact point
moves along it, and the wheel's speed is constant: the line of action of an involute screw drive is a
straight line in space.
"""

from dataclasses import dataclass

import numpy as np
import scipy

from pyworm.drives.worm.flanks.contact_path import ContactPath, Touches
from pyworm.drives.worm.flanks.helicoid import Array, Helicoid
from pyworm.drives.worm.flanks.tangent_planes import WheelPlanes, WormPlanes
from pyworm.drives.worm.flanks.wheel_envelope import WheelFlank, across_axis, turned


@dataclass(frozen=True)
class LineOfAction:
    """The common normal of worm and wheel, fixed in space."""

    worm_theta: float
    """Generator of the worm whose normal lies on the line [rad]."""
    hob_theta: float
    """Generator of the hob whose normal lies on the line [rad]."""
    lag: float
    """Cutting roll minus wheel angle of the touching point [rad]."""
    foot: Array
    """Point of the line nearest the wheel's centre, (3,) [m]."""
    direction: Array
    """Unit normal from the wheel into the worm, (3,)."""


@dataclass(frozen=True)
class StraightPath(ContactPath):
    """The contact point on a line of action; places, reduced by the worm, are distances from its foot [m]."""

    worm: Helicoid
    """The worm as assembled."""
    flank: WheelFlank
    """The wheel flank."""
    line: LineOfAction
    """The line."""

    def touches(self, places: Array) -> Touches:
        """Contacts at places; a plane of the worm moves along its normal by the base travel per radian."""
        line, hob, places = self.line, self.flank.hob, np.asarray(places)
        along = line.direction[:, None] + np.zeros(places.shape)

        def repeated(*q: float) -> Array:
            return np.array(q)[:, None] + np.zeros(places.shape)

        return Touches(
            worm_angle=(self.worm.supports(line.worm_theta)[0] - places) / self.worm.base_travel,
            wheel_angle=(hob.supports(line.hob_theta)[0] - places) / self.flank.lever - line.lag,
            point=line.foot[:, None] + line.direction[:, None] * places,
            normal=-along,
            travel=-self.worm.base_travel * along,
            worm_start=repeated(line.worm_theta),
            wheel_start=repeated(line.hob_theta, line.lag),
        )

    def search(self, tip_radius: float) -> Array:
        """Places within a few tip radii of the worm's mid-plane, where the line leaves its tip cylinder."""
        centre = -self.line.foot[2] / self.line.direction[2]
        return centre + np.linspace(4, -4, 4001) * tip_radius

    def worm_surface(self, angle: float) -> WormPlanes:
        """The worm's tangent planes."""
        return WormPlanes(self.worm, angle)

    def wheel_surface(self, angle: float) -> WheelPlanes:
        """The wheel's tangent planes."""
        return WheelPlanes(self.flank, angle)


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
    hob_normal = np.tensordot(hob.axes.T, turned(normal, -lag), 1)
    hob_theta = np.arctan2(hob_normal[0], -hob_normal[1])
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


def lines_of_action(worm: Helicoid, flank: WheelFlank) -> tuple[StraightPath, ...]:
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
        line = LineOfAction(theta, float(hob_theta), float(lag), foot, worm.normals(theta)[0])
        lines.append(StraightPath(worm, flank, line))
    return tuple(lines)
