"""Forces of the rollers on worm and wheel, summed over both sections."""

import numpy as np

from pyworm.drives.forces import MeshForces, ShaftAxes
from pyworm.drives.roller_worm.envelope import E_X, E_Z
from pyworm.drives.roller_worm.load_sharing import slices
from pyworm.drives.roller_worm.mesh import RollerMesh

PHASES = np.linspace(0.0, 1.0, 8, endpoint=False)
"""Places of the rollers between one pitch and the next over which forces are averaged."""


def roller_forces(mesh: RollerMesh) -> MeshForces:
    """Mean forces over a pitch of the rollers, without friction: rollers turn on their pins."""
    points, forces = (np.concatenate(parts, axis=1) for parts in zip(*_loads(mesh), strict=True))
    towards = np.array([0.0, -1.0, 0.0])
    centre = np.array([0.0, mesh.centre_distance, 0.0])
    on_worm = forces.sum(axis=1)
    along, across = (float(np.sign(part)) or 1.0 for part in (on_worm[0], -on_worm[2]))
    worm = ShaftAxes("worm", centre, towards, along * E_X)
    wheel = ShaftAxes("wheel", np.zeros(3), -towards, across * E_Z)
    return MeshForces("worm", 0.0, (worm.force(points, forces), wheel.force(points, -forces)))


def _loads(mesh: RollerMesh) -> list[tuple[np.ndarray, np.ndarray]]:
    """Points of the slices of all rollers (3, n) [m], and the mean forces there on the worm (3, n) [N]."""
    found = []
    pitch = 2 * np.pi / mesh.rollers.count
    for name, section in mesh.sections.items():
        if mesh.wheel_torque(name) == 0:
            continue
        for phase in PHASES:
            shared = mesh.shared(name, section.first + phase * pitch)
            for number, angle in enumerate(shared.wheel_angles):
                contact, lengths = slices(section, np.array(angle))
                load = shared.load(contact, number) * lengths / len(PHASES)
                found.append((contact.point, load * contact.normal))
    return found
