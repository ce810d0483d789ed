"""Loss between the teeth of a gear pair, by the friction of some contacts of its line of action."""

from collections.abc import Sequence

import numpy as np

from pyworm.drives.gear_pair.mesh import GearPairMesh
from pyworm.drives.mesh_loss import ContactLoss, MeshLoss, largest_model


def gear_mesh_loss(mesh: GearPairMesh, contacts: Sequence[ContactLoss]) -> MeshLoss | None:
    """Loss by the loss factor and the mean friction; None for fewer than two phases."""
    if len(contacts) < 2:
        return None
    friction = _mean_friction(mesh, contacts)
    return MeshLoss(
        power=mesh.power,
        loss=mesh.power * mesh.loss_factor * friction,
        friction=friction,
        error=max(contact.error for contact in contacts),
        words=f"loss factor H_V = {mesh.loss_factor:.4f}, friction interpolated between the solved phases",
        model=largest_model(contacts),
    )


def _mean_friction(mesh: GearPairMesh, contacts: Sequence[ContactLoss]) -> float:
    """Mean friction over load times sliding, interpolated between the contacts, else constant [-]."""
    known = sorted((contact.phase, contact.friction) for contact in contacts)
    phases = mesh.cycle_phases()
    all_of_them = mesh.contacts(phases)
    weight = all_of_them.unit_load * np.abs(all_of_them.sliding)
    solved_phases, frictions = zip(*known, strict=True)
    friction = np.interp(phases, solved_phases, frictions)
    return float(np.trapezoid(weight * friction, phases) / np.trapezoid(weight, phases))
