"""Loss between the teeth and efficiency of a drive, from the simulated friction."""

from dataclasses import replace

from pyworm.case.case import case_again
from pyworm.drives.drive import Drive
from pyworm.drives.mesh_loss import MeshLoss
from pyworm.result.contact_loss import contact_losses
from pyworm.result.result import Result


def with_missing(key: str, label: str, result: Result | None) -> str:
    """Label of a rated figure: of an efficiency with the contacts that the simulated one lacks."""
    if result is None or not result.missing or not key.startswith("efficiency"):
        return label
    return f"{label} (simulation: {result.missing})"


def mesh_loss(drive: Drive | None, result: Result) -> MeshLoss | None:
    """Loss between the teeth of a drive; None of other cases, without friction or enough contacts."""
    good = result.sound.solutions
    if (
        drive is None
        or not good
        or any(solution.figures.friction_coefficient is None for solution in good)
    ):
        return None
    loss = drive.mesh_loss(contact_losses(good))
    return loss and replace(loss, missing=result.missing)


def mesh_loss_of(result: Result) -> MeshLoss | None:
    """Loss between the teeth of the drive that a result is of; None where there is none."""
    return mesh_loss(case_again(result.case).drive, result) if result.case else None
