"""Heights of the two flanks over the common tangent plane, and their slopes and curvatures.

The kernel's Newton iteration finds the parameters q of the flank (`FlankSurface`) on the line through each
point along the common normal, from a quadratic of the point. Beyond the flank's end it is continued.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyworm.drives.worm.flanks.flank_surface import FlankSurface
from pyworm.drives.worm.flanks.helicoid import Array
from pyworm.drives.worm.flanks.lagrange_interpolation import on_mesh
from pyworm.drives.worm.flanks.point_cache import PointCache
from pyworm.formulas.whole_numbers import whole
from pyworm.kernel.flank_height import FlankOverPlane

STENCIL = np.array([[0, 1, -1, 0, 0, 1], [0, 0, 0, 1, -1, 1]])
"""Places from which q as a quadratic of x and y is determined."""

START_DISTANCE = 0.01
"""Distance of these places, as the change of q from one to the next [rad]."""

OUTLINE_RAYS = 512
"""Rays on which the flank's end is found, and points beyond it from which on they are; between two rays its
inverse distance, linear along a straight end, is interpolated."""

OUTLINE_CHANGE = np.pi / 2
"""Change of a parameter [rad] up to which these rays go, about where other windings begin."""

MAX_OUTLINE_STEP = 0.05
"""Largest relative change of the distance of the flank's end from one ray to the next, and farthest that a
point may lie within it, for that; elsewhere a ray of its own leads to the point."""

JUST_BEYOND = 1 - 1e-9
"""Fraction of the ray on the flank of a point beside its end."""

TOLERANCE = 1e-12
"""Error of heights on large meshes [m], a ten-thousandth of a film of 10 nm."""

MOST_CACHED = 1_000_000
"""Points of a flank in the cache: a grid of the figures, the one before, samples of windows."""


def _powers(x: Array, y: Array) -> Array:
    """Powers of x and y up to the second."""
    return np.array([np.ones(x.shape), x, y, x * x, x * y, y * y])


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

    @cached_property
    def _over_plane(self) -> FlankOverPlane:
        return FlankOverPlane(self.surface.numbers, self.axes, self.origin, self.start)

    def expansion(self, q: Array, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height [m], gradient (2, ...) and second derivatives (2, 2, ...) [1/m] at solved q (q, ...)."""
        shape = np.shape(x)
        found = self._over_plane.expansions(np.ravel(x), np.ravel(y), np.reshape(q, (len(q), -1)))
        parts = found.height, found.slopes, found.bend
        height, slopes, bend = (part.reshape((*part.shape[:-1], *shape)) for part in parts)
        return height, slopes, bend

    @cached_property
    def curvatures(self) -> Array:
        """Second derivatives of the height at the contact point, (2, 2) [1/m]."""
        return self.expansion(np.array(self.start), np.zeros(()), np.zeros(()))[2]

    @cached_property
    def _guess(self) -> Array:
        """Coefficients of the powers of x and y in q near the contact point, (q, 6)."""
        here, start = np.zeros(1), np.array(self.start)[:, None]
        rates = self._over_plane.expansions(here, here, start).rates[..., 0]
        x, y = START_DISTANCE / np.abs(rates).max() * STENCIL
        _, q, _ = self._over_plane.heights(x, y, start + rates @ (x, y))
        return np.linalg.solve(_powers(x, y).T, q.T).T

    def solve(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Height [m] of the flank at points (x, y), its q there, (q, ...), and where it exists.

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

    def _found(self, x: Array, y: Array) -> tuple[Array, Array, Array, Array]:
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        return self._cache.recall((x, y), lambda: self._solve_all(x, y))

    @cached_property
    def _cache(self) -> PointCache:
        return PointCache(MOST_CACHED)

    def _solve_all(self, x: Array, y: Array) -> tuple[Array, Array, Array, Array]:
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            found = on_mesh(self._solve_each, x, y, TOLERANCE)
            if found is None:
                found = self._solve_each(x.ravel(), y.ravel())
        found.flags.writeable = False
        found = found.reshape(-1, *x.shape)
        return found[0], found[1], found[2:-1], found[-1] == 1

    def _solve_each(self, x: Array, y: Array) -> Array:
        """Rows: height, also where the flank is continued, height on it, q there, and 1 where it exists.

        Less than 1 is the fraction of the ray to the point that lies on the flank.
        """
        height, q, left = self._over_plane.heights(x, y, self._guess @ _powers(x, y))
        found = np.array([height, height, *q, left > 0])
        for further, least in ((self._between_rays, OUTLINE_RAYS), (self._along_rays, 1)):
            failed = np.flatnonzero(found[-1] == 0)
            if failed.size >= least:
                found[:, failed] = further(x[failed], y[failed])
        return found

    def _along_rays(self, x: Array, y: Array) -> Array:
        """Rows as of `_continued`, by a ray to each point."""
        return self._continued(x, y, *self._over_plane.ends(x, y))

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
        _, q, left = self._over_plane.heights(reach * x_near, reach * y_near, between)
        reach = np.where(left > 0, reach, np.minimum(reach, JUST_BEYOND))
        found = np.zeros((3 + len(q), x.size))
        sound = ~np.isnan(left)
        found[:, near[sound]] = self._continued(
            x_near[sound], y_near[sound], reach[sound], q[:, sound]
        )
        return found

    def _continued(self, x: Array, y: Array, reach: Array, q: Array) -> Array:
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
        length = OUTLINE_CHANGE / rates
        reach, q = self._over_plane.ends(length * x, length * y)
        return np.where(reach < 1, 1 / (reach * length), np.nan), q
