"""Circular contacts of given Moes parameters."""

from math import cos, sin

from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import Density, Roelands
from pyworm.scene.point import Paraboloid, RigidMotion, Scene

STEEL = Body(205.66e9, 0.3)
"""Two of these give E' = 226 GPa."""

OIL = Oil(Roelands.from_alpha(0.04, 22e-9), Density.dowson_higginson_pole(870.0))
RADIUS = 0.01


def circular(m, lubricant, angle=0.0, spin=0.0, oil=OIL, gap=None):
    """A circular contact of given Moes parameters, entrained at an angle [rad] with a mean spin [rad/s]."""
    modulus = STEEL.youngs_modulus / (1 - STEEL.poisson_ratio**2)
    speed_group = (lubricant / (oil.viscosity.alpha * modulus)) ** 4 / 2
    speed = speed_group * modulus * RADIUS / oil.viscosity.eta0
    motion = RigidMotion(speed * cos(angle), speed * sin(angle), spin)
    return Scene(
        name=f"M = {m:g}, L = {lubricant:g}",
        gap=gap or Paraboloid(RADIUS, RADIUS),
        radii=(RADIUS, RADIUS),
        motions=(motion, motion),
        load=m * (2 * speed_group) ** 0.75 * modulus * RADIUS**2,
        bodies=(STEEL, STEEL),
        oil=oil,
    )
