"""Temperatures of oil and bodies of a worm drive from its losses and its cooling.

The state is steady. The oil in the sump has one temperature, that of the inlets of the teeth; all losses
leave through the housing by one conductance, H (T_sump - T_ambient) = P_teeth + P_other. The wheel's bulk
temperature exceeds that of the oil by the loss between the teeth over the heat transfer of its rim (DIN 3996
and ISO/TS 14521, `pyworm.formulas.worm_standard.bulk_temperature`, not compared with the print); the worm's
exceeds the wheel's by a difference that is given, since no source gives one in closed form. P_teeth holds the
friction of asperities where roughness is simulated; P_other is given, or that of the same standard.
"""

from dataclasses import dataclass, replace

from pyworm.drives.other_losses import NonMeshLosses
from pyworm.formulas.worm_standard import bulk_temperature
from pyworm.io import units
from pyworm.io.plain_values import PositiveNumber
from pyworm.io.present import present
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil


@dataclass(frozen=True, kw_only=True)
class Housing:
    """How the housing of a worm drive cools it, and what that does to worm and wheel."""

    ambient_temperature: units.Temperature
    """Temperature of the surroundings [K]."""
    conductance: units.ThermalConductance
    """Heat from the housing to its surroundings over the temperature difference to the oil [W/K]."""
    immersion: PositiveNumber = 1.0
    """Coefficient c_k of the wheel in the standards [-]."""
    worm_excess: units.TemperatureDifference = 0.0
    """Excess of the worm's bulk temperature over the wheel's [K]."""


@dataclass(frozen=True, kw_only=True)
class Cooling(Housing):
    """Cooling of a worm drive, and its losses outside the teeth."""

    other: NonMeshLosses
    """Losses of bearings, seals and churning."""


@dataclass(frozen=True)
class DriveTemperatures:
    """Steady temperatures of a worm drive."""

    sump: float
    """Inlet temperature of the oil [K]."""
    worm: float
    """Bulk temperature of the worm [K]."""
    wheel: float
    """Bulk temperature of the wheel [K]."""

    def oil(self, oil: Oil) -> Oil:
        """An oil at the temperature of the sump."""
        return oil.warmed(self.sump - present(oil.heat, "oil.heat").inlet_temperature)

    def bodies(self, bodies: tuple[Body, Body]) -> tuple[Body, Body]:
        """Worm and wheel with their bulk temperatures."""
        worm, wheel = bodies
        return (
            replace(worm, bulk_temperature=self.worm),
            replace(wheel, bulk_temperature=self.wheel),
        )


def drive_temperatures(
    cooling: Cooling, rim: float, worm_speed: float, tooth_loss: float
) -> DriveTemperatures:
    """Steady temperatures under a loss between the teeth [W]; `rim` is the wheel's width times diameter [m2].

    ValueError if the sump is hotter than the range of the standard's formula.
    """
    sump = cooling.ambient_temperature + (tooth_loss + cooling.other.power) / cooling.conductance
    wheel = bulk_temperature(sump, tooth_loss, worm_speed, rim, cooling.immersion)
    return DriveTemperatures(sump, wheel + cooling.worm_excess, wheel)
