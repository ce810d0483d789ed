"""What standards see of a drive: a worm gear, or a pair of cylindrical gears, at work."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from pyworm.formulas.wear_distress import composite_roughness
from pyworm.formulas.worm_gear import WormGear

Array = np.ndarray


@dataclass(frozen=True)
class WormDuty:
    """A worm gear at work.

    Attributes
    ----------
    gear : WormGear
        Geometry.
    worm_speed : float
        [rad/s].
    torque : float
        On the wheel [N m].
    reduced_modulus : float
        [Pa].
    roughness : tuple of float
        Root mean square heights of worm and wheel, Rq [m].
    driver : str
        "worm" or "wheel".
    words : tuple of str
        How it was derived.
    """

    gear: WormGear
    worm_speed: float
    torque: float
    reduced_modulus: float
    roughness: tuple[float, float]
    driver: Literal["worm", "wheel"] = "worm"
    words: tuple[str, ...] = ()

    @property
    def composite_roughness(self) -> float:
        """Of both flanks [m]."""
        return composite_roughness(*self.roughness)


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
    entrainment : ndarray
        Mean surface velocity [m/s].
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
    entrainment: Array
    hertz_pressure: Array
    film_min: Array
    flash_temperature: Array | None = None
    contact_temperature: Array | None = None

    @property
    def thinnest(self) -> int:
        """Which contact has the thinnest film."""
        return int(np.argmin(self.film_min))


@dataclass(frozen=True)
class GearPairDuty:
    """A pair of cylindrical gears at work.

    Attributes
    ----------
    centre_distance : float
        [m].
    power : float
        Through the mesh [W].
    pitch_line_velocity : float
        [m/s].
    loss_factor : float
        H_V, loss over power and friction [-].
    reduced_modulus : float
        [Pa].
    oil_density : float
        At the inlet [kg/m3].
    line_of_action : LineOfAction
        Its contacts.
    composite_roughness : float or None
        Of both flanks [m]; None where one is not known.
    friction : float or None
        Mean coefficient that the case gives [-]; None without.
    scuffing_temperature : float or None
        Mean scuffing temperature of the oil [K]; None if not known.
    """

    centre_distance: float
    power: float
    pitch_line_velocity: float
    loss_factor: float
    reduced_modulus: float
    oil_density: float
    line_of_action: LineOfAction
    composite_roughness: float | None = None
    friction: float | None = None
    scuffing_temperature: float | None = None


Duty = WormDuty | GearPairDuty
