"""The contacts of the atlas: a sequence of similarity groups that fills its box, and one realisation of each.

Any first part of the sequence fills the box evenly (scrambled Sobol numbers), and in `order` more
densely where the film turns, so that an atlas may be made in parts and continued.
"""

from dataclasses import dataclass
from functools import cache
from math import cos, exp, log, radians, sin

from scipy.stats import qmc

from pyworm.formulas.film import PointGroups, nijenbanning_venner_moes, radii_at_angle
from pyworm.formulas.hertz import hertz
from pyworm.formulas.oil_properties import ROELANDS_POLE_LOG
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil
from pyworm.materials.viscosity_density import ROELANDS_PRESSURE, Barus, Density, Roelands
from pyworm.scene.point import Paraboloid, RigidMotion, Scene

SEED = 28
"""Of the scrambling; the atlas is these contacts and no others."""

DRAWN = 2**13
"""Numbers drawn, of which those within `LARGEST_PRESSURE` and `THICKEST` are contacts."""

MOES_M, MOES_L = (1.0, 3000.0), (0.3, 25.0)
"""Load and lubricant parameter, by the radius along the entrainment, drawn evenly in the logarithm."""

RATIO = (1.0, 30.0)
"""Larger over smaller relative radius, evenly in the logarithm; with the angle all ratios from 1/30 to 30."""

ALIGNED = 0.25
"""Share of the contacts entrained along a principal axis, half of them along each."""

SPIN, STRAIGHT = 0.2, 0.6
"""Largest spin, mean angular velocity times long semi-axis over entrainment speed, and the share without."""

VISCOSITY, Z = (0.006, 0.6), (0.4, 0.75)
"""Viscosity [Pa s] and exponent of Roelands' law, from thin mineral oils to thick traction fluids: together
they give alpha, from 9 to 34 /GPa."""

WORM_RATIO, WORM_Z = (1.0, 60.0), (0.2, 0.4)
"""Ratio of radii and exponent of a second sequence: worm contacts, and polyglycols, whose viscosity rises
less with pressure; its alpha is 5 to 19 /GPa."""

BARUS, INCOMPRESSIBLE = 0.2, 0.25
"""Shares of the oils with Barus' law and without compressibility, independently."""

LARGEST_PRESSURE = 50.0
"""alpha times the Hertz pressure, at most: 2.5 GPa at 20 /GPa."""

THICKEST = 3.0
"""Film by Nijenbanning, Venner and Moes over the Hertz approach, at most: beyond it bodies hardly deform, the
film depends on surfaces far from the contact, and the limits of rigid bodies hold."""

RADIUS, POISSON, DENSITY = 0.01, 0.3, 850.0
"""Realisation: smaller radius [m], Poisson's ratio, density [kg/m3]; the film in Moes' groups does not depend
on them."""


@dataclass(frozen=True)
class Groups:
    """Similarity groups of a contact."""

    moes_m: float
    """Moes' M by the radius along the entrainment."""
    moes_l: float
    """Moes' L by the radius along the entrainment."""
    ratio: float
    """Larger relative radius over the smaller one [-]."""
    angle: float
    """Angle of the entrainment from the direction of the smaller radius, 0 to 90 [deg]: at 0 the long axis of
    the contact lies across the entrainment."""
    spin: float
    """Mean angular velocity, positive from the smaller to the larger radius, times Hertz's long semi-axis
    over the entrainment speed [-]."""
    viscosity: float
    """Viscosity of Roelands' law [Pa s]."""
    z: float
    """Exponent of Roelands' law [-]."""
    barus: bool
    """Whether the viscosity follows Barus' law with the same alpha instead."""
    compressible: bool
    """Whether the oil has Dowson and Higginson's density."""

    @property
    def alpha(self) -> float:
        """Pressure-viscosity coefficient [1/Pa]."""
        return self.z * (log(self.viscosity) + ROELANDS_POLE_LOG) / ROELANDS_PRESSURE

    @property
    def material(self) -> float:
        """G of the realisation: speeds are moderate at both ends of L."""
        return 4500 * (self.moes_l / 10) ** 0.5

    @property
    def reduced_modulus(self) -> float:
        """E' of the realisation [Pa]."""
        return self.material / self.alpha

    @property
    def speed(self) -> float:
        """U of the realisation [-]."""
        return (self.moes_l / self.material) ** 4 / 2

    @property
    def radii(self) -> tuple[float, float]:
        """Relative radii of the realisation, the smaller first [m]."""
        return RADIUS, RADIUS * self.ratio

    @property
    def along(self) -> float:
        """Radius along the entrainment [m]."""
        return radii_at_angle(*self.radii, radians(self.angle))[0]

    @property
    def load(self) -> float:
        """Load of the realisation [N]."""
        return self.moes_m * (2 * self.speed) ** 0.75 * self.reduced_modulus * self.along**2

    @property
    def pressure(self) -> float:
        """alpha times the Hertz pressure [-]."""
        return self.alpha * hertz(*self.radii, self.load, self.reduced_modulus).pressure_max

    @property
    def thickness(self) -> float:
        """Expected film over the Hertz approach [-]."""
        approach = hertz(*self.radii, self.load, self.reduced_modulus).approach
        across = radii_at_angle(*self.radii, radians(self.angle))[1]
        load = self.moes_m * (2 * self.speed) ** 0.75
        groups = PointGroups(self.along, self.along / across, self.speed, load, self.material)
        return nijenbanning_venner_moes(groups).central / approach

    @property
    def inside(self) -> bool:
        """Whether the contact is in the box of the atlas."""
        return self.pressure <= LARGEST_PRESSURE and self.thickness <= THICKEST


