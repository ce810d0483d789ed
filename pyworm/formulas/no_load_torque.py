"""Torque that oil resists with: bearings by Palmgren, turning bodies in a bath by laminar and turbulent drag.

It falls as the oil warms, by the two-thirds power of the viscosity in bearings and by its root on bodies.
"""

from dataclasses import dataclass
from math import cbrt, pi, sqrt

from pyworm.formulas.ranges import positive, within
from pyworm.formulas.unit_factors import RPM, SQUARE_MILLIMETRE

Bearings = str

BATH_FACTORS = {"ball": 2.0, "angular ball": 3.3, "cylindrical": 3.0, "tapered": 4.0}
"""Kind of rolling bearings -> f_0 in an oil bath [-], double of it in pairs (Palmgren 1959; from memory)."""

SLOW_BEARING = 2000.0
"""nu n up to which the torque of a bearing no longer falls [mm2/s rpm] (Palmgren)."""

LAMINAR_DISC, TURBULENT_DISC, CREEPING_DISC = 3.87, 0.146, 64 / 3
"""Moment coefficients of both sides of a free disc [-], M/(rho w^2 R^5/2), times Re^-1/2 (von Karman 1921,
Cochran 1934), Re^-1/5 (von Karman) and 1/Re (Jeffery 1915, exact)."""

LAMINAR_PLATE = 1.328
"""Mean coefficient of friction of a laminar boundary layer times the root of its Reynolds number (Blasius).
"""


def bearing_torque(factor: float, diameter: float, viscosity: float, speed: float) -> float:
    """Torque of a rolling bearing without load M_0 [N m]; arguments in SI units.

    M_0 = 1e-7 f_0 (nu n)^(2/3) d_m^3 N mm, 160e-7 f_0 d_m^3 below nu n = 2000, with nu in mm2/s, n in rpm and
    d_m in mm (Palmgren). `factor` is f_0, `diameter` the mean one. It was measured on warm oil: of cold,
    thick oil it is an upper bound, since its shear heats the film.
    """
    within("f_0", factor, 0.5, 20, "")
    within("mean diameter of the bearing", diameter, 5e-3, 2, "m")
    positive("kinematic viscosity", viscosity, "m2/s")
    # cbrt(2000)^2 = 159: both forms meet there within 1 %
    product = max(viscosity / SQUARE_MILLIMETRE * abs(speed) * RPM, SLOW_BEARING)
    return 1e-10 * factor * cbrt(product) ** 2 * (1e3 * diameter) ** 3


@dataclass(frozen=True)
class DippingBody:
    """A gear body that turns in an oil bath."""

    radius: float
    """Radius of its tips [m]."""
    width: float
    """Width of its rim [m]."""
    immersed: float
    """Share of its surface in the oil [-]."""

    def __post_init__(self) -> None:
        """Refuse other units."""
        within("radius of the gear body", self.radius, 1e-3, 10, "m")
        within("width of the gear body", self.width, 1e-3, 5, "m")
        within("immersed share", self.immersed, 0, 1, "")

    def torque(self, density: float, viscosity: float, speed: float) -> float:
        """Torque by which a bath of oil holds it back [N m]: both sides and the rim, teeth as if smooth.

        Density [kg/m3], kinematic viscosity [m2/s] and speed [rad/s]. Splashing and squeezing of oil out of
        the mesh are not in it.
        """
        positive("density", density, "kg/m3")
        positive("kinematic viscosity", viscosity, "m2/s")
        spin, radius = abs(speed), self.radius
        if spin == 0.0:
            return 0.0
        reynolds = spin * radius**2 / viscosity
        moment = max(
            CREEPING_DISC / reynolds,
            LAMINAR_DISC / sqrt(reynolds),
            TURBULENT_DISC * reynolds**-0.2 if reynolds > 3e5 else 0.0,
        )
        sides = density / 2 * spin**2 * radius**5 * moment
        drag = LAMINAR_PLATE / sqrt(2 * pi * reynolds)
        layer = density / 2 * (spin * radius) ** 2 * drag * 2 * pi * radius**2 * self.width
        creeping = 4 * pi * density * viscosity * spin * radius**2 * self.width
        return self.immersed * (sides + max(layer, creeping))
