"""Heights of the two flanks over the common tangent plane, and their slopes and curvatures.

Newton's method finds the parameters q of the flank (`FlankSurface`) on the line through each point along the
common normal. With the slope T_x = -normal . ex / normal . ez the second derivatives are T_xy = T_xi q_i,y.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyworm.drives.worm.flanks.flank_surface import FlankSurface, along
from pyworm.drives.worm.flanks.helicoid import Array, Components
from pyworm.drives.worm.flanks.lagrange_interpolation import on_mesh
from pyworm.drives.worm.flanks.point_cache import PointCache
from pyworm.formulas.whole_numbers import whole

EDGE = 0.1
"""Ratio of the determinant to that of the contact point at which a flank counts as ending.

It falls to zero at the flank's edge of regression (of the involute the base helix), where curvature grows
without bound; the flank is continued from a little before it."""

MIN_NEWTON_STEP = 1e-6
"""Newton step [rad] below which the height, whose error is the step's cube, is right to rounding."""

MOST_STEPS = 8
"""Largest number of Newton steps for a plane."""

MAX_NEWTON_STEP = 0.3
"""Newton step [rad] at which the iteration fails; larger ones led to other parts of the flank."""

STENCIL = np.array([[0, 1, -1, 0, 0, 1], [0, 0, 0, 1, -1, 1]])
"""Places from which q as a quadratic of x and y is determined."""

START_DISTANCE = 0.01
"""Distance of these places, as the change of q from one to the next [rad]."""

ENDED = 1e-8
"""Accuracy of the flank's end: of the square of the determinant over the contact point's, and of its place
on the ray from there as a fraction of its length."""

MOST_TRIES = 64
"""Largest number of places tried on a ray for the flank's end."""

BACK = 0.9
"""Largest next step from the flank over that to a place tried beyond its end, where the last one was not."""

MAX_PARAMETER_CHANGE = np.pi / 2
"""Largest change of a plane's parameter [rad] from the contact point's: beyond lie other windings."""

OUTLINE_RAYS = 512
"""Rays on which the flank's end is found, and points beyond it from which on they are; between two rays its
inverse distance, linear along a straight end, is interpolated."""

MAX_OUTLINE_STEP = 0.05
"""Largest relative change of the distance of the flank's end from one ray to the next, and farthest that a
point may lie within it, for that; elsewhere a ray of its own leads to the point."""

JUST_BEYOND = 1 - 1e-9
"""Fraction of the ray on the flank of a point beside its end."""

BLOCK = 4096
"""Points solved at once: keeps the work arrays within the processor's cache."""

TOLERANCE = 1e-12
"""Error of heights on large meshes [m], a ten-thousandth of a film of 10 nm."""

MOST_CACHED = 1_000_000
"""Points of a flank in the cache: a grid of the figures, the one before, samples of windows."""


def _powers(x: Array, y: Array) -> Array:
    """Powers of x and y up to the second."""
    return np.array([np.ones(x.shape), x, y, x * x, x * y, y * y])


def _in_blocks(find: Callable[[Array, Array], Array], x: Array, y: Array) -> Array:
    """Evaluate a function at points in blocks, with a row for each quantity."""
    blocks = [slice(first, first + BLOCK) for first in range(0, max(x.size, 1), BLOCK)]
    return np.concatenate([find(x[block], y[block]) for block in blocks], axis=1)


