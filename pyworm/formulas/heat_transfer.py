"""Coefficients of heat transfer at the surfaces of a gear unit, by published correlations.

Coefficients h are in W/(m2 K), related to the surface; `*_SPREAD` is the relative uncertainty (95 %) of a
correlation. Fluids have their properties at the mean of wall and fluid.
"""

from dataclasses import dataclass
from math import cbrt, pi, sqrt

from pyworm.formulas.ranges import positive, within

GRAVITY = 9.81
"""Acceleration of gravity [m/s2]."""

STEFAN_BOLTZMANN = 5.670374e-8
"""Stefan-Boltzmann constant [W/(m2 K4)]."""

CONVECTION_SPREAD = 0.25
"""Of Nusselt numbers in air (Incropera et al. 2011, section 7.1: errors of up to 25 %)."""

RADIATION_SPREAD = 0.1
"""Of radiation from paint, whose emissivity is 0.85 to 0.95."""

STIRRED_SPREAD = 1.0
"""Of oil on turning bodies and walls: a factor of two is assumed, since none was measured in gear units."""

OIL_ON_WALLS = 200.0
"""Coefficient of splashed oil on the walls of a housing [W/(m2 K)] (ISO/TR 14179-2, from memory)."""

SEAT = 2500.0
"""Contact conductance of fitted rings [W/(m2 K)]: the least of stainless steel at 10 MN/m2, which
resists with 0.7e-4 to 4e-4 m2 K/W (Incropera et al. 2011, table 3.1, from memory)."""

LAMINAR_PLATE = 5e5
"""Reynolds number to which the flow along a plate is laminar [-]."""

LAMINAR_FREE = 1e7
"""Rayleigh number to which free convection above a horizontal plate is laminar [-]."""


@dataclass(frozen=True)
class Fluid:
    """Properties of a fluid that carry heat from a wall."""

    conductivity: float
    """Thermal conductivity [W/(m K)]."""
    viscosity: float
    """Kinematic viscosity [m2/s]."""
    diffusivity: float
    """Thermal diffusivity [m2/s]."""
    expansion: float
    """Thermal expansivity [1/K]."""

    @property
    def prandtl(self) -> float:
        """Prandtl number [-]."""
        return self.viscosity / self.diffusivity

    def rayleigh(self, length: float, excess: float) -> float:
        """Rayleigh number of a wall some kelvin warmer or colder than the fluid [-]."""
        buoyancy = GRAVITY * self.expansion * abs(excess)
        return buoyancy * length**3 / (self.viscosity * self.diffusivity)


def air(temperature: float) -> Fluid:
    """Dry air at 1 bar as an ideal gas: Sutherland's laws (White, Viscous Fluid Flow), c_p 1007 J/(kg K)."""
    within("air temperature", temperature, 150, 900, "K")
    ratio = temperature / 273.15
    viscosity = 1.716e-5 * ratio**1.5 * (273.15 + 110.4) / (temperature + 110.4)
    conductivity = 0.0241 * ratio**1.5 * (273.15 + 194) / (temperature + 194)
    density = 1e5 / (287.05 * temperature)
    return Fluid(
        conductivity, viscosity / density, conductivity / (density * 1007), 1 / temperature
    )


def free_on_wall(fluid: Fluid, height: float, excess: float) -> float:
    """Free convection on a vertical wall, laminar and turbulent (Churchill and Chu 1975)."""
    positive("height", height, "m")
    slowed: float = (1 + (0.492 / fluid.prandtl) ** (9 / 16)) ** (8 / 27)
    nusselt: float = (0.825 + 0.387 * fluid.rayleigh(height, excess) ** (1 / 6) / slowed) ** 2
    return nusselt * fluid.conductivity / height


def free_on_top(fluid: Fluid, length: float, excess: float) -> float:
    """Free convection above a warm horizontal plate, 0.54 Ra^(1/4), then 0.15 Ra^(1/3) (McAdams 1954).

    The length is the plate's area over its circumference.
    """
    positive("length", length, "m")
    rayleigh = fluid.rayleigh(length, excess)
    rising: float = (
        0.54 * rayleigh**0.25 if rayleigh <= LAMINAR_FREE else 0.15 * rayleigh ** (1 / 3)
    )
    return rising * fluid.conductivity / length


def free_below(fluid: Fluid, length: float, excess: float) -> float:
    """Free convection below a warm horizontal plate, 0.27 Ra^(1/4) (McAdams 1954)."""
    positive("length", length, "m")
    sinking: float = 0.27 * fluid.rayleigh(length, excess) ** 0.25
    return sinking * fluid.conductivity / length


def forced_along(fluid: Fluid, length: float, velocity: float) -> float:
    """Flow along a plate: 0.664 Re^(1/2) Pr^(1/3), beyond Re 5e5 (0.037 Re^0.8 - 871) Pr^(1/3).

    Incropera et al. (2011), equations 7.30 and 7.38.
    """
    reynolds = abs(velocity) * length / fluid.viscosity
    moved: float = 0.664 * sqrt(reynolds)
    if reynolds > LAMINAR_PLATE:
        moved = 0.037 * reynolds**0.8 - 871
    nusselt = moved * cbrt(fluid.prandtl)
    return nusselt * fluid.conductivity / length


def mixed(free: float, forced: float) -> float:
    """Free and forced convection together, Nu^3 = Nu_F^3 + Nu_N^3 (Incropera et al. 2011, equation 9.64)."""
    return cbrt(free**3 + forced**3)


def radiation(emissivity: float, surface: float, surroundings: float) -> float:
    """Radiation of a convex grey surface into a room [W/(m2 K)]; temperatures in K."""
    within("emissivity", emissivity, 0, 1, "")
    return emissivity * STEFAN_BOLTZMANN * (surface**2 + surroundings**2) * (surface + surroundings)


def rotating_disc(fluid: Fluid, speed: float) -> float:
    """A disc that turns in a fluid of large Prandtl number, Nu_r = 0.62 Re_r^(1/2) Pr^(1/3) (Levich 1962).

    The same all over the disc; laminar up to Re_r of about 2e5, and beyond that less than there is.
    """
    return 0.62 * fluid.conductivity * sqrt(abs(speed) / fluid.viscosity) * cbrt(fluid.prandtl)


def rotating_shaft(fluid: Fluid, diameter: float, speed: float) -> float:
    """A shaft that turns, Nu_D = 0.133 Re_D^(2/3) Pr^(1/3), Re_D = w D^2/nu (Kreith)."""
    reynolds = abs(speed) * diameter**2 / fluid.viscosity
    nusselt = 0.133 * cbrt(reynolds) ** 2 * cbrt(fluid.prandtl)
    return nusselt * fluid.conductivity / diameter


def long_fin(coefficient: float, conductivity: float, diameter: float) -> float:
    """Conductance of a long round bar that sticks out into a fluid [W/K], (h P k A)^(1/2)."""
    return sqrt(coefficient * pi * diameter * conductivity * pi / 4 * diameter**2)


def spreading(conductivity: float, area: float) -> float:
    """Conductance from a footprint into a half-space [W/K], 2 k D of the disc of its area D^2 pi/4.

    Incropera et al. (2011), table 4.1, case 10.
    """
    return 2 * conductivity * sqrt(4 * area / pi)
