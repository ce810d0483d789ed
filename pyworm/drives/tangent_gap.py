"""Heights of the two flanks over the common tangent plane, and the gap between them.

A flank is an envelope of planes, so its height over a point (x, y) of the tangent plane is the stationary
value, over the family's parameters q, of the height T(q) = A / B at which the plane q crosses the line
through (x, y) along the common normal:

    A = support(q) - normal(q) . (origin + x ex + y ey),     B = normal(q) . ez.

Newton's method on dT/dq = 0 settles it; since T is stationary there, its error is the square of that in q
and the height is right to rounding.  Slopes and curvatures of the flank follow from the same derivatives:
dT/dx = -normal . ex / B, and d2T/dx2 = -T_xq T_qq^-1 T_qx by implicit differentiation.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyworm.drives.helicoid import Array, Helicoid
from pyworm.drives.kept import Kept
from pyworm.drives.meshing import WheelFlank, across_axis, turned

STEPS = 2
"""Steps from the contact point out to (x, y) while Newton's method follows the flank."""

EDGE = 0.1
"""Part of the contact point's det T_qq left where a flank counts as ending.

det T_qq falls to zero at the flank's edge of regression (the base helix), where curvature grows without
bound; the flank is continued from a little before it."""

SETTLED = 1e-7
"""Newton step [rad] below which the height, whose error is the step's square, is right to rounding."""

REACH = np.pi / 2
"""Largest change of a plane's parameter [rad] from the contact point's: beyond lie other windings."""

BLOCK = 16384
"""Points solved at once: keeps the work arrays within the processor's cache."""

MOST_KEPT = 500_000
"""Points of a flank that are kept: a grid of the figures, the one before it, and what windows sampled."""

Expansion = tuple[Array, list[Array], list[list[Array]]]
"""A function of q with its gradient and its (symmetric) matrix of second derivatives."""


@dataclass(frozen=True)
class WormPlanes:
    """Tangent planes of the worm flank; the parameter is theta.

    Attributes
    ----------
    worm : Helicoid
        The worm.
    angle : float
        Its rotation angle [rad].
    """

    worm: Helicoid
    angle: float

    def expand(self, q: Sequence[Array], *vectors: Array) -> tuple[Expansion, ...]:
        """Support [m] of the planes, then normal . vector for each of the vectors (3, ...)."""
        normal, slope, bend = self.worm.normals(q[0])
        value, value_slope, value_bend = self.worm.supports(q[0])
        support = value - self.worm.base_travel * self.angle, [value_slope], [[value_bend]]
        dots = [[np.sum(n * vector, 0) for n in (normal, slope, bend)] for vector in vectors]
        return support, *((d[0], [d[1]], [[d[2]]]) for d in dots)


@dataclass(frozen=True)
class WheelPlanes:
    """Tangent planes of the wheel flank; the parameters are the hob's theta and the lag, roll - angle.

    Attributes
    ----------
    flank : WheelFlank
        The wheel flank.
    angle : float
        Its rotation angle [rad].
    """

    flank: WheelFlank
    angle: float

    def expand(self, q: Sequence[Array], *vectors: Array) -> tuple[Expansion, ...]:
        """Support [m] of the planes, then normal . vector for each of the vectors (3, ...)."""
        normal, slope, bend = self.flank.hob.normals(q[0])
        value, value_slope, value_bend = self.flank.hob.supports(q[0])
        lever = self.flank.lever
        expansions: list[Expansion] = [
            (
                value - lever * (q[1] + self.angle),
                [value_slope, np.full_like(value, -lever)],
                [[value_bend, 0.0], [0.0, 0.0]],
            )
        ]
        for vector in vectors:
            # turning the vector back is cheaper than turning three normals
            back = turned(vector, -q[1])
            swing = -across_axis(back)
            mixed = np.sum(slope * swing, 0)
            # swinging twice takes the part across the axis, reversed
            twice = -(normal[0] * back[0] + normal[2] * back[2])
            expansions.append(
                (
                    np.sum(normal * back, 0),
                    [np.sum(slope * back, 0), np.sum(normal * swing, 0)],
                    [[np.sum(bend * back, 0), mixed], [mixed, twice]],
                )
            )
        return tuple(expansions)


