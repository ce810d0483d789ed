"""Flanks of any profile as points, for their heights over a tangent plane.

The parameters q are solved for by Newton's method from the two places in the tangent plane and, of the
wheel, from the hob's condition of cutting, N . V = 0 (`swept_wheel`). The height where the step h leads is
that of the point less its slopes times the step, right to the step's square.
"""

from dataclasses import dataclass

import numpy as np

from pyworm.drives.worm.flanks.flank_surface import FlankSurface, dot
from pyworm.drives.worm.flanks.helicoid import Array, Components
from pyworm.drives.worm.flanks.screw_generator import Vector
from pyworm.drives.worm.flanks.swept_helicoid import SweptHelicoid
from pyworm.drives.worm.flanks.swept_wheel import Cut, SweptWheel


def within(bounds: tuple[float, float], u: Array) -> Array:
    """How far a parameter is within its bounds, negative beyond them."""
    return np.minimum(u - bounds[0], bounds[1] - u)


@dataclass(frozen=True)
class WormPoints(FlankSurface):
    """The worm's flank; the parameters are u and the turn of its curve."""

    worm: SweptHelicoid
    """The worm."""
    angle: float
    """Its rotation angle [rad]."""

    def newton(self, q: list[Array], line: Vector, axes: Array) -> tuple[Array, list[Array], Array]:
        """Height where the step leads, step and the determinant of the ways in the tangent plane."""
        u, turn = q
        on = self.worm.expanded(u, turn, self.angle)
        ways = [(dot(tangent, axes[0]), dot(tangent, axes[1])) for tangent in (on.by_u, on.by_turn)]
        off = [dot(on.point, axis) - dot(line, axis) for axis in axes]
        step, determinant = _solved_two(ways, off[:2])
        height = off[2] - dot(on.by_u, axes[2]) * step[0] - dot(on.by_turn, axes[2]) * step[1]
        return height, step, determinant

    def normals(self, q: list[Array]) -> tuple[Components, list[Components]]:
        """Normals and their derivatives."""
        u, turn = q
        on = self.worm.expanded(u, turn, self.angle)
        return on.normal, [on.normal_by_u, on.normal_by_turn]

    def rates(
        self, q: list[Array], line: Vector, axes: Array, direction: Components
    ) -> list[Array]:
        """Change of q along a direction of the tangent plane."""
        u, turn = q
        on = self.worm.expanded(u, turn, self.angle)
        ways = [(dot(tangent, axes[0]), dot(tangent, axes[1])) for tangent in (on.by_u, on.by_turn)]
        return _solved_two(ways, [dot(direction, axis) for axis in axes[:2]])[0]

    def margin(self, q: list[Array]) -> Array:
        """How far u is within the curve's bounds."""
        return within(self.worm.bounds, q[0])


@dataclass(frozen=True)
class WheelPoints(FlankSurface):
    """The wheel's flank; the parameters are u and turn of the hob's curve and the lag, roll - angle."""

    flank: SweptWheel
    """The wheel flank."""
    angle: float
    """Its rotation angle [rad]."""

    def newton(self, q: list[Array], line: Vector, axes: Array) -> tuple[Array, list[Array], Array]:
        """Height where the step leads, step and the determinant of the three equations."""
        cut, (ex, ey, ez) = self._cut(q, axes)
        rows = [[dot(tangent, axis) for tangent in cut.ways] for axis in (ex, ey)]
        off = [
            dot(cut.point, seen) - dot(line, axis)
            for seen, axis in zip((ex, ey, ez), axes, strict=True)
        ]
        step, determinant = _solved_three([*rows, list(cut.slopes)], [off[0], off[1], cut.miss])
        height = off[2] - sum(
            dot(tangent, ez) * part for tangent, part in zip(cut.ways, step, strict=True)
        )
        return height, step, determinant

    def normals(self, q: list[Array]) -> tuple[Components, list[Components]]:
        """Normals and their derivatives."""
        cut = self.flank.cut(q[0], q[1], q[2] + self.angle)
        cosine, sine = np.cos(q[2]), np.sin(q[2])

        def turned(vector: Components) -> Components:
            x, y, z = vector
            return cosine * x + sine * z, y, cosine * z - sine * x

        return turned(cut.normal), [turned(swing) for swing in cut.swings]

    def rates(
        self, q: list[Array], line: Vector, axes: Array, direction: Components
    ) -> list[Array]:
        """Change of q along a direction of the tangent plane."""
        cut, (ex, ey, _) = self._cut(q, axes)
        rows = [[dot(tangent, axis) for tangent in cut.ways] for axis in (ex, ey)]
        ahead = [dot(direction, axis) for axis in axes[:2]]
        return _solved_three([*rows, list(cut.slopes)], [*ahead, np.zeros_like(ahead[0])])[0]

    def margin(self, q: list[Array]) -> Array:
        """How far u is within the curve's bounds."""
        return within(self.flank.hob.bounds, q[0])

    def _cut(self, q: list[Array], axes: Array) -> tuple[Cut, list[Components]]:
        """Points that the hob cuts, and the axes turned back by the lag, as they were when it cut them."""
        cosine, sine = np.cos(q[2]), np.sin(q[2])
        seen = [(cosine * x - sine * z, y, cosine * z + sine * x) for x, y, z in axes]
        return self.flank.cut(q[0], q[1], q[2] + self.angle), seen


def _solved_two(ways: list[tuple[Array, Array]], right: list[Array]) -> tuple[list[Array], Array]:
    """Solution of 2 x 2 systems whose columns are the ways, and their determinant."""
    (a, c), (b, d) = ways
    determinant = a * d - b * c
    scale = 1 / determinant
    return [
        (d * right[0] - b * right[1]) * scale,
        (a * right[1] - c * right[0]) * scale,
    ], determinant


def _solved_three(rows: list[list[Array]], right: list[Array]) -> tuple[list[Array], Array]:
    """Solution of 3 x 3 systems by cofactors, and their determinant."""
    (a, b, c), (d, e, f), (g, h, i) = rows
    first = e * i - f * h, c * h - b * i, b * f - c * e
    second = f * g - d * i, a * i - c * g, c * d - a * f
    third = d * h - e * g, b * g - a * h, a * e - b * d
    determinant = a * first[0] + b * second[0] + c * third[0]
    scale = 1 / determinant
    return [dot(part, right) * scale for part in (first, second, third)], determinant
