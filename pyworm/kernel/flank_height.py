"""Heights of flanks of worms and their wheels over a tangent plane (`fortran/flanks/flank_height.f90`)."""

from dataclasses import dataclass
from enum import IntEnum
from typing import Any

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.kernel import core
from pyworm.kernel.core import fortran_array

MOST_PARAMETERS = 3
"""Largest number of parameters of a flank."""

FORM_NUMBERS = 9
"""Numbers that form a flank."""


class FlankKind(IntEnum):
    """What a flank is to the kernel."""

    WORM_PLANES = 1
    WHEEL_PLANES = 2
    WORM_POINTS = 3
    WHEEL_POINTS = 4


@dataclass(frozen=True)
class SweptCurve:
    """A curve that sweeps a helicoid: polynomials of s = (u - middle) / half, u its parameter [m]."""

    coefficients: Array
    """Coefficients of the powers of s along x, y and z, the highest first, (3, powers) [m]."""
    middle: float = 0.0
    """Middle of the parameter's range [m]."""
    half: float = 1.0
    """Half of that range [m]."""
    arc: float = 0.0
    """Radius of an arc z = sqrt(arc^2 - (top - u)^2) in place of the polynomial along z [m], or 0."""
    top: float = 0.0
    """Radius of the arc's centre [m]."""


NO_CURVE = SweptCurve(np.zeros((3, 1)))
"""Of involute helicoids."""


@dataclass(frozen=True)
class FlankNumbers:
    """A flank at an instant, by its numbers."""

    kind: FlankKind
    """Its kind."""
    parameters: int
    """Number of its parameters q."""
    seat: tuple[float, float, float, float]
    """Centre distance and axial shift of the screw [m], its swivel and the body's rotation angle [rad]."""
    form: tuple[float, ...]
    """Of planes the base lead angle [rad], base travel and lever [m]; of points the advance per radian, the
    length for which u stands [m], and the ratio threads / teeth."""
    curve: SweptCurve = NO_CURVE
    """Of points the curve that sweeps the worm, or the hob."""
    bounds: tuple[float, float] = (0.0, 0.0)
    """Of points the values of u between which the flank exists."""


@dataclass(frozen=True)
class FlankExpansion:
    """A flank at points of the tangent plane, (points,) along the last axis."""

    height: Array
    """Height [m]."""
    slopes: Array
    """Slopes along x and y, (2, points)."""
    bend: Array
    """Second derivatives [1/m], (2, 2, points)."""
    rates: Array
    """Changes of q along x and y [1/m], (q, 2, points)."""


@dataclass(frozen=True)
class FlankOverPlane:
    """A flank over a tangent plane."""

    numbers: FlankNumbers
    """The flank."""
    axes: Array
    """Rows ex, ey, ez of the contact frame, (3, 3)."""
    origin: Array
    """The contact point, (3,) [m]."""
    start: tuple[float, ...]
    """Parameters q of the flank there."""

    def heights(self, x: Array, y: Array, guess: Array) -> tuple[Array, Array, Array]:
        """Height [m] and q (q, points) at points (x, y) [m] by Newton's method from guesses of q.

        Last the margin to the flank's end. NaN where nothing is found.
        """
        if not x.size:  # of which f2py makes nothing
            return x, guess, x
        q, height, left = core.bindings.flank_heights(*self._given, x, y, _three(guess))
        return height, q[: self.numbers.parameters], left

    def expansions(self, x: Array, y: Array, q: Array) -> FlankExpansion:
        """Height, slopes and curvatures at points (x, y) [m] at which q is known."""
        if not x.size:
            slopes, bend, rates = (np.zeros((*shape, 0)) for shape in ((2,), (2, 2), (len(q), 2)))
            return FlankExpansion(x, slopes, bend, rates)
        height, slopes, bend, rates = core.bindings.flank_expansions(*self._given, x, y, _three(q))
        return FlankExpansion(height, slopes, bend, rates[: self.numbers.parameters])

    def ends(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Fraction of the ray to each point (x, y) [m] that lies on the flank, and q there."""
        reach, q = core.bindings.flank_ends(*self._given, x, y)
        return reach, q[: self.numbers.parameters]

    @property
    def _given(self) -> tuple[Any, ...]:
        numbers, curve = self.numbers, self.numbers.curve
        form = np.zeros(FORM_NUMBERS)
        form[: len(numbers.form)] = numbers.form
        form[3:] = curve.middle, curve.half, curve.arc, curve.top, *numbers.bounds
        return (
            int(numbers.kind),
            numbers.seat,
            form,
            fortran_array(curve.coefficients),
            fortran_array(np.vstack([self.axes, self.origin]).T),
            _three(np.array(self.start)),
        )


def _three(q: Array) -> Array:
    """Parameters with those that the flank does not have, zero."""
    padded = np.zeros((MOST_PARAMETERS, *q.shape[1:]))
    padded[: len(q)] = q
    return fortran_array(padded)
