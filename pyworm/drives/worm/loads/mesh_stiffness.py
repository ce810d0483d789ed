"""Loaded transmission error and mesh stiffness of a worm drive, by the approach of its bodies under load.

Worm and wheel are rigid except for contacts, shaft and, if given, teeth (`load_sharing`). The turn Theta of
the wheel behind its ideal angle is the loaded transmission error; the mesh stiffness is dT2/dTheta at the
same phase.
"""

import numpy as np

from pyworm.drives.torque_balance import MeshAtTorque, TorqueBalance
from pyworm.drives.worm.loads.mesh import WormMesh

PITCH_PHASES = 9
"""Phases over one pitch, the period of the transmission error."""

LOAD_STEP = 0.02
"""Relative step of the torque to both sides for the stiffness; contacts stiffen with its power of a third."""


def mesh_at_torque(mesh: WormMesh, balance: TorqueBalance) -> MeshAtTorque:
    """Loss and yielding of the mesh over a pitch; ValueError where no torque is shared, or equally."""
    shared = mesh.shared_torque
    if shared.sharing == "equal":
        raise ValueError("with sharing = equal no tooth yields")
    wheel = mesh.wheel_torque
    turns, stiffnesses = [], []
    for phase in 0.5 + mesh.pitch * np.linspace(-0.5, 0.5, PITCH_PHASES):
        turns.append(mesh.shared(float(phase)).turn)
        less, more = (
            mesh.shared(float(phase), factor).turn for factor in (1 - LOAD_STEP, 1 + LOAD_STEP)
        )
        stiffnesses.append(2 * LOAD_STEP * wheel / (more - less))
    # the ends are one pitch apart, the same place of the mesh
    return MeshAtTorque(
        speed=mesh.speed,
        torque=wheel,
        ratio=mesh.wheel.teeth / mesh.worm.threads,
        balance=balance,
        transmission_error=float(np.mean(turns[:-1])),
        transmission_error_range=float(np.ptp(turns)),
        stiffness=float(np.mean(stiffnesses[:-1])),
    )
