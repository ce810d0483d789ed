"""Loss between the teeth and efficiency of a drive, from the simulated friction."""

from collections.abc import Sequence

from pyworm.drives.drive import Drive
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.result.contact_loss import contact_losses
from pyworm.solver.solution import Solution


def mesh_loss(drive: Drive | None, solutions: Sequence[Solution]) -> MeshLoss | None:
    """Loss between the teeth of a drive by its converged contacts.

    None where there is no drive, friction was not simulated, or the contacts are not enough.
    """
    good = [of for of in solutions if of.converged]
    if drive is None or not good or any(of.figures.friction_coefficient is None for of in good):
        return None
    return drive.mesh_loss(contact_losses(good))