@dataclass(frozen=True)
class FlankHeight:
    """Height of one flank over the tangent plane."""

    surface: FlankSurface
    """The flank at the instant."""
    origin: Array
    """The contact point, (3,) [m]."""
    axes: Array
    """Rows ex, ey, ez of the contact frame, (3, 3)."""
    start: tuple[float, ...]
    """Parameters q of the flank at the origin."""

    def _line(self, x: Array, y: Array) -> Components:
        """Points at which lines along the common normal cross the tangent plane [m]."""
        ex, ey, _ = self.axes
        return along(along(self.origin, x, ex), y, ey)

    def expansion(self, q: list[Array], x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height [m], gradient (2, ...) and second derivatives (2, 2, ...) [1/m] at solved q."""
        line, axes = self._line(x, y), self.axes
        height = self.surface.newton(q, line, axes)[0]
        slopes, crosses = zip(
            *(self.surface.tilt(q, axis, axes[2]) for axis in axes[:2]), strict=True
        )
        rates = [self.surface.rates(q, line, axes, axis) for axis in axes[:2]]
        bend = [
            [sum(c * r for c, r in zip(cross, rate, strict=True)) for rate in rates]
            for cross in crosses
        ]
        return height, np.array(slopes), np.array(bend)

    @property
    def _start(self) -> list[Array]:
        return [np.asarray(unknown) for unknown in self.start]

    @cached_property
    def curvatures(self) -> Array:
        """Second derivatives of the height at the contact point, (2, 2) [1/m]."""
        return self.expansion(self._start, np.zeros(()), np.zeros(()))[2]

    @cached_property
    def _contact_determinant(self) -> float:
        return float(self.surface.newton(self._start, self.origin, self.axes)[2])

    @cached_property
    def _start_margin(self) -> float:
        """Margin to the flank's end at the contact point; none where it lies on the end or beyond."""
        return min(1 - EDGE**2, float(np.min(self.surface.margin(self._start))))

    @cached_property
    def _guess(self) -> Array:
        """Coefficients of the powers of x and y in q near the contact point, (q, 6)."""
        start = self._start
        rates = np.array(
            [self.surface.rates(start, self.origin, self.axes, axis) for axis in self.axes[:2]]
        )
        x, y = START_DISTANCE / np.abs(rates).max() * STENCIL
        q = [value + a * x + b * y for value, (a, b) in zip(start, rates.T, strict=True)]
        _, q, _ = self._converged(q, self._line(x, y))
        return np.linalg.solve(_powers(x, y).T, np.array(q).T).T

    def _converged(self, q: list[Array], line: Components) -> tuple[Array, list[Array], Array]:
        """Height and q by Newton's method, and the margin to the flank's end; NaN where no plane is found.

        The margin is the square of the determinant over the contact point's, less that of EDGE, or the
        fraction of REACH, or what is left of the parameters, where that is less.
        """
        for _ in range(MOST_STEPS):
            height, step, determinant = self.surface.newton(q, line, self.axes)
            size = np.max(np.abs(step), axis=0)
            near = size < MAX_NEWTON_STEP
            q = [np.where(near, value - h, np.nan) for value, h in zip(q, step, strict=True)]
            if np.all(size < MIN_NEWTON_STEP):
                break
        part = determinant / self._contact_determinant
        left = np.where((size < MIN_NEWTON_STEP) & (part > 0), part * part - EDGE**2, np.nan)
        for value, start in zip(q, self.start, strict=True):
            left = np.minimum(left, 1 - np.abs(value - start) / MAX_PARAMETER_CHANGE)
        left = np.minimum(left, self.surface.margin(q))
        return height, q, left

    def solve(self, x: Array, y: Array) -> tuple[Array, list[Array], Array]:
        """Height [m] of the flank at points (x, y), the touching planes' q, and where it exists.

        Where the flank ends before (x, y), it is continued along the ray from the contact point with the
        slope of its last sound point, whose q is given, and the contact point's curvatures, so that the gap
        stays smooth and opens. Gap and velocities are evaluated at the same points, one after the other:
        results, cached, are not written to.
        """
        height, _, q, exists = self._found(x, y)
        return height, q, exists

    def moving(self, x: Array, y: Array) -> Array:
        """Height [m] of the flank at points (x, y); where it ends before them, of its last sound point.

        The flank as continued may be several times the worm's radius away, where a body turns backwards:
        surfaces that move so do not exist, and their heat, led through the contact, has no sense.
        """
        return self._found(x, y)[1]

    def _found(self, x: Array, y: Array) -> tuple[Array, Array, list[Array], Array]:
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        return self._cache.recall((x, y), lambda: self._solve_all(x, y))

    @cached_property
    def _cache(self) -> PointCache:
        return PointCache(MOST_CACHED)

    def _solve_all(self, x: Array, y: Array) -> tuple[Array, Array, list[Array], Array]:
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            found = on_mesh(self._solve_each, x, y, TOLERANCE)
            if found is None:
                found = self._solve_each(x.ravel(), y.ravel())
        found.flags.writeable = False
        height, moving, *q, exists = found.reshape(-1, *x.shape)
        return height, moving, q, exists == 1

    def _solve_each(self, x: Array, y: Array) -> Array:
        """Rows as of `_solve_block`, also where the flank is continued."""
        found = _in_blocks(self._solve_block, x, y)
        for further, least in ((self._between_rays, OUTLINE_RAYS), (self._along_rays, 1)):
            failed = np.flatnonzero(found[-1] == 0)
            if failed.size >= least:
                found[:, failed] = _in_blocks(further, x[failed], y[failed])
        return found

    def _solve_block(self, x: Array, y: Array) -> Array:
        """Rows: height, twice, q and 1 where the flank is found from the contact point, else 0."""
        height, q, left = self._converged(list(self._guess @ _powers(x, y)), self._line(x, y))
        return np.array([height, height, *q, left > 0])

    def _along_rays(self, x: Array, y: Array) -> Array:
        """Rows as of `_continued`, by a ray to each point."""
        return self._continued(x, y, *self._end(x, y))

    def _between_rays(self, x: Array, y: Array) -> Array:
        """Rows as of `_continued`, by rays of the outline beside them; 0 last where these do not tell."""
        inverse, on_rays = self._outline
        turn = np.arctan2(y, x) / (2 * np.pi) * OUTLINE_RAYS
        first = whole(np.floor(turn))
        part, first, second = turn - first, first % OUTLINE_RAYS, (first + 1) % OUTLINE_RAYS
        change = inverse[second] - inverse[first]
        reach = 1 / ((inverse[first] + part * change) * np.hypot(x, y))
        smooth = np.abs(change) <= MAX_OUTLINE_STEP * np.minimum(inverse[first], inverse[second])
        near = np.flatnonzero(smooth & (reach < 1 + MAX_OUTLINE_STEP))
        reach, x_near, y_near = np.minimum(reach[near], 1.0), x[near], y[near]
        first, second, part = first[near], second[near], part[near]
        between = on_rays[:, first] + part * (on_rays[:, second] - on_rays[:, first])
        _, q, left = self._converged(list(between), self._line(reach * x_near, reach * y_near))
        reach = np.where(left > 0, reach, np.minimum(reach, JUST_BEYOND))
        found = np.zeros((3 + len(q), x.size))
        sound = ~np.isnan(left)
        q = [values[sound] for values in q]
        found[:, near[sound]] = self._continued(x_near[sound], y_near[sound], reach[sound], q)
        return found

    def _continued(self, x: Array, y: Array, reach: Array, q: list[Array]) -> Array:
        """Rows: height on or beyond the flank, and on it, q there and fraction of the ray that lies on it.

        `reach` is that fraction, and `q` belongs to its end.
        """
        height, slope, _ = self.expansion(q, reach * x, reach * y)
        dx, dy = (1 - reach) * x, (1 - reach) * y
        rise = slope[0] * dx + slope[1] * dy
        bend = self.curvatures
        curl = bend[0, 0] * dx**2 + 2 * bend[0, 1] * dx * dy + bend[1, 1] * dy**2
        return np.array([height + rise + curl / 2, height, *q, reach])

    @cached_property
    def _outline(self) -> tuple[Array, Array]:
        """Inverse of the distance to the flank's end on each ray [1/m], and q there; NaN where it is far."""
        angle = 2 * np.pi / OUTLINE_RAYS * np.arange(OUTLINE_RAYS)
        x, y = np.cos(angle), np.sin(angle)
        rates = np.abs(self._guess[:, 1:3] @ (x, y)).max(axis=0)
        length = MAX_PARAMETER_CHANGE / rates
        reach, q = self._end(length * x, length * y)
        return np.where(reach < 1, 1 / (reach * length), np.nan), np.array(q)

    def _end(self, x: Array, y: Array) -> tuple[Array, list[Array]]:
        """Fraction of the ray to (x, y) that lies on the flank, and q there.

        The margin to the flank's end falls nearly linearly, so that the secant method finds its zero, with
        steps halved where no plane is found: that far q is not followed at once.
        """
        none, half, twice = (np.full(x.shape, value) for value in (0.0, 0.5, 2.0))
        margin = np.full(x.shape, self._start_margin)
        q = [np.full(x.shape, value) for value in self.start]
        rays = np.array([none, half, twice, margin, none, margin, none, margin, *q])
        tried = np.flatnonzero(margin > ENDED)
        for _ in range(MOST_TRIES):
            if not tried.size:
                break
            rays[:, tried] = self._farther(rays[:, tried], x[tried], y[tried])
            reach, step, _, left = rays[:4, tried]
            tried = tried[(left > ENDED) & (step > ENDED) & (reach < 1)]
        return rays[0], list(rays[8:])

    def _farther(self, rays: Array, x: Array, y: Array) -> Array:
        """Rays after one more try.

        Rows: fraction of the ray on the flank, next step and its growth if it succeeds, residual there; the
        last place where a plane was found, and its residual; likewise of the place before; q.
        """
        reach, step, growth, left, last, last_left, before, before_left, *q = rays
        goal = last - last_left * (last - before) / (last_left - before_left)
        goal = np.where(goal > reach, np.minimum(goal, 1.0), 1.0)
        there = np.minimum(goal, reach + step)
        tried, ahead = self._followed(q, x, y, reach, there)
        sound, found = ahead > -ENDED, ~np.isnan(ahead)
        back = np.where(found & (last_left > 0), BACK, 0.5) * (there - reach)
        return np.array(
            [
                np.where(sound, there, reach),
                np.where(sound, growth * step, back),
                np.where(sound, np.minimum(2 * growth, 2.0), np.where(found, 1.0, 0.5)),
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
        ray = along(along((0.0, 0.0, 0.0), x, self.axes[0]), y, self.axes[1])
        rates = self.surface.rates(q, along(self.origin, here, ray), self.axes, ray)
        q = [value + (there - here) * rate for value, rate in zip(q, rates, strict=True)]
        _, q, left = self._converged(q, along(self.origin, there, ray))
        return q, left
