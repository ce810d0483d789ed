"""A steady line contact: all that its solver may know of it, and the size of things in it."""

from collections.abc import Callable
from dataclasses import dataclass
from math import hypot, log, sqrt

import numpy as np

from pyworm.formulas.film import LineGroups, line_groups, moes_line
from pyworm.formulas.hertz import HertzLine, hertz_line
from pyworm.oils import Oil

Array = np.ndarray
LineGap = Callable[[Array], tuple[Array, Array]]
"""x [m] -> undeformed gap [m] and a boolean, true where both surfaces exist. The gap is finite everywhere."""


@dataclass(frozen=True)
class Parabola:
    """The gap x^2 / 2R without edges.

    Attributes
    ----------
    radius : float
        Relative radius of curvature [m].
    """

    radius: float

    def __call__(self, x: Array) -> tuple[Array, Array]:
        """Gap [m] and where both surfaces exist (everywhere)."""
        return x**2 / (2 * self.radius), np.ones(x.shape, dtype=bool)


@dataclass(frozen=True)
class LineScene:
    """One lubricated line contact.

    Attributes
    ----------
    gap : LineGap
        Undeformed gap and where both surfaces exist; the contact point is x = 0.
    radius : float
        Relative radius of curvature there [m]: the scale of the contact, and the gap beyond the grid.
    speed : float
        Mean surface velocity relative to the contact point [m/s], positive along x.
    load : float
        Load for each length [N/m].
    reduced_modulus : float
        E' [Pa] with 2/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
    oil : Oil
        The oil at its inlet temperature.
    """

    gap: LineGap
    radius: float
    speed: float
    load: float
    reduced_modulus: float
    oil: Oil

    @property
    def groups(self) -> LineGroups:
        """Dimensionless groups."""
        viscosity = self.oil.viscosity
        return line_groups(
            self.radius,
            self.load,
            self.reduced_modulus,
            abs(self.speed),
            viscosity.eta0,
            viscosity.alpha,
        )

    @property
    def dry(self) -> HertzLine:
        """The dry contact."""
        return hertz_line(self.radius, self.load, self.reduced_modulus)

    @property
    def film(self) -> float:
        """Film where the pressure is largest by Moes [m]."""
        return float(moes_line(self.groups).central)

    def distance_of(self, height: float) -> float:
        """Distance [m] from the contact point at which Hertz's gap has a given height [m].

        Outside the contact the gap is b^2/2R {X (X^2 - 1)^(1/2) - ln[X + (X^2 - 1)^(1/2)]}, X = x/b (Johnson,
        Contact Mechanics, section 4.2).
        """
        b = self.dry.half_width
        near, far = b, 2 * hypot(b, sqrt(2 * self.radius * height))
        for _ in range(60):
            middle = (near + far) / 2
            ratio = middle / b
            root = sqrt(ratio**2 - 1)
            gap = b**2 / (2 * self.radius) * (ratio * root - log(ratio + root))
            near, far = (middle, far) if gap < height else (near, middle)
        return far
