"""Input of ratings by standards: a worm gear, or a pair of cylindrical gears, at an operating point."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from pyworm.formulas.unknown import Unknown, known
from pyworm.formulas.wear_distress import composite_roughness
from pyworm.formulas.worm_gear import WormGear
from pyworm.materials.oil import Oil

Array = np.ndarray


@dataclass(frozen=True)
class WormDuty:
    """A worm gear at an operating point."""

    gear: WormGear
    """Geometry."""
    worm_speed: float
    """Speed of the worm [rad/s]."""
    torque: float
    """Torque of the wheel [N m]."""
    reduced_modulus: float
    """Reduced modulus E' [Pa]."""
    roughness: tuple[float | None, float | None]
    """Root mean square heights of worm and wheel, Rq [m]; None where one is not known."""
    driver: Literal["worm", "wheel"] = "worm"
    """Driving member, "worm" or "wheel"."""
    words: tuple[str, ...] = ()
    """Derivation, in sentences."""
    deflection: float | None = None
    """Deflection of the worm's shaft at the mesh [m]; None where its bearings are not known."""
    oil_temperature: float | None = None
    """Temperature of the oil in the sump, given or by thermal balance [K]; None: a rating finds it."""
    wheel_temperature: float | None = None
    """Bulk temperature of the wheel, given or by thermal balance [K]; None: a rating finds it."""
    wheel_material: str | None = None
    """Material of the wheel in the drive's contacts; None where it has no name."""
    simulated_wheel_temperature: float | None = None
    """Bulk temperature of the wheel in the drive's contacts [K]."""
    contact_ratio: float | None = None
    """Pairs of teeth in mesh on average [-]; None of a gear without its flanks."""
    wheel_limit: float | None = None
    """Temperature that the wheel's material bears for long [K]; None where it has no such limit."""
    wheel_modulus: float | None = None
    """Young's modulus of such a wheel at the bulk temperature of the drive's contacts [Pa]."""
    conductance: float | None = None
    """Heat that the housing gives off for each kelvin of its oil [W/K], where it is given."""
    other_loss: float | None = None
    """Losses besides the teeth [W], where they are given."""

    @property
    def composite_roughness(self) -> float:
        """Composite root mean square roughness of both flanks [m]; ValueError where one is not known."""
        worm, wheel = (
            known(
                Unknown(f"bodies.{name}.roughness is missing") if roughness is None else roughness
            )
            for name, roughness in zip(("worm", "wheel"), self.roughness, strict=True)
        )
        return composite_roughness(worm, wheel)


@dataclass(frozen=True)
class LineOfAction:
    """Contacts along a line of action with their closed forms; arrays over phase."""

    phase: Array
    """0 at the start of the pinion's active profile, 1 at its end."""
    radius: Array
    """Relative radius of curvature [m]."""
    unit_load: Array
    """Normal load for each length of the contact line [N/m]."""
    pinion_velocity: Array
    """Velocity of the pinion's surface across the contact line [m/s]."""
    gear_velocity: Array
    """Velocity of the gear's surface across the contact line [m/s]."""
    hertz_pressure: Array
    """Largest pressure of the dry contact [Pa]."""
    film_central: Array
    """Central film by Dowson and Toyoda, as in AGMA 925-A03 [m]."""
    film_min: Array
    """Minimum film by Dowson and Higginson [m]."""
    specific_film: Array | None = None
    """Minimum film over composite roughness [-]; None if the roughness is not known."""
    flash_temperature: Array | None = None
    """Blok's rise over the mean bulk temperature [K]; None without friction or heat."""
    contact_temperature: Array | None = None
    """Mean bulk temperature and Blok's rise together [K]; None without friction or heat."""
    scuffing_temperature: float | None = None
    """Mean scuffing temperature of the oil [K]; None if not known."""

    @property
    def entrainment(self) -> Array:
        """Mean surface velocity [m/s]."""
        return (self.pinion_velocity + self.gear_velocity) / 2

    @property
    def thinnest(self) -> int:
        """Index of the contact with the thinnest film."""
        return int(np.argmin(self.film_min))


@dataclass(frozen=True)
class GearPairDuty:
    """A pair of cylindrical gears at an operating point."""

    centre_distance: float
    """Distance of the axes [m]."""
    power: float
    """Power through the mesh [W]."""
    pitch_line_velocity: float
    """Velocity of the pitch circles [m/s]."""
    loss_factor: float
    """H_V, loss over power and friction [-]."""
    reduced_modulus: float
    """Reduced modulus E' [Pa]."""
    oil: Oil
    """The oil as it enters the mesh."""
    line_of_action: LineOfAction
    """Contacts along the line of action."""
    bulk_temperature: float | None = None
    """Bulk temperature of the teeth, mean of both gears [K]; None where heat is not known."""
    effusivities: tuple[float, float] | None = None
    """Thermal contact coefficients of pinion and gear [N/(m s^0.5 K)]; None where one is not known."""
    roughness: tuple[float, float] | None = None
    """Root mean square heights of pinion and gear, Rq [m]; None where one is not known."""
    friction: float | None = None
    """Mean coefficient of friction given by the case [-]; None without."""
    scuffing_temperature: float | None = None
    """Mean scuffing temperature of the oil [K]; None if not known."""

    @property
    def composite_roughness(self) -> float | None:
        """Composite roughness of both flanks [m]; None where one is not known."""
        return None if self.roughness is None else composite_roughness(*self.roughness)


Duty = WormDuty | GearPairDuty
