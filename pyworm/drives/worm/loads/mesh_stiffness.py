"""Loaded transmission error and mesh stiffness of a worm drive, by the approach of its bodies under load.

Worm and wheel are rigid except for contacts, shaft and, if given, teeth (`load_sharing`). The turn Theta of
the wheel behind its ideal angle is the loaded transmission error; the mesh stiffness is dT2/dTheta at the
same phase.
"""

from dataclasses import dataclass

import numpy as np

from pyworm.drives.worm.loads.mesh import WormMesh

PITCH_PHASES = 9
"""Phases over one pitch, the period of the transmission error."""

LOAD_STEP = 0.02
"""Relative step of the torque to both sides for the stiffness; contacts stiffen with its power of a third."""


@dataclass(frozen=True)
class LoadedMesh:
    """Yielding of the mesh under its torque."""

    transmission_error: float
    """Mean turn of the wheel behind its ideal angle [rad]."""
    transmission_error_range: float
    """Its range over a pitch, peak to peak [rad]."""
    stiffness: float
    """Mean mesh stiffness, torque of the wheel for each of its turn [N m/rad]."""


def loaded_mesh(mesh: WormMesh) -> LoadedMesh:
    """Yielding of the mesh over a pitch; ValueError where teeth share no torque, or share it equally."""
    shared = mesh.shared_torque
    if shared.sharing == "equal":
        raise ValueError("the teeth share the torque equally, by which no tooth yields")
    wheel = mesh.wheel_torque
    turns, stiffnesses = [], []
    for phase in 0.5 + mesh.pitch * np.linspace(-0.5, 0.5, PITCH_PHASES):
        turns.append(mesh.shared(float(phase)).turn)
        less, more = (
            mesh.shared(float(phase), factor).turn for factor in (1 - LOAD_STEP, 1 + LOAD_STEP)
        )
        stiffnesses.append(2 * LOAD_STEP * wheel / (more - less))
    # the ends are one pitch apart, the same place of the mesh
    return LoadedMesh(
        transmission_error=float(np.mean(turns[:-1])),
        transmission_error_range=float(np.ptp(turns)),
        stiffness=float(np.mean(stiffnesses[:-1])),
    )
