"""Heights of the two flanks over the common tangent plane, and the gap between them.

A flank is an envelope of planes, so its height over a point (x, y) of the tangent plane is the stationary
value, over the family's parameters q, of the height T(q) at which the plane q crosses the line through
(x, y) along the common normal:

    T = (support(q) - normal(q) . (origin + x ex + y ey)) / B,     B = normal(q) . ez.

Newton's method on dT/dq = 0 settles it.  With p the point of the crossing and n_i, s_i the derivatives of
normal and support by q,

    T_i = (s_i - n_i . p) / B,     T_ij = (s_ij - n_ij . p) / B,

the latter where T_i = 0, which is near enough for Newton's method.  Its step h also gives the stationary
value itself, T - T_i h_i / 2, to the step's cube: the height is right to rounding where q is not yet.  Slopes
and curvatures of the flank follow from the same derivatives: T_x = -normal . ex / B, and
T_xy = -T_xi (T_ij)^-1 T_yj by implicit differentiation, with T_xi = -n_i . (ex + T_x ez) / B.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyworm.drives.zi_worm.helicoid import Array, Components, Helicoid, Plane
from pyworm.drives.zi_worm.meshing import WheelFlank
from pyworm.drives.zi_worm.point_cache import PointCache
from pyworm.drives.zi_worm.smooth_mesh import on_mesh

EDGE = 0.1
"""Ratio of det T_ij to that of the contact point at which a flank counts as ending.

det T_ij falls to zero at the flank's edge of regression (the base helix), where curvature grows without
bound; the flank is continued from a little before it."""

SETTLED = 1e-6
"""Newton step [rad] below which the height, whose error is the step's cube, is right to rounding."""

MOST_STEPS = 8
"""Largest number of Newton steps for a plane."""

LONGEST = 0.3
"""Newton step [rad] at which the iteration fails; larger ones led to other parts of the flank."""

STENCIL = np.array([[0, 1, -1, 0, 0, 1], [0, 0, 0, 1, -1, 1]])
"""Places from which q as a quadratic of x and y is determined."""

SPREAD = 0.01
"""Distance of these places, as the change of q from one to the next [rad]."""

ENDED = 1e-8
"""Accuracy of the flank's end: of the square of det T_ij over the contact point's, and of its place on the
ray from there as a fraction of its length."""

MOST_TRIES = 64
"""Largest number of places tried on a ray for the flank's end."""

REACH = np.pi / 2
"""Largest change of a plane's parameter [rad] from the contact point's: beyond lie other windings."""

BLOCK = 4096
"""Points solved at once: keeps the work arrays within the processor's cache."""

TOLERANCE = 1e-12
"""Error of heights on large meshes [m], a ten-thousandth of a film of 10 nm."""

MOST_CACHED = 1_000_000
"""Number of points of a flank in the cache: a grid of the figures, the one before it, and samples of
windows."""

Family = tuple[Plane, list[Plane], list[Plane]]
"""A plane with its derivatives by the parameters, and its second ones: 11, or 11, 12 and 22."""


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

    def at(self, q: Sequence[Array]) -> Family:
        """The planes of parameters q."""
        (support, normal), slope, bend = self.worm.planes(q[0])
        return (support - self.worm.base_travel * self.angle, normal), [slope], [bend]


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


def _dot(one: Components, other: Components) -> Array:
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]


def _along(point: Components, way: Array | float, direction: Components) -> Components:
    """Points some way along a direction."""
    x, y, z = (at + way * along for at, along in zip(point, direction, strict=True))
    return x, y, z


def _powers(x: Array, y: Array) -> Array:
    """Powers of x and y up to the second."""
    return np.array([np.ones(x.shape), x, y, x * x, x * y, y * y])


def _determinant(matrix: list[Array]) -> Array:
    return matrix[0] if len(matrix) == 1 else matrix[0] * matrix[2] - matrix[1] * matrix[1]


def _solved(matrix: list[Array], right: list[Array]) -> list[Array]:
    """Solution of 1 x 1 or symmetric 2 x 2 systems."""
    if len(right) == 1:
        return [right[0] / matrix[0]]
    a, b, c = matrix
    scale = 1 / _determinant(matrix)
    return [(c * right[0] - b * right[1]) * scale, (a * right[1] - b * right[0]) * scale]


