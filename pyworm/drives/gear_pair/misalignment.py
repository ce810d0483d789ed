"""Uneven load over the face of a gear pair by flanks that are not parallel."""

from collections.abc import Sequence
from dataclasses import replace

from pyworm.drives.answers import Misalignment, MountingError
from pyworm.drives.gear_pair.mesh import GearPairMesh
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene

LEAD_ERROR = 10e-6
"""Deviation of the flank lines over the face width [m]."""

MESH_STIFFNESS = 0.85 * 20e9
"""Stiffness of the teeth of steel spur gears, for each width, against an uneven load [N/m2].

0.85 of 20 N/(mm um), the usual value of ISO 6336-1 (method C), from memory.
"""

METHOD = (
    "Misalignment by K_Hbeta of ISO 6336-1 with a mesh stiffness of 17 N/(mm µm), without crowning: "
    "1 + c F/(2 w), or 2 [c F/(2 w)]^(1/2) where the contact does not reach over the whole face."
)


def gear_misalignment(mesh: GearPairMesh, contacts: Sequence[Scene | LineScene]) -> Misalignment:
    """Line contacts under a load that grows linearly over the face; none for scenes of whole faces."""
    if not all(isinstance(contact, LineScene) for contact in contacts):
        return Misalignment(METHOD)
    mean = mesh.normal_force / mesh.teeth.face_width
    excess = MESH_STIFFNESS * LEAD_ERROR / (2 * mean)
    factor = 1 + excess if excess <= 1 else 2 * excess**0.5
    uneven = MountingError(
        label=f"flank lines {LEAD_ERROR * 1e6:g} µm apart over the face",
        contacts=tuple(replace(contact, load=contact.load * factor) for contact in contacts),
        note=f"load at one end {factor:.2f} times the mean (K_Hbeta)",
    )
    return Misalignment(METHOD, (uneven,))
