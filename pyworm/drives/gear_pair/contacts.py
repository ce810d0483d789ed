"""Tooth contacts of a gear pair along its line of action: curvature, velocities, loads."""

from dataclasses import dataclass

import numpy as np

Array = np.ndarray


@dataclass(frozen=True)
class ToothContacts:
    """Contacts along the line of action; numbers or arrays of one shape."""

    phase: Array
    """Place on the path of contact, 0 at the SAP of the pinion, 1 at its EAP."""
    pinion_length: Array
    """Radius of curvature of the pinion in the transverse section [m]."""
    gear_length: Array
    """Radius of curvature of the gear in the transverse section [m]."""
    roll_angle: Array
    """Roll angle of the pinion, radius of curvature over base radius [rad]."""
    pinion_radius: Array
    """Radius of curvature of the pinion across the contact line [m]."""
    gear_radius: Array
    """Radius of curvature of the gear across the contact line [m]."""
    radius: Array
    """Relative radius of curvature across the contact line [m]."""
    pinion_velocity: Array
    """Velocity of the pinion's surface across the contact line, relative to it [m/s]."""
    gear_velocity: Array
    """Velocity of the gear's surface across the contact line, relative to it [m/s]."""
    unit_load: Array
    """Normal load for each length of the contact line [N/m]."""
    load_share: Array
    """Share of the normal force that the contact line carries [-]."""
    line_length: Array
    """Length of the contact line [m]."""
    approach: Array
    """Whether contact is before the pitch point, where friction changes direction."""

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
