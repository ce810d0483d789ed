"""How a gear unit is cooled: by a given conductance of its housing, or by the sizes of the housing."""

from dataclasses import dataclass, replace

from pyworm.drives.other_losses import NonMeshLosses
from pyworm.io import units
from pyworm.io.plain_values import AboveZeroToOne, Phase, PositiveNumber
from pyworm.io.present import present
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil


@dataclass(frozen=True, kw_only=True)
class HousingSizes:
    """A box-shaped housing on a foundation."""

    length: units.Length
    """Length of the foot print [m]."""
    width: units.Length
    """Width of the foot print [m]."""
    height: units.Length
    """Height [m]."""
    wall: units.Length = 8e-3
    """Thickness of the walls, of cast iron [m]."""
    ribs: PositiveNumber = 1.0
    """Surface of the four sides with their ribs over that of plane ones [-]."""
    emissivity: AboveZeroToOne = 0.9
    """Emissivity of the outer surface [-]; 0.9 of paint."""
    air_velocity: units.Velocity = 0.0
    """Velocity of the air that a fan or the wind moves along the housing [m/s]."""
    oil_level: AboveZeroToOne = 0.3
    """Height of the oil over that of the housing [-]."""
    foot: Phase = 0.3
    """Share of the foot print that stands on the foundation [-]."""
    foundation_conductivity: units.Conductivity = 1.4
    """Thermal conductivity of the foundation [W/(m K)]; 1.4 of concrete."""

    @property
    def foot_print(self) -> float:
        """Area of the bottom, and of the top [m2]."""
        return self.length * self.width

    @property
    def sides(self) -> float:
        """Area of the four sides without ribs [m2]."""
        return 2 * (self.length + self.width) * self.height

    @property
    def hull(self) -> float:
        """Area of all walls without ribs [m2]."""
        return self.sides + 2 * self.foot_print


@dataclass(frozen=True, kw_only=True)
class MeasuredPoint:
    """A steady temperature of the sump that was measured at a known loss of the whole unit."""

    loss: units.Power
    """Loss of the gear unit [W]."""
    sump_temperature: units.Temperature
    """Temperature of the oil in the sump [K]."""
    ambient_temperature: units.Temperature
    """Temperature of the surroundings [K]."""


@dataclass(frozen=True, kw_only=True)
class Surroundings:
    """What cools a gear unit; one of `conductance` and `housing` is given."""

    ambient_temperature: units.Temperature
    """Temperature of the surroundings [K]."""
    ambient_swing: units.TemperatureDifference = 0.0
    """Half the difference of the day's warmest and coldest surroundings [K], over time alone."""
    conductance: units.ThermalConductance | None = None
    """Heat from the housing to its surroundings over the temperature difference to the oil [W/K]."""
    housing: HousingSizes | None = None
    """Sizes of the housing, from which its conductance follows."""
    measured: MeasuredPoint | None = None
    """A measured point that the housing's conductance fits; None: by correlations alone."""


@dataclass(frozen=True, kw_only=True)
class Cooling(Surroundings):
    """Cooling of a gear unit, and its losses outside the teeth."""

    other: NonMeshLosses
    """Losses of bearings, seals and churning."""


@dataclass(frozen=True)
class DriveTemperatures:
    """Steady temperatures of a gear set."""

    sump: float
    """Inlet temperature of the oil [K]."""
    bodies: tuple[float, float]
    """Bulk temperatures of both bodies [K]."""

    def oil(self, oil: Oil) -> Oil:
        """An oil at the temperature of the sump."""
        return oil.warmed(self.sump - present(oil.heat, "oil.heat").inlet_temperature)

    def warm(self, bodies: tuple[Body, Body]) -> tuple[Body, Body]:
        """Both bodies with their bulk temperatures."""
        first, second = (
            replace(body, bulk_temperature=temperature)
            for body, temperature in zip(bodies, self.bodies, strict=True)
        )
        return first, second
