"""A gear body on its shaft between two bearings, as heat sees it."""

from dataclasses import dataclass
from math import pi

from pyworm.io.present import present
from pyworm.materials.body import Body

SHAFT_STRESS = 30e6
"""Torsional stress by which shafts are sized where no drawing gives them [Pa], usual in first designs."""

BEARING_OUTSIDE, BEARING_WIDTH = 1.8, 0.42
"""Outside diameter and width of rolling bearings over their bore, those of 6210, 22210 and 30210 [-]."""

SPAN_OVER_WIDTH = 1.5
"""Distance of bearings over the width between them where it is not given [-]."""

STEEL_DENSITY, STEEL_HEAT, STEEL_CONDUCTIVITY = 7850.0, 470.0, 45.0
"""Density [kg/m3], specific heat [J/(kg K)] and conductivity [W/(m K)] of shafts and bearings."""


def sized_shaft(torque: float, most: float) -> float:
    """Diameter of a shaft that carries a torque [N m] under `SHAFT_STRESS`, at most that of its body [m]."""
    return float(min((16 * torque / (pi * SHAFT_STRESS)) ** (1 / 3), most))


@dataclass(frozen=True)
class Rotor:
    """A gear body with its shaft and two bearings."""

    name: str
    """Name of its body."""
    diameter: float
    """Mean diameter of the gear body [m]."""
    width: float
    """Width of the gear body [m]."""
    speed: float
    """Speed [rad/s]."""
    torque: float
    """Torque [N m]."""
    body: Body
    """The solid."""
    shaft: float | None = None
    """Diameter of its shaft [m]; None: sized by the torque."""
    bearing_span: float | None = None
    """Distance of its bearings [m]; None: usual for the width."""

    @property
    def shaft_diameter(self) -> float:
        """Diameter of its shaft [m], at most that of the gear body."""
        return sized_shaft(self.torque, self.diameter) if self.shaft is None else self.shaft

    @property
    def span(self) -> float:
        """Distance of its bearings [m]."""
        wide = self.width + 2 * BEARING_WIDTH * self.shaft_diameter
        return SPAN_OVER_WIDTH * wide if self.bearing_span is None else self.bearing_span

    @property
    def surface(self) -> float:
        """Surface of the gear body: both sides and the rim [m2]."""
        return pi * self.diameter * (self.diameter / 2 + self.width)

    @property
    def capacity(self) -> float:
        """Heat capacity of the gear body [J/K]."""
        held = present(self.body.density, "density") * present(
            self.body.specific_heat, "specific_heat"
        )
        return held * pi / 4 * self.diameter**2 * self.width

    @property
    def shaft_capacity(self) -> float:
        """Heat capacity of the shaft between its bearings, outside the gear body [J/K]."""
        bare = max(self.span - self.width, self.shaft_diameter)
        return STEEL_DENSITY * STEEL_HEAT * pi / 4 * self.shaft_diameter**2 * bare

    @property
    def bearing_capacity(self) -> float:
        """Heat capacity of both bearings [J/K]."""
        bore = self.shaft_diameter
        ring = pi / 4 * bore**2 * (BEARING_OUTSIDE**2 - 1) * BEARING_WIDTH * bore
        return 2 * STEEL_DENSITY * STEEL_HEAT * ring

    @property
    def along_shaft(self) -> float:
        """Conductance from the gear body along the shaft to both bearings [W/K], k A over half the span."""
        section = pi / 4 * self.shaft_diameter**2
        return 2 * STEEL_CONDUCTIVITY * section / (self.span / 2)

    @property
    def inner_seats(self) -> float:
        """Area of the bearings' inner seats [m2]."""
        return 2 * pi * self.shaft_diameter * BEARING_WIDTH * self.shaft_diameter

    @property
    def outer_seats(self) -> float:
        """Area of the bearings' outer seats [m2]."""
        return BEARING_OUTSIDE * self.inner_seats