def _in_blocks(find: Callable[[Array, Array], Array], x: Array, y: Array) -> Array:
    """Evaluate a function at points in blocks, with a row for each quantity."""
    blocks = [slice(first, first + BLOCK) for first in range(0, max(x.size, 1), BLOCK)]
    return np.concatenate([find(x[block], y[block]) for block in blocks], axis=1)


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

    def _line(self, x: Array, y: Array) -> Components:
        """Points at which lines along the common normal cross the tangent plane [m]."""
        ex, ey, _ = self.axes
        return _along(_along(self.origin, x, ex), y, ey)

    def _crossing(self, q: list[Array], line: Components) -> tuple[Array, list[Array], list[Array]]:
        """T, T_i and T_ij of planes where they cross lines along the common normal [m]."""
        (support, normal), first, second = self.planes.at(q)
        ez = self.axes[2]
        lift = _dot(normal, ez)
        height = (support - _dot(normal, line)) / lift
        point = _along(line, height, ez)
        slope, bend = (
            [(support - _dot(normal, point)) / lift for support, normal in derivatives]
            for derivatives in (first, second)
        )
        return height, slope, bend

    def _tilt(self, q: list[Array], direction: Components) -> tuple[Array, list[Array]]:
        """T_x along a direction of the tangent plane, and T_xi, at solved q."""
        (_, normal), first, _ = self.planes.at(q)
        ez = self.axes[2]
        lift = _dot(normal, ez)
        slope = -_dot(normal, direction) / lift
        tangent = _along(direction, slope, ez)
        return slope, [-_dot(swing, tangent) / lift for _, swing in first]

    def expansion(self, q: list[Array], x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height [m], gradient (2, ...) and second derivatives (2, 2, ...) [1/m] at solved q."""
        height, _, matrix = self._crossing(q, self._line(x, y))
        slopes, crosses = zip(*(self._tilt(q, axis) for axis in self.axes[:2]), strict=True)
        rates = [_solved(matrix, cross) for cross in crosses]
        bend = [
            [-sum(c * r for c, r in zip(cross, rate, strict=True)) for rate in rates]
            for cross in crosses
        ]
        return height, np.array(slopes), np.array(bend)

    @cached_property
    def curvatures(self) -> Array:
        """Second derivatives of the height at the contact point, (2, 2) [1/m]."""
        return self.expansion(list(self.start), 0.0, 0.0)[2]

    @cached_property
    def _contact_determinant(self) -> float:
        return _determinant(self._crossing(list(self.start), self.origin)[2])

    @cached_property
    def _guess(self) -> Array:
        """Coefficients of the powers of x and y in q near the contact point, (q, 6)."""
        start = list(self.start)
        matrix = self._crossing(start, self.origin)[2]
        rates = np.array([_solved(matrix, self._tilt(start, axis)[1]) for axis in self.axes[:2]])
        x, y = SPREAD / np.abs(rates).max() * STENCIL
        q = [at - a * x - b * y for at, (a, b) in zip(start, rates.T, strict=True)]
        _, q, _ = self._settled(q, self._line(x, y))
        return np.linalg.solve(_powers(x, y).T, np.array(q).T).T

    def _settled(self, q: list[Array], line: Components) -> tuple[Array, list[Array], Array]:
        """Height and q by Newton's method, and the margin to the flank's end; NaN where no plane is found.

        The margin is the square of det T_ij over the contact point's, less that of EDGE, or the fraction of
        REACH where that is less.
        """
        for _ in range(MOST_STEPS):
            height, slope, matrix = self._crossing(q, line)
            step = _solved(matrix, slope)
            size = np.max(np.abs(step), axis=0)
            near = size < LONGEST
            q = [np.where(near, value - h, np.nan) for value, h in zip(q, step, strict=True)]
            if np.all(size < SETTLED):
                break
        height = height - sum(a * h for a, h in zip(slope, step, strict=True)) / 2
        part = _determinant(matrix) / self._contact_determinant
        left = np.where((size < SETTLED) & (part > 0), part * part - EDGE**2, np.nan)
        for value, start in zip(q, self.start, strict=True):
            left = np.minimum(left, 1 - np.abs(value - start) / REACH)
        return height, q, left

    def solve(self, x: Array, y: Array) -> tuple[Array, list[Array], Array]:
        """Height [m] of the flank at points (x, y), the touching planes' q, and where it exists.

        Where the mathematical flank ends before (x, y), it is continued along the ray from the contact
        point with the slope of its last sound point and the contact point's curvatures, so that the
        gap stays smooth and opens; q is then the last sound point's.

        Gap and velocities are evaluated at the same points one after the other; hence results are cached and
        must not be written to.
        """
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        return self._cache.recall((x, y), lambda: self._solve_all(x, y))

    @cached_property
    def _cache(self) -> PointCache:
        return PointCache(MOST_CACHED)

    def _solve_all(self, x: Array, y: Array) -> tuple[Array, list[Array], Array]:
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            found = on_mesh(self._solve_each, x, y, TOLERANCE)
            if found is None:
                found = self._solve_each(x.ravel(), y.ravel())
        found.flags.writeable = False
        height, *q, exists = found.reshape(-1, *x.shape)
        return height, q, exists == 1

    def _solve_each(self, x: Array, y: Array) -> Array:
        """Rows as of `_solve_block`, also where the flank is continued."""
        found = _in_blocks(self._solve_block, x, y)
        lost = np.flatnonzero(found[-1] == 0)
        if lost.size:
            found[:, lost] = _in_blocks(self._continued, x[lost], y[lost])
        return found

    def _solve_block(self, x: Array, y: Array) -> Array:
        """Rows: height, q and 1 where the flank is found from the contact point, else 0."""
        height, q, left = self._settled(list(self._guess @ _powers(x, y)), self._line(x, y))
        return np.array([height, *q, left > 0])

    def _continued(self, x: Array, y: Array) -> Array:
        """Rows: height on or beyond the flank, q on the flank and fraction of the ray that lies on it."""
        reach, q = self._end(x, y)
        height, slope, _ = self.expansion(q, reach * x, reach * y)
        dx, dy = (1 - reach) * x, (1 - reach) * y
        rise = slope[0] * dx + slope[1] * dy
        bend = self.curvatures
        curl = bend[0, 0] * dx**2 + 2 * bend[0, 1] * dx * dy + bend[1, 1] * dy**2
        return np.array([height + rise + curl / 2, *q, reach])

    def _end(self, x: Array, y: Array) -> tuple[Array, list[Array]]:
        """Fraction of the ray to (x, y) that lies on the flank, and q there.

        The margin to the flank's end falls nearly linearly, so that the secant method finds its zero, with
        steps halved where no plane is found.
        """
        none, half = np.zeros(x.shape), np.full(x.shape, 0.5)
        whole = np.full(x.shape, 1 - EDGE**2)
        q = [np.full(x.shape, value) for value in self.start]
        rays = np.array([none, half, whole, none, whole, none, whole, *q])
        tried = np.arange(x.size)
        for _ in range(MOST_TRIES):
            rays[:, tried] = self._farther(rays[:, tried], x[tried], y[tried])
            reach, step, left = rays[:3, tried]
            tried = tried[(left > ENDED) & (step > ENDED) & (reach < 1)]
            if not tried.size:
                break
        return rays[0], list(rays[7:])

    def _farther(self, rays: Array, x: Array, y: Array) -> Array:
        """Rays after one more try.

        Rows: fraction of the ray on the flank, next step, residual there; the last place where a plane was
        found, and its residual; likewise of the place before; q.
        """
        reach, step, left, last, last_left, before, before_left, *q = rays
        goal = last - last_left * (last - before) / (last_left - before_left)
        goal = np.where(goal > reach, np.minimum(goal, 1.0), 1.0)
        there = np.minimum(goal, reach + step)
        tried, ahead = self._followed(q, x, y, reach, there)
        sound, found = ahead > -ENDED, ~np.isnan(ahead)
        return np.array(
            [
                np.where(sound, there, reach),
                np.where(sound, 2 * step, (there - reach) / 2),
                np.where(sound, ahead, left),
                np.where(found, there, last),
                np.where(found, ahead, last_left),
                np.where(found, last, before),
                np.where(found, last_left, before_left),
                *(np.where(sound, new, old) for new, old in zip(tried, q, strict=True)),
            ]
        )

    def _followed(
        self, q: list[Array], x: Array, y: Array, here: Array, there: Array
    ) -> tuple[list[Array], Array]:
        """q followed along the rays from here (x, y) to there (x, y), and the margin there."""
        ray = _along(_along((0.0, 0.0, 0.0), x, self.axes[0]), y, self.axes[1])
        _, _, matrix = self._crossing(q, _along(self.origin, here, ray))
        rates = _solved(matrix, self._tilt(q, ray)[1])
        q = [value - (there - here) * rate for value, rate in zip(q, rates, strict=True)]
        _, q, left = self._settled(q, _along(self.origin, there, ray))
        return q, left
