"""Tooth contacts of a gear pair along its line of action: curvature, velocities, loads."""

from dataclasses import dataclass

import numpy as np

Array = np.ndarray


@dataclass(frozen=True)
class ToothContacts:
    """Contacts along the line of action; numbers or arrays of one shape.

    Attributes
    ----------
    phase : float
        Place on the path of contact, 0 at the SAP of the pinion, 1 at its EAP.
    pinion_length, gear_length : float
        Radii of curvature in the transverse section [m].
    roll_angle : float
        Roll angle of the pinion, radius of curvature over base radius [rad].
    pinion_radius, gear_radius, radius : float
        Radii of curvature across the contact line, and the relative one [m].
    pinion_velocity, gear_velocity : float
        Velocities of the surfaces across the contact line, relative to it [m/s].
    unit_load : float
        Normal load for each length of the contact line [N/m].
    load_share : float
        Share of the normal force that the contact line carries [-].
    line_length : float
        Length of the contact line [m].
    approach : bool
        Whether contact is before the pitch point, where friction changes direction.
    """

    phase: Array
    pinion_length: Array
    gear_length: Array
    roll_angle: Array
    pinion_radius: Array
    gear_radius: Array
    radius: Array
    pinion_velocity: Array
    gear_velocity: Array
    unit_load: Array
    load_share: Array
    line_length: Array
    approach: Array

    @property
    def entrainment(self) -> Array:
        """Mean surface velocity [m/s]."""
        entrainment: Array = (self.pinion_velocity + self.gear_velocity) / 2
        return entrainment

    @property
    def sliding(self) -> Array:
        """Velocity of the pinion's surface relative to the gear's [m/s]."""
        sliding: Array = self.pinion_velocity - self.gear_velocity
        return sliding

    @property
    def slide_roll_ratio(self) -> Array:
        """Sliding over entrainment [-]."""
        slide_roll_ratio: Array = self.sliding / self.entrainment
        return slide_roll_ratio

    @property
    def pinion_specific_sliding(self) -> Array:
        """Sliding over the velocity of the pinion's surface [-]."""
        pinion_specific_sliding: Array = self.sliding / self.pinion_velocity
        return pinion_specific_sliding

    @property
    def gear_specific_sliding(self) -> Array:
        """Sliding of the gear's surface over its velocity [-]."""
        gear_specific_sliding: Array = -self.sliding / self.gear_velocity
        return gear_specific_sliding
