"""Helicoids that a disc grinds, the flanks of ZK and ZC worms: the envelope of its surface in a screw motion.

The disc's axis crosses the worm's at the distance r + R of their reference radii and is inclined to the
transverse plane by the lead angle gamma there. Its profile is a straight line (ZK, a cone) or a convex arc
(ZC, type C of ISO 1122-2, which makes a concave thread). A point of the disc with the radius rho, the
height w along the disc's axis and the normal (s, c) along both lies on the envelope at the turn v of the
disc where x n_y - y n_x + p n_z = 0 (F. L. Litvin and A. Fuentes, Gear Geometry and Applied Theory, 2004,
chapter 19), here

    s [(r + R) cos(gamma) + p sin(gamma)] sin(v) + sin(gamma) (rho c - w s) cos(v) = sin(gamma) R c,   (1)

of which the root near zero is closed form. Lengths in m, angles in rad.
"""

from dataclasses import dataclass
from functools import cached_property
from math import cos, inf, pi, sin

import numpy as np

from pyworm.formulas.screw_generator import Array, Components, ScrewGenerator

NODES = 33
"""Number of Chebyshev nodes over the radius through which the axial profile is found."""

ROUNDING = 1e-13
"""Chebyshev coefficient that is left out, over half the range of radii."""

MOST_STEPS = 40


@dataclass(frozen=True)
class Disc:
    """A grinding disc and its place about a worm.

    Attributes
    ----------
    radius : float
        Radius of the disc where it touches the worm's reference cylinder [m].
    width : float
        Width of the disc there, the normal width of the worm's space [m].
    pressure_angle : float
        Angle of its profile there.
    arc_radius : float
        Radius of its profile [m], convex; infinite of a cone.
    """

    radius: float
    width: float
    pressure_angle: float
    arc_radius: float = inf

    def profile(self, along: Array) -> tuple[Array, Array, Array, Array]:
        """Radius less the disc's [m], height [m], and normal (s, c), at a way along the profile [m]."""
        at = sin(self.pressure_angle), cos(self.pressure_angle)
        if self.arc_radius == inf:
            out, high = along * at[1], -along * at[0]
            return out, self.width / 2 + high, at[0] + 0 * along, at[1] + 0 * along
        turn = along / self.arc_radius
        half = np.sin(turn / 2)
        chord, sag = self.arc_radius * np.sin(turn), 2 * self.arc_radius * half * half
        s = at[0] * np.cos(turn) + at[1] * np.sin(turn)
        c = at[1] * np.cos(turn) - at[0] * np.sin(turn)
        out, high = chord * at[1] - sag * at[0], -chord * at[0] - sag * at[1]
        return out, self.width / 2 + high, s, c


@dataclass(frozen=True)
class DiscHelicoid(ScrewGenerator):
    """The right-hand helicoid that a disc grinds, swept by its axial profile; its parameter is the radius.

    Attributes
    ----------
    disc : Disc
        The disc.
    reference : float
        Radius of the worm's reference cylinder [m].
    screw : float
        Advance per radian, lead / 2 pi [m].
    inner_radius, end_radius : float
        Radii between which the profile is found [m].

    Raises
    ------
    ValueError
        The disc leaves no profile there.
    """

    disc: Disc
    reference: float
    screw: float
    inner_radius: float
    end_radius: float

    def __post_init__(self) -> None:
        self._coefficients  # noqa: B018  a disc that undercuts is refused here

    @property
    def start_radius(self) -> float:
        """Radius at which the profile begins [m]."""
        return self.inner_radius

    @property
    def bounds(self) -> tuple[float, float]:
        """Radii between which the profile is found [m]."""
        return self.inner_radius, self.end_radius

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

    @cached_property
    def _coefficients(self) -> Array:
        """Axial profile in powers of the radius from -1 to 1 over its range, the highest first."""
        node = np.cos(pi * (np.arange(NODES) + 0.5) / NODES)
        target = self._middle + self._half * node
        along = (self.reference - target) / cos(self.disc.pressure_angle)
        for _ in range(MOST_STEPS):
            (x, y, z), _ = self.ground(along + 1e-30j)
            radius = np.sqrt(x * x + y * y)
            slope = radius.imag / 1e-30
            step = (radius.real - target) / slope
            along = along - step
            if not np.all(np.abs(step) < 1e-2 * self.reference + self._half) or slope.max() >= 0:
                break
            if np.abs(step).max() < 1e-15:
                height = (z - self.screw * np.arctan2(y.real, x.real)).real
                return _as_powers(node, height, ROUNDING * self._half)
        raise ValueError(
            f"a disc of {2e3 * self.disc.radius:.4g} mm leaves no flank from "
            f"{2e3 * self.inner_radius:.4g} to {2e3 * self.end_radius:.4g} mm of the worm's diameter"
        )

    @property
    def _middle(self) -> float:
        return (self.inner_radius + self.end_radius) / 2

    @property
    def _half(self) -> float:
        return (self.end_radius - self.inner_radius) / 2

    def curve(self, u: Array | float) -> tuple[Components, Components, Components]:
        """The axial profile over the radius, and its derivatives."""
        at = (u - self._middle) / self._half
        height, slope, bend = 0 * at, 0 * at, 0 * at
        for coefficient in self._coefficients:
            bend = bend * at + slope
            slope = slope * at + height
            height = height * at + coefficient
        return (
            (u, 0.0, height),
            (1.0, 0.0, slope / self._half),
            (0.0, 0.0, 2 * bend / self._half**2),
        )

    def at_radius(self, radius: Array | float) -> Array:
        """The radius itself [m]."""
        return np.asarray(radius)


def _as_powers(node: Array, height: Array, rounding: float) -> Array:
    """Coefficients of powers, the highest first, of the polynomial through Chebyshev nodes."""
    series = np.polynomial.chebyshev.chebfit(node, height, node.size - 1)
    kept = int(np.flatnonzero(np.abs(series) > rounding).max()) + 1
    return np.polynomial.chebyshev.cheb2poly(series[:kept])[::-1].copy()


def ground_by(
    disc: Disc, lead: float, reference: float, radii: tuple[float, float]
) -> DiscHelicoid:
    """The flank that a disc grinds on a worm with a reference radius [m], between two radii [m]."""
    return DiscHelicoid(disc, reference, lead / (2 * pi), *radii)
