"""Flanks of involute helicoids as families of tangent planes, for their heights over a tangent plane.

Such a flank is an envelope of planes, so its height over a point (x, y) of the tangent plane is the
stationary value, over the family's parameters q, of the height T(q) at which the plane q crosses the line
through (x, y) along the common normal:

    T = (support(q) - normal(q) . (origin + x ex + y ey)) / B,     B = normal(q) . ez.

Newton's method on dT/dq = 0 settles it.  With p the point of the crossing and n_i, s_i the derivatives of
normal and support by q,

    T_i = (s_i - n_i . p) / B,     T_ij = (s_ij - n_ij . p) / B,

the latter where T_i = 0, which is near enough for Newton's method.  Its step h also gives the stationary
value itself, T - T_i h_i / 2, to the step's cube: the height is right to rounding where q is not yet.  The
rates of q over the plane follow by implicit differentiation, q_x = -(T_ij)^-1 T_xj, with T_xi = -n_i . (ex
+ T_x ez) / B.
"""

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyworm.drives.worm.flanks.flank_surface import FlankSurface, along, dot
from pyworm.drives.worm.flanks.helicoid import Array, Components, Helicoid, Plane
from pyworm.drives.worm.flanks.screw_generator import Vector
from pyworm.drives.worm.flanks.wheel_envelope import WheelFlank

Family = tuple[Plane, list[Plane], list[Plane]]
"""A plane with its derivatives by the parameters, and its second ones: 11, or 11, 12 and 22."""


class PlaneFamily(FlankSurface):
    """A flank that is an envelope of planes, with a `Family` at the parameters q."""

    @abstractmethod
    def at(self, q: Sequence[Array]) -> Family:
        """The planes of parameters q."""

    def newton(self, q: list[Array], line: Vector, axes: Array) -> tuple[Array, list[Array], Array]:
        """Height where the step leads, step and det T_ij."""
        height, slope, matrix = self._crossing(q, line, axes[2])
        step = _solved(matrix, slope)
        height = height - sum(a * h for a, h in zip(slope, step, strict=True)) / 2
        return height, step, _determinant(matrix)

    def normals(self, q: list[Array]) -> tuple[Components, list[Components]]:
        """Normals and their derivatives by q."""
        (_, normal), first, _ = self.at(q)
        return normal, [swing for _, swing in first]

    def rates(
        self, q: list[Array], line: Vector, axes: Array, direction: Components
    ) -> list[Array]:
        """Change of q along a direction of the tangent plane."""
        matrix = self._crossing(q, line, axes[2])[2]
        return [-rate for rate in _solved(matrix, self.tilt(q, direction, axes[2])[1])]

    def _crossing(
        self, q: list[Array], line: Vector, ez: Array
    ) -> tuple[Array, list[Array], list[Array]]:
        """T, T_i and T_ij of planes where they cross lines along the common normal [m]."""
        (support, normal), first, second = self.at(q)
        lift = dot(normal, ez)
        height = (support - dot(normal, line)) / lift
        point = along(line, height, ez)
        slope, bend = (
            [(support - dot(normal, point)) / lift for support, normal in derivatives]
            for derivatives in (first, second)
        )
        return height, slope, bend


@dataclass(frozen=True)
class WormPlanes(PlaneFamily):
    """Tangent planes of the worm flank; the parameter is theta."""

    worm: Helicoid
    """The worm."""
    angle: float
    """Its rotation angle [rad]."""

    def at(self, q: Sequence[Array]) -> Family:
        """The planes of parameters q."""
        (support, normal), slope, bend = self.worm.planes(q[0])
        return (support - self.worm.base_travel * self.angle, normal), [slope], [bend]


@dataclass(frozen=True)
class WheelPlanes(PlaneFamily):
    """Tangent planes of the wheel flank; the parameters are the hob's theta and the lag, roll - angle."""

    flank: WheelFlank
    """The wheel flank."""
    angle: float
    """Its rotation angle [rad]."""

    def at(self, q: Sequence[Array]) -> Family:
        """The planes of parameters q."""
        cos, sin, lever = np.cos(q[1]), np.sin(q[1]), self.flank.lever
        (support, (x, y, z)), slope, bend = (
            (support, (cos * x + sin * z, y, cos * z - sin * x))
            for support, (x, y, z) in self.flank.hob.planes(q[0])
        )
        across = slope[1]
        return (
            (support - lever * (q[1] + self.angle), (x, y, z)),
            [slope, (-lever, (z, 0.0, -x))],
            [bend, (0.0, (across[2], 0.0, -across[0])), (0.0, (-x, 0.0, -z))],
        )


def _determinant(matrix: list[Array]) -> Array:
    return matrix[0] if len(matrix) == 1 else matrix[0] * matrix[2] - matrix[1] * matrix[1]


def _solved(matrix: list[Array], right: list[Array]) -> list[Array]:
    """Solution of 1 x 1 or symmetric 2 x 2 systems."""
    if len(right) == 1:
        return [right[0] / matrix[0]]
    a, b, c = matrix
    scale = 1 / _determinant(matrix)
    return [(c * right[0] - b * right[1]) * scale, (a * right[1] - b * right[0]) * scale]
