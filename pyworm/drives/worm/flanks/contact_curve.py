"""The path of contact of a worm of any profile and the wheel that a hob of its kind cuts.

At a rotation angle of the worm the contact has six unknowns, u and turn on the worm, u, turn and lag on the
wheel, and the wheel's angle, and six equations: the two points coincide, the two normals are parallel, and
the hob cuts there. They are solved by Newton's method, from one angle to
the next, which begins over the line of centres on the reference cylinders. The places of this path are worm
angles [rad].
"""

from dataclasses import dataclass
from functools import cached_property
from math import pi

import numpy as np
import scipy

from pyworm.drives.worm.flanks.contact_path import ContactPath, Touches
from pyworm.drives.worm.flanks.flank_points import WheelPoints, WormPoints
from pyworm.drives.worm.flanks.flank_surface import dot
from pyworm.drives.worm.flanks.helicoid import Array, Components
from pyworm.drives.worm.flanks.swept_helicoid import SweptHelicoid
from pyworm.drives.worm.flanks.swept_wheel import SweptWheel, across

MIN_NEWTON_STEP = 1e-11
"""Newton step beyond which nothing is gained."""

MAX_NEWTON_STEP = 0.2
"""Longest Newton step that is taken whole."""

MOST_STEPS = 60

STEP = 0.1
"""Step of the worm's rotation along the path, as a fraction of the rotation for one wheel tooth."""

MAX_ROTATIONS = 2.5
"""Rotation of the worm to either side that the path is followed over, as a multiple of that."""


class HobError(ValueError):
    """A hob that cuts no wheel for the worm, by how it is set up or by its size."""


