"""Torque of a gear unit without load, by the viscosity of its oil: bearings and bodies that dip."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from pyworm.drives.duty import WormDuty
from pyworm.drives.rotor import BEARING_OUTSIDE, Rotor, sized_shaft
from pyworm.formulas.no_load_torque import BATH_FACTORS, DippingBody, bearing_torque
from pyworm.materials.library import NamedOil

SOURCE = "Palmgren (bearings), von Karman and Jeffery (discs), Blasius (rims)"

IMMERSED = 0.3
"""Share of the larger gear body that dips, where nothing says so [-]; that of a level of oil of 0.3."""

BEARINGS_OF_A_SHAFT = 2
"""Bearings of each shaft."""


@dataclass(frozen=True)
class OiledShaft:
    """A shaft with its gear body and two equal bearings, as oil resists it."""

    name: str
    """Its name."""
    speed: float
    """Its speed [rad/s]."""
    bearing_diameter: float
    """Mean diameter of its bearings [m]."""
    bearing_factor: float
    """f_0 of its bearings [-]."""
    body: DippingBody
    """Its gear body."""


@dataclass(frozen=True)
class NoLoad:
    """Torque at the first shaft with which the oil of a unit resists; other shafts turn with it."""

    shafts: tuple[OiledShaft, ...]
    """Its shafts, the driving one first."""
    factor: float = 1.0
    """Factor that fits a known loss [-]."""

    def parts(self, oil: NamedOil, temperature: float) -> dict[str, float]:
        """Torque at the first shaft by "bearings" and "churning", in oil of a temperature [K] [N m]."""
        viscosity, density = (
            float(oil.kinematic_viscosity(temperature)),
            float(oil.density(temperature)),
        )
        first = self.shafts[0].speed
        found = {"bearings": 0.0, "churning": 0.0}
        for shaft in self.shafts:
            slower = self.factor * abs(shaft.speed / first)
            bearing = bearing_torque(
                shaft.bearing_factor, shaft.bearing_diameter, viscosity, shaft.speed
            )
            found["bearings"] += slower * BEARINGS_OF_A_SHAFT * bearing
            found["churning"] += slower * shaft.body.torque(density, viscosity, shaft.speed)
        return found

    def torque(self, oil: NamedOil, temperature: float) -> float:
        """Torque at the first shaft at its speed [N m], in oil of a temperature [K]."""
        return sum(self.parts(oil, temperature).values())

    def fitted(self, power: float, oil: NamedOil, temperature: float) -> "NoLoad":
        """With the factor that gives a known loss [W] in oil of a temperature [K]."""
        computed = self.torque(oil, temperature) * self.shafts[0].speed
        return replace(self, factor=self.factor * power / computed)


def worm_no_load(duty: WormDuty, bearings: str, mean_diameters: Mapping[float, float]) -> NoLoad:
    """That of a worm gear set with `bearings` "adjusted" or "fixed and floating" of the worm.

    `mean_diameters` are those of bearings that are given, by the speed of their shaft [rad/s] -> [m]; others
    follow from shafts sized by their torque. The wheel dips.
    """
    gear = duty.gear
    kind = BATH_FACTORS["tapered" if bearings == "adjusted" else "cylindrical"]
    wheel = gear.wheel_tip_diameter
    worm = OiledShaft(
        "worm",
        duty.worm_speed,
        _mean_diameter(mean_diameters, duty.worm_speed, gear.worm_root_diameter),
        kind,
        DippingBody(gear.worm_diameter / 2 + gear.module, wheel / 2, 0.0),
    )
    speed = duty.worm_speed / gear.ratio
    sized = sized_shaft(duty.torque, wheel)
    return NoLoad(
        (
            worm,
            OiledShaft(
                "wheel",
                speed,
                _mean_diameter(mean_diameters, speed, sized),
                BATH_FACTORS["tapered"],
                DippingBody(wheel / 2, gear.face_width, IMMERSED),
            ),
        )
    )


def rotors_no_load(rotors: Sequence[Rotor]) -> NoLoad:
    """That of any gears as cylinders on their shafts; the larger one dips, bearings are cylindrical."""
    largest = max(rotors, key=lambda rotor: rotor.diameter)
    return NoLoad(
        tuple(
            OiledShaft(
                rotor.name,
                rotor.speed,
                (1 + BEARING_OUTSIDE) / 2 * rotor.shaft_diameter,
                BATH_FACTORS["cylindrical"],
                DippingBody(rotor.diameter / 2, rotor.width, IMMERSED if rotor is largest else 0.0),
            )
            for rotor in rotors
        )
    )


def _mean_diameter(given: Mapping[float, float], speed: float, shaft: float) -> float:
    """Mean diameter of the bearings of a shaft of a diameter [m], as given for its speed or usual for it."""
    for known, diameter in given.items():
        if abs(known / speed - 1) < 1e-3:
            return diameter
    return (1 + BEARING_OUTSIDE) / 2 * shaft