def _solved(matrix: list[list[Array]], right: list[Array]) -> tuple[list[Array], Array]:
    """Solution of 1 x 1 or symmetric 2 x 2 systems, and their determinants."""
    if len(right) == 1:
        return [right[0] / matrix[0][0]], matrix[0][0]
    (a, b), (_, c) = matrix
    determinant = a * c - b * b
    return [
        (c * right[0] - b * right[1]) / determinant,
        (a * right[1] - b * right[0]) / determinant,
    ], determinant


@dataclass(frozen=True)
class FlankHeight:
    """Height of one flank over the tangent plane.

    Attributes
    ----------
    planes : WormPlanes or WheelPlanes
        The flank's tangent planes at the instant.
    origin : ndarray
        The contact point, (3,) [m].
    axes : ndarray
        Rows ex, ey, ez of the contact frame, (3, 3).
    start : tuple of float
        Parameters q of the plane that touches at the origin.
    """

    planes: WormPlanes | WheelPlanes
    origin: Array
    axes: Array
    start: tuple[float, ...]

    def _crossing(
        self, q: Sequence[Array], x: Array, y: Array, *along: Array
    ) -> tuple[Array, list[Array], list[list[Array]], list[tuple[Array, list[Array]]]]:
        """T and its q derivatives at fixed (x, y); then dT/d(along) and its q slopes.

        Parameters
        ----------
        q : sequence of array
            Parameters of the planes.
        x, y : array
            Points of the tangent plane [m].
        along : ndarray
            Axes of the tangent plane, (3,), whose slopes are wanted.
        """
        ex, ey, ez = self.axes
        line = np.stack([o + x * a + y * b for o, a, b in zip(self.origin, ex, ey, strict=True)])
        constant = [axis.reshape((3,) + (1,) * np.ndim(x)) for axis in (ez, *along)]
        (s, s1, s2), (n, n1, n2), (b, b1, b2), *rest = self.planes.expand(q, line, *constant)
        size = range(len(q))
        t = (s - n) / b
        t1 = [(s1[i] - n1[i] - t * b1[i]) / b for i in size]
        t2 = [
            [(s2[i][j] - n2[i][j] - t1[i] * b1[j] - t1[j] * b1[i] - t * b2[i][j]) / b for j in size]
            for i in size
        ]
        slopes = []
        for value, value1, _ in rest:
            slope = -value / b
            slopes.append((slope, [-(value1[i] + slope * b1[i]) / b for i in size]))
        return t, t1, t2, slopes

    def expansion(self, q: Sequence[Array], x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height [m], gradient (2, ...) and second derivatives (2, 2, ...) [1/m] at solved q."""
        t, _, t2, slopes = self._crossing(q, x, y, *self.axes[:2])
        crosses = [cross for _, cross in slopes]
        rates = [_solved(t2, cross)[0] for cross in crosses]
        bend = [
            [-sum(c * r for c, r in zip(crosses[i], rates[j], strict=True)) for j in range(2)]
            for i in range(2)
        ]
        return t, np.stack([slope for slope, _ in slopes]), np.array(bend)

    @cached_property
    def curvatures(self) -> Array:
        """Second derivatives of the height at the contact point, (2, 2) [1/m]."""
        q = [np.array(value) for value in self.start]
        return self.expansion(q, np.array(0.0), np.array(0.0))[2]

    @cached_property
    def _start_determinant(self) -> float:
        q = [np.array(value) for value in self.start]
        _, t1, t2, _ = self._crossing(q, np.array(0.0), np.array(0.0))
        return float(_solved(t2, t1)[1])

    def _newton(
        self, q: list[Array], x: Array, y: Array, count: int
    ) -> tuple[list[Array], Array, Array]:
        """Newton steps towards dT/dq = 0; also the height and whether the flank is sound there."""
        for _ in range(count):
            _, t1, t2, _ = self._crossing(q, x, y)
            step, _ = _solved(t2, t1)
            # beyond the edge a step may be wild; such points are given up, here kept finite
            step = [np.clip(np.nan_to_num(s), -0.3, 0.3) for s in step]
            q = [value - s for value, s in zip(q, step, strict=True)]
            if max(np.max(np.abs(s), initial=0.0) for s in step) < SETTLED:
                break
        t, t1, t2, _ = self._crossing(q, x, y)
        step, determinant = _solved(t2, t1)
        sound = determinant / self._start_determinant > EDGE
        sound &= np.max(np.abs(step), axis=0) < SETTLED
        for value, start in zip(q, self.start, strict=True):
            sound &= np.abs(value - start) < REACH
        return q, t, sound

    def _follow(
        self,
        q: list[Array],
        x: Array,
        y: Array,
        here: Array | float,
        there: Array | float,
        count: int,
    ) -> tuple[list[Array], Array, Array]:
        """Parameters carried along the rays from here (x, y) to there (x, y), 0 to 1 of the ray."""
        _, _, t2, slopes = self._crossing(q, here * x, here * y, *self.axes[:2])
        ahead = there - here
        (_, cross_x), (_, cross_y) = slopes
        drift = [cx * x * ahead + cy * y * ahead for cx, cy in zip(cross_x, cross_y, strict=True)]
        step, _ = _solved(t2, drift)
        q = [value - s for value, s in zip(q, step, strict=True)]
        return self._newton(q, there * x, there * y, count)

    def solve(self, x: Array, y: Array) -> tuple[Array, list[Array], Array]:
        """Height [m] of the flank at points (x, y), the touching planes' q, and where it exists.

        Where the mathematical flank ends before (x, y), it is continued along the ray from the contact
        point with the slope of its last sound point and the contact point's curvatures, so that the
        gap stays smooth and opens; q is then the last sound point's.

        Gap and velocities are asked for at the same points, one after the other: what was found is kept, and
        must not be written to.
        """
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        return self._kept.recall((x, y), lambda: self._solve_all(x, y))

    @cached_property
    def _kept(self) -> Kept:
        return Kept(MOST_KEPT)

    def _solve_all(self, x: Array, y: Array) -> tuple[Array, list[Array], Array]:
        flat = x.ravel(), y.ravel()
        height = np.empty(x.size)
        exists = np.empty(x.size, dtype=bool)
        q = [np.empty(x.size) for _ in self.start]
        for first in range(0, x.size, BLOCK):
            block = slice(first, first + BLOCK)
            height[block], parts, exists[block] = self._solve_block(flat[0][block], flat[1][block])
            for whole, part in zip(q, parts, strict=True):
                whole[block] = part
        found = height, *q, exists
        for part in found:
            part.flags.writeable = False
        height, *q, exists = (part.reshape(x.shape) for part in found)
        return height, q, exists

    def _solve_block(self, x: Array, y: Array) -> tuple[Array, list[Array], Array]:
        q = [np.full(x.shape, value) for value in self.start]
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            for k in range(STEPS):
                count = 6 if k == STEPS - 1 else 1
                q, height, sound = self._follow(q, x, y, k / STEPS, (k + 1) / STEPS, count)
            lost = np.flatnonzero(~sound)
            if lost.size:
                height[lost], parts = self._continued(x[lost], y[lost])
                for whole, part in zip(q, parts, strict=True):
                    whole[lost] = part
        return height, q, sound

    def _continued(self, x: Array, y: Array) -> tuple[Array, list[Array]]:
        """Heights beyond the flank's end, and q where the flank ends on each ray."""
        reach, beyond = np.zeros(x.shape), np.ones(x.shape)
        q = [np.full(x.shape, value) for value in self.start]
        step = np.full(x.shape, 1 / 16)
        for _ in range(64):
            there = np.minimum(reach + step, beyond)
            tried, _, sound = self._follow(q, x, y, reach, there, 4)
            q = [np.where(sound, new, old) for new, old in zip(tried, q, strict=True)]
            reach = np.where(sound, there, reach)
            step = np.where(sound, step, step / 2)
            if np.all(step < 1e-7):
                break
        height, slope, _ = self.expansion(q, reach * x, reach * y)
        dx, dy = (1 - reach) * x, (1 - reach) * y
        rise = slope[0] * dx + slope[1] * dy
        bend = self.curvatures
        curl = bend[0, 0] * dx**2 + 2 * bend[0, 1] * dx * dy + bend[1, 1] * dy**2
        return height + rise + curl / 2, q
