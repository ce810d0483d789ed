"""Temperatures of oil and bodies of a worm drive from its losses and its cooling.

Steady state. The oil in the sump is one body of oil, as warm as what the teeth take in; all losses leave
through the housing by one conductance, H (T_sump - T_ambient) = P_teeth + P_other. The wheel's bulk is warmer
than the oil that cools it, by the loss between the teeth over the transfer of its rim (DIN 3996 and ISO/TS
14521, `pyworm.formulas.worm_standard.bulk_temperature`, not compared with the print); the worm's is warmer
than the wheel's by a difference that is given: no source gives one in closed form.
"""

from dataclasses import dataclass, replace

from pyworm.formulas.worm_standard import bulk_temperature
from pyworm.materials.body import Body
from pyworm.materials.oil import Oil


@dataclass(frozen=True)
class Cooling:
    """What carries the losses of a worm drive away.

    Attributes
    ----------
    ambient_temperature : float
        [K].
    conductance : float
        Heat that the housing gives to its surroundings for each kelvin of the oil above them [W/K].
    other_loss : float
        Loss of bearings, seals and churning [W].
    immersion : float
        The standards' c_k of the wheel [-].
    worm_excess : float
        How much warmer the worm's bulk is than the wheel's [K].
    """

    ambient_temperature: float
    conductance: float
    other_loss: float
    immersion: float
    worm_excess: float


@dataclass(frozen=True)
class DriveTemperatures:
    """Steady temperatures of a worm drive.

    Attributes
    ----------
    sump, worm, wheel : float
        Of the oil as the teeth take it in, and of the bodies far from their surfaces [K].
    """

    sump: float
    worm: float
    wheel: float

    def oil(self, oil: Oil) -> Oil:
        """An oil as warm as the sump."""
        return oil.warmed(self.sump - oil.heat.inlet_temperature)

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
    """Steady temperatures under a loss between the teeth.

    Parameters
    ----------
    cooling : Cooling
        What carries the losses away.
    rim : float
        Face width of the wheel times its reference diameter [m2].
    worm_speed, tooth_loss : float
        [rad/s] and [W].

    Raises
    ------
    ValueError
        The sump would be hotter than the standard's formula is for.
    """
    sump = cooling.ambient_temperature + (tooth_loss + cooling.other_loss) / cooling.conductance
    wheel = bulk_temperature(sump, tooth_loss, worm_speed, rim, cooling.immersion)
    return DriveTemperatures(sump, wheel + cooling.worm_excess, wheel)
