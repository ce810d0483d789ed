"""Temperatures of oil and bodies of a worm drive from its losses and its cooling.

The state is steady. The oil in the sump has one temperature, that of the inlets of the teeth. The wheel's
bulk temperature exceeds that of the oil by the loss between the teeth over the heat transfer of its rim
(DIN 3996 and ISO/TS 14521, `pyworm.formulas.worm_standard.bulk_temperature`, not compared with the print).
Of a unit of given conductance all losses leave through the housing, H (T_sump - T_ambient) = P_teeth +
P_other, and the worm's temperature exceeds the wheel's by a difference that is given, since no source gives
one in closed form: the thermal network of gear bodies and oil (`pyworm.drives.gear_unit`), by hand. The
sizes of a housing give the network of the whole unit. P_teeth holds the friction of asperities where
roughness is simulated; P_other is given, or that of the same standard.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import sqrt

from pyworm.drives.cooling import Cooling, DriveTemperatures, Surroundings
from pyworm.drives.gear_unit import GearUnit
from pyworm.drives.rotor import Rotor
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.formulas.worm_standard import bulk_temperature, rim_heat_transfer
from pyworm.io import units
from pyworm.io.plain_values import PositiveNumber
from pyworm.materials.oil import Oil


@dataclass(frozen=True, kw_only=True)
class WormSurroundings(Surroundings):
    """What cools a worm drive, and what that does to worm and wheel."""

    immersion: PositiveNumber = 1.0
    """Coefficient c_k of the wheel in the standards [-]."""
    worm_excess: units.TemperatureDifference = 0.0
    """Excess of the worm's bulk temperature over the wheel's [K]."""


@dataclass(frozen=True, kw_only=True)
class WormCooling(Cooling, WormSurroundings):
    """Cooling of a worm drive, and its losses outside the teeth."""


def worm_rotors(mesh: WormMesh, spans: Mapping[str, float]) -> tuple[Rotor, Rotor]:
    """Worm and wheel as cylinders; `spans` are distances of bearings by shaft [m], where they are given.

    The worm is as long as its tip cylinder lies within the wheel's throat, its shaft as thick as its root.
    ValueError where the load of one tooth is given.
    """
    load, worm, wheel = mesh.shared_torque, mesh.worm, mesh.wheel
    torque = load.torque if load.shaft == "wheel" else load.torque / mesh.ratio
    reach = wheel.tip_radius**2 - (mesh.centre_distance - worm.tip_radius) ** 2
    return (
        Rotor(
            name="worm",
            diameter=2 * mesh.reference_radius,
            width=2 * sqrt(reach),
            speed=mesh.speed,
            torque=torque * mesh.ratio,
            body=mesh.bodies[0],
            shaft=2 * worm.root_radius,
            bearing_span=spans.get("worm"),
        ),
        Rotor(
            name="wheel",
            diameter=2 * mesh.wheel_reference_radius,
            width=wheel.face_width,
            speed=mesh.speed * mesh.ratio,
            torque=torque,
            body=mesh.bodies[1],
            bearing_span=spans.get("wheel"),
        ),
    )


def worm_unit(
    cooling: WormCooling, rotors: tuple[Rotor, Rotor], oil: Oil, rim: float, tooth_loss: float
) -> GearUnit:
    """The thermal network of a worm drive; `rim` is the wheel's width times diameter [m2].

    Worm and wheel, into which half the loss goes, give off half as much for each kelvin as the standard's
    rim does for the whole loss: the wheel is as warm as there, and so is the worm, which has no source.
    """
    transfer = rim_heat_transfer(rotors[0].speed, cooling.immersion)
    return GearUnit(rotors, oil, cooling, tooth_loss, to_oil=transfer * rim / 2)


def drive_temperatures(
    cooling: WormCooling, conductance: float, rim: float, worm_speed: float, tooth_loss: float
) -> DriveTemperatures:
    """Steady temperatures for a conductance of the housing [W/K] and a loss between the teeth [W].

    `rim` is the wheel's width times diameter [m2]. ValueError if the sump is hotter than the range of the
    standard's formula.
    """
    sump = cooling.ambient_temperature + (tooth_loss + cooling.other.power) / conductance
    wheel = bulk_temperature(sump, tooth_loss, worm_speed, rim, cooling.immersion)
    return DriveTemperatures(sump, (wheel + cooling.worm_excess, wheel))
