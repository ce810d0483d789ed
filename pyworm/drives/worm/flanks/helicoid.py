"""Involute helicoids as families of tangent planes, at their place in the drive.

The involute helicoid is the surface swept by the tangents of its base helix; its tangent plane stays the
same along such a straight generator and is the osculating plane of the helix.  So the flank is the
envelope of planes with one parameter theta (the polar angle at which the generator touches the base
cylinder), and turning the screw by an angle only moves each plane along its own normal (F. L. Litvin and
A. Fuentes, Gear Geometry and Applied Theory, 2004, chapter 19, derived here in support form).

Drive frame: origin in the wheel's centre, X from the worm to the wheel, Y along the wheel's axis, Z along
the worm's axis.  Threads are right-handed and the flank is the one that drives when the worm turns
positively about Z; the other flank is the same one turned by half a turn about X.
"""

from dataclasses import dataclass
from functools import cached_property
from math import cos, sin
from typing import TYPE_CHECKING

import numpy as np

from pyworm.drives.worm.flanks.involute_helicoid import axial_profile, normal_pressure_angle
from pyworm.drives.worm.flanks.screw_generator import Array, Components

Plane = tuple[Array | float, Components]
"""Distance from the wheel's centre, support [m], and unit normal of a plane normal . x = support."""


class Seated:
    """A screw at its place in the drive frame."""

    if TYPE_CHECKING:  # of each kind its own property

        @property
        def screw(self) -> float:
            """Advance per radian, lead / 2 pi [m]."""

        @property
        def start_radius(self) -> float:
            """Radius at which the flank begins [m]."""

    centre_distance: float
    """Distance of the axis from the wheel's axis [m]."""
    swivel: float
    """Turn of the axis about X [rad]; positive adds to the lead angle that the wheel sees."""
    axial_shift: float
    """Shift of the axis along the wheel's axis Y [m]."""

    @cached_property
    def axis_point(self) -> Array:
        """Intersection of the axis with the common perpendicular to the wheel's axis, (3,) [m]."""
        return np.array([-self.centre_distance, self.axial_shift, 0.0])

    def seat(self, angle: float) -> tuple[float, float, float, float]:
        """Its place, and a rotation angle [rad], as of `pyworm.kernel.flank_height.FlankNumbers`."""
        return self.centre_distance, self.axial_shift, self.swivel, angle

    @cached_property
    def axes(self) -> Array:
        """Columns: the screw's own x, y and z (its axis) directions in the drive frame, (3, 3)."""
        upright, tilt = cos(self.swivel), sin(self.swivel)
        return np.array([[1.0, 0.0, 0.0], [0.0, upright, -tilt], [0.0, tilt, upright]])

    def sweep(self, point: Array) -> Array:
        """Velocity of the turning screw at points (3, ...) [m] over its speed, (3, ...) [m]."""
        axis = self.axis_point.reshape((3,) + (1,) * (np.ndim(point) - 1))
        return np.cross(self.axes[:, 2], point - axis, axisb=0, axisc=0)

    def radius(self, point: Array) -> Array:
        """Distance of points (3, ...) from the screw's axis [m]."""
        point = np.asarray(point)
        turned_back = np.tensordot(self.axes.T, point, 1)
        origin = self.axes.T @ self.axis_point
        return np.sqrt((turned_back[0] - origin[0]) ** 2 + (turned_back[1] - origin[1]) ** 2)

    def along_axis(self, point: Array) -> Array:
        """Distance of points (3, ...) along the screw's axis from the common perpendicular [m]."""
        axis = self.axes[:, 2]
        return np.tensordot(axis, point, 1) - axis @ self.axis_point


@dataclass(frozen=True)
class Helicoid(Seated):
    """A right-hand involute helicoid at its place in the drive frame."""

    base_radius: float
    """Radius of the base cylinder [m]."""
    lead: float
    """Advance in one turn [m]."""
    centre_distance: float
    """Distance of the axis from the wheel's axis [m]."""
    swivel: float = 0.0
    """Turn of the axis about X [rad]; positive adds to the lead angle that the wheel sees."""
    axial_shift: float = 0.0
    """Shift of the axis along the wheel's axis Y [m]."""

    @cached_property
    def screw(self) -> float:
        """Advance per radian, lead / 2 pi [m]."""
        return self.lead / (2 * np.pi)

    @cached_property
    def base_lead_angle(self) -> float:
        """Lead angle on the base cylinder [rad]."""
        return float(np.arctan2(self.screw, self.base_radius))

    @cached_property
    def base_travel(self) -> float:
        """Advance of a tangent plane along its normal per radian [m]: base pitch times threads / 2 pi."""
        return self.screw * float(np.cos(self.base_lead_angle))

    @property
    def start_radius(self) -> float:
        """Radius at which the flank begins, the base cylinder's [m]."""
        return self.base_radius

    def axial_profile(self, radius: float) -> float:
        """Height [m] of the flank's section with a plane through the axis, over the radius [m]."""
        return axial_profile(radius, self.base_radius, self.lead)

    def normal_travel(self, radius: float) -> float:
        """Advance of the flank along its normal per radian [m]: the same at every radius."""
        return self.base_travel

    def pressure_angle(self, radius: float) -> float:
        """Normal pressure angle at a radius [rad]."""
        return normal_pressure_angle(self.lead, self.base_radius, radius)

    def planes(self, theta: Array | float) -> tuple[Plane, Plane, Plane]:
        """The tangent plane of a generator at rotation angle 0 and its first two derivatives by theta.

        Turning the screw by psi takes base_travel psi off the support.
        """
        across, along = sin(self.base_lead_angle), cos(self.base_lead_angle)
        x, y = across * np.cos(theta), across * np.sin(theta)
        tilt, upright = sin(self.swivel), cos(self.swivel)

        def seated(normal: Components, travel: Array | float) -> Plane:
            to_axis = self.axial_shift * normal[1] - self.centre_distance * normal[0]
            return to_axis + travel, normal

        return (
            seated(
                (y, -upright * x - tilt * along, upright * along - tilt * x),
                self.base_travel * theta,
            ),
            seated((x, upright * y, tilt * y), self.base_travel),
            seated((-y, upright * x, tilt * x), 0.0),
        )

    def normals(self, theta: Array) -> tuple[Array, Array, Array]:
        """Unit normal into the thread, and its first two derivatives by theta, each (3, ...)."""
        normal, slope, bend = (np.stack(normal) for _, normal in self.planes(theta))
        return normal, slope, bend

    def supports(self, theta: Array | float) -> tuple[Array, Array, Array]:
        """Distance of the tangent plane from the wheel's centre [m] and its theta derivatives.

        At rotation angle psi of the screw the plane is normal . x = support - base_travel psi.
        """
        support, slope, bend = (np.asarray(support) for support, _ in self.planes(theta))
        return support, slope, bend

    def point(self, theta: Array, along: Array, angle: float = 0.0) -> Array:
        """Points (3, ...) [m] of generators theta [rad] at distances from the base helix [m]."""
        theta, along = np.broadcast_arrays(np.asarray(theta), np.asarray(along))
        x, y = np.cos(theta), np.sin(theta)
        across = along * cos(self.base_lead_angle)
        local = np.stack(
            [
                self.base_radius * x - across * y,
                self.base_radius * y + across * x,
                self.screw * (theta - angle) + along * sin(self.base_lead_angle),
            ]
        )
        origin = self.axis_point.reshape((3,) + (1,) * theta.ndim)
        return origin + np.tensordot(self.axes, local, 1)
