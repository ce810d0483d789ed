"""A line contact: all that its solver may know of it.

The contact is the same all along the line. x runs across the line with its origin at the contact point;
velocities are those of the surfaces along x, relative to the (moving) contact point.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf

import numpy as np

from pyworm.materials.body import Body, composite_roughness, reduced_modulus
from pyworm.materials.oil import Oil
from pyworm.scene.past import Past
from pyworm.scene.point import require_radii, require_simulated

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
    name : str
        What tables and pictures call it.
    gap : LineGap
        Undeformed gap and where both surfaces exist.
    radius : float
        Relative radius of curvature at the contact point [m]: the scale of the contact, and the gap beyond
        the grid.
    velocities : tuple of float
        Velocity of body 1 and of body 2 [m/s].
    load : float
        Normal load for each length [N/m].
    bodies : tuple of Body
        Body 1 and body 2.
    oil : Oil
        The oil at its inlet temperature.
    phase : float or None
        Place in the mesh cycle, 0 to 1; None outside a drive.
    slide_roll_ratio : float or None
        Place on a traction curve: sliding over entrainment [-]; None outside one.
    section, station : str or None, float or None
        Section of a worm that has two, and place along the contact line, 0 to 1; None elsewhere.
    past : Past or None
        What the contact was earlier, as the drive turns; None where nothing changes.
    rigid : bool
        Whether the bodies keep their shape under the film.

    Raises
    ------
    ValueError
        A radius that is not that of a gap that knows its own, or an oil or a body of a class that the kernel
        does not know.
    """

    name: str
    gap: LineGap
    radius: float
    velocities: tuple[float, float]
    load: float
    bodies: tuple[Body, Body]
    oil: Oil
    phase: float | None = None
    slide_roll_ratio: float | None = None
    section: str | None = None
    station: float | None = None
    past: "Past[LineScene] | None" = None
    rigid: bool = False

    def __post_init__(self) -> None:
        """Refuse what would be solved as something else."""
        require_simulated(self.oil, self.bodies)
        require_radii((self.radius,), (getattr(self.gap, "radius", self.radius),))

    @property
    def bending_modulus(self) -> float:
        """Reduced modulus by which the bodies bend under the film [Pa]; infinite of rigid ones."""
        return inf if self.rigid else self.reduced_modulus

    @property
    def reduced_modulus(self) -> float:
        """Reduced modulus E' of the two bodies [Pa]."""
        return reduced_modulus(*self.bodies)

    @property
    def composite_roughness(self) -> float | None:
        """Root mean square height of both surfaces together [m]; None if it is not known."""
        return composite_roughness(*self.bodies)

    @property
    def entrainment(self) -> float:
        """Mean surface velocity [m/s]."""
        return sum(self.velocities) / 2

    @property
    def sliding(self) -> float:
        """Velocity of body 1 relative to body 2 [m/s]."""
        return self.velocities[0] - self.velocities[1]
