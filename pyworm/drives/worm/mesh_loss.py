"""Loss between the teeth of a worm drive, by the friction of some contacts of its mesh cycle."""

from collections.abc import Callable, Sequence

import numpy as np

from pyworm.drives.mesh_loss import ContactLoss, MeshLoss, largest_model
from pyworm.drives.tooth_loss import FEWEST_PHASES, cycle_loss
from pyworm.drives.worm.loads.mesh import WormMesh
from pyworm.io.on_demand import xarray as xr

LoadedCycle = Callable[[], "xr.Dataset"]


def worm_mesh_loss(
    mesh: WormMesh, loaded_cycle: LoadedCycle, contacts: Sequence[ContactLoss]
) -> MeshLoss | None:
    """Loss of all teeth in mesh by solved contacts; None for too few phases of a shared torque."""
    if mesh.tooth_load is None:
        return _of_shared_torque(mesh, loaded_cycle, contacts)
    return _of_given_load(mesh, mesh.tooth_load, contacts)


def _of_shared_torque(
    mesh: WormMesh, loaded_cycle: LoadedCycle, contacts: Sequence[ContactLoss]
) -> MeshLoss | None:
    if len(contacts) < FEWEST_PHASES:
        return None
    loss = cycle_loss(loaded_cycle(), sorted(contacts, key=lambda contact: contact.phase))
    driven = loss.worm_torque * mesh.speed
    return MeshLoss(
        power=driven if mesh.driver == "worm" else driven + loss.power,
        loss=loss.power,
        friction=loss.friction,
        error=loss.error / loss.power,
        words="of all teeth in mesh, each under its share of the load, over the mesh cycle",
        model=None if loss.model_error is None else loss.model_error / loss.power,
    )


def _of_given_load(mesh: WormMesh, load: float, contacts: Sequence[ContactLoss]) -> MeshLoss:
    """Loss where the load of a tooth is given [N], times the mean number of teeth in contact."""
    teeth = mesh.mean_teeth_in_contact
    loss = float(np.mean([contact.power for contact in contacts])) * teeth
    output = load * mesh.load_arm * teeth * mesh.speed * mesh.ratio
    return MeshLoss(
        power=output + loss,
        loss=loss,
        friction=float(np.mean([contact.friction for contact in contacts])),
        error=max(contact.error for contact in contacts),
        words=f"means over the solved mesh phases; {teeth:.2f} teeth in contact on average, each "
        "under the load given",
        model=largest_model(contacts),
    )
