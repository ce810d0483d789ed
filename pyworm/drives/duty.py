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
    """A worm gear at an operating point.

    Attributes
    ----------
    gear : WormGear
        Geometry.
    worm_speed : float
        Speed of the worm [rad/s].
    torque : float
        Torque of the wheel [N m].
    reduced_modulus : float
        Reduced modulus E' [Pa].
    roughness : tuple of float or None
        Root mean square heights of worm and wheel, Rq [m]; None where one is not known.
    driver : str
        Driving member, "worm" or "wheel".
    words : tuple of str
        Derivation, in sentences.
    deflection : float or None
        Deflection of the worm's shaft at the mesh [m]; None where its bearings are not known.
    oil_temperature, wheel_temperature : float or None
        Temperature of the oil in the sump, and bulk temperature of the wheel, as they are given or follow
        from the drive's thermal balance [K]; None where a rating has to find them.
    wheel_material : str or None
        Material of the wheel in the drive's contacts; None where it has no name.
    simulated_wheel_temperature : float or None
        Bulk temperature of the wheel in the drive's contacts [K].
    contact_ratio : float or None
        Pairs of teeth in mesh on average [-]; None of a gear without its flanks.
    wheel_limit, wheel_modulus : float or None
        Temperature that the wheel's material bears in continuous use [K], and its Young's modulus at the bulk
        temperature of the drive's contacts [Pa]; None of a material without such a limit.
    conductance, other_loss : float or None
        Heat that the housing gives off for each kelvin of its oil [W/K], and losses besides the teeth [W],
        where they are given.
    """

    gear: WormGear
    worm_speed: float
    torque: float
    reduced_modulus: float
    roughness: tuple[float | None, float | None]
    driver: Literal["worm", "wheel"] = "worm"
    words: tuple[str, ...] = ()
    deflection: float | None = None
    oil_temperature: float | None = None
    wheel_temperature: float | None = None
    wheel_material: str | None = None
    simulated_wheel_temperature: float | None = None
    contact_ratio: float | None = None
    wheel_limit: float | None = None
    wheel_modulus: float | None = None
    conductance: float | None = None
    other_loss: float | None = None

    @property
    def composite_roughness(self) -> float:
        """Composite root mean square roughness of both flanks [m]; ValueError where one is not known."""
        worm, wheel = (
            known(Unknown(f"bodies.{name}.roughness is missing") if of is None else of)
            for name, of in zip(("worm", "wheel"), self.roughness, strict=True)
        )
        return composite_roughness(worm, wheel)


@dataclass(frozen=True)
class LineOfAction:
    """Contacts along a line of action with their closed forms; arrays over phase.

    Attributes
    ----------
    phase : ndarray
        0 at the start of the pinion's active profile, 1 at its end.
    radius : ndarray
        Relative radius of curvature [m].
    unit_load : ndarray
        Normal load for each length of the contact line [N/m].
    pinion_velocity, gear_velocity : ndarray
        Velocities of the surfaces across the contact line [m/s].
    hertz_pressure : ndarray
        Largest pressure of the dry contact [Pa].
    film_min : ndarray
        Least film by Dowson and Higginson [m].
    flash_temperature, contact_temperature : ndarray or None
        Blok's rise over the mean bulk temperature, and both together [K]; None without friction or heat.
    """

    phase: Array
    radius: Array
    unit_load: Array
    pinion_velocity: Array
    gear_velocity: Array
    hertz_pressure: Array
    film_min: Array
    flash_temperature: Array | None = None
    contact_temperature: Array | None = None

    @property
    def entrainment(self) -> Array:
        """Mean surface velocity [m/s]."""
        entrainment: Array = (self.pinion_velocity + self.gear_velocity) / 2
        return entrainment

    @property
    def thinnest(self) -> int:
        """Index of the contact with the thinnest film."""
        return int(np.argmin(self.film_min))


@dataclass(frozen=True)
class GearPairDuty:
    """A pair of cylindrical gears at an operating point.

    Attributes
    ----------
    centre_distance : float
        Distance of the axes [m].
    power : float
        Power through the mesh [W].
    pitch_line_velocity : float
        Velocity of the pitch circles [m/s].
    loss_factor : float
        H_V, loss over power and friction [-].
    reduced_modulus : float
        Reduced modulus E' [Pa].
    oil : Oil
        The oil as it enters the mesh.
    bulk_temperature : float or None
        Of the teeth, mean of both gears [K]; None where heat is not known.
    effusivities : tuple of float or None
        Thermal contact coefficients of pinion and gear [N/(m s^0.5 K)]; None where one is not known.
    line_of_action : LineOfAction
        Contacts along the line of action.
    roughness : tuple of float or None
        Root mean square heights of pinion and gear, Rq [m]; None where one is not known.
    friction : float or None
        Mean coefficient of friction given by the case [-]; None without.
    scuffing_temperature : float or None
        Mean scuffing temperature of the oil [K]; None if not known.
    """

    centre_distance: float
    power: float
    pitch_line_velocity: float
    loss_factor: float
    reduced_modulus: float
    oil: Oil
    line_of_action: LineOfAction
    bulk_temperature: float | None = None
    effusivities: tuple[float, float] | None = None
    roughness: tuple[float, float] | None = None
    friction: float | None = None
    scuffing_temperature: float | None = None

    @property
    def composite_roughness(self) -> float | None:
        """Composite roughness of both flanks [m]; None where one is not known."""
        return None if self.roughness is None else composite_roughness(*self.roughness)


Duty = WormDuty | GearPairDuty
