"""Indices of the mesh that the literature on roller enveloping worms goes by, of contact lines.

With v the velocity of the worm relative to the wheel, as if the roller stood still on its pin:

- lubrication angle: between v and the contact line, arcsin(|v . x| / |v|) with x across the line; at 90 deg
  sliding draws all its oil into the contact, at 0 none;
- self-rotation angle: between v and the roller's axis d, arccos(|v . d| / |v|); at 90 deg a free roller can
  roll, at 0 it can only slide along its axis;
- induced normal curvature: that of the gap across the line (`LineContact.curvature`).

The words are those of the school of X. Deng, and so are the angles by what its abstracts say of them; its
formulas in coordinates of a cylinder could not be read. Derived here; tested against differences of
positions.
"""

import numpy as np

from pyworm.drives.roller_worm.envelope import Array, LineContact, RollerEnvelope, dot


def lubrication_angle(envelope: RollerEnvelope, contact: LineContact) -> Array:
    """Angle between the relative velocity and the contact line [rad], 0 to pi/2."""
    velocity = envelope.relative_velocity(contact.point)
    across, along = dot(velocity, contact.across), dot(velocity, contact.along)
    return np.arctan2(np.abs(across), np.abs(along))


def self_rotation_angle(envelope: RollerEnvelope, contact: LineContact) -> Array:
    """Angle between the relative velocity and the roller's axis [rad], 0 to pi/2."""
    velocity = envelope.relative_velocity(contact.point)
    _, _, axis, _ = envelope.axes(contact.wheel_angle)
    share = np.abs(dot(velocity, axis)) / np.sqrt(dot(velocity, velocity))
    return np.arccos(np.minimum(share, 1.0))
