"""Hertz's dry contacts in closed form: elliptic (hence circular) and line.

No curve fits: the ellipticity is solved from the exact ratio of elliptic integrals, to rounding.
"""

from dataclasses import dataclass
from math import exp, inf, log, pi, sqrt

import numpy as np
import numpy.typing as npt

from pyworm.formulas.arrays import Alike, Values


@dataclass(frozen=True)
class HertzContact:
    """An elliptic contact of two smooth elastic bodies without friction."""

    semi_axis_x: float
    """Semi-axis of the ellipse along x [m]."""
    semi_axis_y: float
    """Semi-axis of the ellipse along y [m]."""
    pressure_max: float
    """Pressure at the centre [Pa]."""
    approach: float
    """Rigid approach of points far from the contact [m]."""

    @property
    def ellipticity(self) -> float:
        """Semi-axis along y over semi-axis along x [-]."""
        return self.semi_axis_y / self.semi_axis_x

    def pressure(self, x: Alike, y: Alike) -> Alike:
        """Pressure [Pa] at (x, y) [m], numbers or arrays; zero outside the ellipse."""
        inside = 1 - (x / self.semi_axis_x) ** 2 - (y / self.semi_axis_y) ** 2
        pressure: Alike = self.pressure_max * np.sqrt(np.maximum(inside, 0.0))
        return pressure


@dataclass(frozen=True)
class HertzLine:
    """A line contact of two parallel cylinders.

    The rigid approach is not given: per unit length it depends on the shape of the whole bodies.
    """

    half_width: float
    """Half of the width of the contact [m]."""
    pressure_max: float
    """Pressure on the centre line [Pa]."""

    def pressure(self, x: Alike) -> Alike:
        """Pressure [Pa] at a distance x [m] from the centre line, a number or an array."""
        inside = 1 - (x / self.half_width) ** 2
        pressure: Alike = self.pressure_max * np.sqrt(np.maximum(inside, 0.0))
        return pressure


def hertz(radius_x: float, radius_y: float, load: float, reduced_modulus: float) -> HertzContact:
    """Elliptic contact of an undeformed gap x^2 / 2 Rx + y^2 / 2 Ry under a load F [N].

    With a >= b the semi-axes, m = 1 - (b/a)^2 and the complete elliptic integrals K(m), D(m) = (K - E) / m
    and B(m) = K - D, all of them regular at m = 0:

        R_long / R_short = (a/b)^2 B / D,   a^3 = 6 F R_long D / (pi E'),
        p_max = 3 F / (2 pi a b),           approach = 2 p_max b K / E'.

    Radii and load are positive; 2/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [Pa]. Source: K. L. Johnson, Contact
    Mechanics (1985), equations 4.24 to 4.26, whose E* is E'/2 and whose A and B are 1/2R. Valid while the
    contact is small against both radii.
    """
    _require_positive(radius_x=radius_x, radius_y=radius_y, load=load)
    _require_positive(reduced_modulus=reduced_modulus)
    radius_long, radius_short = max(radius_x, radius_y), min(radius_x, radius_y)
    axis_ratio = _axis_ratio(radius_long / radius_short)
    k, d = _elliptic_integrals(axis_ratio)
    long = (6 * load * radius_long * d / (pi * reduced_modulus)) ** (1 / 3)
    short = axis_ratio * long
    pressure_max = 3 * load / (2 * pi * long * short)
    along_x, along_y = (long, short) if radius_x >= radius_y else (short, long)
    return HertzContact(
        along_x, along_y, pressure_max, 2 * pressure_max * short * k / reduced_modulus
    )


def hertz_line(radius: float, load_per_length: float, reduced_modulus: float) -> HertzLine:
    """Line contact of an undeformed gap x^2 / 2 R under a load for each length of line [N/m].

    R is the relative radius of curvature across the line [m], E' [Pa] as of `hertz`. Source: K. L. Johnson,
    Contact Mechanics (1985), equations 4.43 and 4.45.
    """
    _require_positive(radius=radius, load_per_length=load_per_length)
    _require_positive(reduced_modulus=reduced_modulus)
    half_width = sqrt(8 * load_per_length * radius / (pi * reduced_modulus))
    return HertzLine(half_width, 2 * load_per_length / (pi * half_width))


def ellipticity(radius_ratio: npt.ArrayLike) -> Values:
    """Semi-axis along over semi-axis across, of the radius along over the radius across [-], positive."""
    found: Values = np.vectorize(_ellipticity, otypes=[float])(radius_ratio)[()]
    return found


def _ellipticity(radius_ratio: float) -> float:
    _require_positive(radius_ratio=radius_ratio)
    if radius_ratio < 1:
        return _axis_ratio(1 / radius_ratio)
    return 1 / _axis_ratio(radius_ratio)


def _axis_ratio(radius_ratio: float) -> float:
    """Short over long semi-axis for a ratio (>= 1) of the long to the short radius.

    It is the fixed point of (b/a)^2 = B / (D R_long / R_short); a step leaves a quarter of the error at most.
    """
    axis_ratio, step = 1.0, inf
    while abs(step) > ELLIPTICITY_TOLERANCE:
        k, d = _elliptic_integrals(axis_ratio)
        step = log((k - d) / d / radius_ratio) / 2 - log(axis_ratio)
        axis_ratio *= exp(step)
    return axis_ratio


ELLIPTICITY_TOLERANCE = 1e-14
"""Relative change of the ratio of the semi-axes at which it is found."""


def _elliptic_integrals(axis_ratio: float) -> tuple[float, float]:
    """K(m) and D(m) = (K - E) / m of m = 1 - axis_ratio^2, by the arithmetic-geometric mean.

    Source: M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions (1964), section 17.6; every c^2 is
    divided by m, so that nothing cancels where the contact is circular.
    """
    mean, root, c = (1 + axis_ratio) / 2, sqrt(axis_ratio), (1 - axis_ratio) / 2
    share = c / (2 * (1 + axis_ratio))
    total, weight = 0.5 + share, 1.0
    while c > 1e-9:  # the next one is less than its square
        mean, root, following = (mean + root) / 2, sqrt(mean * root), (mean - root) / 2
        share *= (following / c) ** 2
        c, weight = following, 2 * weight
        total += weight * share
    k = pi / (2 * mean)
    return k, k * total


def _require_positive(**values: float) -> None:
    for name, value in values.items():
        if not 0 < value < inf:
            raise ValueError(f"{name} is {value}; it must be positive and finite")
