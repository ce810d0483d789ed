"""Helicoids that a disc grinds, the flanks of ZK and ZC worms: the envelope of its surface in a screw motion.

The disc's axis crosses the worm's at the distance r + R of their reference radii and is inclined to the
transverse plane by the lead angle gamma there. Its profile is a straight line (ZK, a cone) or a convex arc
(ZC, type C of ISO 1122-2, which makes a concave thread). A point of the disc with the radius rho, the
height w along the disc's axis and the normal (s, c) along both lies on the envelope at the turn v of the
disc where x n_y - y n_x + p n_z = 0 (F. L. Litvin and A. Fuentes, Gear Geometry and Applied Theory, 2004,
chapter 19), here

    s [(r + R) cos(gamma) + p sin(gamma)] sin(v) + sin(gamma) (rho c - w s) cos(v) = sin(gamma) R c,   (1)

of which the root near zero is closed form. Where the radius of this envelope over the way along the profile
is smallest it has an edge of regression, as an involute helicoid has at its base cylinder; deeper the disc
undercuts the thread. Lengths in m, angles in rad.
"""

from dataclasses import dataclass
from functools import cached_property
from math import cos, inf, pi, sin

import numpy as np
import scipy

from pyworm.drives.worm.flanks.screw_generator import Array, Components, ScrewGenerator
from pyworm.kernel.flank_height import SweptCurve

NODES = 33
"""Number of Chebyshev nodes over the radius through which the axial profile is found."""

ROUNDING = 1e-13
"""Chebyshev coefficient that is left out, over half the range of radii."""

MOST_STEPS = 40

SAMPLES = 256
"""Number of places along the disc's profile, over the range of radii, by which its envelope is followed."""

EDGE_SEEN = 0.25
"""Depth below the inner radius to which an edge of regression bends the profile, over the range of radii."""

OFF_EDGE = 1e-4
"""Distance from the edge of regression at which the flank begins, where it has a normal, likewise."""


@dataclass(frozen=True)
class Disc:
    """A grinding disc and its place about a worm."""

    radius: float
    """Radius of the disc where it touches the worm's reference cylinder [m]."""
    width: float
    """Width of the disc there, the normal width of the worm's space [m]."""
    pressure_angle: float
    """Angle of its profile there."""
    arc_radius: float = inf
    """Radius of its profile [m], convex; infinite of a cone."""

    def profile(self, along: Array) -> tuple[Array, Array, Array, Array]:
        """Radius less the disc's [m], height [m], and normal (s, c), at a way along the profile [m]."""
        direction = sin(self.pressure_angle), cos(self.pressure_angle)
        if self.arc_radius == inf:
            out, high = along * direction[1], -along * direction[0]
            return out, self.width / 2 + high, direction[0] + 0 * along, direction[1] + 0 * along
        turn = along / self.arc_radius
        half = np.sin(turn / 2)
        chord, sag = self.arc_radius * np.sin(turn), 2 * self.arc_radius * half * half
        s = direction[0] * np.cos(turn) + direction[1] * np.sin(turn)
        c = direction[1] * np.cos(turn) - direction[0] * np.sin(turn)
        out, high = (
            chord * direction[1] - sag * direction[0],
            -chord * direction[0] - sag * direction[1],
        )
        return out, self.width / 2 + high, s, c