@cache
def sequence() -> dict[int, Groups]:
    """The groups of all contacts by their numbers."""
    first, second = (qmc.Sobol(9, seed=seed).random(DRAWN).tolist() for seed in (SEED, SEED + 1))
    drawn = [_groups(RATIO, Z, *row) for row in first]
    drawn += [_groups(WORM_RATIO, WORM_Z, *row) for row in second]
    return {number: one for number, one in enumerate(drawn) if one.inside}


def order() -> list[int]:
    """Numbers of the contacts in the order in which they are solved.

    After each contact of the first sequence comes the next one from where the film turns most with the groups
    (`turning`), so that these are twice to three times as dense, and after every other one the next of the
    second sequence.
    """
    first = [number for number in sequence() if number < DRAWN]
    dense = iter([number for number in first if turning(sequence()[number])])
    worms = iter([number for number in sequence() if number >= DRAWN])
    found: dict[int, None] = {}
    for place, number in enumerate(first):
        found.setdefault(number)
        following = next((one for one in dense if one not in found), None)
        if following is not None:
            found.setdefault(following)
        if place % 2:
            found.setdefault(next(worms, number))
    return list(found)


def turning(of: Groups) -> bool:
    """Whether small changes of the groups change the film much: light loads, slender and askew or along."""
    return of.moes_m < 10 or (of.ratio > 3 and of.angle > 60)


def _groups(ratios, exponents, m, el, ratio, angle, spin, viscosity, z, barus, density) -> Groups:
    """Groups from two ranges and nine numbers between 0 and 1."""
    turning = 2 * spin - 1
    beyond = max(abs(turning) - STRAIGHT, 0.0) / (1 - STRAIGHT)
    between = (angle - ALIGNED / 2) / (1 - ALIGNED)
    return Groups(
        moes_m=logarithmic(MOES_M, m),
        moes_l=logarithmic(MOES_L, el),
        ratio=logarithmic(ratios, ratio),
        angle=90 * min(max(between, 0.0), 1.0),
        spin=SPIN * (beyond if turning > 0 else -beyond),
        viscosity=logarithmic(VISCOSITY, viscosity),
        z=exponents[0] + (exponents[1] - exponents[0]) * z,
        barus=barus < BARUS,
        compressible=density >= INCOMPRESSIBLE,
    )


def logarithmic(bounds: tuple[float, float], at: float) -> float:
    """A value between two bounds, evenly in its logarithm, from a number between 0 and 1."""
    return exp(log(bounds[0]) + log(bounds[1] / bounds[0]) * at)


def contact(number: int) -> Scene:
    """A contact of the atlas as a scene of pure rolling."""
    of = sequence()[number]
    law = Roelands(of.viscosity, of.z)
    speed = of.speed * of.reduced_modulus * of.along / law.eta0
    dry = hertz(*of.radii, of.load, of.reduced_modulus)
    turning = of.spin * speed / max(dry.semi_axis_x, dry.semi_axis_y)
    angle = radians(of.angle)
    motion = RigidMotion(speed * cos(angle), speed * sin(angle), turning)
    body = Body(of.reduced_modulus * (1 - POISSON**2), POISSON)
    density = Density.dowson_higginson if of.compressible else Density.incompressible
    viscosity = Barus(law.eta0, of.alpha) if of.barus else law
    return Scene(
        name=f"contact {number}",
        gap=Paraboloid(*of.radii),
        radii=of.radii,
        motions=(motion, motion),
        load=of.load,
        bodies=(body, body),
        oil=Oil(viscosity, density(DENSITY)),
    )
