"""A flank at an instant, as heights over a tangent plane ask for it."""

from abc import ABC, abstractmethod

import numpy as np

from pyworm.drives.worm.flanks.helicoid import Array, Components
from pyworm.drives.worm.flanks.screw_generator import Vector


def dot(first: Vector, other: Vector) -> Array:
    """Scalar product of components."""
    return np.asarray(first[0] * other[0] + first[1] * other[1] + first[2] * other[2])


def along(point: Vector, distance: Array | float, direction: Vector) -> Components:
    """Points some way along a direction."""
    x, y, z = (
        coordinate + distance * part for coordinate, part in zip(point, direction, strict=True)
    )
    return x, y, z


class FlankSurface(ABC):
    """A flank by parameters q, one array each.

    A line along the normal ez is given by its point in the tangent plane; `axes` has the rows ex, ey, ez.
    """

    @abstractmethod
    def newton(self, q: list[Array], line: Vector, axes: Array) -> tuple[Array, list[Array], Array]:
        """One step of Newton's method to the place of the flank on a line.

        Height along the line where the step leads [m], right to the square of the step at least; the step to
        be taken off q; and a determinant that vanishes at the flank's edge of regression.
        """

    @abstractmethod
    def normals(self, q: list[Array]) -> tuple[Components, list[Components]]:
        """Normals of any length, and their derivatives by q."""

    @abstractmethod
    def rates(
        self, q: list[Array], line: Vector, axes: Array, direction: Components
    ) -> list[Array]:
        """Change of q along a direction of the tangent plane, at the flank's place on a line."""

    def margin(self, q: list[Array]) -> Array | float:
        """What is left of the parameters to the flank's end, one where they have none."""
        return 1.0

    def tilt(self, q: list[Array], direction: Components, ez: Array) -> tuple[Array, list[Array]]:
        """Slope of the height along a direction of the tangent plane, and its derivatives by q."""
        normal, swings = self.normals(q)
        lift = dot(normal, ez)
        slope = -dot(normal, direction) / lift
        tangent = along(direction, slope, ez)
        return slope, [-dot(swing, tangent) / lift for swing in swings]
