"""A curve that sweeps a helicoid by its screw motion, the one description that all worm flanks share.

Every helicoid is swept by a curve r0(u) that turns about z and advances by p per radian, so that

    r(u, turn) = R(turn) r0(u) + p turn ez,    N(u, turn) = R(turn) [r0' x (ez x r0 + p ez)],

and x N_y - y N_x + p N_z = 0 (F. L. Litvin and A. Fuentes, Gear Geometry and Applied Theory, 2004, chapter
19). The flank rises outwards and its normal N points into the thread. Lengths in m, angles in rad.
"""

from abc import ABC, abstractmethod

import numpy as np

from pyworm.kernel.flank_height import SweptCurve

Array = np.ndarray

Components = tuple[Array | float, Array | float, Array | float]
"""Components of vectors along x, y and z as separate arrays, cheaper at many places than one array."""

Vector = Components | Array | list[Array]
"""Vectors by their components, in whatever holds the three of them."""


class ScrewGenerator(ABC):
    """A curve and the screw that moves it."""

    screw: float
    """Advance per radian p, lead / 2 pi [m]."""

    @property
    @abstractmethod
    def start_radius(self) -> float:
        """Radius at which the flank begins [m]."""

    @property
    @abstractmethod
    def bounds(self) -> tuple[float, float]:
        """Parameters u of the curve between which the flank exists [m]."""

    @abstractmethod
    def curve(self, u: Array | float) -> tuple[Components, Components, Components]:
        """The curve [m] and its first [-] and second [1/m] derivatives by its parameter [m]."""

    @property
    def swept(self) -> SweptCurve:
        """The curve for the kernel; NotImplementedError of one that sweeps no working flank."""
        raise NotImplementedError

    @abstractmethod
    def at_radius(self, radius: Array | float) -> Array:
        """Parameter of the curve at a distance from the axis [m]."""

    def axial_profile(self, radius: Array | float) -> Array:
        """Height [m] of the section with a plane through the axis, over the radius [m]."""
        x, y, z = self.curve(self.at_radius(np.asarray(radius)))[0]
        return z - self.screw * np.arctan2(y, x)

    def point(self, u: Array, turn: Array) -> Array:
        """Points, (3, ...) [m], of the curve's parameter [m] after a turn [rad]."""
        x, y, z = self.curve(u)[0]
        cosine, sine = np.cos(turn), np.sin(turn)
        return np.stack([cosine * x - sine * y, sine * x + cosine * y, z + self.screw * turn])

    def normal_at(self, radius: float) -> Array:
        """Unit normal at a radius [m] over polar angle zero, (3,)."""
        u = self.at_radius(radius)
        x, y, _ = self.curve(u)[0]
        return self.normal(u, -np.arctan2(y, x))

    def pressure_angle(self, radius: float) -> float:
        """Normal pressure angle at a radius [m]."""
        return float(np.arcsin(abs(self.normal_at(radius)[0])))

    def normal(self, u: Array, turn: Array) -> Array:
        """Unit normals there, (3, ...), into the thread."""
        (x, y, _), along, _ = self.curve(u)
        nx, ny, nz = cross_product(along, (-y, x, self.screw))
        cosine, sine = np.cos(turn), np.sin(turn)
        normal = np.stack([cosine * nx - sine * ny, sine * nx + cosine * ny, nz + 0 * sine])
        return normal / np.sqrt(np.sum(normal**2, axis=0))


def cross_product(first: Components, other: Components) -> Components:
    """Cross product."""
    return (
        first[1] * other[2] - first[2] * other[1],
        first[2] * other[0] - first[0] * other[2],
        first[0] * other[1] - first[1] * other[0],
    )


def apart(
    first: ScrewGenerator, other: ScrewGenerator, reference: float, radii: tuple[float, float]
) -> float:
    """Largest distance along the axis [m] of two flanks between two radii, laid together at a third [m]."""
    radius = np.append(np.linspace(*radii, 101), reference)
    height = first.axial_profile(radius) - other.axial_profile(radius)
    return float(np.abs(height - height[-1]).max())