@dataclass(frozen=True)
class DiscHelicoid(ScrewGenerator):
    """The right-hand helicoid that a disc grinds, swept by its axial profile.

    Its parameter u is the radius; where an edge of regression ends the profile at a radius r_0, near which it
    bends as (r - r_0)^(3/2), it is that of r = r_0 + u^2 / (end_radius - r_0), of which it is smooth.

    ValueError if the disc leaves no profile from the reference radius to the end.
    """

    disc: Disc
    """The disc."""
    reference: float
    """Radius of the worm's reference cylinder [m]."""
    screw: float
    """Advance per radian, lead / 2 pi [m]."""
    inner_radius: float
    """Radius from which the profile is found [m], from its edge on where that lies between both."""
    end_radius: float
    """Radius up to which the profile is found [m]."""

    def __post_init__(self) -> None:
        self._coefficients  # noqa: B018  a disc that leaves no flank is refused here

    @cached_property
    def start_radius(self) -> float:
        """Radius at which the profile begins [m]: at its edge, or within."""
        edge = -inf if self.edge is None else self.edge
        return max(self.inner_radius, edge + OFF_EDGE * (self.end_radius - self.inner_radius))

    @property
    def undercut(self) -> bool:
        """Whether the profile ends at an edge above the inner radius."""
        return self.start_radius > self.inner_radius

    @cached_property
    def bounds(self) -> tuple[float, float]:
        """Parameters between which the profile is found [m]."""
        low, high = self.at_radius(np.array([self.start_radius, self.end_radius]))
        return float(low), float(high)

    def ground(self, along: Array) -> tuple[Components, Components]:
        """Point of the envelope [m] and its unit normal, at a way along the disc's profile [m]."""
        disc = self.disc
        lead_angle = np.arctan2(self.screw, self.reference)
        upright, tilt = np.cos(lead_angle), np.sin(lead_angle)
        out, high, s, c = disc.profile(along)
        radius = disc.radius + out
        a = s * ((self.reference + disc.radius) * upright + self.screw * tilt)
        b = tilt * (radius * c - high * s)
        miss = tilt * (high * s - out * c)
        # d - b is `miss`: the root near zero of a sin v + b cos v = d in the form that keeps its digits
        v = 2 * np.arctan(miss / (a + np.sqrt(a * a + b * b - (b + miss) ** 2)))
        sine, half = np.sin(v), np.sin(v / 2)
        across = radius * sine
        point = (
            self.reference - out + 2 * radius * half * half,
            upright * across - tilt * high,
            tilt * across + upright * high,
        )
        normal = (-s * np.cos(v), s * upright * sine - c * tilt, s * tilt * sine + c * upright)
        return point, normal

    def _radius(self, along: Array) -> tuple[Array, Array]:
        """Radius of the envelope [m] and its slope [-], at a way along the disc's profile [m]."""
        (x, y, _), _ = self.ground(along + 1e-30j)
        radius = np.sqrt(x * x + y * y)
        return radius.real, radius.imag / 1e-30

    @cached_property
    def _followed(self) -> tuple[Array, Array, float | None]:
        """Ways along the disc's profile [m] from the worm's tip to its root, their radii [m], and the edge.

        The envelope is followed from the reference radius to both sides, as long as its radius falls with the
        way; the edge, beyond which it would rise again, is given by its way [m].

        ValueError if it does not reach the end.
        """
        span = self.end_radius - self.inner_radius
        distances = np.arange(0, 8 * SAMPLES) * span / SAMPLES
        lowest = self.inner_radius - EDGE_SEEN * span
        sides = []
        for along in (-distances, distances):
            with np.errstate(invalid="ignore"):
                (x, y, _), _ = self.ground(along)
            exists = np.isfinite(x * x + y * y)
            count = len(distances) if exists.all() else int(np.argmin(exists))
            radius, slope = self._radius(along[:count])
            falls = slope < 0
            sides.append((along, radius, count if falls.all() else int(np.argmin(falls))))
        (out, high, outer), (inwards, low, inner) = sides
        if outer == 0 or high[:outer].max() < self.end_radius:
            raise self._no_flank
        deep = int(np.argmax(low[:inner] < lowest)) if low[:inner].min() < lowest else inner
        edge = None
        if deep == inner:  # it turns before the lowest radius is reached
            if inner >= len(low):
                raise self._no_flank
            edge = float(
                scipy.optimize.brentq(
                    lambda distance: float(self._radius(np.array([distance]))[1][0]),
                    inwards[inner - 1],
                    inwards[inner],
                    xtol=1e-15,
                )
            )
        ways = np.append(out[1:outer][::-1], inwards[: deep + (edge is None)])
        radii = np.append(high[1:outer][::-1], low[: deep + (edge is None)])
        return ways, radii, edge

    @cached_property
    def edge(self) -> float | None:
        """Radius of the edge of regression [m]; None where it is too far below the inner radius to matter."""
        distance = self._followed[2]
        return None if distance is None else float(self._radius(np.array([distance]))[0][0])

    @property
    def _no_flank(self) -> ValueError:
        return ValueError(
            f"a disc of {2e3 * self.disc.radius:.4g} mm leaves no flank from "
            f"{2e3 * self.reference:.4g} to {2e3 * self.end_radius:.4g} mm of the worm's diameter"
        )

    @cached_property
    def _coefficients(self) -> Array:
        """Axial profile in powers of the parameter from -1 to 1 over its range, the highest first."""
        node = np.cos(pi * (np.arange(NODES) + 0.5) / NODES)
        target = self._at(self._middle + self._half * node)[0]
        ways, radii, edge = self._followed
        along = np.interp(target, radii[::-1], ways[::-1])
        last = np.inf if edge is None else edge
        for _ in range(MOST_STEPS):
            radius, slope = self._radius(along)
            step = (radius - target) / slope
            along = np.minimum(along - step, (along + last) / 2)
            if np.abs(step).max() < 1e-15:
                break
        (x, y, z), _ = self.ground(along)
        height = z - self.screw * np.arctan2(y, x)
        return _as_powers(node, height, ROUNDING * self._half)

    @property
    def _middle(self) -> float:
        return (self.bounds[0] + self.bounds[1]) / 2

    @property
    def _half(self) -> float:
        return (self.bounds[1] - self.bounds[0]) / 2

    def _at(self, u: Array | float) -> tuple[Array | float, Array | float, float]:
        """Radius at a parameter [m], and its first [-] and second [1/m] derivatives."""
        if self.edge is None:
            return u, 1.0, 0.0
        over = self.end_radius - self.edge
        return self.edge + u * u / over, 2 * u / over, 2 / over

    def curve(self, u: Array | float) -> tuple[Components, Components, Components]:
        """The axial profile over its parameter, and its derivatives."""
        scaled = (u - self._middle) / self._half
        height, slope, bend = 0 * scaled, 0 * scaled, 0 * scaled
        for coefficient in self._coefficients:
            bend = bend * scaled + slope
            slope = slope * scaled + height
            height = height * scaled + coefficient
        radius, by_u, bent = self._at(u)
        return (
            (radius, 0.0, height),
            (by_u, 0.0, slope / self._half),
            (bent, 0.0, 2 * bend / self._half**2),
        )

    @property
    def swept(self) -> SweptCurve:
        """The axial profile over its parameter."""
        powers = max(len(self._coefficients), 3)
        coefficients = np.zeros((3, powers))
        coefficients[2, powers - len(self._coefficients) :] = self._coefficients
        middle, half = self._middle, self._half
        radius, by_u, bent = self._at(middle)
        coefficients[0, -3:] = bent * half**2 / 2, by_u * half, radius
        return SweptCurve(coefficients, middle, half)

    def at_radius(self, radius: Array | float) -> Array:
        """Parameter at a radius [m]; at the edge below it."""
        if self.edge is None:
            return np.asarray(radius)
        over = self.end_radius - self.edge
        return np.sqrt(np.maximum(np.asarray(radius) - self.edge, 0.0) * over)


def _as_powers(node: Array, height: Array, rounding: float) -> Array:
    """Coefficients of powers, the highest first, of the polynomial through Chebyshev nodes."""
    series = np.polynomial.chebyshev.chebfit(node, height, node.size - 1)
    kept = int(np.flatnonzero(np.abs(series) > rounding).max()) + 1
    return np.polynomial.chebyshev.cheb2poly(series[:kept])[::-1].copy()