@dataclass(frozen=True)
class ContactCurve(ContactPath):
    """The contact point of a worm of any profile; places are worm angles."""

    worm: SweptHelicoid
    """The worm as assembled."""
    flank: SweptWheel
    """The wheel flank."""
    threads: int
    """Number of threads of the worm."""
    reference_radii: tuple[float, float]
    """Reference radii of worm and hob [m], where the path is begun."""

    def touches(self, places: Array) -> Touches:
        """Contacts at worm angles; beyond the path as far as it could be followed they go straight on."""
        places = np.asarray(places, float)
        known = np.clip(places, *self._nodes[[0, -1]])
        unknown = self._spline(known)
        for _ in range(2):
            miss, slopes, _ = self._residual(unknown, known)
            unknown = unknown - _solved(slopes, miss)
        _, slopes, pace = self._residual(unknown, known)
        rates = -_solved(slopes, pace)
        on = self.worm.expanded(unknown[0], unknown[1], known)
        normal = _stacked(on.normal)
        rising = _stacked((0.0, 0.0, 0.0), known) - self.worm.screw * self.worm.axes[:, 2][:, None]
        travel = _stacked(on.by_u, known) * rates[0] + _stacked(on.by_turn) * rates[1] + rising
        past = places - known
        return Touches(
            worm_angle=places,
            wheel_angle=unknown[5] + rates[5] * past,
            point=_stacked(on.point) + travel * past,
            normal=-normal / np.sqrt(np.sum(normal**2, axis=0)),
            travel=travel,
            worm_start=unknown[:2] + rates[:2] * past,
            wheel_start=unknown[2:5] + rates[2:5] * past,
        )

    def ends(self) -> tuple[float, float]:
        """First and last worm angle of the path as far as it could be followed."""
        return float(self._nodes[0]), float(self._nodes[-1])

    def search(self, tip_radius: float) -> Array:
        """Worm angles along the path as far as it could be followed."""
        return np.linspace(self._nodes[0], self._nodes[-1], 401)

    def worm_surface(self, angle: float) -> WormPoints:
        """The worm's points."""
        return WormPoints(self.worm, angle)

    def wheel_surface(self, angle: float) -> WheelPoints:
        """The wheel's points."""
        return WheelPoints(self.flank, angle)

    @cached_property
    def _spline(self) -> "scipy.interpolate.CubicHermiteSpline":
        """Unknowns over the worm's angle, a first guess between the angles solved."""
        angles, unknowns, rates = self._followed
        return scipy.interpolate.CubicHermiteSpline(angles, unknowns, rates, axis=1)

    @property
    def _nodes(self) -> Array:
        return self._followed[0]

    @cached_property
    def _followed(self) -> tuple[Array, Array, Array]:
        """Worm angles, unknowns there and their rates, along the path to either side of its beginning."""
        angle, start = self._begun
        step = STEP * 2 * pi / self.threads
        found = []
        for angle_step in (-step, step):
            side, here, unknown = [], angle, start
            while abs(here - angle) < MAX_ROTATIONS * 2 * pi / self.threads:
                _, slopes, pace = self._residual(unknown[:, None], np.array([here]))
                rate = -_solved(slopes, pace)[:, 0]
                side.append((here, unknown, rate))
                here, guess = here + angle_step, unknown + angle_step * rate
                solved = self._solved_at(guess, here)
                if solved is None or np.abs(solved - guess).max() > MAX_NEWTON_STEP:
                    break
                unknown = solved
            found.append(side)
        path = [*found[0][:0:-1], *found[1]]
        angles, unknowns, rates = zip(*path, strict=True)
        return np.array(angles), np.array(unknowns).T, np.array(rates).T

    @property
    def _begun(self) -> tuple[float, Array]:
        """Worm angle and unknowns of the contact from the pitch points; HobError without one near."""
        (u, turn, angle), (cut_u, cut_turn, hob_angle) = (
            screw.over_centres(radius)
            for screw, radius in zip((self.worm, self.flank.hob), self.reference_radii, strict=True)
        )
        guess = np.array([u, turn, cut_u, cut_turn, 0.0, hob_angle * self.flank.ratio])
        found = self._solved_at(guess, angle)
        if found is None:
            raise HobError(
                f"hob.swivel and hob.axial_shift are {np.degrees(self.flank.hob.swivel):.4g} deg and "
                f"{self.flank.hob.axial_shift * 1e3:.4g} mm, for which worm and wheel do not touch near the "
                "pitch point; a set-up that brings the contact there is needed"
            )
        return angle, found

    def _solved_at(self, guess: Array, angle: float) -> Array | None:
        """The unknowns at a worm angle; None where Newton's method does not find them."""
        unknown: Array = guess
        for _ in range(MOST_STEPS):
            miss, slopes, _ = self._residual(unknown[:, None], np.array([angle]))
            try:
                step = _solved(slopes, miss)[:, 0]
            except np.linalg.LinAlgError:
                return None
            size = np.abs(step).max()
            unknown = unknown - step * (MAX_NEWTON_STEP / max(size, MAX_NEWTON_STEP))
            if not (
                _within(self.worm.bounds, unknown[0]) and _within(self.flank.hob.bounds, unknown[2])
            ):
                return None
            if size < MIN_NEWTON_STEP:
                return np.asarray(unknown)
        return None

    def _residual(self, unknown: Array, angle: Array) -> tuple[Array, Array, Array]:
        """Equations at places, (6, places), derivatives by unknowns (6, 6, places) and by the angle.

        They are the distance of the points over the size, the normal of the wheel along the worm's flank, and
        N . V. A screw's angle and the wheel's roll move its points along its axis alone.
        """
        u, turn, cut_u, cut_turn, lag, wheel = unknown
        on, size = self.worm.expanded(u, turn, angle), self.worm.size
        cut = self.flank.cut(cut_u, cut_turn, lag + wheel)
        cosine, sine = np.cos(lag), np.sin(lag)

        def turned(vector: Components) -> Components:
            x, y, z = vector
            return cosine * x + sine * z, y, cosine * z - sine * x

        point, normal = turned(cut.point), turned(cut.normal)
        by_cut_u, by_cut_turn, _ = (turned(tangent) for tangent in cut.ways)
        swings = tuple(turned(swing) for swing in cut.swings)
        rise = turned(self.flank.rise)
        by_lag = [a + b for a, b in zip(across(point), rise, strict=True)]
        rows = [(a - b) / size for a, b in zip(on.point, point, strict=True)]
        slopes = [
            [a / size, b / size, -c / size, -d / size, -e / size, -f / size]
            for a, b, c, d, e, f in zip(
                on.by_u, on.by_turn, by_cut_u, by_cut_turn, by_lag, rise, strict=True
            )
        ]
        for tangent, bends in zip((on.by_u, on.by_turn), self.worm.bends(u, turn), strict=True):
            rows.append(dot(tangent, normal) / size**2)
            by_worm = [dot(bend, normal) / size**2 for bend in bends]
            by_wheel = [dot(tangent, swing) / size**2 for swing in swings]
            slopes.append([*by_worm, *by_wheel, 0.0])
        rows.append(cut.miss / size**2)
        by_u, by_turn, by_roll = (slope / size**2 for slope in cut.slopes)
        slopes.append([0.0, 0.0, by_u, by_turn, by_roll, by_roll])
        pace = [-self.worm.screw * part / size for part in self.worm.axes[:, 2]] + [0.0] * 3
        return (
            np.stack(np.broadcast_arrays(*rows)),
            np.stack([np.stack(np.broadcast_arrays(*row, angle)[:6]) for row in slopes]),
            np.stack(np.broadcast_arrays(*pace, angle)[:6]),
        )


def _solved(slopes: Array, right: Array) -> Array:
    """Solution of systems (6, 6, places) for (6, places)."""
    matrices, columns = np.moveaxis(slopes, -1, 0), np.moveaxis(right, -1, 0)
    return np.moveaxis(np.linalg.solve(matrices, columns[..., None])[..., 0], 0, -1)


def _stacked(vector: Components, like: Array | float = 0.0) -> Array:
    """Components as one array, (3, ...)."""
    return np.stack(np.broadcast_arrays(*(part + 0 * np.asarray(like) for part in vector)))


def _within(bounds: tuple[float, float], u: float) -> bool:
    """Whether a parameter is within its bounds."""
    return bounds[0] < u < bounds[1]
